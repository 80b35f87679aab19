// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Evolution/FiniteVolumes.h"

#include "Evolution/EvolutionShapes.h"
#include "Evolution/PolygonLaplacian.h"
#include "Evolution/SurfaceGeometry.h"
#include "Evolution/SurfaceGradient.h"
#include "ThreadedExecution.h"

#include <Eigen/Dense>
#include <Eigen/Eigenvalues>
#include <gtest/gtest.h>

using namespace evolving;

namespace
{

/// A surface with its matrices.
struct Discretization
{
  SurfaceMesh mesh;
  MeshTopology topology;
  FiniteVolumes volumes;

  explicit Discretization(const SurfaceMesh& surface, const Execution& execution = {})
    : mesh(surface)
    , topology(mesh)
    , volumes(topology)
  {
    this->volumes.update(this->mesh, execution);
  }
  Eigen::MatrixXd dense() const { return Eigen::MatrixXd(this->volumes.stiffness()); }
  double area() const { return totalArea(this->volumes.coVolumes(), Execution()); }
};

/// A closed prism over a regular hexagon: two hexagons and six quads.
SurfaceMesh hexagonalPrism()
{
  SurfaceMesh mesh;
  for (const double z : { 0.0, 0.7 })
  {
    for (int k = 0; k < 6; ++k)
    {
      mesh.addPoint(Vec3(std::cos(k * shapes::Pi / 3.0), std::sin(k * shapes::Pi / 3.0), z));
    }
  }
  mesh.addFace({ 5, 4, 3, 2, 1, 0 });
  mesh.addFace({ 6, 7, 8, 9, 10, 11 });
  for (Index k = 0; k < 6; ++k)
  {
    mesh.addFace({ k, (k + 1) % 6, (k + 1) % 6 + 6, k + 6 });
  }
  return mesh;
}

std::vector<SurfaceMesh> variousSurfaces()
{
  return { icosphere(2), shapes::bumpySphere(2), cubeSphere(4), hexagonalPrism(),
    shapes::shakenSheet(6, true, 0.4, 1), shapes::shakenSheet(6, false, 0.3, 2),
    shapes::torusGrid(9, 7, 2.0, 0.8, false) };
}

} // namespace

// The properties of section 4.1.

TEST(FiniteVolumes, StiffnessIsSymmetric)
{
  for (const SurfaceMesh& mesh : variousSurfaces())
  {
    const Eigen::MatrixXd L = Discretization(mesh).dense();
    EXPECT_LT((L - L.transpose()).cwiseAbs().maxCoeff(), 1e-13 * L.cwiseAbs().maxCoeff());
  }
}

