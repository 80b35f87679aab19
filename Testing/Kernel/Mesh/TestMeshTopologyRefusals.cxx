// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Checks/Refusal.h"
#include "Errors.h"
#include "Mesh/MeshTopology.h"
#include "Shapes/Polyhedra.h"
#include "Shapes/Sheets.h"
#include "Shapes/Spheres.h"
#include "Shapes/Tubes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <utility>

namespace evolving
{

using namespace evolving::shapes;

namespace
{

std::string refusalOf(const SurfaceMesh& mesh)
{
  return checks::refusalOf([&] { MeshTopology{ mesh }; });
}

bool startsWith(const std::string& text, const std::string& beginning)
{
  return text.compare(0, beginning.size(), beginning) == 0;
}

TEST(MeshTopologyRefusals, AMoebiusBandInOneSentence)
{
  for (const Index count : { 3, 4, 9, 30 })
  {
    const std::string message = refusalOf(moebiusBand(count));
    EXPECT_TRUE(startsWith(message, "The two faces at the edge between points ")) << message;
    EXPECT_NE(message.find("opposite orientations"), std::string::npos);
    EXPECT_EQ(std::count(message.begin(), message.end(), '.'), 1);
  }
}

TEST(MeshTopologyRefusals, AFlippedFace)
{
  SurfaceMesh mesh = unitIcosphere(1);
  std::swap(mesh.cornerVertices[30], mesh.cornerVertices[31]);
  EXPECT_NE(refusalOf(mesh).find("opposite orientations"), std::string::npos);
}

TEST(MeshTopologyRefusals, AnEdgeOfThreeFaces)
{
  const SurfaceMesh fins =
    makeMesh({ { 0, 0, 0 }, { 0, 0, 1 }, { 1, 0, 0 }, { 0, 1, 0 }, { -1, -1, 0 } },
      { { 0, 1, 2 }, { 1, 0, 3 }, { 0, 1, 4 } });
  EXPECT_TRUE(startsWith(
    refusalOf(fins), "The edge between points 0 and 1 belongs to 3 faces, expected at most 2"));
}

TEST(MeshTopologyRefusals, EveryKindOfBowTie)
{
  const SurfaceMesh open =
    makeMesh({ { 0, 0, 0 }, { 1, -1, 0 }, { 1, 1, 0 }, { -1, 1, 0 }, { -1, -1, 0 } },
      { { 0, 1, 2 }, { 0, 3, 4 } });
  const SurfaceMesh closed = cellSurface({ { 0, 0, 0 }, { 1, 1, 1 } });
  // The disc's centre becomes the top of a tetrahedron as well.
  SurfaceMesh mixed = fan(5);
  mixed.addPoint({ 1, 0, 1 });
  mixed.addPoint({ -1, 1, 1 });
  mixed.addFace({ 0, 6, 7 });
  for (const SurfaceMesh& mesh : { open, closed, mixed })
  {
    const std::string message = refusalOf(mesh);
    EXPECT_TRUE(startsWith(message, "Several separate fans of faces meet at point ")) << message;
  }
}

TEST(MeshTopologyRefusals, AnEdgeFromAVertexToItself)
{
  const SurfaceMesh mesh = makeMesh({ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 } }, { { 0, 1, 1, 2 } });
  EXPECT_TRUE(startsWith(refusalOf(mesh), "An edge joins point 1 to itself"));
}

} // namespace

} // namespace evolving
