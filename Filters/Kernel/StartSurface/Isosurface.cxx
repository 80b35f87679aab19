// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "StartSurface/Isosurface.h"

#include "Errors.h"
#include "StartSurface/InsideSamples.h"
#include "StartSurface/QuadSplitting.h"
#include "StartSurface/SurfaceNets.h"
#include "StartSurface/WellComposed.h"

#include <cmath>
#include <sstream>

namespace evolving
{

namespace
{

void requireUsable(const DistanceGrid& grid, const IsosurfaceOptions& options)
{
  std::ostringstream message;
  if (!(grid.spacing.minCoeff() > 0.0) || !grid.spacing.allFinite() || !grid.origin.allFinite())
  {
    message << "The grid has the spacing (" << grid.spacing.transpose() << ") and the origin ("
            << grid.origin.transpose()
            << "), expected a positive finite spacing and a finite origin; correct the image.";
    throw InputError(message.str());
  }
  if (!std::isfinite(options.isoValue))
  {
    message << "The iso-value is " << options.isoValue
            << ", expected a finite number; choose one within the field's range.";
    throw InputError(message.str());
  }
  if (options.relaxationSweeps < 0)
  {
    message << "The number of relaxation sweeps is " << options.relaxationSweeps
            << ", expected 0 or more; choose 0 for none.";
    throw InputError(message.str());
  }
}

} // namespace

SurfaceMesh isosurface(const DistanceGrid& grid, const std::vector<float>& field,
  const IsosurfaceOptions& options, const Execution& execution)
{
  requireUsable(grid, options);
  InsideSamples samples(grid, field, options.isoValue, execution.phase(0.0, 0.1));
  makeWellComposed(samples, execution.phase(0.1, 0.4));
  if (options.fillCavities)
  {
    fillCavities(samples, execution.phase(0.4, 0.5));
  }
  SurfaceNet net = surfaceNet(grid, samples, execution.phase(0.5, 0.9));
  relaxWithinCells(net, options.relaxationSweeps, execution.phase(0.9, 1.0));
  execution.report(1.0);
  return options.triangles ? splitQuads(net.mesh) : std::move(net.mesh);
}

} // namespace evolving
