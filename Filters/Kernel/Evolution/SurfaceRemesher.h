// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * New elements of the right size for a surface that evolves, wherever it goes.
 */

#ifndef EVOLVING_SURFACE_REMESHER_H
#define EVOLVING_SURFACE_REMESHER_H

#include "Evolution/ElementSizes.h"
#include "Evolution/FlowOptions.h"
#include "Evolution/Remesher.h"
#include "Execution.h"
#include "Mesh/SurfaceMesh.h"

#include <tuple>
#include <vector>

namespace evolving
{

struct SurfaceRemeshingOptions
{
  ElementSizing sizing = ElementSizing::Uniform;
  double edgeLength = 0.0; ///< 0 = automatic, see SurfaceRemesher::edgeLength()
  BoundaryMode boundaryMode = BoundaryMode::Fixed;
  bool onlyDegenerate = false; ///< the start's elements stay until hasDegenerateElements()
  bool keepsStart = true;      ///< false: those are made anew at once, as they are nobody's choice
  double targetArea = 0.0;     ///< of what the surface is to reach; 0 = unknown
};

/// All of them: a new one does not compile before it is listed here.
inline auto membersOf(const SurfaceRemeshingOptions& options)
{
  const auto& [sizing, edgeLength, boundaryMode, onlyDegenerate, keepsStart, targetArea] = options;
  return std::tie(sizing, edgeLength, boundaryMode, onlyDegenerate, keepsStart, targetArea);
}

inline bool operator==(const SurfaceRemeshingOptions& a, const SurfaceRemeshingOptions& b)
{
  return membersOf(a) == membersOf(b);
}

/// @throws InputError for an edge length that is neither 0 nor a number from 1e-100 to 1e100
void checkOptions(const SurfaceRemeshingOptions& options);

/**
 * Splits, collapses and flips edges and relaxes vertices along the smooth surface that the evolved
 * triangles stand for (CurvedReference), so that remeshing again and again does not shrink it.
 *
 * - Good elements stay as they are, except at the end of the flow, where all are made as good as
 *   can be. With onlyDegenerate any elements stay until some degenerate, those of the start at the
 *   end, too: then polygons become triangles, all elements are made anew, and necks that have
 *   pinched off are cut (withNecksCut()) where no field holds the surface.
 * - A component keeps at least some hundred vertices, however small it has become
 *   (setElementSizes()); one that has shrunk to a point (VanishedComponents) is left out when
 *   others remain.
 * - A boundary keeps its shape: its edges are split, and only vertices in a straight line vanish.
 *   A boundary that moves freely may lose other ones as well.
 * - Where the surface comes without self-intersections, remeshing makes none.
 */
class SurfaceRemesher : public Remesher
{
public:
  /// On a surface that is so many times as large as its target, or larger, there are that many
  /// times as many vertices: a sphere around a model has elements about as small as those it ends
  /// with, and one that is much larger costs no more.
  static constexpr double LargestPerTarget = 4.0;

  /// @param start of triangles, unless onlyDegenerate. @throws InputError as MeshTopology and
  /// checkOptions()
  SurfaceRemesher(const SurfaceMesh& start, const SurfaceRemeshingOptions& options);

  /**
   * The mean length that edges of a surface should have: the wanted one, or, with onlyDegenerate,
   * that of as many vertices as the start has, and 2562 at least, on whatever area there is by now.
   * Where the area of the target is known, as many on that; but on its way a surface that is much
   * larger has no more than LargestPerTarget times as many. Else the mean of the start's edges.
   */
  double edgeLength(const SurfaceMesh& surface) const;

  /// @throws InputError as setElementSizes(). @throws Cancelled
  std::optional<SurfaceMesh> remesh(
    const RemeshingInput& input, const Execution& execution) override;

private:
  std::optional<SurfaceMesh> remeshTriangles(
    const RemeshingInput& input, const Execution& execution);

  bool hasStartElements(const SurfaceMesh& surface) const;
  bool isTooCoarse(const SurfaceMesh& surface) const;
  bool mayStay(const RemeshingInput& input) const;
  bool isCreasedEnd(const RemeshingInput& input) const;

  SurfaceRemeshingOptions Options;
  std::vector<Index> StartCorners; ///< with onlyDegenerate: the start's faces
  double Vertices = 0.0;    ///< how many equilateral ones shall cover it; 0 for edges of one length
  double SmallestComponent; ///< area of one at the start
};

} // namespace evolving

#endif
