// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * The search for the best place of one vertex amidst its triangles.
 */

#ifndef EVOLVING_STAR_SEARCH_H
#define EVOLVING_STAR_SEARCH_H

#include "Remeshing/EditableSurface.h"
#include "Remeshing/ReferenceSurface.h"
#include "Types.h"

#include <array>
#include <vector>

namespace evolving
{

/**
 * A vertex tries places around it on the reference, in eight directions and at smaller and smaller
 * distances, and goes where the smallest angle of its triangles is larger. It keeps its height over
 * the reference; one on a curve slides along it.
 */
class StarSearch
{
public:
  StarSearch(EditableSurface& surface, const ReferenceSurface& reference);

  /// Pinned vertices, corners and boundary vertices stay. @return whether the vertex has moved
  bool improve(Index v);

private:
  bool isBetter(const Vec3& point);
  double worstCosineAt(const Vec3& point) const;
  void begin(Index v);
  ReferenceSurface::Foot foot(const Vec3& point, Index guess) const;
  bool searchAt(Index v, double move);
  bool tryMove(Index v, const Vec3& move);
  void place(Index v, const Vec3& point);
  bool isUpright(Index v) const;

  EditableSurface& Surface;
  const ReferenceSurface& Reference;
  Vec3 Normal, U, V;
  Index Label = 0;
  Index Curve = NoIndex;
  double Worst = 0.0;
  double Height = 0.0;
  std::vector<Vec3> OldAreas;
  std::vector<std::array<Vec3, 2>> Rim; ///< what each face has across from the vertex
};

} // namespace evolving

#endif
