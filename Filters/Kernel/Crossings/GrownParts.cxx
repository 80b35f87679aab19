// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Crossings/GrownParts.h"

#include "Mesh/VertexNormals.h"

#include <cmath>

namespace evolving
{

namespace
{

///@{
/// Of the diagonal: more than what floats leave of a contact, and so little that the strips that
/// come of faces side by side are lower than what FaceNormals takes for slivers.
constexpr double LeastGrowth = 4e-7;
constexpr double MoreGrowth = 4e-7;
/// To all sides: boxes on a lattice that only grow would still meet in edges.
constexpr double Shake = 1e-7;
///@}

/// The fraction of a number's multiple.
double spread(double step, Index number)
{
  double whole = 0.0;
  return std::modf(step * (number + 1), &whole);
}

double growthOf(Index part)
{
  constexpr double GoldenRatio = 0.6180339887498949; // no two fractions are near each other
  return LeastGrowth + MoreGrowth * spread(GoldenRatio, part);
}

Vec3 shakeOf(Index vertex)
{
  // The same in three dimensions: the powers of the root of x^4 = x + 1, inverted.
  const Vec3 place(spread(0.8191725133961645, vertex), spread(0.6710436067037893, vertex),
    spread(0.5497004779019703, vertex));
  return Shake * (2.0 * place - Vec3::Ones());
}

} // namespace

std::vector<Vec3> grownPoints(
  const SurfaceMesh& mesh, const SurfaceParts& parts, const std::vector<IndexPair>& pairs)
{
  std::vector<char> meets(parts.list.size(), 0);
  for (const auto& [first, second] : pairs)
  {
    const Index a = parts.ofFace[at(first)];
    const Index b = parts.ofFace[at(second)];
    meets[at(a)] |= static_cast<char>(a != b);
    meets[at(b)] |= static_cast<char>(a != b);
  }
  const double diagonal = boundingBox(mesh).diagonal().norm();
  const std::vector<Vec3> normals = angleWeightedNormals(mesh);
  std::vector<Vec3> points = mesh.points;
  for (Index face = 0; face < mesh.faceCount(); ++face)
  {
    const Index part = parts.ofFace[at(face)];
    if (meets[at(part)] == 0 || !parts.list[at(part)].isClosed)
    {
      continue;
    }
    for (Index k = 0; k < 3; ++k)
    {
      const Index vertex = mesh.faceVertex(face, k);
      const Vec3 move = growthOf(part) * normals[at(vertex)] + shakeOf(vertex);
      points[at(vertex)] = mesh.points[at(vertex)] + diagonal * move;
    }
  }
  return points;
}

} // namespace evolving
