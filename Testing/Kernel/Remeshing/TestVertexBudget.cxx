// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Remeshing/VertexBudget.h"

#include "Errors.h"
#include "Mesh/Angles.h"
#include "Remeshing/EditingChecks.h"
#include "Remeshing/RemeshingShapes.h"
#include "Remeshing/SizingField.h"
#include "StartSurface/PrimitiveSurfaces.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>

namespace
{

using namespace evolving;
using namespace evolving::editing;

TEST(VertexBudget, IsWhatTheAreaNeeds)
{
  EditableSurface sphere(icosphere(3));
  setUniformSizes(sphere, 0.1);
  // 2 A / (sqrt(3) s^2), with a little less area than the sphere's.
  const double vertices = expectedVertices(sphere);
  EXPECT_NEAR(vertices, 4.0 * Pi * 2.0 / (std::sqrt(3.0) * 0.01), 20.0);
  EXPECT_NO_THROW(requireFewVertices(sphere, 0.1, 1.001 * vertices));
  EXPECT_THROW(requireFewVertices(sphere, 0.1, 0.999 * vertices), InputError);
}

TEST(VertexBudget, WhatItProposesPasses)
{
  EditableSurface sphere(icosphere(2));
  setUniformSizes(sphere, 1e-4);
  double proposed = 0.0;
  try
  {
    requireFewVertices(sphere, 1e-4);
    FAIL() << "more than a billion vertices";
  }
  catch (const InputError& error)
  {
    const std::string sentence = error.what();
    const std::string before = "at least ";
    EXPECT_EQ(sentence.back(), '.');
    proposed = std::stod(sentence.substr(sentence.find(before) + before.size()));
  }
  setUniformSizes(sphere, proposed);
  EXPECT_NO_THROW(requireFewVertices(sphere, proposed));
  EXPECT_GT(expectedVertices(sphere), 0.8 * MostVertices);
}

TEST(VertexBudget, NeedlesCountByTheirLength)
{
  // Next to no area, but edges that must be cut into 10,000 pieces.
  for (const double width : { 1e-3, 1e-6, 1e-14, 0.0 })
  {
    SurfaceMesh mesh;
    mesh.points = { Vec3(0, 0, 0), Vec3(width, 0, 0), Vec3(0, 1, 0) };
    mesh.addFace({ 0, 1, 2 });
    EditableSurface needle(mesh);
    setUniformSizes(needle, 1e-4);
    const double vertices = verticesToMake(needle);
    EXPECT_GE(vertices, 1e4) << width;
    EXPECT_LE(vertices, 1e5) << width;
    EXPECT_THROW(requireFewVertices(needle, 1e-4, 0.9 * vertices), InputError);
    EXPECT_NO_THROW(requireFewVertices(needle, 1e-4, 1.1 * vertices));
    setUniformSizes(needle, 2.0);
    EXPECT_LT(verticesToMake(needle), 1.0) << width;
  }
}

TEST(VertexBudget, OfRoundFacesTheAreaDecides)
{
  EditableSurface sphere(icosphere(2));
  for (const double size : { 1.0, 0.1, 0.01 })
  {
    setUniformSizes(sphere, size);
    const double vertices = expectedVertices(sphere);
    EXPECT_NEAR(verticesToMake(sphere), vertices, 1e-12 * vertices) << size;
  }
}

} // namespace
