// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Operators/PolygonLaplacian.h"

#include "Mesh/Angles.h"
#include "Operators/Discretization.h"
#include "Shapes/Draws.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

using namespace evolving;

TEST(PolygonLaplacian, SplittingAQuadByHandGivesTheFoldedMatrix)
{
  // P^T L_tri P and the row sums of P^T M_tri P, written out with dense matrices.
  std::mt19937 random(11);
  std::uniform_real_distribution<double> shift(-0.2, 0.2);
  SurfaceMesh quad;
  for (const Vec3& p : { Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(1.2, 1, 0), Vec3(0, 0.8, 0) })
  {
    quad.addPoint(p + shapes::drawnVector(shift, random));
  }
  quad.addFace({ 0, 1, 2, 3 });
  const VirtualVertex apex = virtualVertex(quad.points);
  SurfaceMesh fan;
  fan.points = quad.points;
  fan.addPoint(apex.point);
  for (Index k = 0; k < 4; ++k)
  {
    fan.addFace({ k, (k + 1) % 4, 4 });
  }
  Eigen::MatrixXd P = Eigen::MatrixXd::Zero(5, 4);
  P.topRows(4).setIdentity();
  for (Eigen::Index k = 0; k < 4; ++k)
  {
    P(4, k) = apex.weights[static_cast<std::size_t>(k)];
  }
  const Discretization triangles(fan);
  const Discretization polygon(quad);
  const Eigen::MatrixXd expected = P.transpose() * triangles.dense() * P;
  EXPECT_LT((polygon.dense() - expected).cwiseAbs().maxCoeff(), 1e-13);
  const Eigen::Map<const Eigen::VectorXd> masses(triangles.volumes.coVolumes().data(), 5);
  const Eigen::VectorXd rowSums =
    P.transpose() * masses.asDiagonal() * P * Eigen::VectorXd::Ones(4);
  for (Eigen::Index k = 0; k < 4; ++k)
  {
    EXPECT_NEAR(polygon.volumes.coVolumes()[static_cast<std::size_t>(k)], rowSums[k], 1e-14);
  }
}

TEST(PolygonLaplacian, VirtualVertexOfARegularPolygonIsItsCentre)
{
  std::vector<Vec3> corners;
  for (int k = 0; k < 5; ++k)
  {
    corners.emplace_back(3.0 + std::cos(0.4 * Pi * k), std::sin(0.4 * Pi * k), 2.0);
  }
  const VirtualVertex apex = virtualVertex(corners);
  EXPECT_LT((apex.point - Vec3(3, 0, 2)).norm(), 1e-14);
  for (const double weight : apex.weights)
  {
    EXPECT_NEAR(weight, 0.2, 1e-14);
  }
}

TEST(PolygonLaplacian, VirtualVertexMinimisesTheSquaredAreas)
{
  std::mt19937 random(3);
  std::uniform_real_distribution<double> shift(-0.3, 0.3);
  std::vector<Vec3> corners;
  for (int k = 0; k < 6; ++k)
  {
    corners.emplace_back(std::cos(Pi * k / 3.0) + shift(random),
      std::sin(Pi * k / 3.0) + shift(random), shift(random));
  }
  const auto energy = [&](const Vec3& apex)
  {
    double sum = 0.0;
    for (std::size_t k = 0; k < corners.size(); ++k)
    {
      const double area = triangleArea(corners[k], corners[(k + 1) % corners.size()], apex);
      sum += area * area;
    }
    return sum;
  };
  const Vec3 apex = virtualVertex(corners).point;
  for (int trial = 0; trial < 20; ++trial)
  {
    const Vec3 other = apex + 0.01 * shapes::drawnVector(shift, random);
    EXPECT_LT(energy(apex), energy(other));
  }
}

TEST(PolygonLaplacian, CornersOnALineAreFinite)
{
  FaceStencil stencil;
  computeFaceStencil({ Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(2, 0, 0), Vec3(3, 0, 0) }, stencil);
  for (const double weight : stencil.pairWeights)
  {
    EXPECT_TRUE(std::isfinite(weight));
  }
  for (const double area : stencil.cornerAreas)
  {
    EXPECT_NEAR(area, 0.0, 1e-12);
  }
}
