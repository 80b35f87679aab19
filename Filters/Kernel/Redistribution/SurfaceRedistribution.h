// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * Tangential redistribution alone: the points of a surface move along it until its elements are
 * even, or denser where it is curved.
 */

#ifndef EVOLVING_SURFACE_REDISTRIBUTION_H
#define EVOLVING_SURFACE_REDISTRIBUTION_H

#include "Execution.h"
#include "Mesh/SurfaceMesh.h"
#include "Redistribution/RedistributionOptions.h"
#include "Redistribution/StateArrays.h"

namespace evolving
{

struct SurfaceRedistributionOptions
{
  int numberOfSteps = 50;
  double timeStep = 0.1;
  /**
   * curvatureControlAlpha in units of half the diagonal of the surface's box. By default the shapes
   * of elements count alone: equal areas cost angles on meshes with irregular vertices.
   */
  RedistributionOptions redistribution = { 0.0, 8.0, 0.0, AngleMethod::Shape, AngleWeighting::None,
    CurvatureControl::None, 0.1 };
  bool preserveShape = true; ///< points end on the input surface
  BoundaryMode boundaryMode = BoundaryMode::SlideAlong;
  double featureAngle = 45.0; ///< degrees between face normals above which an edge is sharp
};

struct SurfaceRedistributionResult
{
  SurfaceMesh mesh;   ///< the input's faces, new points
  StateArrays arrays; ///< at the end; those that belong to a field are empty
};

/**
 * Moves the points by v_T of section 3.3. Points of sharp edges and, with SlideAlong, of the
 * boundary slide along the input's curves; points where such curves end, meet or turn by more than
 * the feature angle stay. A move is shortened, to zero if need be, when it would turn a corner of
 * an element over, or would make an element's smallest angle smaller than before and smaller than
 * 10 degrees; of such an element's vertices those yield whose own moves do it, all only where they
 * do it together. With the angle-based velocity switched on, no element's smallest angle gets
 * smaller than the surface's has become, unless that is above 40 degrees and stays there; if the
 * volume-based one is not, elements may pass through angles below 10 degrees otherwise.
 * @param surface an oriented manifold, closed or with boundary
 * @throws InputError for options out of range or a surface that cannot be used
 * @throws Cancelled
 */
SurfaceRedistributionResult redistributeSurface(const SurfaceMesh& surface,
  const SurfaceRedistributionOptions& options, const Execution& execution = {});

} // namespace evolving

#endif
