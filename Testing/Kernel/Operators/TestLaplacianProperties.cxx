// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Operators/FiniteVolumes.h"

#include "Mesh/MeshTopology.h"
#include "Operators/Discretization.h"
#include "Operators/SurfaceGeometry.h"
#include "Shapes/MixedPolygons.h"
#include "Shapes/Polyhedra.h"
#include "Shapes/Sheets.h"
#include "Shapes/Spheres.h"
#include "Shapes/Tubes.h"
#include "StartSurface/PrimitiveSurfaces.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

// The properties that section 4.1 asks of a discrete Laplacian.

using namespace evolving;

namespace
{

std::vector<SurfaceMesh> variousSurfaces()
{
  return { icosphere(2), shapes::bumpySphere(2), cubeSphere(4), shapes::hexagonalPrism(),
    shapes::mixedSphere(2), shapes::shakenSheet(6, true, 0.4, 1),
    shapes::shakenSheet(6, false, 0.3, 2), shapes::quadTorus(9, 7, 2.0, 0.8) };
}

/// Dirichlet energy over squared norm of a function on a surface.
double rayleighQuotient(const Discretization& d, const std::function<double(const Vec3&)>& function)
{
  Eigen::VectorXd f(d.mesh.vertexCount());
  for (Eigen::Index i = 0; i < f.size(); ++i)
  {
    f[i] = function(d.mesh.points[static_cast<std::size_t>(i)]);
  }
  const Eigen::Map<const Eigen::VectorXd> mu(d.volumes.coVolumes().data(), f.size());
  return f.dot(d.volumes.stiffness() * f) / f.cwiseAbs2().dot(mu);
}

} // namespace

TEST(LaplacianProperties, StiffnessIsSymmetric)
{
  for (const SurfaceMesh& mesh : variousSurfaces())
  {
    const Eigen::MatrixXd L = Discretization(mesh).dense();
    EXPECT_LT((L - L.transpose()).cwiseAbs().maxCoeff(), 1e-13 * L.cwiseAbs().maxCoeff());
  }
}

TEST(LaplacianProperties, StiffnessIsLocal)
{
  const Discretization d(shapes::mixedSphere(2));
  for (Index row = 0; row < d.mesh.vertexCount(); ++row)
  {
    forEachEntry(d.volumes.stiffness(), row,
      [&](Index column, double)
      {
        bool sharesFace = column == row;
        for (Index face = 0; face < d.mesh.faceCount(); ++face)
        {
          bool hasRow = false;
          bool hasColumn = false;
          for (Index k = 0; k < d.mesh.faceSize(face); ++k)
          {
            hasRow = hasRow || d.mesh.faceVertex(face, k) == row;
            hasColumn = hasColumn || d.mesh.faceVertex(face, k) == column;
          }
          sharesFace = sharesFace || (hasRow && hasColumn);
        }
        EXPECT_TRUE(sharesFace);
      });
  }
}

TEST(LaplacianProperties, WeightsArePositiveWithoutObtuseAngles)
{
  const Eigen::MatrixXd L = Discretization(icosphere(2)).dense();
  for (Eigen::Index i = 0; i < L.rows(); ++i)
  {
    for (Eigen::Index j = 0; j < L.cols(); ++j)
    {
      EXPECT_TRUE(i == j || L(i, j) <= 0.0);
    }
  }
}

TEST(LaplacianProperties, StiffnessIsPositiveSemiDefiniteWithConstantsAsItsKernel)
{
  for (const SurfaceMesh& mesh : variousSurfaces())
  {
    const Eigen::MatrixXd L = Discretization(mesh).dense();
    const Eigen::VectorXd eigenvalues =
      Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(L).eigenvalues();
    const double largest = eigenvalues[eigenvalues.size() - 1];
    EXPECT_NEAR(eigenvalues[0], 0.0, 1e-13 * largest);
    EXPECT_GT(eigenvalues[1], 1e-4 * largest);
    EXPECT_LT((L * Eigen::VectorXd::Ones(L.rows())).cwiseAbs().maxCoeff(), 1e-13 * largest);
  }
}

