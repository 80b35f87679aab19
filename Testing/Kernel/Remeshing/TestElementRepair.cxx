// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Remeshing/ElementRepair.h"

#include "Errors.h"
#include "MemoryCount.h"
#include "Mesh/MeshQuality.h"
#include "Mesh/SelfIntersections.h"
#include "Remeshing/EditingChecks.h"
#include "Remeshing/RemeshingShapes.h"
#include "Shapes/MeshVariants.h"
#include "Shapes/Polyhedra.h"
#include "Shapes/Spheres.h"
#include "StartSurface/PrimitiveSurfaces.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <random>
#include <set>
#include <vector>

namespace
{

using namespace evolving;
using namespace evolving::editing;
using namespace evolving::shapes;

constexpr double Sound = 42.0;

EditableSurface goodSphere()
{
  const SurfaceMesh sphere = icosphere(3);
  return shapes::sized(sphere, meanEdgeLength(sphere));
}

Index edgeNear(const EditableSurface& surface, const Vec3& direction)
{
  const Index v = shapes::vertexNear(surface, direction);
  Index found = NoIndex;
  surface.forEachOutgoing(v, [&found](Index e) { found = e; });
  return found;
}

/// A split edge leaves four triangles with angles of about 30 degrees.
EditableSurface withSplitEdge(const Vec3& direction)
{
  EditableSurface surface = goodSphere();
  const Index e = edgeNear(surface, direction);
  const Vec3 middle = 0.5 * (surface.point(surface.from(e)) + surface.point(surface.to(e)));
  surface.split(e, middle.normalized());
  return surface;
}

double farthestFromSphere(const EditableSurface& surface)
{
  double farthest = 0.0;
  for (const Index v : verticesOf(surface))
  {
    farthest = std::max(farthest, std::abs(surface.point(v).norm() - 1.0));
  }
  return farthest;
}

/// How far the middle of an edge is from the unit sphere: a collapse may draw both ends there.
double sagitta(double edge)
{
  return edge * edge / 8.0;
}

/// The cube [-1, 1]^3 and its edges.
class Cube : public OffsetReference
{
public:
  Cube()
    : OffsetReference(shapes::triangleBox(1, Vec3::Ones()), 0.0)
  {
  }
  Vec3 onCurve(const Vec3& point, Index /*curve*/) const override
  {
    Index along = 0;
    point.cwiseAbs().minCoeff(&along);
    Vec3 foot = point.cwiseSign();
    foot[along] = point[along];
    return foot;
  }
};

TEST(ElementRepair, TakesASplitBack)
{
  const Vec3 place = Vec3(0.3, 0.5, 0.8).normalized();
  EditableSurface surface = withSplitEdge(place);
  ASSERT_LT(smallestAngle(surface.mesh()), 32.0);
  const Index vertices = static_cast<Index>(verticesOf(surface).size());
  EXPECT_GT(repairElements(surface, shapes::ExactSphere(), Sound), 0);
  EXPECT_GT(smallestAngle(surface.mesh()), Sound);
  EXPECT_LT(surface.vertexSlots(), vertices);
  EXPECT_LT(farthestFromSphere(surface), sagitta(surface.size(0)));
  expectSound(surface, { 2, 0, 1 });
  EXPECT_TRUE(selfIntersections(surface.mesh()).empty());
}

TEST(ElementRepair, FlipsAFlippedEdgeBack)
{
  EditableSurface surface = goodSphere();
  const Index e = edgeNear(surface, Vec3(-0.3, 0.5, 0.8).normalized());
  ASSERT_TRUE(surface.canFlip(e));
  surface.flip(e);
  ASSERT_LT(smallestAngle(surface.mesh()), 32.0);
  EXPECT_GT(repairElements(surface, shapes::ExactSphere(), Sound), 0);
  EXPECT_GT(smallestAngle(surface.mesh()), Sound);
  expectSound(surface, { 2, 0, 1 });
}

TEST(ElementRepair, LeavesGoodElementsAlone)
{
  EditableSurface surface = goodSphere();
  const SurfaceMesh before = surface.mesh();
  EXPECT_EQ(repairElements(surface, shapes::ExactSphere(), Sound), 0);
  EXPECT_TRUE(surface.mesh() == before);
}

TEST(ElementRepair, ChangesNothingFarFromTheBadPlace)
{
  const Vec3 place = Vec3(0.3, 0.5, 0.8).normalized();
  EditableSurface surface = withSplitEdge(place);
  std::set<Place> before;
  for (const Index v : verticesOf(surface))
  {
    before.insert(placeOf(surface.point(v)));
  }
  repairElements(surface, shapes::ExactSphere(), Sound);
  Index moved = 0;
  for (const Index v : verticesOf(surface))
  {
    if (before.count(placeOf(surface.point(v))) == 0)
    {
      ++moved;
      EXPECT_LT((surface.point(v) - place).norm(), 4.5 * surface.size(v));
    }
  }
  EXPECT_LT(moved, 25);
}

TEST(ElementRepair, NeverMakesTheWorstWorseOnShakenSpheres)
{
  for (unsigned seed = 0; seed < 4; ++seed)
  {
    EditableSurface surface = shapes::sized(shapes::shakenSphere(2, 0.12, seed), 0.3);
    const double before = smallestAngle(surface.mesh());
    EXPECT_GT(repairElements(surface, shapes::ExactSphere(), Sound), 0);
    EXPECT_GT(smallestAngle(surface.mesh()), std::min(before + 5.0, Sound));
    EXPECT_LT(farthestFromSphere(surface), sagitta(surface.size(0)));
    expectSound(surface, { 2, 0, 1 });
    EXPECT_TRUE(selfIntersections(surface.mesh()).empty());
  }
}

TEST(ElementRepair, LeavesLockedFacesAndFeaturesAlone)
{
  const Vec3 place = Vec3(0.3, 0.5, 0.8).normalized();
  EditableSurface surface = withSplitEdge(place);
  for (const Index v : verticesOf(surface))
  {
    surface.setLocked(v);
  }
  const Content before(surface);
  EXPECT_EQ(repairElements(surface, shapes::ExactSphere(), Sound), 0);
  EXPECT_TRUE(Content(surface) == before);
}

TEST(ElementRepair, ALockedFaceStaysWhateverHappensAround)
{
  for (unsigned seed = 0; seed < 12; ++seed)
  {
    const SurfaceMesh mesh = shapes::shakenSphere(2, 0.2, seed);
    EditableSurface surface = shapes::sized(mesh, 0.3);
    Index worst = 0;
    for (Index f = 1; f < mesh.faceCount(); ++f)
    {
      worst = smallestAngle(mesh, f) < smallestAngle(mesh, worst) ? f : worst;
    }
    std::set<Place> corners;
    for (Index k = 0; k < 3; ++k)
    {
      surface.setLocked(mesh.faceVertex(worst, k));
      corners.insert(placeOf(mesh.facePoint(worst, k)));
    }
    EXPECT_GT(repairElements(surface, shapes::ExactSphere(), Sound), 0);
    Index found = 0;
    for (Index f = 0; f < surface.faceSlots(); ++f)
    {
      const std::set<Place> places = { placeOf(surface.corner(f, 0)), placeOf(surface.corner(f, 1)),
        placeOf(surface.corner(f, 2)) };
      found += places == corners ? 1 : 0;
    }
    EXPECT_EQ(found, 1) << seed;
  }
}

TEST(ElementRepair, CreasesOfABoxStay)
{
  constexpr double Least = 30.0;
  const SurfaceMesh box = shapes::triangleBox(6, Vec3(1.0, 1.0, 1.0));
  EditableSurface surface = shapes::sized(box, 0.35);
  shapes::markCreases(surface);
  const Index inner = shapes::vertexNear(surface, Vec3(0.0, 0.0, 1.0));
  surface.setPoint(inner, surface.point(inner) + Vec3(0.22, 0.2, 0.0));
  ASSERT_LT(smallestAngle(surface.mesh()), 23.0);
  const Index repaired = repairElements(surface, Cube(), Least);
  EXPECT_GT(smallestAngle(surface.mesh()), Least);
  EXPECT_GT(repaired, 0);
  double length = 0.0;
  for (Index e = 0; e < surface.edgeSlots(); ++e)
  {
    const bool isCrease = surface.hasEdge(e) && surface.curve(e) != NoIndex;
    length += isCrease ? 0.5 * surface.length(e) : 0.0;
  }
  EXPECT_NEAR(length, 24.0, 1e-12);
  EXPECT_NEAR(signedVolume(surface.mesh()), 8.0, 1e-12);
}

TEST(ElementRepair, CostsTheSameWhateverTheSizeOfTheSurface)
{
  if (!MemoryCount::isSupported())
  {
    GTEST_SKIP() << "nothing counts memory here";
  }
  // The whole surface may be copied a few times in all, but not for every bad place.
  const SurfaceMesh sphere = icosphere(5);
  EditableSurface surface = shapes::sized(sphere, meanEdgeLength(sphere));
  std::mt19937 random(9);
  constexpr int Places = 20;
  for (int place = 0; place < Places; ++place)
  {
    const Index e = edgeNear(surface, randomPoint(random).normalized());
    const Vec3 middle = 0.5 * (surface.point(surface.from(e)) + surface.point(surface.to(e)));
    surface.split(e, middle.normalized());
  }
  surface.compact();
  const MemoryCount ofCopy;
  const EditableSurface copy = surface;
  const std::size_t one = ofCopy.total();
  const MemoryCount ofRepair;
  EXPECT_GE(repairElements(surface, shapes::ExactSphere(), Sound), Places);
  EXPECT_LT(ofRepair.total(), 5 * one);
}

TEST(ElementRepair, HasNothingToDoOnAnEmptySurface)
{
  EditableSurface empty{ SurfaceMesh() };
  EXPECT_EQ(repairElements(empty, shapes::ExactSphere(), Sound), 0);
}

TEST(ElementRepair, IsCancelled)
{
  EditableSurface surface = withSplitEdge(Vec3::UnitZ());
  const Execution stopped(nullptr, nullptr, [] { return true; });
  EXPECT_THROW(repairElements(surface, shapes::ExactSphere(), Sound, stopped), Cancelled);
}

} // namespace
