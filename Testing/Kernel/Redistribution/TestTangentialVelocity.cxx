// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Mesh/MeshTopology.h"
#include "Redistribution/TangentialVelocity.h"
#include "Shapes/Sheets.h"
#include "Shapes/Spheres.h"
#include "Shapes/Tubes.h"
#include "StartSurface/PrimitiveSurfaces.h"

#include <gtest/gtest.h>

#include <algorithm>

using namespace evolving;

namespace
{

struct Surface
{
  SurfaceMesh mesh;
  MeshTopology topology;
  SurfaceCurves curves;
  SurfaceGeometry geometry;
  std::vector<Vec3> normalVelocity;
  std::vector<double> noDistance;

  explicit Surface(const SurfaceMesh& surface)
    : mesh(surface)
    , topology(mesh)
    , curves(mesh, topology)
    , geometry(topology)
  {
    this->geometry.update(this->mesh, Execution());
    for (std::size_t i = 0; i < mesh.points.size(); ++i)
    {
      this->normalVelocity.push_back(this->topology.isBoundary(static_cast<Index>(i))
          ? Vec3(Vec3::Zero())
          : this->geometry.curvatureVectors()[i]);
    }
  }
  std::vector<Vec3> velocity(
    const RedistributionOptions& options, BoundaryMode mode, double timeStep = 1e-3) const
  {
    TangentialVelocity tangential(this->topology, this->curves, options, mode, 1e-10);
    return tangential.velocity(
      { this->mesh, this->geometry, this->normalVelocity, this->noDistance, 1.0, timeStep },
      Execution());
  }
};

RedistributionOptions allThree()
{
  RedistributionOptions options;
  options.volume = 2.0;
  options.angle = 1.0;
  options.length = 0.5;
  return options;
}

} // namespace

TEST(TangentialVelocity, IsOrthogonalToTheNormals)
{
  for (const SurfaceMesh& mesh :
    { shapes::bumpySphere(3), cubeSphere(6), shapes::quadTorus(12, 8, 2.0, 0.8) })
  {
    const Surface s(mesh);
    double largest = 0.0;
    const std::vector<Vec3> v = s.velocity(allThree(), BoundaryMode::Fixed);
    for (std::size_t i = 0; i < v.size(); ++i)
    {
      EXPECT_NEAR(v[i].dot(s.geometry.normals()[i]), 0.0, 1e-12);
      largest = std::max(largest, v[i].norm());
    }
    EXPECT_GT(largest, 1e-3);
  }
}

TEST(TangentialVelocity, IsTheSumOfItsKinds)
{
  const Surface s(shapes::bumpySphere(2));
  std::vector<Vec3> sum(s.mesh.points.size(), Vec3::Zero());
  for (const int kind : { 0, 1, 2 })
  {
    RedistributionOptions one;
    one.volume = kind == 0 ? 2.0 : 0.0;
    one.angle = kind == 1 ? 1.0 : 0.0;
    one.length = kind == 2 ? 0.5 : 0.0;
    const std::vector<Vec3> v = s.velocity(one, BoundaryMode::Fixed);
    for (std::size_t i = 0; i < v.size(); ++i)
    {
      sum[i] += v[i];
    }
  }
  const std::vector<Vec3> v = s.velocity(allThree(), BoundaryMode::Fixed);
  for (std::size_t i = 0; i < v.size(); ++i)
  {
    EXPECT_LT((v[i] - sum[i]).norm(), 1e-12);
  }
}

TEST(TangentialVelocity, IsZeroWhenSwitchedOff)
{
  const Surface s(shapes::bumpySphere(2));
  for (const Vec3& v : s.velocity(RedistributionOptions(), BoundaryMode::Free))
  {
    EXPECT_EQ(v, Vec3(Vec3::Zero()));
  }
}

TEST(TangentialVelocity, ObeysTheBoundaryMode)
{
  const Surface s(shapes::shakenSheet(6, true, 0.4, 9));
  const std::vector<Vec3> fixed = s.velocity(allThree(), BoundaryMode::Fixed);
  const std::vector<Vec3> sliding = s.velocity(allThree(), BoundaryMode::SlideAlong);
  const std::vector<Vec3> free = s.velocity(allThree(), BoundaryMode::Free);
  double along = 0.0;
  double across = 0.0;
  for (Index i = 0; i < s.mesh.vertexCount(); ++i)
  {
    const auto v = static_cast<std::size_t>(i);
    if (!s.topology.isBoundary(i))
    {
      EXPECT_EQ(fixed[v], free[v]);
      EXPECT_EQ(sliding[v], free[v]);
      continue;
    }
    EXPECT_EQ(fixed[v], Vec3(Vec3::Zero()));
    const bool isCorner = s.curves.isCorner(i);
    const bool isHorizontal = s.mesh.points[v].y() == 0.0 || s.mesh.points[v].y() == 1.0;
    const Vec3 tangent = isHorizontal ? Vec3::UnitX() : Vec3::UnitY();
    EXPECT_LT((sliding[v] - tangent * tangent.dot(sliding[v])).norm(), 1e-14);
    EXPECT_TRUE(!isCorner || sliding[v].norm() == 0.0);
    along = std::max(along, sliding[v].norm());
    across = std::max(across, (free[v] - tangent * tangent.dot(free[v])).norm());
  }
  EXPECT_GT(along, 1e-3);
  EXPECT_GT(across, 1e-3);
}

TEST(TangentialVelocity, NeverGoesFartherThanHalfAnEdge)
{
  const Surface s(shapes::bumpySphere(3));
  RedistributionOptions wild;
  wild.volume = 1e9;
  const double timeStep = 0.5;
  const std::vector<Vec3> v = s.velocity(wild, BoundaryMode::Fixed, timeStep);
  for (Index i = 0; i < s.mesh.vertexCount(); ++i)
  {
    double longest = 0.0;
    for (const Index j : s.topology.ringVertices(i))
    {
      longest = std::max(longest,
        (s.mesh.points[static_cast<std::size_t>(j)] - s.mesh.points[static_cast<std::size_t>(i)])
          .norm());
    }
    EXPECT_LE(timeStep * v[static_cast<std::size_t>(i)].norm(), 0.5 * longest);
  }
}