TEST(LaplacianProperties, IsLinearlyPreciseInThePlane)
{
  for (const bool triangles : { true, false })
  {
    const Discretization d(shapes::shakenSheet(8, triangles, 0.35, 5));
    const Vec3 slope(0.7, -1.3, 0.0);
    for (Index row = 0; row < d.mesh.vertexCount(); ++row)
    {
      double laplacian = 0.0;
      forEachEntry(d.volumes.stiffness(), row,
        [&](Index column, double value)
        { laplacian += value * slope.dot(d.mesh.points[static_cast<std::size_t>(column)]); });
      if (!d.topology.isBoundary(row))
      {
        EXPECT_NEAR(laplacian, 0.0, 1e-12);
      }
    }
  }
}

TEST(LaplacianProperties, MeanCurvatureConvergesOnTheSphere)
{
  for (const bool triangles : { true, false })
  {
    double lastError = 0.0;
    for (const int level : { 2, 3, 4 })
    {
      const SurfaceMesh mesh =
        triangles ? icosphere(level, 2.0) : cubeSphere(6 << (level - 2), 2.0);
      const MeshTopology topology(mesh);
      SurfaceGeometry geometry(topology);
      geometry.update(mesh, Execution());
      double square = 0.0;
      for (Index i = 0; i < mesh.vertexCount(); ++i)
      {
        const double error = geometry.meanCurvature(i) - 1.0; // 2 / r
        square += geometry.coVolumes()[static_cast<std::size_t>(i)] * error * error;
      }
      const double error = std::sqrt(square);
      if (lastError > 0.0)
      {
        EXPECT_LT(error, 0.75 * lastError); // first order near irregular vertices
      }
      lastError = error;
    }
    EXPECT_LT(lastError, 0.1);
  }
}

TEST(LaplacianProperties, TheEnergyOfThePositionsIsTwiceTheArea)
{
  // The Dirichlet energy of the identity; on polygons the area of the fans around virtual vertices.
  for (const SurfaceMesh& mesh : variousSurfaces())
  {
    const Discretization d(mesh);
    double energy = 0.0;
    for (int axis = 0; axis < 3; ++axis)
    {
      Eigen::VectorXd f(d.mesh.vertexCount());
      for (Eigen::Index i = 0; i < f.size(); ++i)
      {
        f[i] = d.mesh.points[static_cast<std::size_t>(i)][axis];
      }
      energy += f.dot(d.volumes.stiffness() * f);
    }
    EXPECT_NEAR(energy, 2.0 * d.area(), 1e-13 * energy);
  }
}

TEST(LaplacianProperties, EigenvaluesOfTheSphereConvergeWithSecondOrder)
{
  // Spherical harmonics of degree n have the eigenvalue n (n + 1).
  const auto quadratic = [](const Vec3& p) { return p.x() * p.y() + p.y() * p.z(); };
  const auto cubic = [](const Vec3& p) { return p.x() * p.y() * p.z(); };
  using Sphere = std::function<SurfaceMesh(int)>;
  for (const Sphere& sphere :
    { Sphere([](int level) { return icosphere(level); }),
      Sphere([](int level) { return cubeSphere(3 << (level - 1)); }), Sphere(shapes::mixedSphere) })
  {
    const Discretization coarse(sphere(3));
    const Discretization fine(sphere(4));
    EXPECT_NEAR(rayleighQuotient(fine, cubic), 12.0, 0.2);
    EXPECT_NEAR(rayleighQuotient(fine, quadratic), 6.0, 0.06);
    const double cubicRatio =
      (rayleighQuotient(coarse, cubic) - 12.0) / (rayleighQuotient(fine, cubic) - 12.0);
    const double quadraticRatio =
      (rayleighQuotient(coarse, quadratic) - 6.0) / (rayleighQuotient(fine, quadratic) - 6.0);
    EXPECT_NEAR(std::log2(cubicRatio), 2.0, 0.15);
    EXPECT_NEAR(std::log2(quadraticRatio), 2.0, 0.15);
  }
}
