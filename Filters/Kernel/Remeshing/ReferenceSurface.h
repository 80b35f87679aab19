// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * What a surface under remeshing lies on: where its vertices go back to when they have moved.
 */

#ifndef EVOLVING_REFERENCE_SURFACE_H
#define EVOLVING_REFERENCE_SURFACE_H

#include "Execution.h"
#include "Mesh/SurfaceMesh.h"
#include "Trees/AABBTree.h"
#include "Types.h"

namespace evolving
{

class ReferenceSurface
{
public:
  /// A place on the reference.
  struct Foot
  {
    Vec3 point;
    Vec3 normal;              ///< unit vector, on the side that was asked for
    Index triangle = NoIndex; ///< to begin the next search near by
  };

  virtual ~ReferenceSurface() = default;

  /**
   * The place of the reference that belongs to a point; of one without faces the point itself.
   * @param facing the normal of the surface there
   * @param label of the faces there, EditableSurface::label()
   * @param guess a triangle that may be close; a number of none is no guess
   */
  virtual Foot onSurface(const Vec3& point, const Vec3& facing, Index label, Index guess) const = 0;
  /// The closest point of a curve, EditableSurface::curve(); the point itself where none is known.
  virtual Vec3 onCurve(const Vec3& point, Index curve) const;
};

/**
 * All points at a distance from a triangle mesh, on the side where they are asked for; the mesh
 * itself at distance 0. Its orientation does not matter.
 */
class OffsetReference : public ReferenceSurface
{
public:
  /// @throws Cancelled
  OffsetReference(const SurfaceMesh& triangles, double offset, const Execution& execution = {});

  Foot onSurface(const Vec3& point, const Vec3& facing, Index label, Index guess) const override;

  const AABBTree& tree() const { return this->Tree; }

private:
  AABBTree Tree;
  double Offset;
};

} // namespace evolving

#endif
