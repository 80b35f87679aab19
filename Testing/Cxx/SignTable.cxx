// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "SignTable.h"

#include "ChangedSurfaces.h"
#include "SelfCrossingSurfaces.h"

#include "vtkMeshSDF.h"
#include "vtkPolyData.h"

namespace
{

using Sample::Point;
using Sample::Surface;

//------------------------------------------------------------------------------
Surface Sphere()
{
  return Sample::Icosphere(3);
}

//------------------------------------------------------------------------------
Surface FacesTwice()
{
  const auto some = Sample::KeepPolygons(Sphere(), [](vtkIdType i) { return i % 4 == 0; });
  const auto others = Sample::KeepPolygons(Sphere(), [](vtkIdType i) { return i % 4 == 1; });
  return Sample::Together(Sphere(), Sample::Together(some, Sample::InsideOut(others)));
}

//------------------------------------------------------------------------------
/// A triangle without area beside the sphere.
Surface WithoutArea()
{
  const auto segment =
    Sample::Make({ { -0.9, -1.3, 0.9 }, { 0.9, -1.3, 0.9 }, { 0, -1.3, 0.9 } }, { { 0, 1, 2 } });
  return Sample::Together(Sphere(), segment);
}

//------------------------------------------------------------------------------
Surface Apart()
{
  return Sample::Together(Sphere(), Sample::InsideOut(Sample::Icosphere(3, 0.5, { 3, 0, 0 })));
}

//------------------------------------------------------------------------------
Surface Shells()
{
  return Sample::InsideOut(Sample::Together(Sphere(), Sample::Icosphere(3, 0.5)));
}

//------------------------------------------------------------------------------
Surface Hollow()
{
  return Sample::Together(Sample::InsideOut(Sphere()), Sample::Icosphere(3, 0.5));
}

//------------------------------------------------------------------------------
Surface Overlapping()
{
  return Sample::Together(Sphere(), Sample::InsideOut(Sample::Icosphere(3, 1.0, { 1, 0, 0 })));
}

//------------------------------------------------------------------------------
Surface WithHoles()
{
  return Sample::InsideOut(Sample::KeepPolygons(Sphere(), [](vtkIdType i) { return i % 11 != 0; }));
}

//------------------------------------------------------------------------------
/// The part of the sphere below z = 0.2, facing inwards.
Surface Bowl()
{
  std::vector<Sample::Polygon> low;
  const std::vector<Point> points = Sample::CoordinatesOf(Sphere());
  for (const Sample::Polygon& polygon : Sample::PolygonsOf(Sphere()))
  {
    if (points[static_cast<std::size_t>(polygon.front())][2] < 0.2)
    {
      low.push_back(polygon);
    }
  }
  return Sample::InsideOut(Sample::Make(points, low));
}

//------------------------------------------------------------------------------
/// Two cubes with one edge in common, and a third that shares a corner with the first.
Surface Touching()
{
  const auto cube = Sample::Box(2);
  const auto second = Sample::Mapped(cube,
    [](const Point& p) -> Point {
      return { p[0] + 2.0, p[1] + 2.0, p[2] };
    });
  const auto third = Sample::Mapped(cube,
    [](const Point& p) -> Point {
      return { p[0] - 2.0, p[1] - 2.0, p[2] - 2.0 };
    });
  return Sample::Together(Sample::Together(cube, Sample::InsideOut(second)), third);
}

//------------------------------------------------------------------------------
/// Two cubes with one side in common.
Surface WithWall()
{
  const auto moved = Sample::Mapped(Sample::Box(1),
    [](const Point& p) -> Point {
      return { p[0] + 2.0, p[1], p[2] };
    });
  return Sample::Together(Sample::Box(1), moved);
}

//------------------------------------------------------------------------------
/// A cube with a sheet that stands on the edge x = y = 1.
Surface WithFin()
{
  std::vector<Point> points = Sample::CoordinatesOf(Sample::Box(1));
  std::vector<Sample::Polygon> polygons = Sample::PolygonsOf(Sample::Box(1));
  const auto first = static_cast<vtkIdType>(points.size());
  points.insert(points.end(), { { 1, 1, -1 }, { 1, 1, 1 }, { 2, 2, 1 }, { 2, 2, -1 } });
  polygons.push_back({ first, first + 1, first + 2, first + 3 });
  return Sample::Make(points, polygons);
}

constexpr int Normal = vtkMeshSDF::PSEUDONORMAL;
constexpr int Winding = vtkMeshSDF::WINDING_NUMBER;

const SignCell Right = { "right", "-+" };
const std::vector<Point> InAndOut = { { 0, 0, 0 }, { 1.2, 0, 0 } };

//------------------------------------------------------------------------------
std::vector<SignRow> ClosedRows()
{
  return { { "Closed", "Closed", Sphere, InAndOut, Right, Right, Right, Normal },
    { "InsideOut", "Closed, facing inwards", [] { return Sample::InsideOut(Sphere()); }, InAndOut,
      Right, Right, Right, Normal },
    { "Flipped", "Closed, some faces flipped",
      [] { return Sample::WithMixedOrientation(Sphere()); }, InAndOut, Right, Right, Right,
      Normal },
    { "Twice", "Closed, some faces twice, either way round", FacesTwice, InAndOut, Right, Right,
      Right, Normal },
    { "Soup", "Closed, every face with its own points (STL)", [] { return Sample::Soup(Sphere()); },
      InAndOut, Right, Right, Right, Normal },
    { "WithoutArea", "Closed, and faces without area", WithoutArea, InAndOut, Right, Right, Right,
      Winding },
    { "Apart", "Closed parts that are apart, each facing either way", Apart,
      { { 0, 0, 0 }, { 3, 0, 0 }, { 1.7, 0, 0 } }, { "right", "--+" }, { "right", "--+" },
      { "right", "--+" }, Normal },
    { "Touching", "Closed parts that touch in edges or corners, each facing either way", Touching,
      { { 0, 0, 0 }, { 2, 2, 0 }, { -2, -2, -2 }, { 2, 0, 0 } }, { "right", "---+" },
      { "right", "---+" }, { "right", "---+" }, Winding } };
}

//------------------------------------------------------------------------------
std::vector<SignRow> NestedAndCrossingRows()
{
  return { { "Overlapping", "Closed parts that overlap, each facing either way", Overlapping,
             { { -0.75, 0, 0 }, { -0.15, 0, 0 }, { 0.5, 0, 0 }, { 2.3, 0, 0 } },
             { "right, but for single samples where parts cross", "---+" },
             { "outside next to hidden faces", "-+-+" }, { "right", "---+" }, Winding },
    { "Shells", "A shell in a shell, facing the same way", Shells,
      { { 0, 0, 0 }, { 0.62, 0, 0 }, { 0.88, 0, 0 }, { 1.2, 0, 0 } },
      { "solid: inside both", "---+" }, { "outside next to the inner shell", "-+-+" },
      { "solid: inside both", "---+" }, Winding },
    { "Hollow", "A shell in a shell, facing the other way (a hollow)", Hollow,
      { { 0, 0, 0 }, { 0.62, 0, 0 }, { 0.88, 0, 0 }, { 1.2, 0, 0 } },
      { "solid: the hollow is inside", "---+" }, { "right", "+--+" }, { "right", "+--+" },
      Winding },
    { "SelfCrossing", "A surface that crosses itself, all of it facing outwards",
      Sample::SelfOverlappingPrism,
      { { 0.25, 0, 0 }, { 0.62, 0, 0 }, { 1.3, 0, 0 }, { -0.4, 0, 0 } }, { "right", "---+" },
      { "outside next to hidden faces", "-+-+" }, { "right", "---+" }, Winding },
    { "SelfCrossingTwisted", "A surface that crosses itself, a part of it facing inwards",
      Sample::TwistedPrism, { { -0.6, 0, 0 }, { 0.4, 0, 0 }, { 0.9, 0, 0 }, { 0.2, 0.6, 0 } },
      { "right", "--++" }, { "wrong there, and far outside too", "-+--" },
      { "that part is outside", "-+++" }, Winding } };
}

//------------------------------------------------------------------------------
std::vector<SignRow> OtherRows()
{
  return { { "Wall", "Closed, and a wall inside", WithWall,
             { { 0, 0, 0 }, { 0.75, 0, 0 }, { 1.25, 0, 0 }, { 3.3, 0, 0 } }, { "right", "---+" },
             { "outside next to one side of the wall", "--++" }, { "right", "---+" }, Winding },
    { "Fin", "Closed, and a fin outside", WithFin,
      { { 0, 0, 0 }, { 1.6, 1.4, 0 }, { 1.4, 1.6, 0 } }, { "right", "-++" },
      { "inside next to one side of the fin", "--+" }, { "right", "-++" }, Winding },
    { "Holes", "Open, with holes wider than a cell, facing either way", WithHoles, InAndOut,
      { "outside: the flood pours in", "++" }, { "right away from the holes", "-+" },
      { "right away from the holes", "-+" }, Winding },
    { "Bowl", "Open, with a large opening (a bowl), facing either way", Bowl,
      { { 0, 0, -0.6 }, { 0, 0, 0.8 }, { 1.2, 0, -0.3 } }, { "outside: the flood pours in", "+++" },
      { "inside in front of the opening too", "--+" },
      { "inside up to a membrane over the opening, where the sign jumps", "-++" }, Winding },
    { "Sheet", "A sheet, a single triangle", [] { return Sample::Sheet(6); },
      { { 0, 0, 0.5 }, { 0, 0, -0.5 } }, { "outside", "++" },
      { "outside before it, inside behind it", "+-" }, { "outside", "++" }, Winding },
    { "OneSided", "A one-sided surface (Moebius band, Klein bottle)",
      [] { return Sample::Moebius(40); }, {}, { "without meaning", "?" },
      { "without meaning", "?" }, { "without meaning", "?" }, Winding },
    { "Points", "Points, vertices, lines: the points are measured to",
      [] { return Sample::PointsOf(Sphere()); }, InAndOut, { "refused", "!" }, { "refused", "!" },
      { "refused", "!" }, vtkMeshSDF::UNSIGNED } };
}

} // namespace

//------------------------------------------------------------------------------
const std::vector<SignRow>& SignTable()
{
  static const std::vector<SignRow> table = []
  {
    std::vector<SignRow> rows;
    for (const auto& part : { ClosedRows(), NestedAndCrossingRows(), OtherRows() })
    {
      rows.insert(rows.end(), part.begin(), part.end());
    }
    return rows;
  }();
  return table;
}

//------------------------------------------------------------------------------
std::string HtmlOf(const SignRow& row)
{
  static const char* const names[] = { "", "Flood Fill", "Winding Number", "Pseudonormal",
    "Unsigned" };
  const auto cell = [](const char* text) { return std::string("<td>") + text + "</td>"; };
  return "<tr>" + cell(row.Input) + cell(row.FloodFill.Says) + cell(row.Pseudonormal.Says) +
    cell(row.WindingNumber.Says) + cell("no sign") + cell(names[row.Automatic]) + "</tr>";
}
