// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Crossings/OuterSurface.h"

#include "Checks/Refusal.h"
#include "Mesh/TopologySummary.h"
#include "Shapes/MeshVariants.h"
#include "Shapes/Polyhedra.h"
#include "Shapes/Sheets.h"
#include "StartSurface/PrimitiveSurfaces.h"
#include "ThreadedExecution.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

using namespace evolving;

namespace
{

using Cells = std::array<std::array<std::array<bool, 9>, 9>, 9>; ///< with empty ones around

/// Boxes with integer corners from 0 to 7, which touch in every way.
struct Boxes
{
  SurfaceMesh mesh;
  Cells isFilled{};

  explicit Boxes(int count, unsigned seed)
  {
    std::mt19937 generator(seed);
    std::uniform_int_distribution<int> corner(0, 5);
    std::uniform_int_distribution<int> side(1, 2);
    for (int i = 0; i < count; ++i)
    {
      std::array<int, 3> low{};
      std::array<int, 3> high{};
      for (std::size_t axis = 0; axis < 3; ++axis)
      {
        low[axis] = corner(generator);
        high[axis] = low[axis] + side(generator);
      }
      this->mesh = shapes::merged(
        this->mesh, shapes::box(Vec3(low[0], low[1], low[2]), Vec3(high[0], high[1], high[2])));
      this->fill(low, high);
    }
  }

  double volume() const
  {
    double cells = 0.0;
    this->forEachCell([&](std::size_t i, std::size_t j, std::size_t k)
      { cells += this->isFilled[i][j][k] ? 1.0 : 0.0; });
    return cells;
  }

  double area() const
  {
    double faces = 0.0;
    this->forEachCell(
      [&](std::size_t i, std::size_t j, std::size_t k)
      {
        const bool cell = this->isFilled[i][j][k];
        faces += i > 0 && cell != this->isFilled[i - 1][j][k] ? 1.0 : 0.0;
        faces += j > 0 && cell != this->isFilled[i][j - 1][k] ? 1.0 : 0.0;
        faces += k > 0 && cell != this->isFilled[i][j][k - 1] ? 1.0 : 0.0;
      });
    return faces;
  }

private:
  template <class Visit>
  static void forEachCell(const Visit& visit)
  {
    for (std::size_t i = 0; i < 9; ++i)
    {
      for (std::size_t j = 0; j < 9; ++j)
      {
        for (std::size_t k = 0; k < 9; ++k)
        {
          visit(i, j, k);
        }
      }
    }
  }

  void fill(const std::array<int, 3>& low, const std::array<int, 3>& high)
  {
    for (int i = low[0]; i < high[0]; ++i)
    {
      for (int j = low[1]; j < high[1]; ++j)
      {
        for (int k = low[2]; k < high[2]; ++k)
        {
          this->isFilled[at(i) + 1][at(j) + 1][at(k) + 1] = true;
        }
      }
    }
  }
};

SurfaceMesh outer(const SurfaceMesh& mesh)
{
  const std::optional<SurfaceMesh> surface = outerSurface(weldCoincidentPoints(mesh));
  EXPECT_TRUE(surface);
  return surface.value_or(SurfaceMesh());
}

} // namespace

TEST(OuterSurface, IsNoneWhereNothingCrosses)
{
  bool isTangled = true;
  EXPECT_FALSE(outerSurface(icosphere(2), {}, &isTangled));
  EXPECT_FALSE(isTangled);
  const SurfaceMesh apart =
    shapes::merged(shapes::box(Vec3::Zero(), Vec3::Ones()), shapes::box({ 2, 0, 0 }, { 3, 1, 1 }));
  EXPECT_FALSE(outerSurface(apart));
}

TEST(OuterSurface, IsNoneOfATangle)
{
  // 71 x 71 needles through one triangle of a plate: more pairs of lines than can be looked at.
  constexpr int Side = 71;
  const Eigen::Matrix3d slim = Vec3(0.1, 0.1, 3.0).asDiagonal();
  const SurfaceMesh needle = shapes::mapped(shapes::cornerTetrahedron(), slim);
  SurfaceMesh needles;
  for (int k = 0; k < Side * Side; ++k)
  {
    const Vec3 place(k % Side + 0.3, k / Side + 0.4, -1.0);
    for (const Vec3& point : needle.points)
    {
      needles.addPoint(point + place);
    }
    const Index first = needles.vertexCount() - needle.vertexCount();
    for (Index f = 0; f < needle.faceCount(); ++f)
    {
      needles.addFace({ first + needle.faceVertex(f, 0), first + needle.faceVertex(f, 1),
        first + needle.faceVertex(f, 2) });
    }
  }
  const SurfaceMesh plate = shapes::box({ -200, -200, -0.5 }, { 200, 200, 0.5 });
  bool isTangled = false;
  EXPECT_FALSE(outerSurface(shapes::merged(needles, plate), {}, &isTangled));
  EXPECT_TRUE(isTangled);
}

TEST(OuterSurface, OfTwoBoxesIsTheirUnion)
{
  const SurfaceMesh boxes = shapes::merged(
    shapes::box(Vec3::Zero(), Vec3::Ones()), shapes::box({ 0.5, 0.4, 0.3 }, { 2, 1.7, 1.9 }));
  const SurfaceMesh surface = outer(boxes);
  const TopologySummary topology = summarizeTopology(surface);
  EXPECT_TRUE(topology.isClosed() && topology.isManifold() && topology.isOriented());
  EXPECT_EQ(topology.components, 1);
  EXPECT_EQ(topology.genus(), 0);
  EXPECT_NEAR(signedVolume(surface), 1.0 + 1.5 * 1.3 * 1.6 - 0.5 * 0.6 * 0.7, 1e-4);
}

