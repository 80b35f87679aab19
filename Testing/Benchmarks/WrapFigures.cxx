// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "WrapFigures.h"

#include "ElementQuality.h"
#include "Models.h"
#include "NormalDeviation.h"
#include "Report.h"
#include "SurfaceDeviation.h"

#include "Cxx/RaggedEdges.h"
#include "Cxx/SampleSurfaces.h"

#include "Mesh/TopologySummary.h"

#include "vtkPolyData.h"

#include <cmath>
#include <limits>

namespace benchmark
{

namespace
{

constexpr double None = std::numeric_limits<double>::quiet_NaN();

enum class Better
{
  Neither,
  Smaller,
  Larger,
  AsTheTarget
};

struct Column
{
  const char* name;
  int digits;
  Better better;
};

const std::vector<Column>& columns()
{
  static const std::vector<Column> all{ { "points", 0, Better::Neither },
    { "ragged", 2, Better::Smaller }, { "% over 20", 2, Better::Smaller },
    { "normal rms", 2, Better::Smaller }, { "hausdorff", 5, Better::Smaller },
    { "fwd max", 5, Better::Smaller }, { "fwd rms", 6, Better::Smaller },
    { "bwd rms", 6, Better::Smaller }, { "genus", 0, Better::AsTheTarget },
    { "least angle", 1, Better::Larger }, { "seconds", 2, Better::Smaller } };
  return all;
}

double genusOf(const evolving::SurfaceMesh& surface)
{
  const evolving::TopologySummary topology = evolving::summarizeTopology(surface);
  const bool hasGenus = topology.isClosed() && topology.isManifold() && topology.isOriented();
  return hasGenus ? static_cast<double>(topology.genus()) : None;
}

/// Not of several parts, which may hide or meet each other: nobody knows which one is right.
double rightGenus(const evolving::SurfaceMesh& target)
{
  return evolving::summarizeTopology(target).components == 1 ? genusOf(target) : None;
}

Sample::Surface polyDataOf(const evolving::SurfaceMesh& surface)
{
  std::vector<Sample::Point> points;
  for (const evolving::Vec3& point : surface.points)
  {
    points.push_back({ point.x(), point.y(), point.z() });
  }
  std::vector<Sample::Polygon> triangles;
  for (evolving::Index f = 0; f < surface.faceCount(); ++f)
  {
    triangles.push_back(
      { surface.faceVertex(f, 0), surface.faceVertex(f, 1), surface.faceVertex(f, 2) });
  }
  return Sample::Make(points, triangles);
}

/// What is not a number is never better, nor is there a better one than it.
bool isBetter(Better better, double a, double b, double target)
{
  switch (better)
  {
    case Better::Smaller:
      return a < b;
    case Better::Larger:
      return a > b;
    case Better::AsTheTarget:
      return std::abs(a - target) < std::abs(b - target);
    default:
      return false;
  }
}

} // namespace

std::vector<std::string> figureNames()
{
  std::vector<std::string> names;
  for (const Column& column : columns())
  {
    names.emplace_back(column.name);
  }
  return names;
}

std::vector<std::string> figureNotes()
{
  return {
    "A star: the better of the two; of genera the one nearer to that of the target, where this is"
    " one closed surface.",
    "Ragged: the length of edges sharper than 30 degrees that continue nowhere (saw teeth), corners"
    " of the target apart, and distances, by the diagonal of the target's box; forward from the"
    " result to the target.",
    "% over 20: of the result's area, where its normal is more than 20 degrees off the target's;"
    " normal rms and least angle in degrees."
  };
}

WrapFigures wrapFigures(
  const evolving::SurfaceMesh& surface, vtkPolyData* target, const Seconds& time)
{
  const evolving::SurfaceMesh reference = kernelMesh(target);
  const double diagonal = evolving::boundingBox(reference).diagonal().norm();
  const NormalDeviation normals = normalDeviation(surface, reference);
  const SurfaceDeviation off = deviation(surface, reference);
  return { static_cast<double>(surface.vertexCount()),
    RaggedLengthOf(polyDataOf(surface), target) / diagonal, 100.0 * normals.partOver20, normals.rms,
    off.hausdorff(), off.forward.largest, off.forward.rms, off.backward.rms, genusOf(surface),
    elementQuality(surface).smallestAngle, time.wall };
}

std::vector<std::string> withStars(
  const WrapFigures& figures, const WrapFigures& others, vtkPolyData* target)
{
  const double genus = rightGenus(kernelMesh(target));
  std::vector<std::string> texts;
  for (std::size_t c = 0; c < columns().size(); ++c)
  {
    const Column& column = columns()[c];
    const std::string text =
      std::isnan(figures[c]) ? std::string("-") : fixed(figures[c], column.digits);
    texts.push_back(text + (isBetter(column.better, figures[c], others[c], genus) ? "*" : " "));
  }
  return texts;
}

} // namespace benchmark
