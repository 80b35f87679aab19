// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Remeshing/VertexBudget.h"

#include "Errors.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <vector>

namespace evolving
{

namespace
{

/// Of a needle for each size that it is long, up to where it counts for the half of an equilateral
/// triangle of its longest edge: as measured, when short edges have collapsed.
constexpr double VerticesPerLength = 4.0;
constexpr double VerticesPerSquaredLength = 1.0 / 7.0;

/// What a face is to be divided into, in squares and lengths of its size.
struct FaceNeed
{
  double area;
  double longestEdge;

  /// With sizes that many times as large. A vertex has two equilateral triangles of area
  /// sqrt(3)/4 s^2; an equilateral one has a vertex for each 4 s^2 of its squared edge.
  double vertices(double coarser) const
  {
    const double byArea = this->area / (std::sqrt(3.0) / 2.0 * coarser * coarser);
    const double length = this->longestEdge / coarser;
    const double byLength =
      std::min(VerticesPerLength * length, VerticesPerSquaredLength * length * length);
    return std::max(byArea, byLength);
  }
};

FaceNeed needOf(const EditableSurface& surface, Index face)
{
  double size = 0.0;
  double longest = 0.0;
  for (Index e = 3 * face; e < 3 * face + 3; ++e)
  {
    size += surface.size(surface.from(e)) / 3.0;
    longest = std::max(longest, surface.length(e));
  }
  if (!(longest > 0.0)) // a point is not divided, whatever its size
  {
    return { 0.0, 0.0 };
  }
  return { 0.5 * surface.doubleArea(face).norm() / (size * size), longest / size };
}

std::vector<FaceNeed> needsOf(const EditableSurface& surface)
{
  std::vector<FaceNeed> needs;
  for (Index f = 0; f < surface.faceSlots(); ++f)
  {
    if (surface.hasFace(f))
    {
      needs.push_back(needOf(surface, f));
    }
  }
  return needs;
}

double verticesToMake(const std::vector<FaceNeed>& needs, double coarser)
{
  double vertices = 0.0;
  for (const FaceNeed& need : needs)
  {
    vertices += need.vertices(coarser);
  }
  return vertices;
}

/// How many times as large sizes must be.
double coarsening(const std::vector<FaceNeed>& needs, double most)
{
  double tooFine = 1.0;
  double enough = 2.0;
  while (verticesToMake(needs, enough) > most)
  {
    tooFine = enough;
    enough *= 2.0;
  }
  constexpr int Bisections = 20; // to six digits
  for (int i = 0; i < Bisections; ++i)
  {
    const double middle = 0.5 * (tooFine + enough);
    (verticesToMake(needs, middle) > most ? tooFine : enough) = middle;
  }
  return enough;
}

} // namespace

double verticesToMake(const EditableSurface& surface)
{
  return verticesToMake(needsOf(surface), 1.0);
}

void requireFewVertices(const EditableSurface& surface, double edgeLength, double most)
{
  const std::vector<FaceNeed> needs = needsOf(surface);
  const double vertices = verticesToMake(needs, 1.0);
  if (vertices <= most)
  {
    return;
  }
  constexpr double Margin = 1.1; // so that what is proposed passes
  std::ostringstream message;
  message << "Triangles with edges of " << edgeLength << " would be about " << 2.0 * vertices
          << ", expected at most " << 2.0 * most << "; set TargetEdgeLength to at least "
          << Margin * edgeLength * coarsening(needs, most) << ".";
  throw InputError(message.str());
}

} // namespace evolving
