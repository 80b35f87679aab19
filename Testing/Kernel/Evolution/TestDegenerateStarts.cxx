// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

// What a remeshed flow makes of a start whose faces have next to no area: few vertices, or a
// sentence.

#include "Evolution/SurfaceFlow.h"

#include "Errors.h"
#include "Evolution/DegenerateStarts.h"
#include "Evolution/EvolutionFields.h"
#include "Evolution/SurfaceRemesher.h"
#include "Remeshing/CurvedReference.h"
#include "Remeshing/Remeshing.h"
#include "Remeshing/SizingField.h"
#include "Shapes/MeshVariants.h"
#include "StartSurface/PrimitiveSurfaces.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

using namespace evolving;

namespace
{

/// Of the components that there are, at most two, and of what is fine already.
constexpr Index FewVertices = 5000;

void followRemeshed(const degenerate::Start& start, ElementSizing sizing, bool hasField)
{
  FlowOptions options;
  options.numberOfSteps = 2;
  const auto field = hasField ? shapes::sphereField(21, 1.6, 0.3) : nullptr;
  const auto remesher = std::make_shared<SurfaceRemesher>(
    start.mesh, SurfaceRemeshingOptions{ sizing, 0.0, BoundaryMode::Fixed });
  SurfaceFlow flow(
    std::make_shared<const SurfaceMesh>(start.mesh), field, remesher, options, Execution());
  while (!flow.isFinished())
  {
    flow.step();
    EXPECT_LT(flow.mesh().vertexCount(), FewVertices) << start.name;
    EXPECT_TRUE(std::all_of(flow.mesh().points.begin(), flow.mesh().points.end(),
      [](const Vec3& p) { return p.allFinite(); }))
      << start.name;
  }
}

} // namespace

TEST(DegenerateStarts, HaveFewVerticesAfterRemeshing)
{
  for (const degenerate::Start& start : degenerate::starts(1e-6))
  {
    followRemeshed(start, ElementSizing::Uniform, true);
  }
  for (const degenerate::Start& start : degenerate::starts(1e-14))
  {
    followRemeshed(start, ElementSizing::CurvatureAdaptive, false);
  }
}

TEST(DegenerateStarts, WithoutAreaAreRefused)
{
  SurfaceMesh noFaces;
  noFaces.points = { Vec3(0, 0, 0), Vec3(1, 0, 0) };
  for (const SurfaceMesh& mesh : { SurfaceMesh(), noFaces, degenerate::cap(0.0) })
  {
    EXPECT_THROW(followRemeshed({ "no area", mesh }, ElementSizing::Uniform, false), InputError);
  }
}

TEST(DegenerateStarts, AFaceWithoutAreaBesideOthersIsHarmless)
{
  const SurfaceMesh line = shapes::transformed(degenerate::cap(0.0), 1.0, Vec3(3, 0, 0));
  followRemeshed({ "line", shapes::merged(icosphere(2), line) }, ElementSizing::Uniform, true);
}

TEST(DegenerateStarts, SplittingEndsWhereTheVerticesAreTooMany)
{
  RemeshingOptions options;
  options.mostVertices = 1000.0;
  for (const SurfaceMesh& mesh : { icosphere(2), degenerate::needle(1e-14) })
  {
    EditableSurface surface(mesh);
    setUniformSizes(surface, 1e-4);
    EXPECT_THROW(remeshOnce(surface, CurvedReference(mesh), options), InputError);
    EXPECT_LT(surface.vertexSlots(), 5000); // a sweep more
  }
}
