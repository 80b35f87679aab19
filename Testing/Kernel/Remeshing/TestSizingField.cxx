// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Remeshing/SizingField.h"

#include "Mesh/MeshQuality.h"
#include "Remeshing/CurvedReference.h"
#include "Remeshing/EditingChecks.h"
#include "Remeshing/ReferenceSurface.h"
#include "Remeshing/Remeshing.h"
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
#include <utility>
#include <vector>

namespace
{

using namespace evolving;
using namespace evolving::editing;

double steepest(const EditableSurface& surface)
{
  double steepest = 0.0;
  for (const Index e : edgesOf(surface))
  {
    const double growth = surface.size(surface.to(e)) - surface.size(surface.from(e));
    steepest = std::max(steepest, growth / surface.length(e));
  }
  return steepest;
}

/// A tube of radius 1 with its two ends closed by flat discs.
SurfaceMesh closedTube()
{
  constexpr Index Around = 40;
  constexpr Index Along = 12;
  SurfaceMesh mesh = shapes::tube(Around, Along, 0.8, [](double) { return 1.0; });
  const Index bottom = mesh.addPoint(Vec3(0, 0, -0.8));
  const Index top = mesh.addPoint(Vec3(0, 0, 0.8));
  for (Index i = 0; i < Around; ++i)
  {
    const Index j = (i + 1) % Around;
    mesh.addFace({ j, i, bottom });
    mesh.addFace({ Around * Along + i, Around * Along + j, top });
  }
  return mesh;
}

/// Over every edge, again and again.
void gradeByAllEdges(EditableSurface& surface, double gradation)
{
  for (bool hasChanged = true; hasChanged;)
  {
    hasChanged = false;
    for (Index e = 0; e < surface.edgeSlots(); ++e)
    {
      for (const auto& [v, u] : { std::pair{ surface.from(e), surface.to(e) },
             std::pair{ surface.to(e), surface.from(e) } })
      {
        const double most =
          surface.size(v) + gradation * (surface.point(u) - surface.point(v)).norm();
        hasChanged = hasChanged || surface.size(u) > most;
        surface.setSize(u, std::min(surface.size(u), most));
      }
    }
  }
}

TEST(SizingField, IsGradedAsOverAllEdges)
{
  std::mt19937 random(3);
  std::uniform_real_distribution<double> exponent(-4.0, 0.0);
  for (const double gradation : { 0.1, 0.5 })
  {
    EditableSurface surface(shapes::shakenSphere(4, 0.2, 1));
    for (Index v = 0; v < surface.vertexSlots(); ++v)
    {
      surface.setSize(v, v % 9 == 0 ? std::pow(10.0, exponent(random)) : 1.0);
    }
    EditableSurface expected = surface;
    gradeByAllEdges(expected, gradation);
    gradeSizes(surface, gradation);
    for (Index v = 0; v < surface.vertexSlots(); ++v)
    {
      ASSERT_EQ(surface.size(v), expected.size(v)) << "vertex " << v;
    }
  }
}

TEST(SizingField, OnASphereIsThatOfItsCurvature)
{
  for (const double radius : { 0.5, 1.0, 7.0 })
  {
    EditableSurface surface(icosphere(4, radius));
    for (const double error : { 1e-3 * radius, 1e-2 * radius, 1e-1 * radius })
    {
      setSizesForError(surface, { 1e-3 * radius, 10.0 * radius }, error);
      const double expected = std::sqrt(6.0 * error * radius - 3.0 * error * error);
      for (const Index v : verticesOf(surface))
      {
        ASSERT_NEAR(surface.size(v), expected, 0.04 * expected);
      }
    }
  }
}

TEST(SizingField, OfAnEquilateralTriangleOnASphereIsItsEdge)
{
  // The plane of a triangle of edge s is e below the sphere: r^2 = s^2 / 3 + (r - e)^2.
  const double s = 0.3;
  const double error = 1.0 - std::sqrt(1.0 - s * s / 3.0);
  EditableSurface surface(icosphere(4));
  setSizesForError(surface, { 1e-3, 10.0 }, error);
  EXPECT_NEAR(surface.size(0), s, 0.01 * s);
}

TEST(SizingField, GrowsWithTheError)
{
  // Also beyond the radius, where no triangle between points of the sphere can be so far off.
  EditableSurface surface(icosphere(3));
  double last = 0.0;
  for (double error = 1e-4; error < 50.0; error *= 1.5)
  {
    setSizesForError(surface, { 1e-3, 100.0 }, error);
    ASSERT_GE(surface.size(0), last) << "error " << error;
    last = surface.size(0);
  }
  EXPECT_NEAR(last, std::sqrt(3.0), 0.04);
}

TEST(SizingField, StaysBetweenItsBounds)
{
  EditableSurface surface(shapes::ellipsoid(4, Vec3(1.0, 1.0, 4.0)));
  setSizesForError(surface, { 0.1, 0.3 }, 2e-3);
  double smallest = 1.0;
  double largest = 0.0;
  for (const Index v : verticesOf(surface))
  {
    smallest = std::min(smallest, surface.size(v));
    largest = std::max(largest, surface.size(v));
  }
  EXPECT_GE(smallest, 0.1);
  EXPECT_LE(largest, 0.3);
  EXPECT_GT(largest / smallest, 1.3);
}

TEST(SizingField, FlatPartsGetTheLargestSize)
{
  EditableSurface sheet(shapes::sheet(10, true));
  setSizesForError(sheet, { 0.01, 0.7 }, 1e-6);
  for (const Index v : verticesOf(sheet))
  {
    EXPECT_EQ(sheet.size(v), 0.7);
  }
}

TEST(SizingField, CreasesOfABoxAreNoCurvature)
{
  EditableSurface box(shapes::triangleBox(6, Vec3(1.0, 0.7, 0.5)));
  shapes::markCreases(box);
  setSizesForError(box, { 0.01, 0.7 }, 1e-3);
  for (const Index v : verticesOf(box))
  {
    EXPECT_EQ(box.size(v), 0.7);
  }
}

TEST(SizingField, AtTheRimOfATubeIsThatOfTheTube)
{
  // The disc at its end is flat, the tube has curvature 1; the rim is a vertex of both.
  EditableSurface surface(closedTube());
  shapes::markCreases(surface);
  constexpr double Error = 1e-3;
  setSizesForError(surface, { 0.001, 10.0, 1e9 }, Error);
  const double expected = std::sqrt(6.0 * Error - 3.0 * Error * Error);
  for (const Index v : verticesOf(surface))
  {
    EXPECT_GT(surface.size(v), 0.97 * expected) << surface.point(v).transpose();
  }
}

TEST(SizingField, GradationBoundsGrowthAlongEdges)
{
  for (const double gradation : { 0.02, 0.05, 0.1 })
  {
    EditableSurface surface(shapes::bumpySphere(4));
    setSizesForError(surface, { 1e-3, 10.0, 1e9 }, 1e-3);
    std::vector<double> before;
    for (const Index v : verticesOf(surface))
    {
      before.push_back(surface.size(v));
    }
    ASSERT_GT(steepest(surface), 0.2);
    gradeSizes(surface, gradation);
    EXPECT_LE(steepest(surface), gradation * (1.0 + 1e-12));
    EXPECT_EQ(*std::min_element(before.begin(), before.end()),
      surface.size(
        static_cast<Index>(std::min_element(before.begin(), before.end()) - before.begin())));
    for (const Index v : verticesOf(surface))
    {
      ASSERT_LE(surface.size(v), before[static_cast<std::size_t>(v)]);
    }
  }
}

TEST(SizingField, GradesByDistanceAlongEdges)
{
  // One small size at the centre of a disc: a cone along the rays of vertices.
  EditableSurface disc(shapes::disc(10));
  setUniformSizes(disc, 5.0);
  disc.setSize(0, 0.1);
  gradeSizes(disc, 0.4);
  EXPECT_NEAR(disc.size(shapes::vertexNear(disc, Vec3::UnitX())), 0.5, 1e-14);
  EXPECT_NEAR(disc.size(shapes::vertexNear(disc, 0.5 * Vec3::UnitX())), 0.3, 1e-14);
}

TEST(SizingField, ExpectsTheVerticesOfWhatIsThere)
{
  for (const int level : { 2, 3, 4 })
  {
    const SurfaceMesh mesh = icosphere(level);
    const EditableSurface surface = shapes::sized(mesh, meanEdgeLength(mesh));
    EXPECT_NEAR(expectedVertices(surface), mesh.vertexCount(), 0.03 * mesh.vertexCount());
  }
  EditableSurface unset = shapes::sized(icosphere(3), 0.1);
  const double before = expectedVertices(unset);
  setUniformSizes(unset, 0.2);
  EXPECT_NEAR(expectedVertices(unset), 0.25 * before, 1e-9);
}

/// Remeshes with sizes for so many vertices. @return how many there are then
Index countAfterRemeshing(const SurfaceMesh& mesh, double largest, double vertices)
{
  const CurvedReference reference(mesh);
  EditableSurface surface(mesh);
  for (int pass = 0; pass < 8; ++pass)
  {
    setSizesForVertexCount(surface, { 0.1 * largest, largest }, vertices);
    remeshOnce(surface, reference, {});
  }
  return surface.vertexSlots();
}

TEST(SizingField, GivesTheWantedNumberOfVertices)
{
  EXPECT_NEAR(
    countAfterRemeshing(shapes::ellipsoid(4, Vec3(1.0, 1.0, 4.0)), 1.0, 1000.0), 1000, 100);
  EXPECT_NEAR(countAfterRemeshing(shapes::torus(60, 24, 2.0, 0.7), 0.8, 1500.0), 1500, 150);
}

TEST(SizingField, FindsTheErrorForAVertexCount)
{
  // Where a few vertices are very curved, larger errors must not bring small sizes back.
  for (const SurfaceMesh& mesh : { shapes::ellipsoid(4, Vec3(1.0, 1.0, 4.0)),
         shapes::ellipsoid(4, Vec3(0.2, 1.0, 1.0)), shapes::bumpySphere(4) })
  {
    EditableSurface surface(mesh);
    for (const double vertices : { 150.0, 500.0, 3000.0 })
    {
      const CurvatureSizing sizing{ 0.01, 2.0, 1.0 };
      const double error = setSizesForVertexCount(surface, sizing, vertices);
      EXPECT_NEAR(expectedVertices(surface), vertices, 0.01 * vertices);
      setSizesForError(surface, sizing, error);
      EXPECT_NEAR(expectedVertices(surface), vertices, 0.01 * vertices);
    }
  }
}

TEST(SizingField, NeedsNoSmallestSize)
{
  EditableSurface surface(shapes::ellipsoid(3, Vec3(1.0, 1.0, 4.0)));
  setSizesForVertexCount(surface, { 0.0, 2.0 }, 800.0);
  EXPECT_NEAR(expectedVertices(surface), 800.0, 1.0);
}

TEST(SizingField, ScalesWithTheSurface)
{
  EditableSurface one(shapes::bumpySphere(3));
  EditableSurface other(shapes::transformed(shapes::bumpySphere(3), 8.0, Vec3::Zero()));
  const double error = setSizesForVertexCount(one, { 0.05, 0.5 }, 700.0);
  EXPECT_NEAR(setSizesForVertexCount(other, { 0.4, 4.0 }, 700.0), 8.0 * error, 1e-9 * error);
  for (const Index v : verticesOf(one))
  {
    ASSERT_NEAR(other.size(v), 8.0 * one.size(v), 1e-9);
  }
}

} // namespace
