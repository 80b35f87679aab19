// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * Is the surface after a step still one?
 */

#ifndef EVOLVING_SURFACE_GUARD_H
#define EVOLVING_SURFACE_GUARD_H

#include "Errors.h"
#include "Execution.h"
#include "Mesh/SurfaceMesh.h"
#include "Types.h"

namespace evolving
{

/// A step left next to nothing of the surface: less than SmallestAreaPart of the start.
class SurfaceVanished : public SolverError
{
public:
  using SolverError::SolverError;
};

/// The conditions that every state of a flow must meet.
class SurfaceGuard
{
public:
  SurfaceGuard() = default;
  /**
   * @param image the box of the field's samples; empty without a field
   * @param guard enlargement of the box around start and image that no point may leave
   */
  SurfaceGuard(const SurfaceMesh& start, const Box& image, double guard);

  /**
   * @throws SolverError that says what is wrong, when a coordinate is not finite or a point has
   * left the box. @throws SurfaceVanished
   */
  void require(const SurfaceMesh& mesh, const Execution& execution) const;

private:
  void requireInside(const SurfaceMesh& mesh, const Execution& execution) const;

  Box Guard;
  double Enlargement = 1.0;
  double StartArea = 0.0;
};

} // namespace evolving

#endif
