// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Operators/FiniteVolumes.h"

#include "Operators/Discretization.h"
#include "Shapes/MeshVariants.h"
#include "Shapes/Polyhedra.h"
#include "Shapes/Sheets.h"
#include "Shapes/Spheres.h"
#include "StartSurface/PrimitiveSurfaces.h"
#include "ThreadedExecution.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace evolving;

TEST(FiniteVolumes, CurvatureVectorsPointInwards)
{
  const Discretization d(icosphere(0));
  for (Index i = 0; i < 12; ++i)
  {
    const Vec3 h = d.volumes.curvatureVectors(d.mesh, Execution())[static_cast<std::size_t>(i)];
    EXPECT_LT(h.dot(d.mesh.points[static_cast<std::size_t>(i)]), 0.0);
  }
}

TEST(FiniteVolumes, CoVolumesSumToTheArea)
{
  EXPECT_NEAR(
    Discretization(shapes::hexagonalPrism()).area(), 3.0 * std::sqrt(3.0) + 6.0 * 0.7, 1e-12);
  EXPECT_NEAR(Discretization(shapes::shakenSheet(7, true, 0.4, 3)).area(), 1.0, 1e-12);
  EXPECT_NEAR(Discretization(shapes::shakenSheet(7, false, 0.3, 4)).area(), 1.0, 1e-12);
  const Discretization sphere(icosphere(3));
  EXPECT_NEAR(sphere.area(), surfaceArea(sphere.mesh), 1e-12);
}

TEST(FiniteVolumes, CoVolumeOfARegularVertexIsAThirdOfItsRing)
{
  const Discretization d(shapes::sheet(4, true));
  EXPECT_NEAR(d.volumes.coVolumes()[12], 1.0 / 16.0, 1e-14); // six triangles of 1/32 each
}

TEST(FiniteVolumes, LosesNothingFarFromTheOrigin)
{
  const Discretization here(shapes::bumpySphere(3));
  const Discretization there(shapes::transformed(here.mesh, 1.0, Vec3(1e6, -2e6, 3e6)));
  const auto h = here.volumes.curvatureVectors(here.mesh, Execution());
  const auto far = there.volumes.curvatureVectors(there.mesh, Execution());
  for (std::size_t i = 0; i < h.size(); ++i)
  {
    EXPECT_LT((h[i] - far[i]).norm(), 1e-6 * (1.0 + h[i].norm()));
  }
}

TEST(FiniteVolumes, DegenerateTrianglesHaveFiniteWeights)
{
  SurfaceMesh mesh = shapes::sheet(4, true);
  mesh.points[12] = mesh.points[13];                        // an edge without length
  mesh.points[7] = 0.5 * (mesh.points[6] + mesh.points[8]); // three points on a line
  mesh.points[16] = mesh.points[17] = mesh.points[18];
  const Discretization d(mesh);
  const Eigen::MatrixXd L = d.dense();
  EXPECT_TRUE(L.allFinite());
  const Eigen::VectorXd eigenvalues =
    Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(L).eigenvalues();
  EXPECT_GT(eigenvalues[0], -1e-12 * eigenvalues[eigenvalues.size() - 1]);
  for (const double mu : d.volumes.coVolumes())
  {
    EXPECT_GT(mu, 0.0);
  }
}

TEST(FiniteVolumes, UnusedPointsHaveEmptyRows)
{
  SurfaceMesh mesh = icosphere(1);
  mesh.addPoint(Vec3(5, 5, 5));
  const Discretization d(mesh);
  EXPECT_EQ(d.volumes.stiffness().coeff(42, 42), 0.0);
  EXPECT_EQ(d.volumes.curvatureVectors(mesh, Execution())[42], Vec3(Vec3::Zero()));
}

TEST(FiniteVolumes, HasTheSameBitsForAnyNumberOfThreads)
{
  const Discretization serial(cubeSphere(40)); // several chunks of vertices and faces
  for (const int threads : { 1, 2, 8 })
  {
    const Discretization d(serial.mesh, threadedExecution(threads, 21));
    EXPECT_EQ(d.volumes.coVolumes(), serial.volumes.coVolumes());
    const Eigen::Index entries = serial.volumes.stiffness().nonZeros();
    EXPECT_TRUE(std::equal(serial.volumes.stiffness().valuePtr(),
      serial.volumes.stiffness().valuePtr() + entries, d.volumes.stiffness().valuePtr()));
  }
}
