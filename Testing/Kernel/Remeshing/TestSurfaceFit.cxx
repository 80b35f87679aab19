// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Remeshing/SurfaceFit.h"

#include "Mesh/MeshQuality.h"
#include "Remeshing/EditingChecks.h"
#include "Remeshing/ReferenceSurface.h"
#include "Remeshing/RemeshingShapes.h"
#include "Shapes/Sheets.h"
#include "Shapes/Spheres.h"
#include "StartSurface/PrimitiveSurfaces.h"
#include "ThreadedExecution.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace
{

using namespace evolving;
using namespace evolving::editing;

constexpr double NormalOnly = std::numeric_limits<double>::infinity();

/// Two planes that meet at 90 degrees over x = 0.52, y along the ridge.
SurfaceMesh roof()
{
  SurfaceMesh mesh;
  mesh.points = { Vec3(-9, -9, -9.52), Vec3(0.52, -9, 0), Vec3(9, -9, -8.48), Vec3(-9, 9, -9.52),
    Vec3(0.52, 9, 0), Vec3(9, 9, -8.48) };
  mesh.addFace({ 0, 1, 4 });
  mesh.addFace({ 0, 4, 3 });
  mesh.addFace({ 1, 2, 5 });
  mesh.addFace({ 1, 5, 4 });
  return mesh;
}

/// A sheet with all vertices on the roof, none on its ridge.
EditableSurface sheetOnRoof(Index n)
{
  SurfaceMesh mesh = shapes::sheet(n, true);
  for (Vec3& p : mesh.points)
  {
    p.z() = -std::abs(p.x() - 0.52);
  }
  return shapes::sized(mesh, 1.2 / n);
}

/// Of the distances of a surface's points from the unit sphere, outside positive.
struct Moments
{
  double mean = 0.0;
  double rms = 0.0;
};

Moments distanceFromSphere(const EditableSurface& surface)
{
  double area = 0.0;
  Moments sums;
  constexpr int N = 24;
  for (Index f = 0; f < surface.faceSlots(); ++f)
  {
    const double weight = surface.doubleArea(f).norm();
    for (int i = 0; i < N; ++i)
    {
      for (int j = 0; i + j < N; ++j)
      {
        // The centres of N^2 equal triangles, those that stand and those that hang.
        for (const double third : { 1.0 / 3.0, 2.0 / 3.0 })
        {
          const double u = (i + third) / N;
          const double v = (j + third) / N;
          if (u + v < 1.0)
          {
            const Vec3 p = u * surface.corner(f, 0) + v * surface.corner(f, 1) +
              (1.0 - u - v) * surface.corner(f, 2);
            const double distance = p.norm() - 1.0;
            sums.mean += weight * distance;
            sums.rms += weight * distance * distance;
            area += weight;
          }
        }
      }
    }
  }
  return { sums.mean / area, std::sqrt(sums.rms / area) };
}

TEST(SurfaceFit, TakesTheMeanErrorOfASphereAway)
{
  // Of a triangle between points of a sphere the distance is k L^2 / 2 times the sum of products
  // of two barycentric coordinates: 0.125 in the mean, 0.129 in the root mean square. What is left
  // without the mean is 0.032.
  for (const int level : { 3, 4 })
  {
    const SurfaceMesh mesh = icosphere(level);
    EditableSurface surface = shapes::sized(mesh, meanEdgeLength(mesh));
    const Moments before = distanceFromSphere(surface);
    const double unit = std::pow(meanEdgeLength(mesh), 2.0);
    EXPECT_NEAR(before.mean, -0.125 * unit, 0.004 * unit);
    EXPECT_NEAR(before.rms, 0.129 * unit, 0.004 * unit);
    fitToReference(surface, shapes::ExactSphere(), { 4, 1.0, NormalOnly });
    const Moments after = distanceFromSphere(surface);
    EXPECT_NEAR(after.rms / before.rms, 0.032 / 0.129, 0.01);
    EXPECT_NEAR(after.mean / before.mean, 0.0, 1e-3);
  }
}

TEST(SurfaceFit, OneIterationDoesNearlyAll)
{
  EditableSurface once = shapes::sized(shapes::shakenSphere(3, 0.15, 1), 0.15);
  const Moments before = distanceFromSphere(once);
  EditableSurface often = once;
  fitToReference(once, shapes::ExactSphere(), { 1, 1.0, NormalOnly });
  fitToReference(often, shapes::ExactSphere(), { 5, 1.0, NormalOnly });
  EXPECT_LT(distanceFromSphere(once).rms, 0.4 * before.rms);
  EXPECT_LT(distanceFromSphere(often).rms, 1.001 * distanceFromSphere(once).rms);
}

TEST(SurfaceFit, DampingGoesPartOfTheWay)
{
  EditableSurface whole = shapes::sized(icosphere(3), 0.15);
  EditableSurface half = whole;
  fitToReference(whole, shapes::ExactSphere(), { 1, 1.0, NormalOnly });
  fitToReference(half, shapes::ExactSphere(), { 1, 0.5, NormalOnly });
  for (const Index v : verticesOf(whole))
  {
    ASSERT_NEAR(half.point(v).norm() - 1.0, 0.5 * (whole.point(v).norm() - 1.0), 1e-9);
  }
}

TEST(SurfaceFit, NormalOnlyMovesAlongNormals)
{
  EditableSurface surface = shapes::sized(icosphere(3), 0.15);
  const EditableSurface before = surface;
  fitToReference(surface, shapes::ExactSphere(), { 1, 1.0, NormalOnly });
  for (const Index v : verticesOf(surface))
  {
    const Vec3 move = surface.point(v) - before.point(v);
    ASSERT_GT(move.norm(), 1e-4);
    ASSERT_LT(move.cross(before.normal(v)).norm(), 1e-12);
  }
}

TEST(SurfaceFit, CurvesBoundariesAndPinsStay)
{
  EditableSurface surface = shapes::sized(shapes::halfSphere(10), 0.15);
  surface.setPinned(5);
  surface.setCurve(edgeBetween(surface, 0, 1), 0);
  const SurfaceMesh before = surface.mesh();
  fitToReference(surface, shapes::ExactSphere(), { 2, 1.0, 0.5 });
  for (const Index v : verticesOf(surface))
  {
    const bool isFixed = surface.isBoundary(v) || v == 5 || v == 0 || v == 1;
    ASSERT_EQ(surface.point(v) == before.points[static_cast<std::size_t>(v)], isFixed) << v;
  }
}

TEST(SurfaceFit, WhereNothingIsFreeNothingMoves)
{
  EditableSurface surface = shapes::sized(icosphere(1), 0.5);
  for (const Index v : verticesOf(surface))
  {
    surface.setLocked(v);
  }
  fitToReference(surface, shapes::ExactSphere(), { 2, 1.0, 0.0 });
  EXPECT_TRUE(surface.mesh() == icosphere(1));
}

TEST(SurfaceFit, NoVertexGoesFarAtOnce)
{
  EditableSurface surface = shapes::sized(icosphere(3, 1.5), 0.2);
  fitToReference(surface, shapes::ExactSphere(), { 1, 1.0, 0.0 });
  for (const Index v : verticesOf(surface))
  {
    // The sphere is two and a half sizes below.
    ASSERT_LT(surface.point(v).norm(), 1.499);
    ASSERT_GT(surface.point(v).norm(), 1.5 - surface.size(v));
  }
}

/// The mean distance from the ridge of the vertices that are nearest to it.
double distanceFromRidge(const EditableSurface& sheet, Index n)
{
  double sum = 0.0;
  for (Index j = 2; j <= n - 2; ++j)
  {
    const Vec3& p = sheet.point(j * (n + 1) + n / 2);
    sum += std::hypot(p.x() - 0.52, p.z()) / (n - 3);
  }
  return sum;
}

TEST(SurfaceFit, VerticesFindTheRidgeWhenTheyMayMoveAlong)
{
  const OffsetReference reference(roof(), 0.0);
  EditableSurface along = sheetOnRoof(16);
  EditableSurface normal = along;
  const double before = distanceFromRidge(along, 16);
  ASSERT_NEAR(before, 0.02 * std::sqrt(2.0), 1e-12);
  fitToReference(along, reference, { 8, 1.0, 0.02 });
  EXPECT_LT(distanceFromRidge(along, 16), 0.01 * before);
  fitToReference(normal, reference, { 8, 1.0, NormalOnly });
  EXPECT_GT(distanceFromRidge(normal, 16), 0.8 * before);
}

TEST(SurfaceFit, IsTheSameOnAnyThreads)
{
  const OffsetReference reference(icosphere(5), 0.0);
  EditableSurface serial = shapes::sized(shapes::shakenSphere(4, 0.2, 3), 0.07);
  fitToReference(serial, reference, { 2, 1.0, 0.5 });
  for (const int threads : { 1, 2, 8 })
  {
    EditableSurface surface = shapes::sized(shapes::shakenSphere(4, 0.2, 3), 0.07);
    fitToReference(surface, reference, { 2, 1.0, 0.5 }, threadedExecution(threads, 4));
    EXPECT_TRUE(surface.mesh() == serial.mesh());
  }
}

TEST(SurfaceFit, PlacesIntegrateTheSquareOfASag)
{
  // Of a polynomial of fourth degree in barycentric coordinates, over the area: i! j! k! 2 /
  // (n+2)!.
  const auto factorial = [](int n) { return std::tgamma(n + 1.0); };
  for (int i = 0; i <= 4; ++i)
  {
    for (int j = 0; i + j <= 4; ++j)
    {
      for (int k = 0; i + j + k <= 4; ++k)
      {
        double sum = 0.0;
        for (std::size_t p = 0; p < FitPlaces.size(); ++p)
        {
          sum += FitWeights[p] / 6.0 * std::pow(FitPlaces[p][0], i) * std::pow(FitPlaces[p][1], j) *
            std::pow(FitPlaces[p][2], k);
        }
        const double exact =
          2.0 * factorial(i) * factorial(j) * factorial(k) / factorial(i + j + k + 2);
        EXPECT_NEAR(sum, exact, 1e-14);
      }
    }
  }
}

} // namespace
