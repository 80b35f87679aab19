// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "VolumeFlows/SurfaceDiffusion.h"

#include "Mesh/MeshTopology.h"
#include "Operators/EnclosedVolume.h"
#include "Shapes/MeshVariants.h"
#include "Shapes/Spheres.h"
#include "ThreadedExecution.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace evolving;

namespace
{

struct Step
{
  explicit Step(const SurfaceMesh& start, double timeStep, const Execution& execution = {})
    : mesh(start)
    , topology(start)
    , geometry(topology)
  {
    this->geometry.update(start, execution);
    const std::vector<char> none(start.points.size(), 0);
    SurfaceDiffusion diffusion(1.0, 1e-12);
    this->velocity = diffusion.velocity(start, this->geometry, none, timeStep, execution);
    this->iterations = diffusion.iterations();
    for (std::size_t i = 0; i < start.points.size(); ++i)
    {
      this->mesh.points[i] += timeStep * this->velocity[i];
    }
  }

  SurfaceMesh mesh; ///< after the step
  MeshTopology topology;
  SurfaceGeometry geometry; ///< before it
  std::vector<Vec3> velocity;
  int iterations = 0;
};

} // namespace

TEST(SurfaceDiffusion, MovesNoVolumeInFirstOrder)
{
  const SurfaceMesh start = shapes::bumpySphere(3);
  const std::vector<Vec3> gradient = volumeGradient(start);
  for (const double timeStep : { 1e-6, 1e-3, 1.0 })
  {
    const Step step(start, timeStep);
    double flux = 0.0;
    double size = 0.0;
    for (std::size_t i = 0; i < gradient.size(); ++i)
    {
      flux += gradient[i].dot(step.velocity[i]);
      size += std::abs(gradient[i].dot(step.velocity[i]));
    }
    EXPECT_LT(std::abs(flux), 1e-8 * size) << timeStep;
  }
}

TEST(SurfaceDiffusion, LosesAreaHoweverLongTheStep)
{
  for (const SurfaceMesh& start :
    { shapes::bumpySphere(3), shapes::unevenSphere(3), shapes::ellipsoid(3, Vec3(3.0, 2.0, 1.0)) })
  {
    for (const double timeStep : { 1e-6, 1e-3, 1.0, 1e3 })
    {
      EXPECT_LT(surfaceArea(Step(start, timeStep).mesh), surfaceArea(start)) << timeStep;
    }
  }
}

TEST(SurfaceDiffusion, LetsASphereRest)
{
  // But for what its vertices differ in their curvatures.
  const SurfaceMesh sphere = shapes::unitIcosphere(3);
  const Step step(sphere, 1.0);
  double farthest = 0.0;
  for (std::size_t i = 0; i < sphere.points.size(); ++i)
  {
    farthest = std::max(farthest, (step.mesh.points[i] - sphere.points[i]).norm());
  }
  EXPECT_LT(farthest, 5e-3);
}

TEST(SurfaceDiffusion, TakesHardlyMoreIterationsOnFinerMeshes)
{
  const int coarse = Step(shapes::bumpySphere(2), 1e-3).iterations;
  const int fine = Step(shapes::bumpySphere(5), 1e-3).iterations; // 10,242 vertices: multigrid
  EXPECT_LT(coarse, 60);
  EXPECT_LT(fine, 150);
}

TEST(SurfaceDiffusion, HasTheSameBitsForAnyNumberOfThreads)
{
  const SurfaceMesh start = shapes::bumpySphere(5);
  const std::vector<Vec3> one = Step(start, 1e-3).velocity;
  for (const int threads : { 2, 8 })
  {
    EXPECT_EQ(one, Step(start, 1e-3, threadedExecution(threads, 1)).velocity) << threads;
  }
}
