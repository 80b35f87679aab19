// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "DirtySurfaces.h"

#include "ChangedSurfaces.h"

#include "vtkCellArray.h"
#include "vtkCleanPolyData.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <algorithm>

namespace
{

using Sample::Point;
using Sample::Polygon;
using Sample::Surface;

constexpr Answer Result = Answer::Result;
constexpr Answer Empty = Answer::Empty;
constexpr Answer Error = Answer::Error;

//------------------------------------------------------------------------------
Surface Sphere()
{
  return Sample::Icosphere(2);
}

//------------------------------------------------------------------------------
/// A sphere whose point 7 is elsewhere.
Surface WithPoint(double x)
{
  const auto surface = Sphere();
  surface->GetPoints()->SetPoint(7, x, 0.0, 0.0);
  return surface;
}

//------------------------------------------------------------------------------
/// A sphere with a point outside that no polygon uses.
Surface WithStrayPoint()
{
  std::vector<Point> points = Sample::CoordinatesOf(Sphere());
  points.push_back({ 3.0, 0.0, 0.0 });
  return Sample::Make(points, Sample::PolygonsOf(Sphere()));
}

//------------------------------------------------------------------------------
/// A sphere with one more polygon.
Surface WithPolygon(const Polygon& polygon)
{
  const auto surface = Sphere();
  surface->GetPolys()->InsertNextCell(static_cast<vtkIdType>(polygon.size()), polygon.data());
  return surface;
}

//------------------------------------------------------------------------------
Surface Scaled(double factor)
{
  return Sample::Icosphere(2, factor);
}

//------------------------------------------------------------------------------
/// The points of a sphere with cells of another kind.
Surface WithCells(void (vtkPolyData::*set)(vtkCellArray*), vtkIdType size)
{
  const auto surface = Sample::PointsOf(Sphere());
  vtkNew<vtkCellArray> cells;
  for (vtkIdType id = 0; id + size <= surface->GetNumberOfPoints(); ++id)
  {
    const vtkIdType ids[2] = { id, id + 1 };
    cells->InsertNextCell(size, ids);
  }
  (surface->*set)(cells);
  return surface;
}

//------------------------------------------------------------------------------
Surface Strip()
{
  const auto surface = Sample::Make(
    { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 1, 1, 0 }, { 0, 2, 0 }, { 1, 2, 0 } }, {});
  vtkNew<vtkCellArray> strips;
  const vtkIdType ids[6] = { 0, 1, 2, 3, 4, 5 };
  strips->InsertNextCell(6, ids);
  surface->SetStrips(strips);
  return surface;
}

//------------------------------------------------------------------------------
Surface StripWithWrongId()
{
  const auto surface = Strip();
  vtkNew<vtkCellArray> strips;
  // More than 32 bits: must not be cut to point 1.
  const vtkIdType ids[4] = { 0, (vtkIdType(1) << 32) + 1, 2, 3 };
  strips->InsertNextCell(4, ids);
  surface->SetStrips(strips);
  return surface;
}

//------------------------------------------------------------------------------
/// Two closed cubes, one beside the other, each with points of its own.
Surface TwoCubes(const Point& way)
{
  const auto second = Sample::Box(2);
  for (vtkIdType i = 0; i < second->GetNumberOfPoints(); ++i)
  {
    double p[3];
    second->GetPoint(i, p);
    second->GetPoints()->SetPoint(i, p[0] + way[0], p[1] + way[1], p[2] + way[2]);
  }
  return Sample::Together(Sample::Box(2), second);
}

//------------------------------------------------------------------------------
/// With points in common.
Surface Joined(const Surface& surface)
{
  vtkNew<vtkCleanPolyData> joined;
  joined->SetInputData(surface);
  joined->Update();
  return joined->GetOutput();
}

//------------------------------------------------------------------------------
Surface CubesAlongAnEdge()
{
  return TwoCubes({ 2.0, 2.0, 0.0 });
}

//------------------------------------------------------------------------------
Surface CubesInACorner()
{
  return TwoCubes({ 2.0, 2.0, 2.0 });
}

//------------------------------------------------------------------------------
/// Four faces meet at one edge.
Surface EdgeOfFourFaces()
{
  return Joined(CubesAlongAnEdge());
}

//------------------------------------------------------------------------------
Surface PointOfTwoFans()
{
  return Joined(CubesInACorner());
}

//------------------------------------------------------------------------------
/// Two triangles of the sphere once more, with the same and with the opposite orientation.
Surface WithDuplicateFaces()
{
  const auto surface = Sphere();
  const Polygon first = Sample::PolygonOf(surface, 0);
  Polygon second = Sample::PolygonOf(surface, 50);
  std::reverse(second.begin(), second.end());
  surface->GetPolys()->InsertNextCell(3, first.data());
  surface->GetPolys()->InsertNextCell(3, second.data());
  return surface;
}

