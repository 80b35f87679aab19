// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

// Surfaces whose symmetry leaves the tangential velocity no direction.

#include "Redistribution/TangentialVelocity.h"

#include "Checks/SurfaceMeasures.h"
#include "Evolution/FlowRuns.h"
#include "Mesh/Angles.h"
#include "Mesh/MeshTopology.h"
#include "Operators/Discretization.h"
#include "Shapes/Tubes.h"
#include "StartSurface/PrimitiveSurfaces.h"

#include <Eigen/Dense>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace evolving;

namespace
{

constexpr Index Around = 16;
constexpr Index Across = 9; // odd: areas of alternate strips would have no say in co-volumes

/// A torus of quads whose circles along the ring are at the given angles of the tube.
SurfaceMesh torusAt(const Eigen::VectorXd& angles)
{
  SurfaceMesh mesh = shapes::quadTorus(Around, Across, 2.0, 0.8);
  for (std::size_t i = 0; i < mesh.points.size(); ++i)
  {
    const double u = 2.0 * Pi * static_cast<double>(i / Across) / Around;
    const double v = angles[static_cast<Eigen::Index>(i % Across)];
    const double r = 2.0 + 0.8 * std::cos(v);
    mesh.points[i] = Vec3(r * std::cos(u), r * std::sin(u), 0.8 * std::sin(v));
  }
  return mesh;
}

Eigen::VectorXd evenAngles()
{
  return Eigen::VectorXd::LinSpaced(Across, 0.0, 2.0 * Pi * (Across - 1) / Across);
}

/// Of the circles after the first: co-volume over the mean, minus one.
Eigen::VectorXd excess(const Eigen::VectorXd& angles)
{
  const Discretization d(torusAt(angles));
  const Eigen::Map<const Eigen::VectorXd> mu(d.volumes.coVolumes().data(), Across);
  return mu.tail(Across - 1).array() / mu.mean() - 1.0;
}

/// The angles at which all co-volumes are equal, by Newton's method.
Eigen::VectorXd anglesOfEqualAreas()
{
  constexpr double Difference = 1e-6;
  Eigen::VectorXd angles = evenAngles();
  for (int iteration = 0; iteration < 8; ++iteration)
  {
    Eigen::MatrixXd slope(Across - 1, Across - 1);
    for (Eigen::Index k = 0; k < Across - 1; ++k)
    {
      Eigen::VectorXd ahead = angles;
      Eigen::VectorXd behind = angles;
      ahead[k + 1] += Difference;
      behind[k + 1] -= Difference;
      slope.col(k) = (excess(ahead) - excess(behind)) / (2.0 * Difference);
    }
    angles.tail(Across - 1) -= slope.partialPivLu().solve(excess(angles));
  }
  return angles;
}

/// v_T of a surface with velocity v_N = speed * h.
std::vector<Vec3> tangentialVelocity(
  const SurfaceMesh& mesh, double speed, const RedistributionOptions& options)
{
  const MeshTopology topology(mesh);
  const SurfaceCurves curves(mesh, topology);
  SurfaceGeometry geometry(topology);
  geometry.update(mesh, Execution());
  std::vector<Vec3> normalVelocity = geometry.curvatureVectors();
  for (Vec3& v : normalVelocity)
  {
    v *= speed;
  }
  TangentialVelocity velocity(topology, curves, options, BoundaryMode::Fixed, 1e-10);
  return velocity.velocity({ mesh, geometry, normalVelocity, {}, 1.0, 1e-3 }, Execution());
}

double largest(const std::vector<Vec3>& vectors)
{
  double length = 0.0;
  for (const Vec3& v : vectors)
  {
    length = std::max(length, v.norm());
  }
  return length;
}

RedistributionOptions rates(double volume, double angle, double length)
{
  RedistributionOptions options;
  options.volume = volume;
  options.angle = angle;
  options.length = length;
  return options;
}

} // namespace

TEST(RegularSurfaces, AnIcosahedronDoesNotMoveTangentially)
{
  FlowOptions options = flows::meanCurvatureFlow(0.01, 5);
  for (const CurvatureControl control : { CurvatureControl::None, CurvatureControl::Exponential })
  {
    options.redistribution = rates(50.0, 10.0, 10.0);
    options.redistribution.curvatureControl = control;
    SurfaceFlow flow(icosphere(0), nullptr, options);
    while (!flow.isFinished())
    {
      flow.step();
      EXPECT_LT(largest(flow.arrays().tangentialVelocity), 1e-12);
    }
    const double radius = flow.mesh().points[0].norm();
    EXPECT_LT(radius, 0.95);
    for (std::size_t i = 0; i < 12; ++i)
    {
      EXPECT_LT((flow.mesh().points[i] - radius * icosphere(0).points[i]).norm(), 1e-12);
    }
  }
}

// On a torus in space no grid is regular in every sense: the outer side is longer than the inner
// one. A grid with equal co-volumes has nothing for the volume-based velocity to do, ...

TEST(RegularSurfaces, ATorusOfEqualAreasDoesNotMoveByVolume)
{
  const SurfaceMesh even = torusAt(anglesOfEqualAreas());
  EXPECT_LT(checks::relativeSpread(Discretization(even).volumes.coVolumes()), 1e-14);
  EXPECT_LT(largest(tangentialVelocity(even, 0.0, rates(1.0, 0.0, 0.0))), 1e-12);
  const SurfaceMesh uneven = torusAt(evenAngles());
  EXPECT_GT(largest(tangentialVelocity(uneven, 0.0, rates(1.0, 0.0, 0.0))), 0.01);
}

// ... one with equal edges along every circle nothing for the length-based one, ...

TEST(RegularSurfaces, ATorusOfEqualEdgesAlongItsCirclesDoesNotMoveByLength)
{
  const SurfaceMesh even = torusAt(evenAngles());
  EXPECT_LT(largest(tangentialVelocity(even, 0.0, rates(0.0, 0.0, 1.0))), 1e-12);
  const SurfaceMesh uneven = torusAt(anglesOfEqualAreas());
  EXPECT_GT(largest(tangentialVelocity(uneven, 0.0, rates(0.0, 0.0, 1.0))), 0.01);
}

// ... and around the axis, where every grid of revolution is regular, nothing ever moves.

TEST(RegularSurfaces, ATorusDoesNotTurnAboutItsAxis)
{
  const SurfaceMesh torus = torusAt(evenAngles());
  for (const RedistributionOptions& options :
    { rates(1.0, 0.0, 0.0), rates(0.0, 1.0, 0.0), rates(0.0, 0.0, 1.0) })
  {
    const std::vector<Vec3> v = tangentialVelocity(torus, 1.0, options);
    EXPECT_GT(largest(v), 0.01);
    for (std::size_t i = 0; i < v.size(); ++i)
    {
      const Vec3 aroundAxis = Vec3::UnitZ().cross(torus.points[i]).normalized();
      EXPECT_NEAR(v[i].dot(aroundAxis), 0.0, 1e-12) << "vertex " << i;
    }
  }
}
