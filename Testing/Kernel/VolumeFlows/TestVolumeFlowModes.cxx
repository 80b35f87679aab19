// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

// A sphere with a small mode of degree l: each flow lets it fade at a known rate.

#include "Shapes/Spheres.h"
#include "VolumeFlows/VolumeFlowRuns.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace evolving;

namespace
{

constexpr double Amplitude = 1e-3;

/// Legendre's polynomials.
double legendre(int degree, double z)
{
  return degree == 2 ? 0.5 * (3.0 * z * z - 1.0) : 0.5 * z * (5.0 * z * z - 3.0);
}

SurfaceMesh sphereWithMode(int level, int degree)
{
  SurfaceMesh mesh = shapes::unitIcosphere(level);
  for (Vec3& p : mesh.points)
  {
    p *= 1.0 + Amplitude * legendre(degree, p.z());
  }
  return mesh;
}

/// Of the mode in |F|, by the co-volumes.
double amplitudeOf(const SurfaceFlow& flow, int degree)
{
  double product = 0.0;
  double square = 0.0;
  for (std::size_t i = 0; i < flow.mesh().points.size(); ++i)
  {
    const Vec3& p = flow.mesh().points[i];
    const double mode = legendre(degree, p.normalized().z());
    product += flow.arrays().coVolume[i] * mode * (p.norm() - 1.0);
    square += flow.arrays().coVolume[i] * mode * mode;
  }
  return product / square;
}

/// How far the measured rate is from the exact one, of that.
double errorOfRate(const SurfaceMesh& start, FlowOptions options, int degree, double rate)
{
  const double time = 1.0 / rate;
  options.timeStep = time / options.numberOfSteps;
  SurfaceFlow flow(start, nullptr, options);
  const double before = amplitudeOf(flow, degree);
  while (!flow.isFinished())
  {
    flow.step();
  }
  EXPECT_EQ(flow.stopReason(), "");
  const double measured = std::log(before / amplitudeOf(flow, degree)) / time;
  return std::abs(measured / rate - 1.0);
}

/// Steps that go with the square of the edges: orders over three levels of the sphere.
void expectSecondOrder(const FlowOptions& options, int degree, double rate)
{
  double coarser = 0.0;
  for (int level = 2; level <= 4; ++level)
  {
    FlowOptions here = options;
    here.numberOfSteps = 4 << (2 * (level - 2));
    const double error = errorOfRate(sphereWithMode(level, degree), here, degree, rate);
    if (level > 2)
    {
      // 162 points are few.
      EXPECT_GT(std::log2(coarser / error), level == 3 ? 1.45 : 1.75)
        << "level " << level << ", degree " << degree;
    }
    coarser = error;
  }
  EXPECT_LT(coarser, 0.03);
}

} // namespace

TEST(VolumePreservingFlow, LetsModesFadeAtTheirRatesWithSecondOrder)
{
  // (l - 1)(l + 2)
  expectSecondOrder(flows::volumePreserving(0), 2, 4.0);
  expectSecondOrder(flows::volumePreserving(0), 3, 10.0);
}

TEST(SurfaceDiffusionFlow, LetsModesFadeAtTheirRatesWithSecondOrder)
{
  // (l - 1) l (l + 1)(l + 2)
  expectSecondOrder(flows::surfaceDiffusion(0), 2, 24.0);
  expectSecondOrder(flows::surfaceDiffusion(0), 3, 120.0);
}
