// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

// Where flows that hold the volume end: in balls, of the volume of each component.

#include "Errors.h"
#include "Evolution/EvolutionFields.h"
#include "Mesh/BoundaryLoops.h"
#include "Mesh/MeshQuality.h"
#include "Operators/EnclosedVolume.h"
#include "Shapes/MeshVariants.h"
#include "Shapes/SampledOnGrid.h"
#include "Shapes/Sheets.h"
#include "Shapes/Spheres.h"
#include "Shapes/Tubes.h"
#include "StartSurface/PrimitiveSurfaces.h"
#include "VolumeFlows/VolumeFlowRuns.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace evolving;

namespace
{

constexpr double Rounding = 1e-12; ///< of a volume

SurfaceMesh ellipsoid321(int level)
{
  return shapes::ellipsoid(level, Vec3(3.0, 2.0, 1.0));
}

/// 4 x 1 x 1, of triangles.
SurfaceMesh cuboid(Index divisions)
{
  std::mt19937 random(1);
  SurfaceMesh quads = cubeSphere(divisions);
  for (Vec3& p : quads.points)
  {
    p /= p.cwiseAbs().maxCoeff();
    p = p.cwiseProduct(Vec3(2.0, 0.5, 0.5));
  }
  return shapes::triangulated(quads, random);
}

void expectBall(const SurfaceMesh& mesh, double volume, double tolerance)
{
  const double radius = flows::radiusOfBall(volume);
  const flows::Radii radii = flows::radiiOf(mesh);
  EXPECT_NEAR(radii.least / radius, 1.0, tolerance);
  EXPECT_NEAR(radii.largest / radius, 1.0, tolerance);
}

} // namespace

TEST(VolumePreservingFlow, MakesABallOfAnEllipsoid)
{
  const SurfaceMesh start = ellipsoid321(4);
  SurfaceFlow flow = flows::remeshed(start, flows::volumePreserving(100));
  const flows::Ledger ledger = flows::runWithLedger(flow);
  EXPECT_LT(ledger.volumeDrift, Rounding);
  EXPECT_LT(ledger.areaGrowth, 0.0);
  expectBall(flow.mesh(), signedVolume(start), 3e-3);
}

TEST(VolumePreservingFlow, HoldsTheVolumeWhateverElseMoves)
{
  for (const double timeStep : { 1e-3, 0.05, 1.0 })
  {
    FlowOptions options = flows::volumePreserving(12, timeStep);
    options.redistribution.volume = 10.0;
    options.redistribution.angle = 3.0;
    options.smoothingSteps = 3;
    options.smoothingSpeed = 0.1;
    SurfaceFlow given(ellipsoid321(3), nullptr, options);
    EXPECT_LT(flows::runWithLedger(given).volumeDrift, Rounding) << timeStep;
    SurfaceRemeshingOptions uniform;
    SurfaceFlow renewed(std::make_shared<const SurfaceMesh>(ellipsoid321(3)), nullptr,
      std::make_shared<SurfaceRemesher>(ellipsoid321(3), uniform), options);
    EXPECT_LT(flows::runWithLedger(renewed).volumeDrift, Rounding) << timeStep;
    EXPECT_NE(renewed.mesh().vertexCount(), 642);
  }
}

TEST(VolumePreservingFlow, SmoothsNoiseAndTakesNothingAway)
{
  const SurfaceMesh clean = shapes::unitIcosphere(4);
  const SurfaceMesh noisy = shapes::shaken(clean, 0.02, 3);
  SurfaceFlow flow(noisy, nullptr, flows::volumePreserving(10, 1e-3));
  const flows::Ledger ledger = flows::runWithLedger(flow);
  EXPECT_LT(ledger.volumeDrift, Rounding);
  const auto roughness = [](const SurfaceMesh& mesh)
  { return flows::radiiOf(mesh).largest - flows::radiiOf(mesh).least; };
  EXPECT_LT(roughness(flow.mesh()), 0.2 * roughness(noisy));
}

TEST(VolumePreservingFlow, KeepsPolygonsAndUnits)
{
  SurfaceMesh quads = shapes::transformed(cubeSphere(8), 1e-3, Vec3(5.0, 0.0, 0.0));
  for (Vec3& p : quads.points)
  {
    p.z() *= 1.5;
  }
  FlowOptions options = flows::volumePreserving(40);
  options.relativeUnits = true;
  SurfaceFlow flow(quads, nullptr, options);
  const flows::Ledger ledger = flows::runWithLedger(flow);
  EXPECT_LT(ledger.volumeDrift, 1e-10); // 5 / 0.001 of rounding
  EXPECT_LT(ledger.areaGrowth, 0.0);
  EXPECT_FALSE(flow.mesh().hasOnlyTriangles());
}