TEST(OuterSurface, OfBoxesThatTouchInEveryWayIsTheirUnion)
{
  for (unsigned seed = 0; seed < 60; ++seed)
  {
    const Boxes boxes(8, seed);
    const auto surface = outerSurface(boxes.mesh);
    if (!surface)
    {
      continue;
    }
    EXPECT_NEAR(signedVolume(*surface), boxes.volume(), 1e-3) << seed;
    EXPECT_NEAR(surfaceArea(*surface), boxes.area(), 1e-2) << seed;
    EXPECT_EQ(summarizeTopology(*surface).boundaryEdges, 0) << seed;
    EXPECT_TRUE(summarizeTopology(*surface).isOriented()) << seed;
  }
}

TEST(OuterSurface, OfTurnedBoxesIsTheirUnionToo)
{
  const Eigen::Matrix3d rotation = shapes::someRotation();
  for (unsigned seed = 0; seed < 20; ++seed)
  {
    const Boxes boxes(12, seed);
    const auto surface =
      outerSurface(shapes::transformed(shapes::mapped(boxes.mesh, rotation), 1e-3, Vec3(1, -2, 3)));
    ASSERT_TRUE(surface);
    EXPECT_NEAR(1e9 * signedVolume(*surface), boxes.volume(), 1e-3) << seed;
    EXPECT_NEAR(1e6 * surfaceArea(*surface), boxes.area(), 1e-2) << seed;
  }
}

/// Welded, they share a face, an edge or a corner.
TEST(OuterSurface, OfBoxesThatShareTheirPointsIsTheirUnion)
{
  for (const Vec3& step : { Vec3(1, 0, 0), Vec3(1, 1, 0), Vec3(1, 1, 1) })
  {
    SurfaceMesh row;
    for (int i = 0; i < 3; ++i)
    {
      row = shapes::merged(row, shapes::box(i * step, i * step + Vec3::Ones()));
    }
    const SurfaceMesh surface = outer(row);
    EXPECT_NEAR(signedVolume(surface), 3.0, 1e-4);
    EXPECT_NEAR(surfaceArea(surface), step.sum() == 1.0 ? 14.0 : 18.0, 1e-3);
    EXPECT_TRUE(summarizeTopology(surface).isClosed());
    EXPECT_EQ(summarizeTopology(surface).components, 1);
  }
}

TEST(OuterSurface, DoesNotAskHowPartsAreTurned)
{
  const SurfaceMesh ball = icosphere(3);
  const SurfaceMesh box = shapes::box(Vec3::Zero(), Vec3(2, 2, 2));
  const SurfaceMesh expected = outer(shapes::merged(ball, box));
  EXPECT_NEAR(signedVolume(expected), 8.0 + signedVolume(ball) * 7.0 / 8.0, 1e-2);
  EXPECT_EQ(outer(shapes::merged(reversed(ball), box)).faceCount(), expected.faceCount());
  EXPECT_EQ(outer(shapes::merged(ball, reversed(box))).faceCount(), expected.faceCount());
}

TEST(OuterSurface, HasACurveWhereASheetEntersABox)
{
  // The sheet [0, 1]^2 at height 0.5, the right half of it in a box.
  const SurfaceMesh sheet = shapes::transformed(shapes::sheet(4, true), 1.0, Vec3(0, 0, 0.5));
  const SurfaceMesh box = shapes::box({ 0.55, -1, -1 }, { 3, 2, 2 });
  const Box extent = boundingBox(sheet);
  const double kept = (0.55 - extent.min().x()) * extent.sizes().y();
  const SurfaceMesh surface = outer(shapes::merged(sheet, box));
  EXPECT_NEAR(surfaceArea(surface), surfaceArea(box) + kept, 1e-3);
  EXPECT_EQ(summarizeTopology(surface).components, 1);
}

TEST(OuterSurface, KeepsTheFloorOfACavity)
{
  // A hollow ball with a rod through its wall: the cavity stays one.
  const SurfaceMesh hollow =
    shapes::merged(icosphere(3), reversed(shapes::transformed(icosphere(3), 0.5, Vec3::Zero())));
  const SurfaceMesh surface =
    outer(shapes::merged(hollow, shapes::box({ 0.7, -0.1, -0.1 }, { 1.5, 0.1, 0.1 })));
  EXPECT_NEAR(boundingBox(surface).max().x(), 1.5, 1e-4);
  EXPECT_EQ(summarizeTopology(surface).components, 2);
}

TEST(OuterSurface, DoesNotCutASoup)
{
  const SurfaceMesh soup = weldCoincidentPoints(shapes::randomSoup(120, 2.0, 3));
  EXPECT_FALSE(outerSurface(soup));
  // But by a box that is in it.
  const auto surface = outerSurface(shapes::merged(soup, shapes::box(Vec3::Zero(), Vec3::Ones())));
  ASSERT_TRUE(surface);
  EXPECT_LT(surface->faceCount(), 3000);
}

TEST(OuterSurface, OnThreadsIsTheSame)
{
  const SurfaceMesh mesh = Boxes(12, 1).mesh;
  const auto alone = outerSurface(mesh);
  EXPECT_EQ(outerSurface(mesh, threadedExecution(2, 1)), alone);
  EXPECT_EQ(outerSurface(mesh, threadedExecution(8, 1)), alone);
}
