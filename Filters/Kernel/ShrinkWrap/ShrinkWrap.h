// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * From any mesh or point set to an evolution that ends on it: the distance image, the start
 * surface and the parameters of the flow, chosen from the model.
 */

#ifndef EVOLVING_SHRINK_WRAP_H
#define EVOLVING_SHRINK_WRAP_H

#include "Evolution/FlowOptions.h"
#include "Evolution/ScalarImage.h"
#include "Execution.h"
#include "Mesh/SurfaceMesh.h"

#include <array>
#include <memory>

namespace evolving
{

/// Where the evolution starts.
enum class WrapStart
{
  Isosurface = 0, ///< of the distance, a little outside: has the target's holes and handles
  Icosphere = 1,  ///< a sphere around the target, as in the thesis
};

struct ShrinkWrapOptions
{
  WrapStart start = WrapStart::Isosurface;
  std::array<int, 3> sampleDimensions = { 128, 128, 128 };
  double targetEdgeLength = 0.0; ///< 0 = defaultEdgeLength() of the target's area
  double gapSize = 0.0;          ///< 0 = two cells, and at least the edge length
  int numberOfSteps = 50;
  double offsetDistance = 0.0; ///< of the result from the target, outwards
};

bool operator==(const ShrinkWrapOptions& a, const ShrinkWrapOptions& b);

/// An evolution that is ready to run.
struct ShrinkWrapProblem
{
  SurfaceMesh start;
  std::shared_ptr<const ScalarImage> field; ///< zero where the result shall lie
  FlowOptions flow;                         ///< in absolute units
  double edgeLength = 0.0;                  ///< of the start's triangles, nearly
};

/// sqrt(2 A / (9000 sqrt(3))): equilateral triangles of this edge cover A with 9000 vertices.
double defaultEdgeLength(double area);

/// The time step of the flow that prepareShrinkWrap() will choose; it depends on options alone.
double shrinkWrapTimeStep(const ShrinkWrapOptions& options);

/**
 * A target without an inside to speak of (an open sheet, points) is given a thin wall.
 * @param mesh the target: triangles in any state, or points only; not empty
 * @throws InputError for a target without extent, coordinates that are not finite, or options out
 * of range
 * @throws Cancelled
 */
ShrinkWrapProblem prepareShrinkWrap(
  const SurfaceMesh& mesh, const ShrinkWrapOptions& options, const Execution& execution = {});

} // namespace evolving

#endif