TEST(VolumeFlows, KeepTheVolumeOfEachComponent)
{
  const SurfaceMesh small = shapes::transformed(ellipsoid321(2), 0.3, Vec3(4.0, 0.0, 0.0));
  const SurfaceMesh cavity = reversed(shapes::transformed(ellipsoid321(2), 0.2, Vec3::Zero()));
  const SurfaceMesh start = shapes::merged(shapes::merged(ellipsoid321(3), small), cavity);
  const std::vector<double> before = componentVolumes(start, MeshTopology(start));
  for (const FlowOptions& options : { flows::volumePreserving(30), flows::surfaceDiffusion(30) })
  {
    SurfaceFlow flow = flows::remeshed(start, options);
    flows::runWithLedger(flow);
    const std::vector<double> after = componentVolumes(flow.mesh(), MeshTopology(flow.mesh()));
    ASSERT_EQ(after.size(), before.size());
    for (std::size_t c = 0; c < after.size(); ++c)
    {
      EXPECT_NEAR(after[c] / before[c], 1.0, 1e-11) << c;
    }
    EXPECT_FALSE(flow.extinctionTime());
  }
}

TEST(VolumePreservingFlow, MakesASphericalCapInAFixedBoundary)
{
  // Of a dent whose boundary is a circle: a soap film with air below it.
  SurfaceMesh start = shapes::disc(16);
  for (Vec3& p : start.points)
  {
    const double squared = p.head<2>().squaredNorm();
    p.z() = 0.8 * (1.0 - squared) * (1.0 + p.x());
  }
  FlowOptions options = flows::volumePreserving(100, 0.02);
  SurfaceFlow flow(start, nullptr, options);
  const double volume = signedVolume(start, Vec3::Zero());
  while (!flow.isFinished())
  {
    flow.step();
  }
  EXPECT_EQ(flow.stopReason(), "");
  EXPECT_NEAR(signedVolume(flow.mesh(), Vec3::Zero()) / volume, 1.0, 1e-12);
  // A cap of height t over the unit circle has the volume pi t (3 + t^2) / 6.
  double height = 1.0;
  for (int k = 0; k < 50; ++k)
  {
    height = 6.0 * std::abs(volume) / (Pi * (3.0 + height * height));
  }
  const double radius = 0.5 * (1.0 + height * height) / height;
  const Vec3 center(0.0, 0.0, height - radius);
  const flows::Radii radii = flows::radiiOf(flow.mesh(), center);
  EXPECT_NEAR(radii.least / radius, 1.0, 0.01);
  EXPECT_NEAR(radii.largest / radius, 1.0, 0.01);
}

TEST(SurfaceDiffusionFlow, MakesABallOfACuboid)
{
  const SurfaceMesh start = cuboid(20); // 2402 vertices
  SurfaceFlow flow = flows::remeshed(start, flows::surfaceDiffusion(60));
  const flows::Ledger ledger = flows::runWithLedger(flow);
  EXPECT_LT(ledger.volumeDrift, Rounding);
  EXPECT_LE(ledger.areaGrowth, 0.0);
  expectBall(flow.mesh(), 4.0, 5e-3);
}

TEST(SurfaceDiffusionFlow, GrowsInUnitsOfLengthToTheFourth)
{
  FlowOptions options = flows::surfaceDiffusion(5, 1e-3);
  options.relativeUnits = true;
  SurfaceFlow one(ellipsoid321(2), nullptr, options);
  SurfaceFlow tenfold(shapes::transformed(ellipsoid321(2), 10.0, Vec3::Zero()), nullptr, options);
  while (!one.isFinished())
  {
    one.step();
    tenfold.step();
  }
  EXPECT_NEAR(tenfold.record().area / one.record().area, 100.0, 1e-7);
}

TEST(VolumeFlows, RefuseFieldsAndBoundariesInASentence)
{
  const auto field =
    shapes::image(shapes::cubicGrid(9, 2.0), [](const Vec3& p) { return p.norm(); });
  const SurfaceMesh open = shapes::openCylinder(8, 4, 1.0, 1.0);
  FlowOptions sliding = flows::volumePreserving(3, 0.01);
  sliding.boundaryMode = BoundaryMode::SlideAlong;
  EXPECT_THROW(SurfaceFlow(open, nullptr, sliding), InputError);
  EXPECT_THROW(SurfaceFlow(open, nullptr, flows::surfaceDiffusion(3, 0.01)), InputError);
  for (const FlowOptions& options :
    { flows::volumePreserving(3, 0.01), flows::surfaceDiffusion(3, 0.01) })
  {
    try
    {
      SurfaceFlow flow(icosphere(1), field, options);
      FAIL();
    }
    catch (const InputError& error)
    {
      const std::string text = error.what();
      EXPECT_NE(text.find("got a field, expected none"), std::string::npos) << text;
    }
  }
}
