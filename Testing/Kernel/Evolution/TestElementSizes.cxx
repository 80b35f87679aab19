// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Evolution/ElementSizes.h"

#include "Errors.h"
#include "Evolution/DegenerateStarts.h"
#include "Remeshing/VertexBudget.h"
#include "Shapes/MeshVariants.h"
#include "StartSurface/PrimitiveSurfaces.h"

#include <gtest/gtest.h>

#include <algorithm>

using namespace evolving;

namespace
{

constexpr ElementSizing Both[] = { ElementSizing::Uniform, ElementSizing::CurvatureAdaptive };
constexpr double LongEdges = 1e3; ///< only the least number of vertices counts

double verticesOf(const SurfaceMesh& mesh, double edgeLength, ElementSizing sizing)
{
  EditableSurface surface(mesh);
  setElementSizes(surface, edgeLength, sizing, MostVertices);
  return verticesToMake(surface);
}

SurfaceMesh needlesApart(int count)
{
  SurfaceMesh all;
  for (int i = 0; i < count; ++i)
  {
    all = shapes::merged(all, degenerate::needle(1e-6, Vec3(i, 0, 0)));
  }
  return all;
}

} // namespace

TEST(ElementSizes, AComponentHasSomeHundredVertices)
{
  const SurfaceMesh two =
    shapes::merged(icosphere(3), shapes::transformed(icosphere(3), 1e-6, Vec3(3.0, 0.0, 0.0)));
  for (const ElementSizing sizing : Both)
  {
    const double ofOne = verticesOf(icosphere(3), LongEdges, sizing);
    EXPECT_GT(ofOne, 50.0);
    EXPECT_LT(ofOne, 300.0);
    const double ofBoth = verticesOf(two, LongEdges, sizing);
    EXPECT_GT(ofBoth, 1.95 * ofOne);
    EXPECT_LT(ofBoth, 3.1 * ofOne); // the small one is the curved one
  }
}

TEST(ElementSizes, ANeedleHasNoMoreThanAnyOther)
{
  for (const double width : { 1e-3, 1e-6, 1e-10, 1e-14 })
  {
    for (const degenerate::Start& start : degenerate::starts(width))
    {
      for (const ElementSizing sizing : Both)
      {
        const double vertices = verticesOf(start.mesh, 0.2, sizing);
        EXPECT_GT(vertices, 20.0) << start.name << " " << width;
        EXPECT_LT(vertices, 3e4) << start.name << " " << width;
      }
    }
  }
}

TEST(ElementSizes, ManyComponentsHaveFewerEach)
{
  for (const ElementSizing sizing : Both)
  {
    // Four times as many as the components' ten thousand: needles.
    EXPECT_LT(verticesOf(needlesApart(3000), LongEdges, sizing), 1e5);
  }
}

TEST(ElementSizes, TooShortEdgesAreRefused)
{
  for (const ElementSizing sizing : Both)
  {
    EXPECT_THROW(verticesOf(icosphere(2), 1e-6, sizing), InputError);
    EXPECT_THROW(verticesOf(degenerate::needle(1e-14), 1e-9, sizing), InputError);
  }
}