//------------------------------------------------------------------------------
Surface Overlapping()
{
  return Sample::Together(Sphere(), Sample::Icosphere(2, 1.0, { 0.7, 0.0, 0.0 }));
}

} // namespace

//------------------------------------------------------------------------------
const std::vector<DirtySurface>& DirtySurfaces()
{
  constexpr Answer R = Result;
  constexpr Answer O = Empty;
  constexpr Answer X = Error;
  using S = Sample::Surface;
  // In this order: distance, evolution, redistribution, wrap, hierarchy.
  static const std::vector<DirtySurface> all = {
    { "Nothing", []() { return S::New(); }, O, O, O, O, O },
    { "PointsOnly", []() { return Sample::PointsOf(Sphere()); }, R, X, X, R, X },
    { "OnePoint",
      []() {
        return Sample::Make({ { 1, 2, 3 } }, {});
      },
      R, X, X, X, X },
    { "Vertices", []() { return WithCells(&vtkPolyData::SetVerts, 1); }, R, X, X, R, X },
    { "Lines", []() { return WithCells(&vtkPolyData::SetLines, 2); }, R, X, X, R, X },
    { "OneTriangle",
      []() {
        return Sample::Make({ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 1 } }, { { 0, 1, 2 } });
      },
      R, R, R, R, R },
    { "Strip", Strip, R, R, R, R, R },
    { "Quads", []() { return Sample::CubeSphere(5); }, R, R, R, R, R },
    { "Soup", []() { return Sample::Soup(Sphere()); }, R, R, R, R, R },
    { "Sheet", []() { return Sample::Sheet(6); }, R, R, R, R, R },
    { "Open", []() { return Sample::KeepPolygons(Sphere(), [](vtkIdType i) { return i > 0; }); }, R,
      R, R, R, R },
    { "InsideOut", []() { return Sample::InsideOut(Sphere()); }, R, R, R, R, R },
    { "TwoParts",
      []() {
        return Sample::Together(Sphere(), Sample::Icosphere(2, 1.0, { 4, 0, 0 }));
      },
      R, R, R, R, R },
    { "Shells", []() { return Sample::Together(Sphere(), Sample::Icosphere(2, 0.5)); }, R, R, R, R,
      R },
    { "Overlapping", Overlapping, R, R, R, R, R },
    { "FarAway",
      []() {
        return Sample::Icosphere(2, 1.0, { 1e6, 1e6, -1e6 });
      },
      R, R, R, R, R },
    { "Tiny", []() { return Scaled(1e-30); }, R, R, R, R, R },
    { "Huge", []() { return Scaled(1e30); }, R, R, R, R, R },
    { "StrayPoint", WithStrayPoint, R, R, R, R, R },
    { "DuplicateFaces", WithDuplicateFaces, R, X, X, R, R },
    { "CubesAlongAnEdge", CubesAlongAnEdge, R, R, R, R, R },
    { "CubesInACorner", CubesInACorner, R, R, R, R, R },
    { "EdgeOfFourFaces", EdgeOfFourFaces, R, X, X, R, R },
    { "PointOfTwoFans", PointOfTwoFans, R, X, X, R, R },
    { "MixedOrientation", []() { return Sample::WithMixedOrientation(Sphere()); }, R, X, X, R, R },
    { "Moebius", []() { return Sample::Moebius(40); }, R, X, X, R, R },
    { "NoArea",
      []() {
        return Sample::Make({ { 0, 0, 0 }, { 1, 1, 1 }, { 2, 2, 2 } }, { { 0, 1, 2 } });
      },
      R, X, R, X, R },
    { "NaN", []() { return WithPoint(vtkMath::Nan()); }, X, X, X, R, X },
    { "Infinity", []() { return WithPoint(vtkMath::Inf()); }, X, X, X, R, X },
    { "IdTooLarge",
      []() {
        return WithPolygon({ 0, 1, 162 });
      },
      X, X, X, X, X },
    { "IdBeyondInt",
      []() {
        return WithPolygon({ 0, 1, (vtkIdType(1) << 32) + 2 });
      },
      X, X, X, X, X },
    { "IdNegative",
      []() {
        return WithPolygon({ 0, 1, -1 });
      },
      X, X, X, X, X },
    { "IdOfStripBeyondInt", StripWithWrongId, X, X, X, X, X },
    { "TwoCorners",
      []() {
        return WithPolygon({ 0, 1 });
      },
      X, X, X, R, X },
  };
  return all;
}
