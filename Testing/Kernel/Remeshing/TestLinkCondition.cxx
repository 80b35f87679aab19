// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Errors.h"
#include "Remeshing/EditableSurface.h"
#include "Remeshing/EditingChecks.h"
#include "Remeshing/RemeshingShapes.h"
#include "Shapes/MeshVariants.h"
#include "Shapes/Polyhedra.h"
#include "Shapes/Sheets.h"
#include "Shapes/Tubes.h"
#include "StartSurface/PrimitiveSurfaces.h"
#include "StartSurface/QuadSplitting.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <string>
#include <vector>

namespace
{

using namespace evolving;

using namespace evolving::shapes;
using namespace evolving::editing;

/// The triangles as lists of vertices, each from its smallest on; in order.
using Faces = std::vector<std::array<Index, 3>>;

Faces sorted(Faces faces)
{
  for (std::array<Index, 3>& face : faces)
  {
    std::rotate(face.begin(), std::min_element(face.begin(), face.end()), face.end());
  }
  std::sort(faces.begin(), faces.end());
  return faces;
}

Faces facesOf(const EditableSurface& surface)
{
  Faces faces;
  for (Index f = 0; f < surface.faceSlots(); ++f)
  {
    if (surface.hasFace(f))
    {
      faces.push_back({ surface.from(3 * f), surface.from(3 * f + 1), surface.from(3 * f + 2) });
    }
  }
  return sorted(faces);
}

/// a becomes b; faces that had both are gone.
Faces collapsed(Faces faces, Index a, Index b)
{
  for (std::array<Index, 3>& face : faces)
  {
    std::replace(face.begin(), face.end(), a, b);
  }
  const auto isGone = [](const std::array<Index, 3>& f)
  { return f[0] == f[1] || f[1] == f[2] || f[2] == f[0]; };
  faces.erase(std::remove_if(faces.begin(), faces.end(), isGone), faces.end());
  return sorted(faces);
}

SurfaceMesh meshOf(const Faces& faces, const std::vector<Vec3>& points)
{
  SurfaceMesh mesh;
  mesh.points = points;
  for (const std::array<Index, 3>& face : faces)
  {
    mesh.addFace({ face[0], face[1], face[2] });
  }
  return mesh;
}

/// Are the faces a surface of the same kind, and one vertex fewer?
bool isSameWithout(const Faces& faces, const SurfaceMesh& before)
{
  const SurfaceMesh mesh = meshOf(faces, before.points);
  try
  {
    return kindOf(mesh) == kindOf(before) && !hasTwinFaces(mesh) &&
      summarizeTopology(mesh).usedVertices == summarizeTopology(before).usedVertices - 1;
  }
  catch (const InputError&)
  {
    return false;
  }
}

/// Every collapse of a mesh, against the same on lists of vertices.
void expectCollapsesAsOnLists(const SurfaceMesh& mesh)
{
  const EditableSurface surface(mesh);
  const Faces faces = facesOf(surface);
  for (const Index e : edgesOf(surface))
  {
    const std::string edge =
      std::to_string(surface.from(e)) + " to " + std::to_string(surface.to(e));
    const Faces expected = collapsed(faces, surface.from(e), surface.to(e));
    ASSERT_EQ(surface.canCollapse(e), isSameWithout(expected, mesh)) << edge;
    if (surface.canCollapse(e))
    {
      EditableSurface edited = surface;
      edited.collapse(e);
      ASSERT_EQ(facesOf(edited), expected) << edge;
      expectSound(edited, kindOf(mesh));
    }
  }
}

/// Every flip of a mesh: allowed just where the surface stays one.
void expectFlipsAsOnLists(const SurfaceMesh& mesh)
{
  const EditableSurface surface(mesh);
  for (const Index e : edgesOf(surface))
  {
    const Index o = surface.opposite(e);
    if (o == NoIndex)
    {
      ASSERT_FALSE(surface.canFlip(e));
      continue;
    }
    const Index c = surface.apex(e);
    const Index d = surface.apex(o);
    Faces expected = facesOf(surface);
    const auto replace = [&](const std::array<Index, 3>& old, const std::array<Index, 3>& now)
    { *std::find(expected.begin(), expected.end(), sorted({ old })[0]) = now; };
    replace({ surface.from(e), surface.to(e), c }, { d, surface.to(e), c });
    replace({ surface.to(e), surface.from(e), d }, { c, surface.from(e), d });
    expected = sorted(expected);
    const SurfaceMesh flipped = meshOf(expected, mesh.points);
    bool isSurface = !hasTwinFaces(flipped);
    try
    {
      isSurface = isSurface && kindOf(flipped) == kindOf(mesh);
    }
    catch (const InputError&)
    {
      isSurface = false;
    }
    ASSERT_EQ(surface.canFlip(e), isSurface) << surface.from(e) << " to " << surface.to(e);
    if (isSurface)
    {
      EditableSurface edited = surface;
      edited.flip(e);
      ASSERT_EQ(facesOf(edited), expected);
      expectSound(edited, kindOf(mesh));
    }
  }
}

/// Small surfaces, on which nearly everything is an exception.
std::vector<SurfaceMesh> smallSurfaces()
{
  std::vector<SurfaceMesh> meshes = { cornerTetrahedron(), icosphere(0), icosphere(1),
    shapes::torus(3, 3, 2.0, 0.7), shapes::torus(4, 3, 2.0, 0.7), shapes::torus(5, 4, 2.0, 0.7),
    shapes::sheet(1, true), shapes::sheet(2, true), shapes::sheet(3, true), shapes::disc(1),
    shapes::disc(2), splitQuads(annulus(3)), splitQuads(annulus(4)), splitQuads(unitCube()),
    splitQuads(slabWithHoles(1)) };
  meshes.push_back(shapes::merged(cornerTetrahedron(), shapes::sheet(2, true)));
  meshes.push_back(makeMesh({ Vec3::Zero(), Vec3::UnitX(), Vec3::UnitY() }, { { 0, 1, 2 } }));
  // Two pyramids over a triangle.
  meshes.push_back(
    makeMesh({ Vec3::UnitX(), Vec3::UnitY(), Vec3(-1, -1, 0), Vec3::UnitZ(), Vec3(0, 0, -1) },
      { { 0, 1, 3 }, { 1, 2, 3 }, { 2, 0, 3 }, { 1, 0, 4 }, { 2, 1, 4 }, { 0, 2, 4 } }));
  return meshes;
}

TEST(LinkCondition, CollapsesAreThoseThatKeepTheSurface)
{
  for (const SurfaceMesh& mesh : smallSurfaces())
  {
    expectCollapsesAsOnLists(mesh);
  }
}

TEST(LinkCondition, FlipsAreThoseThatKeepTheSurface)
{
  for (const SurfaceMesh& mesh : smallSurfaces())
  {
    expectFlipsAsOnLists(mesh);
  }
}

TEST(LinkCondition, ATetrahedronStaysAsItIs)
{
  const EditableSurface surface(cornerTetrahedron());
  for (const Index e : edgesOf(surface))
  {
    EXPECT_FALSE(surface.canCollapse(e));
    EXPECT_FALSE(surface.canFlip(e));
  }
}

TEST(LinkCondition, AnApexOfThreeNeighboursRefuses)
{
  EditableSurface surface(icosphere(1));
  const Index first = surface.from(0);
  const Index second = surface.from(1);
  const Index apex = surface.apex(0);
  // A vertex inside the face has three neighbours; the edges around it would leave it two.
  const Index m = surface.split(0, surface.point(first));
  surface.flip(
    edgeBetween(surface, m, surface.apex(surface.opposite(edgeBetween(surface, first, m)))));
  ASSERT_EQ(surface.valence(m), 3);
  EXPECT_FALSE(surface.canCollapse(edgeBetween(surface, first, apex)));
  EXPECT_FALSE(surface.canCollapse(edgeBetween(surface, apex, second)));
  EXPECT_FALSE(surface.canFlip(edgeBetween(surface, m, apex)));
  EXPECT_TRUE(surface.canCollapse(edgeBetween(surface, m, apex)));
}

TEST(LinkCondition, TwoBoundariesAreNotPinched)
{
  const EditableSurface ring(splitQuads(annulus(12)));
  Index across = 0;
  for (const Index e : edgesOf(ring))
  {
    if (ring.opposite(e) != NoIndex)
    {
      EXPECT_FALSE(ring.canCollapse(e));
      ++across;
    }
    else
    {
      EXPECT_TRUE(ring.canCollapse(e));
    }
  }
  EXPECT_EQ(across, 48);
}

TEST(LinkCondition, AThirdCommonNeighbourRefuses)
{
  // The tube of this torus has three vertices around: any two have the third as neighbour.
  const EditableSurface surface(shapes::torus(12, 3, 2.0, 0.7));
  EXPECT_FALSE(surface.canCollapse(edgeBetween(surface, 0, 1)));
  EXPECT_FALSE(surface.canCollapse(edgeBetween(surface, 1, 2)));
  EXPECT_TRUE(surface.canCollapse(edgeBetween(surface, 0, 3)));
}

} // namespace
