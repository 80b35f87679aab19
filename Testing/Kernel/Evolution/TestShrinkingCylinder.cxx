// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

// An open cylinder under mean curvature flow whose rims are moved as the exact solution says.

#include "Evolution/SemiImplicitStep.h"
#include "Mesh/MeshTopology.h"
#include "Shapes/Tubes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace evolving;

namespace
{

constexpr double EndTime = 0.3;

/// r' = -1 / r from r(0) = 1.
double exactRadius(double time)
{
  return std::sqrt(1.0 - 2.0 * time);
}

/// A cylinder between z = -0.5 and 0.5 with prescribed rims.
class Cylinder
{
public:
  explicit Cylinder(Index n)
    : Mesh(shapes::tube(6 * n, 2 * n, 0.5, [](double) { return 1.0; }))
    , Topology(this->Mesh)
    , Geometry(this->Topology)
    , IsKnown(this->Mesh.points.size(), 0)
    , Epsilon(this->Mesh.points.size(), 1.0)
    , AtRest(this->Mesh.points.size(), Vec3::Zero())
  {
    this->Geometry.update(this->Mesh, Execution());
    for (Index i = 0; i < this->Mesh.vertexCount(); ++i)
    {
      this->IsKnown[static_cast<std::size_t>(i)] = this->Topology.isBoundary(i);
    }
  }

  void step(double timeStep)
  {
    const double shrink = exactRadius(this->Time + timeStep) / exactRadius(this->Time) - 1.0;
    std::vector<Vec3> rims;
    for (const Vec3& p : this->Mesh.points)
    {
      rims.emplace_back(shrink * p.x(), shrink * p.y(), 0.0);
    }
    const std::vector<Vec3>& move = this->Step.displacement(this->Geometry,
      { this->Epsilon, this->AtRest, this->IsKnown, rims, timeStep }, 1e-12, Execution());
    for (std::size_t i = 0; i < move.size(); ++i)
    {
      this->Mesh.points[i] += move[i];
    }
    this->Geometry.update(this->Mesh, Execution());
    this->Time += timeStep;
  }

  /// Integral over the surface of (|(x, y)| - r(t))^2.
  double squaredError() const
  {
    double sum = 0.0;
    for (std::size_t i = 0; i < this->Mesh.points.size(); ++i)
    {
      const double off = this->Mesh.points[i].head<2>().norm() - exactRadius(this->Time);
      sum += off * off * this->Geometry.coVolumes()[i];
    }
    return sum;
  }

  /// How far the mesh leaves the plane z = const of each of its circles.
  double largestShift(const Cylinder& start) const
  {
    double largest = 0.0;
    for (std::size_t i = 0; i < this->Mesh.points.size(); ++i)
    {
      largest = std::max(largest, std::abs(this->Mesh.points[i].z() - start.Mesh.points[i].z()));
    }
    return largest;
  }

private:
  SurfaceMesh Mesh;
  MeshTopology Topology;
  SurfaceGeometry Geometry;
  std::vector<char> IsKnown;
  std::vector<double> Epsilon;
  std::vector<Vec3> AtRest;
  SemiImplicitStep Step;
  double Time = 0.0;
};

/// The error (6.1) up to the end time, with time steps that go with the square of the edges.
double errorOfRun(Index n)
{
  Cylinder cylinder(n);
  const auto steps = static_cast<int>(n * n) / 2;
  const double timeStep = EndTime / steps;
  double sum = 0.0;
  for (int k = 0; k < steps; ++k)
  {
    cylinder.step(timeStep);
    sum += timeStep * cylinder.squaredError();
  }
  EXPECT_LT(cylinder.largestShift(Cylinder(n)), 0.01);
  return std::sqrt(sum);
}

} // namespace

TEST(ShrinkingCylinder, FollowsTheExactSolutionWithSecondOrder)
{
  double coarse = errorOfRun(4);
  EXPECT_LT(coarse, 0.02);
  for (const Index n : { 8, 16 })
  {
    const double fine = errorOfRun(n);
    EXPECT_NEAR(std::log2(coarse / fine), 2.0, 0.15) << "from " << n / 2 << " to " << n;
    coarse = fine;
  }
}
