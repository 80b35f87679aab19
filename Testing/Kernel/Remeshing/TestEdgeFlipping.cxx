// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Remeshing/EdgeFlipping.h"

#include "Mesh/Angles.h"
#include "Mesh/MeshQuality.h"
#include "Remeshing/EditingChecks.h"
#include "Remeshing/RemeshingShapes.h"
#include "Shapes/MeshVariants.h"
#include "Shapes/Polyhedra.h"
#include "Shapes/Sheets.h"
#include "Shapes/Spheres.h"
#include "Shapes/Tubes.h"
#include "StartSurface/PrimitiveSurfaces.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <set>
#include <utility>
#include <vector>

namespace
{

using namespace evolving;

using namespace evolving::shapes;
using namespace evolving::editing;

/// The sum of squared deviations from the best valences.
Index deviation(const EditableSurface& surface)
{
  Index sum = 0;
  for (const Index v : verticesOf(surface))
  {
    const Index d = surface.valence(v) - (surface.isBoundary(v) ? 4 : 6);
    sum += d * d;
  }
  return sum;
}

/// The smallest angle of each face, in ascending order.
std::vector<double> sortedAngles(const SurfaceMesh& mesh)
{
  std::vector<double> angles;
  for (Index f = 0; f < mesh.faceCount(); ++f)
  {
    angles.push_back(smallestAngle(mesh, f));
  }
  std::sort(angles.begin(), angles.end());
  return angles;
}

/// Flips edges at random.
void tangle(EditableSurface& surface, int flips, unsigned seed)
{
  std::mt19937 random(seed);
  std::uniform_int_distribution<Index> any(0, surface.edgeSlots() - 1);
  for (int i = 0; i < flips; ++i)
  {
    const Index e = any(random);
    if (surface.canFlip(e))
    {
      surface.flip(e);
    }
  }
}

/// The edges as pairs of vertices for which keeps(e) holds.
template <class Keeps>
std::set<std::pair<Index, Index>> edgesWhere(const EditableSurface& surface, const Keeps& keeps)
{
  std::set<std::pair<Index, Index>> edges;
  for (const Index e : edgesOf(surface))
  {
    if (keeps(e))
    {
      edges.emplace(surface.from(e), surface.to(e));
    }
  }
  return edges;
}

TEST(EdgeFlipping, BringsValencesBack)
{
  EditableSurface surface(icosphere(3));
  tangle(surface, 300, 1);
  const Index before = deviation(surface);
  const Index flips = flipForValences(surface);
  expectSound(surface, { 2, 0, 1 });
  EXPECT_GT(flips, 100);
  // Each flip gains at least two: deviations change by even numbers.
  EXPECT_LE(deviation(surface), before - 2 * flips);
  EXPECT_LT(deviation(surface), before / 4);
  EXPECT_GE(deviation(surface), 12); // Euler: the sum of 6 - valence is 12
}

TEST(EdgeFlipping, LeavesRegularValencesAlone)
{
  for (const SurfaceMesh& mesh : { icosphere(3), shapes::torus(18, 9, 2.0, 0.7) })
  {
    EditableSurface surface(mesh);
    EXPECT_EQ(flipForValences(surface), 0);
    EXPECT_TRUE(surface.mesh() == mesh);
  }
}

TEST(EdgeFlipping, FindsTheDelaunayTriangulationOfAPlane)
{
  // Max-min angle flips end in it (Lawson); no point lies inside a circumcircle.
  const SurfaceMesh mesh = shapes::shakenSheet(8, true, 0.3, 2);
  EditableSurface sheet(mesh);
  const double before = smallestAngle(mesh);
  EXPECT_GT(flipForAngles(sheet), 10);
  EXPECT_GE(smallestAngle(sheet.mesh()), before);
  for (const Index e : edgesOf(sheet))
  {
    if (sheet.opposite(e) != NoIndex)
    {
      const auto angle = [&](Index half)
      {
        const Vec3 a = sheet.point(sheet.from(half)) - sheet.point(sheet.apex(half));
        const Vec3 b = sheet.point(sheet.to(half)) - sheet.point(sheet.apex(half));
        return std::atan2(a.cross(b).norm(), a.dot(b));
      };
      EXPECT_LE(angle(e) + angle(sheet.opposite(e)), Pi + 1e-9);
    }
  }
}

TEST(EdgeFlipping, RaisesTheSmallestAngles)
{
  // The faces' smallest angles in ascending order grow as words do in a dictionary.
  EditableSurface surface(shapes::shakenSphere(4, 0.25, 3));
  const std::vector<double> before = sortedAngles(surface.mesh());
  EXPECT_GT(flipForAngles(surface), 100);
  EXPECT_TRUE(sortedAngles(surface.mesh()) > before);
  expectSound(surface, { 2, 0, 1 });
  EXPECT_EQ(flipForAngles(surface), 0);
}

TEST(EdgeFlipping, KeepsFeaturesAndLockedFaces)
{
  for (const bool isForAngles : { false, true })
  {
    EditableSurface surface(shapes::shakenSphere(3, 0.3, 4));
    tangle(surface, 200, 5);
    for (Index v = 0; v < surface.vertexSlots(); ++v)
    {
      if (surface.point(v).z() > 0.2)
      {
        surface.setLocked(v);
      }
    }
    for (Index e = 0; e < surface.edgeSlots(); e += 5)
    {
      surface.setCurve(e, e);
    }
    const auto isKept = [&](Index e)
    { return surface.isFeature(e) || surface.isLockedFace(EditableSurface::faceOf(e)); };
    const auto before = edgesWhere(surface, isKept);
    EXPECT_GT(isForAngles ? flipForAngles(surface) : flipForValences(surface), 0);
    const auto after = edgesWhere(surface, isKept); // new faces between locked vertices are too
    EXPECT_TRUE(std::includes(after.begin(), after.end(), before.begin(), before.end()));
    expectSound(surface, { 2, 0, 1 });
  }
}

TEST(EdgeFlipping, DoesNotCutCreases)
{
  // The edges of a slanted box are no features here, but to flip one would cut its corner.
  std::mt19937 generator(5);
  const Eigen::Matrix3d slant = (Eigen::Matrix3d() << 1, 0.3, 0, 0, 1, 0, 0, 0.2, 1).finished();
  for (const bool isForAngles : { false, true })
  {
    const SurfaceMesh quads = subdividedBox(5, Vec3(1.0, 0.4, 0.2));
    EditableSurface box(triangulated(mapped(quads, slant), generator));
    EXPECT_GT(isForAngles ? flipForAngles(box) : flipForValences(box), 10);
    EXPECT_NEAR(signedVolume(box.mesh()), 0.64, 1e-14);
    EXPECT_NEAR(surfaceArea(box.mesh()), surfaceArea(mapped(quads, slant)), 1e-13);
  }
}

TEST(EdgeFlipping, ValencesDoNotCostHalfAnAngle)
{
  EditableSurface surface(shapes::shakenSphere(3, 0.3, 6));
  tangle(surface, 100, 7);
  double before = smallestAngle(surface.mesh());
  const Index flips = flipForValences(surface);
  EXPECT_GT(flips, 50);
  EXPECT_GT(smallestAngle(surface.mesh()), 0.4 * before);
}

} // namespace
