// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

// The measure of ragged edges, on boxes whose edges are known.

#include "ChangedSurfaces.h"
#include "RaggedEdges.h"
#include "SampleSurfaces.h"

#include "vtkPolyData.h"

#include <gtest/gtest.h>

#include <cmath>

namespace
{

using Sample::Point;

/// Boxes and sheets from -1 to 1 have eight quads each way.
constexpr double Side = 0.25;

//------------------------------------------------------------------------------
/// Moves every second point of the edge at x = 1, y = 1 inwards, within the face y = 1.
Point Notched(const Point& p, double depth)
{
  const bool isSecond = std::lround((p[2] + 1.0) / Side) % 2 == 1;
  return { p[0] == 1.0 && p[1] == 1.0 && isSecond ? 1.0 - depth : p[0], p[1], p[2] };
}

//------------------------------------------------------------------------------
TEST(RaggedEdges, OfABoxAreNone)
{
  const auto box = Sample::Box(8);
  EXPECT_NEAR(SharpLengthOf(box), 24.0, 1e-9);
  EXPECT_EQ(RaggedLengthOf(box, box), 0.0);
  EXPECT_EQ(SharpLengthOf(Sample::Icosphere(3)), 0.0);
}

//------------------------------------------------------------------------------
TEST(RaggedEdges, AreThoseOfASaw)
{
  // Its teeth turn by 51 degrees. All but the two edges at the corners are counted.
  const auto sheet = Sample::Sheet(8);
  const auto saw = Sample::Mapped(sheet,
    [](const Point& p)
    {
      const bool isSecond = std::lround((p[0] + 1.0) / Side) % 2 == 1;
      return Point{ p[0], p[1] == 1.0 && isSecond ? 1.0 - 0.12 : p[1], p[2] };
    });
  EXPECT_EQ(RaggedLengthOf(sheet, sheet), 0.0);
  EXPECT_NEAR(RaggedLengthOf(saw, sheet), 6.0 * std::hypot(Side, 0.12), 1e-9);
}

//------------------------------------------------------------------------------
TEST(RaggedEdges, AreTeethAndFoldsOfABox)
{
  const auto box = Sample::Box(8);
  const auto notched = Sample::Mapped(box, [](const Point& p) { return Notched(p, 0.12); });
  EXPECT_GT(RaggedLengthOf(notched, box), 8.0 * std::hypot(Side, 0.12));
}

//------------------------------------------------------------------------------
TEST(RaggedEdges, AreNotThoseThatOnlyBend)
{
  // By 23 degrees, as the rim of a round hole of 16 edges does.
  const auto box = Sample::Box(8);
  const auto bent = Sample::Mapped(box, [](const Point& p) { return Notched(p, 0.05); });
  EXPECT_EQ(RaggedLengthOf(bent, box), 0.0);
}

//------------------------------------------------------------------------------
TEST(RaggedEdges, AreAtCornersThatTheTargetHasNot)
{
  // Three edges at each of the eight.
  EXPECT_NEAR(RaggedLengthOf(Sample::Box(8), Sample::Icosphere(3)), 24.0 * Side, 1e-9);
}

//------------------------------------------------------------------------------
TEST(RaggedEdges, AreThoseOfARimThatLostATriangle)
{
  // Its three edges have one triangle now, and turn by 90 and 135 degrees.
  const auto box = Sample::Triangulated(Sample::Box(8));
  const auto open = Sample::KeepPolygons(box, [](vtkIdType number) { return number != 20; });
  EXPECT_NEAR(RaggedLengthOf(open, box), (2.0 + std::sqrt(2.0)) * Side, 1e-9);
}

} // namespace
