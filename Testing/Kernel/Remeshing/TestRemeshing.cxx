// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Remeshing/Remeshing.h"

#include "Mesh/MeshQuality.h"
#include "Mesh/SelfIntersections.h"
#include "Remeshing/CurvedReference.h"
#include "Remeshing/EditingChecks.h"
#include "Remeshing/RemeshingShapes.h"
#include "Remeshing/StarOptimization.h"
#include "Remeshing/SurfaceFit.h"
#include "Shapes/MeshVariants.h"
#include "Shapes/Polyhedra.h"
#include "Shapes/Spheres.h"
#include "Shapes/Tubes.h"
#include "StartSurface/PrimitiveSurfaces.h"
#include "ThreadedExecution.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace
{

using namespace evolving;
using namespace evolving::editing;

EditableSurface remeshed(
  const SurfaceMesh& mesh, const SurfaceMesh& target, double size, int passes)
{
  const CurvedReference reference(target);
  EditableSurface surface = shapes::sized(mesh, size);
  for (int pass = 0; pass < passes; ++pass)
  {
    remeshOnce(surface, reference, {});
  }
  return surface;
}

void expectGoodElements(const EditableSurface& surface, const Kind& kind)
{
  expectSound(surface, kind);
  const SurfaceMesh mesh = surface.mesh();
  const shapes::LengthRange lengths = shapes::relativeLengths(surface);
  EXPECT_GT(lengths.shortest, 0.6);
  EXPECT_LT(lengths.longest, 1.5);
  EXPECT_GT(smallestAngle(mesh), 30.0);
  EXPECT_TRUE(selfIntersections(mesh).empty());
  EXPECT_EQ(surface.vertexSlots(), mesh.vertexCount()); // none unused
}

TEST(Remeshing, GivesASphereGoodElements)
{
  const SurfaceMesh target = icosphere(5);
  for (const unsigned seed : { 1U, 2U, 3U })
  {
    const SurfaceMesh mesh = shapes::shakenSphere(4, 0.2, seed);
    for (const double size : { 0.08, 0.13, 0.21 })
    {
      const EditableSurface surface = remeshed(mesh, target, size, 5);
      expectGoodElements(surface, { 2, 0, 1 });
      EXPECT_NEAR(surface.vertexSlots(), expectedVertices(surface), 0.1 * surface.vertexSlots());
    }
  }
}

TEST(Remeshing, GivesATorusGoodElements)
{
  const SurfaceMesh target = shapes::torus(160, 70, 2.0, 0.7);
  for (const unsigned seed : { 1U, 2U, 3U })
  {
    const SurfaceMesh mesh = shapes::shaken(shapes::torus(30, 16, 2.0, 0.7), 0.03, seed);
    for (const double size : { 0.15, 0.2, 0.31 })
    {
      expectGoodElements(remeshed(mesh, target, size, 5), { 0, 0, 1 });
    }
  }
}

TEST(Remeshing, FollowsSizes)
{
  EditableSurface surface(icosphere(4));
  const CurvedReference reference(icosphere(5));
  for (int pass = 0; pass < 6; ++pass)
  {
    for (const Index v : verticesOf(surface))
    {
      surface.setSize(v, 0.12 + 0.06 * surface.point(v).z());
    }
    remeshOnce(surface, reference, {});
  }
  for (const Index v : verticesOf(surface))
  {
    surface.setSize(v, 0.12 + 0.06 * surface.point(v).z());
  }
  expectGoodElements(surface, { 2, 0, 1 });
}

TEST(Remeshing, ScalesBitForBit)
{
  const auto run = [](double scale)
  {
    const SurfaceMesh mesh =
      shapes::transformed(shapes::shakenSphere(3, 0.2, 5), scale, Vec3::Zero());
    const CurvedReference reference(
      shapes::transformed(shapes::bumpySphere(4), scale, Vec3::Zero()));
    EditableSurface surface(mesh);
    setSizesForVertexCount(surface, { 0.05 * scale, 0.4 * scale }, 600.0);
    for (int pass = 0; pass < 3; ++pass)
    {
      remeshOnce(surface, reference, {});
    }
    polishOnce(surface, reference, {});
    optimizeStars(surface, reference, 45.0, 3);
    fitToReference(surface, reference, { 2, 1.0, 0.5 });
    return surface.mesh();
  };
  const SurfaceMesh one = run(1.0);
  for (const double scale : { std::ldexp(1.0, -20), 4.0, std::ldexp(1.0, 17) })
  {
    EXPECT_TRUE(run(scale) == shapes::transformed(one, scale, Vec3::Zero()));
  }
}

TEST(Remeshing, IsTheSameOnAnyThreads)
{
  const CurvedReference reference(icosphere(5));
  const auto run = [&](const Execution& execution)
  {
    EditableSurface surface = shapes::sized(shapes::shakenSphere(4, 0.2, 2), 0.05);
    remeshOnce(surface, reference, {}, execution);
    polishOnce(surface, reference, {}, execution);
    return surface.mesh();
  };
  const SurfaceMesh serial = run({});
  for (const int threads : { 2, 8 })
  {
    EXPECT_TRUE(run(threadedExecution(threads, 3)) == serial);
  }
}

TEST(Remeshing, PolishingAddsNoVertices)
{
  EditableSurface surface = remeshed(shapes::shakenSphere(4, 0.3, 3), icosphere(5), 0.1, 2);
  const Index before = surface.vertexSlots();
  const double angle = smallestAngle(surface.mesh());
  const CurvedReference reference(icosphere(5));
  for (int pass = 0; pass < 3; ++pass)
  {
    polishOnce(surface, reference, {});
  }
  EXPECT_LE(surface.vertexSlots(), before);
  EXPECT_GT(surface.vertexSlots(), 0.97 * before);
  EXPECT_GT(smallestAngle(surface.mesh()), angle);
  for (const Index v : verticesOf(surface))
  {
    EXPECT_GE(surface.valence(v), 5);
    EXPECT_LE(surface.valence(v), 7);
  }
}

TEST(Remeshing, KeepsCreasesWhereTheyAre)
{
  /// The sides and edges of a box, all as one curve.
  class Box : public OffsetReference
  {
  public:
    explicit Box(const SurfaceMesh& mesh)
      : OffsetReference(mesh, 0.0)
    {
    }
    Vec3 onCurve(const Vec3& point, Index /*curve*/) const override
    {
      Vec3 on = point.cwiseMax(-1.0).cwiseMin(1.0);
      Index inner = 0;
      on.cwiseAbs().minCoeff(&inner);
      for (Index k = 0; k < 3; ++k)
      {
        on[k] = k == inner ? on[k] : std::copysign(1.0, on[k]);
      }
      return on;
    }
  };
  const SurfaceMesh mesh = shapes::triangleBox(7, Vec3(1.0, 1.0, 1.0));
  const Box reference(mesh);
  EditableSurface box = shapes::sized(mesh, 0.2);
  shapes::markCreases(box);
  for (int pass = 0; pass < 5; ++pass)
  {
    remeshOnce(box, reference, {});
  }
  expectSound(box, { 2, 0, 1 });
  EXPECT_GT(smallestAngle(box.mesh()), 25.0);
  EXPECT_NEAR(signedVolume(box.mesh()), 8.0, 1e-12);
  EXPECT_NEAR(surfaceArea(box.mesh()), 24.0, 1e-12);
}

} // namespace