TEST(FiniteVolumes, StiffnessIsLocal)
{
  const Discretization d(cubeSphere(4));
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

TEST(FiniteVolumes, WeightsArePositiveWithoutObtuseAngles)
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

TEST(FiniteVolumes, StiffnessIsPositiveSemiDefiniteWithConstantsAsItsKernel)
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

TEST(FiniteVolumes, IsLinearlyPreciseInThePlane)
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

TEST(FiniteVolumes, MeanCurvatureConvergesOnTheSphere)
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
  EXPECT_NEAR(Discretization(hexagonalPrism()).area(), 3.0 * std::sqrt(3.0) + 6.0 * 0.7, 1e-12);
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

TEST(FiniteVolumes, SplittingAQuadByHandGivesTheFoldedMatrix)
{
  // P^T L_tri P and the row sums of P^T M_tri P, written out with dense matrices.
  std::mt19937 random(11);
  std::uniform_real_distribution<double> shift(-0.2, 0.2);
  SurfaceMesh quad;
  for (const Vec3& p : { Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(1.2, 1, 0), Vec3(0, 0.8, 0) })
  {
    quad.addPoint(p + Vec3(shift(random), shift(random), shift(random)));
  }
  quad.addFace({ 0, 1, 2, 3 });
  const VirtualVertex apex = virtualVertex(quad.points);
  SurfaceMesh fan = quad;
  fan.faceOffsets = { 0 };
  fan.cornerVertices.clear();
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

TEST(PolygonLaplacian, VirtualVertexOfARegularPolygonIsItsCentre)
{
  std::vector<Vec3> corners;
  for (int k = 0; k < 5; ++k)
  {
    corners.emplace_back(3.0 + std::cos(0.4 * shapes::Pi * k), std::sin(0.4 * shapes::Pi * k), 2.0);
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
    corners.emplace_back(std::cos(shapes::Pi * k / 3.0) + shift(random),
      std::sin(shapes::Pi * k / 3.0) + shift(random), shift(random));
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
    const Vec3 other = apex + 0.01 * Vec3(shift(random), shift(random), shift(random));
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

TEST(SurfaceGradient, IsExactForLinearFunctionsInThePlane)
{
  const Vec3 slope(0.7, -1.3, 0.0);
  for (const bool triangles : { true, false })
  {
    const Discretization d(shapes::shakenSheet(6, triangles, 0.35, 8));
    std::vector<double> values;
    for (const Vec3& p : d.mesh.points)
    {
      values.push_back(slope.dot(p) + 4.0);
    }
    for (const Vec3& gradient : surfaceGradient(d.mesh, d.volumes, values, Execution()))
    {
      EXPECT_LT((gradient - slope).norm(), 1e-12);
    }
  }
}

TEST(SurfaceGradient, AgreesWithTheBoundaryIntegral)
{
  // (4.27) with the weights 5/12, 5/12, 2/12 at the midpoints of the co-volume's edges.
  double last = 0.0;
  for (const int level : { 2, 3, 4 })
  {
    const Discretization d(icosphere(level));
    std::vector<double> psi;
    for (const Vec3& p : d.mesh.points)
    {
      psi.push_back(p.x() * p.y() + std::sin(2.0 * p.z()));
    }
    const auto h = d.volumes.curvatureVectors(d.mesh, Execution());
    const auto gradient = surfaceGradient(d.mesh, d.volumes, psi, Execution());
    double difference = 0.0;
    double size = 0.0;
    for (Index i = 0; i < d.mesh.vertexCount(); ++i)
    {
      const auto v = static_cast<std::size_t>(i);
      const Vec3& F = d.mesh.points[v];
      Vec3 integral = Vec3::Zero();
      for (const Index corner : d.topology.ringCorners(i))
      {
        const auto p = static_cast<std::size_t>(d.topology.vertexOf(d.topology.next(corner)));
        const auto q = static_cast<std::size_t>(d.topology.vertexOf(d.topology.previous(corner)));
        const Vec3 B = (F + d.mesh.points[p] + d.mesh.points[q]) / 3.0;
        const auto edge = [&](const Vec3& neighbour, double value)
        {
          const Vec3 M = 0.5 * (F + neighbour);
          const Vec3 sigma = B - M;
          const Vec3 e = M - F;
          const Vec3 nu = (e - e.dot(sigma) / sigma.dot(sigma) * sigma).normalized();
          integral += sigma.norm() * value * nu;
        };
        edge(d.mesh.points[p], (5.0 * psi[v] + 5.0 * psi[p] + 2.0 * psi[q]) / 12.0);
        edge(d.mesh.points[q], (5.0 * psi[v] + 2.0 * psi[p] + 5.0 * psi[q]) / 12.0);
      }
      const Vec3 oracle = integral / d.volumes.coVolumes()[v] - psi[v] * h[v];
      difference += (tangentialPart(oracle - gradient[v], F)).squaredNorm();
      size += gradient[v].squaredNorm();
    }
    const double relative = std::sqrt(difference / size);
    EXPECT_LT(relative, last > 0.0 ? 0.6 * last : 0.02);
    last = relative;
  }
}
