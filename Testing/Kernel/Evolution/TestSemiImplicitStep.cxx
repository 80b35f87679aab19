// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Evolution/SemiImplicitStep.h"
#include "Mesh/MeshTopology.h"
#include "Shapes/MeshVariants.h"
#include "Shapes/Sheets.h"
#include "Shapes/Spheres.h"
#include "StartSurface/PrimitiveSurfaces.h"

#include <Eigen/Dense>
#include <gtest/gtest.h>

#include <cmath>

using namespace evolving;

namespace
{

/// A bumpy sphere with epsilon and velocities that differ from vertex to vertex.
struct Example
{
  SurfaceMesh mesh;
  MeshTopology topology;
  SurfaceGeometry geometry;
  std::vector<double> epsilon;
  std::vector<Vec3> velocity;
  std::vector<char> isKnown;
  std::vector<Vec3> known;

  explicit Example(const SurfaceMesh& surface)
    : mesh(surface)
    , topology(mesh)
    , geometry(topology)
    , isKnown(mesh.points.size(), 0)
    , known(mesh.points.size(), Vec3(std::nan(""), 0.0, 0.0)) // must not be read
  {
    this->geometry.update(this->mesh, Execution());
    for (const Vec3& p : this->mesh.points)
    {
      this->epsilon.push_back(1.0 + 0.9 * std::sin(4.0 * p.x() + p.y()));
      this->velocity.emplace_back(std::cos(p.y()), p.x() * p.z(), 0.3);
    }
  }

  std::vector<Vec3> step(double tau) const
  {
    SemiImplicitStep evolution;
    return evolution.displacement(this->geometry,
      { this->epsilon, this->velocity, this->isKnown, this->known, tau }, 1e-13, Execution());
  }

  /// (I + tau diag(epsilon / mu) L) F^(t+tau) = F^t + tau v, solved as it is printed (4.16).
  Eigen::MatrixXd denseStep(double tau) const
  {
    const Eigen::Index n = this->mesh.vertexCount();
    Eigen::MatrixXd A(this->geometry.volumes().stiffness());
    Eigen::MatrixXd b(n, 3);
    for (Eigen::Index i = 0; i < n; ++i)
    {
      const auto k = static_cast<std::size_t>(i);
      A.row(i) *= tau * this->epsilon[k] / this->geometry.coVolumes()[k];
      A(i, i) += 1.0;
      b.row(i) = this->mesh.points[k] + tau * this->velocity[k];
      if (this->isKnown[k])
      {
        A.row(i).setZero();
        A(i, i) = 1.0;
        b.row(i) = this->mesh.points[k] + this->known[k];
      }
    }
    return A.partialPivLu().solve(b);
  }

  void expectDense(double tau) const
  {
    const std::vector<Vec3> displacement = this->step(tau);
    const Eigen::MatrixXd expected = this->denseStep(tau);
    for (std::size_t i = 0; i < displacement.size(); ++i)
    {
      const Vec3 position = this->mesh.points[i] + displacement[i];
      EXPECT_LT((position.transpose() - expected.row(static_cast<Eigen::Index>(i))).norm(), 1e-10);
    }
  }
};

} // namespace

TEST(SemiImplicitStep, SolvesTheSystemAsPrinted)
{
  Example(shapes::bumpySphere(2)).expectDense(0.01);
  Example(cubeSphere(5)).expectDense(0.3);
}

TEST(SemiImplicitStep, HandlesEpsilonOverManyOrders)
{
  Example example(shapes::bumpySphere(2));
  for (std::size_t i = 0; i < example.epsilon.size(); ++i)
  {
    example.epsilon[i] = std::pow(10.0, -static_cast<double>(i % 9));
  }
  example.expectDense(0.01);
}

TEST(SemiImplicitStep, RowsWithoutEpsilonMoveExplicitly)
{
  Example example(shapes::bumpySphere(2));
  for (std::size_t i = 0; i < example.epsilon.size(); i += 3)
  {
    example.epsilon[i] = i % 2 == 0 ? 0.0 : 1e-15;
  }
  example.expectDense(0.02);
  const std::vector<Vec3> displacement = example.step(0.02);
  for (std::size_t i = 0; i < displacement.size(); i += 3)
  {
    EXPECT_EQ(displacement[i], Vec3(0.02 * example.velocity[i]));
  }
  example.epsilon.assign(example.epsilon.size(), 0.0);
  EXPECT_EQ(example.step(0.02)[5], Vec3(0.02 * example.velocity[5]));
}

TEST(SemiImplicitStep, GivenDisplacementsAreConditionsForTheOthers)
{
  Example example(shapes::sheet(6, true));
  for (Index i = 0; i < example.mesh.vertexCount(); ++i)
  {
    if (example.topology.isBoundary(i))
    {
      const auto k = static_cast<std::size_t>(i);
      example.isKnown[k] = 1;
      example.known[k] = Vec3(0.01, 0.0, 0.1 * example.mesh.points[k].x());
    }
  }
  example.expectDense(0.05);
  EXPECT_EQ(example.step(0.05)[0], example.known[0]);
}

TEST(SemiImplicitStep, LosesNothingFarFromTheOrigin)
{
  const Example here(shapes::bumpySphere(3));
  Example there(shapes::transformed(here.mesh, 1.0, Vec3(1e6, 2e6, -1e6)));
  there.epsilon = here.epsilon;
  there.velocity = here.velocity;
  const std::vector<Vec3> a = here.step(0.01);
  const std::vector<Vec3> b = there.step(0.01);
  for (std::size_t i = 0; i < a.size(); ++i)
  {
    EXPECT_LT((a[i] - b[i]).norm(), 1e-8);
  }
}

TEST(SemiImplicitStep, ASphereShrinksByOneImplicitEulerStep)
{
  // r_1 (1 + 2 tau / r_0^2) = r_0 for the exact curvature.
  const Example sphere(icosphere(4));
  SemiImplicitStep evolution;
  const std::vector<double> epsilon(sphere.epsilon.size(), 1.0);
  const std::vector<Vec3> none(epsilon.size(), Vec3::Zero());
  const std::vector<Vec3> move = evolution.displacement(
    sphere.geometry, { epsilon, none, sphere.isKnown, none, 0.1 }, 1e-12, Execution());
  for (std::size_t i = 0; i < move.size(); ++i)
  {
    EXPECT_NEAR((sphere.mesh.points[i] + move[i]).norm(), 1.0 / 1.2, 2e-3);
  }
}
