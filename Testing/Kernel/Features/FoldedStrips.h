// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * A sheet folded along parallel lines: creases and patches of known folds, widths and distances.
 */

#ifndef EVOLVING_TESTING_FOLDED_STRIPS_H
#define EVOLVING_TESTING_FOLDED_STRIPS_H

#include "Features/SharpEdges.h"
#include "Features/TargetTriangles.h"
#include "Mesh/Angles.h"
#include "Mesh/SurfaceMesh.h"

#include <cmath>
#include <cstddef>
#include <vector>

namespace evolving::shapes
{

/// Strips of these widths side by side, `length` along y in `rows` squares each; folds in degrees.
inline SurfaceMesh foldedStrips(
  const std::vector<double>& widths, const std::vector<double>& folds, double length, Index rows)
{
  std::vector<Vec3> profile{ Vec3::Zero() };
  double angle = 0.0;
  for (std::size_t k = 0; k < widths.size(); ++k)
  {
    // Up and down in turn, so that the strips do not run into each other.
    angle += k == 0 ? 0.0 : (k % 2 == 0 ? -1.0 : 1.0) * folds[k - 1] * Pi / 180.0;
    profile.push_back(profile.back() + widths[k] * Vec3(std::cos(angle), 0.0, std::sin(angle)));
  }
  SurfaceMesh mesh;
  for (Index row = 0; row <= rows; ++row)
  {
    for (const Vec3& p : profile)
    {
      mesh.addPoint(p + Vec3(0.0, length * row / rows, 0.0));
    }
  }
  const auto columns = static_cast<Index>(profile.size());
  for (Index row = 0; row < rows; ++row)
  {
    for (Index k = 0; k + 1 < columns; ++k)
    {
      const Index a = row * columns + k;
      const Index b = a + columns;
      mesh.addFace({ a, a + 1, b + 1 });
      mesh.addFace({ a, b + 1, b });
    }
  }
  return mesh;
}

/// By fold line, from left to right: is every edge of it sharp (1), none (0) or some (-1)?
inline std::vector<int> sharpLines(
  const TargetTriangles& target, const SharpEdges& sharp, std::size_t strips)
{
  std::vector<int> lines;
  const auto columns = static_cast<Index>(strips) + 1;
  for (Index line = 1; line + 1 < columns; ++line)
  {
    int edges = 0;
    int sharpOnes = 0;
    for (Index edge = 0; edge < target.edges().edgeCount(); ++edge)
    {
      const auto [a, b] = target.edgeVertices(edge);
      const bool isOfLine = a % columns == line && b % columns == line;
      edges += isOfLine ? 1 : 0;
      sharpOnes += isOfLine && sharp.isSharp(edge) ? 1 : 0;
    }
    lines.push_back(sharpOnes == 0 ? 0 : sharpOnes == edges ? 1 : -1);
  }
  return lines;
}

} // namespace evolving::shapes

#endif
