// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * Where a surface folds: its sharp edges.
 */

#ifndef EVOLVING_SHARP_EDGES_H
#define EVOLVING_SHARP_EDGES_H

#include "Execution.h"
#include "Features/TargetTriangles.h"
#include "Types.h"

#include <vector>

namespace evolving
{

/**
 * An edge is sharp where the normals of its two faces differ by more than an angle (however the
 * faces are turned; an angle met exactly is not exceeded by rounding), where it has more than two
 * faces, and, when wanted, where it has only one.
 * Which edges count can be changed afterwards, see takeFacetEdges() and keepCarriable().
 */
class SharpEdges
{
public:
  /// @param angle in degrees
  SharpEdges(const TargetTriangles& target, double angle, bool withBoundary,
    const Execution& execution = {});

  bool isSharp(Index edge) const { return this->Sharp[static_cast<std::size_t>(edge)] != 0; }
  /// The largest angle between two faces of an edge in degrees, 0 flat; 180 at the boundary.
  double fold(Index edge) const { return this->Folds[static_cast<std::size_t>(edge)]; }
  /// Is the fold larger than an angle in degrees? One that is met exactly is not, for all rounding.
  bool foldsBeyond(Index edge, double angle) const;
  /// How nearly the fold is enough for a sharp edge: 0 flat, 1 enough.
  double relativeFold(Index edge) const;
  /// Counts as sharp, however little it folds.
  void takeIn(Index edge)
  {
    this->Sharp[static_cast<std::size_t>(edge)] = 1;
    this->HasTaken = true;
  }
  bool hasTakenIn() const { return this->HasTaken; }
  /// No longer counts as sharp.
  void leaveOut(Index edge) { this->Sharp[static_cast<std::size_t>(edge)] = 0; }

  /// The sharp edges in ascending order.
  std::vector<Index> list() const;

private:
  double Angle;
  std::vector<double> Folds;
  std::vector<char> Sharp;
  bool HasTaken = false;
};

} // namespace evolving

#endif
