// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Remeshing/Relaxation.h"

#include "Mesh/MeshQuality.h"
#include "Remeshing/CurvedReference.h"
#include "Remeshing/EditingChecks.h"
#include "Remeshing/RemeshingShapes.h"
#include "Shapes/Sheets.h"
#include "Shapes/Spheres.h"
#include "StartSurface/PrimitiveSurfaces.h"
#include "ThreadedExecution.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace
{

using namespace evolving;
using namespace evolving::editing;

/// The plane z = 0 with curve 3 along the line y = 1/2.
class PlaneWithLine : public ReferenceSurface
{
public:
  Foot onSurface(
    const Vec3& point, const Vec3& /*facing*/, Index /*label*/, Index /*guess*/) const override
  {
    return { Vec3(point.x(), point.y(), 0.0), Vec3::UnitZ(), NoIndex };
  }
  Vec3 onCurve(const Vec3& point, Index curve) const override
  {
    return curve == 3 ? Vec3(point.x(), 0.5, 0.0) : point;
  }
};

TEST(Relaxation, MakesAShakenSphereBetter)
{
  EditableSurface surface = shapes::sized(shapes::shakenSphere(4, 0.3, 1), 0.07);
  const AngleSummary before = summarizeAngles(surface.mesh());
  relax(surface, shapes::ExactSphere(), 0.7, 5);
  const AngleSummary after = summarizeAngles(surface.mesh());
  EXPECT_LT(before.smallest, 15.0);
  EXPECT_GT(after.smallest, 30.0);
  EXPECT_GT(after.mean, before.mean + 5.0);
  for (const Index v : verticesOf(surface))
  {
    ASSERT_NEAR(surface.point(v).norm(), 1.0, 1e-14);
  }
}

TEST(Relaxation, AnEvenSheetStays)
{
  EditableSurface sheet = shapes::sized(shapes::sheet(6, true), 0.2);
  const SurfaceMesh before = sheet.mesh();
  relax(sheet, PlaneWithLine(), 1.0, 3);
  for (const Index v : verticesOf(sheet))
  {
    EXPECT_LT((sheet.point(v) - before.points[static_cast<std::size_t>(v)]).norm(), 1e-14);
  }
}

TEST(Relaxation, CornersBoundariesAndPinsStay)
{
  EditableSurface sheet = shapes::sized(shapes::shakenSheet(8, true, 0.3, 2), 0.125);
  sheet.setPinned(40);
  sheet.setLocked(50);
  const SurfaceMesh before = sheet.mesh();
  relax(sheet, PlaneWithLine(), 0.7, 5);
  Index stayed = 0;
  for (const Index v : verticesOf(sheet))
  {
    const bool isFixed = sheet.isBoundary(v) || v == 40 || v == 50;
    EXPECT_EQ(sheet.point(v) == before.points[static_cast<std::size_t>(v)], isFixed);
    stayed += isFixed ? 1 : 0;
  }
  EXPECT_EQ(stayed, 34);
}

TEST(Relaxation, VerticesSlideAlongTheirCurve)
{
  EditableSurface sheet = shapes::sized(shapes::shakenSheet(8, true, 0.3, 3), 0.125);
  for (Index i = 0; i < 8; ++i)
  {
    sheet.setPoint(36 + i, Vec3(sheet.point(36 + i).x(), 0.5, 0.0));
    sheet.setCurve(edgeBetween(sheet, 36 + i, 37 + i), 3);
  }
  relax(sheet, PlaneWithLine(), 0.7, 60);
  for (Index i = 0; i <= 8; ++i)
  {
    EXPECT_LT((sheet.point(36 + i) - Vec3(i / 8.0, 0.5, 0.0)).norm(), 1e-3);
  }
}

TEST(Relaxation, OfACurveKnowsWhatItIs)
{
  EditableSurface sheet(shapes::sheet(4, true));
  sheet.setCurve(edgeBetween(sheet, 11, 12), 5);
  EXPECT_EQ(curveOfVertex(sheet, 12), NoIndex); // it ends there
  sheet.setCurve(edgeBetween(sheet, 12, 13), 5);
  EXPECT_EQ(curveOfVertex(sheet, 12), 5);
  EXPECT_EQ(curveOfVertex(sheet, 11), NoIndex);
  EXPECT_EQ(curveOfVertex(sheet, 7), NoIndex);
  sheet.setCurve(edgeBetween(sheet, 12, 17), 5);
  EXPECT_EQ(curveOfVertex(sheet, 12), NoIndex); // a corner
  sheet.setCurve(edgeBetween(sheet, 12, 17), NoIndex);
  sheet.setCurve(edgeBetween(sheet, 12, 13), 6);
  EXPECT_EQ(curveOfVertex(sheet, 12), NoIndex); // another curve goes on
}

TEST(Relaxation, ACurveThatMeetsItselfAtTheBoundaryHasACorner)
{
  // The boundary's edge and one that leaves it inwards are of the same curve.
  EditableSurface sheet(shapes::sheet(4, true));
  sheet.setCurve(edgeBetween(sheet, 1, 2), 5);
  sheet.setCurve(edgeBetween(sheet, 2, 3), 5);
  sheet.setCurve(edgeBetween(sheet, 2, 7), 5);
  EXPECT_EQ(curveOfVertex(sheet, 2), NoIndex);
}

TEST(Relaxation, CentroidsLieNearerToSmallSizes)
{
  // Sizes grow along x, so vertices move to smaller x.
  EditableSurface sheet(shapes::sheet(8, true));
  for (const Index v : verticesOf(sheet))
  {
    sheet.setSize(v, 0.1 + 0.2 * sheet.point(v).x());
  }
  const SurfaceMesh before = sheet.mesh();
  relax(sheet, PlaneWithLine(), 0.7, 1);
  for (const Index v : verticesOf(sheet))
  {
    if (!sheet.isBoundary(v))
    {
      EXPECT_LT(sheet.point(v).x(), before.points[static_cast<std::size_t>(v)].x() - 1e-4);
    }
  }
}

TEST(Relaxation, ElementsFollowTheSizes)
{
  // Sizes grow from 0.6 at one pole to 1.4 at the other; edges were equally long at both.
  EditableSurface sphere(icosphere(4));
  const auto meanLength = [&](double side)
  {
    double sum = 0.0;
    double count = 0.0;
    for (const Index e : edgesOf(sphere))
    {
      const bool isThere = side * sphere.point(sphere.from(e)).z() > 0.8;
      sum += isThere ? sphere.length(e) : 0.0;
      count += isThere ? 1.0 : 0.0;
    }
    return sum / count;
  };
  EXPECT_NEAR(meanLength(1.0) / meanLength(-1.0), 1.0, 0.01);
  for (int i = 0; i < 60; ++i)
  {
    for (const Index v : verticesOf(sphere))
    {
      sphere.setSize(v, 0.07 * (1.0 + 0.4 * sphere.point(v).z()));
    }
    relax(sphere, shapes::ExactSphere(), 0.7, 1);
  }
  EXPECT_GT(meanLength(1.0) / meanLength(-1.0), 1.04);
}

TEST(Relaxation, NoFaceTurnsOver)
{
  const SurfaceMesh mesh = shapes::shakenSphere(3, 0.6, 5);
  EditableSurface surface = shapes::sized(mesh, 0.15);
  for (int sweep = 0; sweep < 5; ++sweep)
  {
    const EditableSurface before = surface;
    relax(surface, CurvedReference(icosphere(4)), 1.0, 1);
    for (Index f = 0; f < surface.faceSlots(); ++f)
    {
      const Vec3 was = before.doubleArea(f).normalized();
      ASSERT_GT(surface.doubleArea(f).normalized().dot(was), 0.0);
    }
  }
}

TEST(Relaxation, LandingGoesOntoTheReference)
{
  for (EditableSurface surface :
    { shapes::sized(icosphere(3, 1.07), 0.15), EditableSurface(icosphere(3, 1.07)) })
  {
    land(surface, shapes::ExactSphere());
    for (const Index v : verticesOf(surface))
    {
      ASSERT_NEAR(surface.point(v).norm(), 1.0, 1e-14);
    }
  }
}

TEST(Relaxation, IsTheSameOnAnyThreads)
{
  const CurvedReference reference(icosphere(4));
  EditableSurface serial = shapes::sized(shapes::shakenSphere(5, 0.4, 6), 0.035);
  relax(serial, reference, 0.7, 3);
  for (const int threads : { 1, 2, 8 })
  {
    EditableSurface surface = shapes::sized(shapes::shakenSphere(5, 0.4, 6), 0.035);
    relax(surface, reference, 0.7, 3, threadedExecution(threads, 9));
    EXPECT_TRUE(surface.mesh() == serial.mesh());
  }
}

} // namespace
