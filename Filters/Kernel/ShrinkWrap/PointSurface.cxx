// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ShrinkWrap/PointSurface.h"

#include "Distance/SignedDistance.h"
#include "Errors.h"
#include "Remeshing/CurvedReference.h"
#include "Remeshing/EdgeCollapsing.h"
#include "Remeshing/EdgeFlipping.h"
#include "Remeshing/EditableSurface.h"
#include "Remeshing/IntersectionFreeStages.h"
#include "Remeshing/PointFit.h"
#include "Remeshing/Remeshing.h"
#include "Remeshing/SizingField.h"
#include "ShrinkWrap/PointSpread.h"
#include "ShrinkWrap/TightGrid.h"
#include "StartSurface/GapClosing.h"
#include "StartSurface/InsideSamples.h"
#include "StartSurface/Isosurface.h"
#include "StartSurface/SurfaceComponents.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <vector>

namespace evolving
{

namespace
{

std::vector<float> distanceTo(
  const SurfaceMesh& points, const DistanceGrid& grid, const Execution& execution)
{
  SignedDistanceOptions options;
  options.sign = SignMethod::Unsigned;
  return signedDistance(points, grid, grid.extent, options, execution).distance;
}

/// What the balls have to be, and how near to come.
struct Balls
{
  double gap = 0.0;
  double touch = 0.0;
};

class PointSurface
{
public:
  PointSurface(const SurfaceMesh& points, const ShrinkWrapOptions& options,
    const PointTuning& tuning, const Execution& execution)
    : Points(differentPoints(points))
    , Bounds(boundingBox(this->Points))
    , Options(options)
    , Tuning(tuning)
    , Run(execution)
  {
  }

  SurfaceMesh make()
  {
    requireExtent(this->Points);
    this->requireFineGrid();
    this->Spacing = this->meanSpacing(this->Run.phase(0.0, 0.2));
    const double room = 0.5 * std::max(this->Options.gapSize, this->largestGap());
    this->Grid = tightGrid(this->Bounds, this->Options.sampleDimensions, room);
    this->Distance = distanceTo(this->Points, this->Grid, this->Run.phase(0.2, 0.3));
    SurfaceMesh surface = this->leftBy(this->chooseBalls(), this->Run.phase(0.3, 0.6));
    if (surface.faceCount() == 0)
    {
      Balls apart = this->aroundSheet();
      apart.touch = std::max(apart.touch, this->cell()); // some samples are that near
      surface = this->leftBy(apart, this->Run.phase(0.6, 0.6));
    }
    return this->fitted(surface);
  }

private:
  /// Around the largest ball that the grid can see beside the points.
  double largestRoom() const
  {
    const double coarsest = this->Tuning.largestCell * this->Bounds.sizes().maxCoeff();
    return roomForCells(this->Bounds, this->Options.sampleDimensions, coarsest);
  }

  /// Of the balls that are tried.
  double largestGap() const
  {
    return std::min(this->Tuning.largestGap * this->Spacing, 2.0 * this->largestRoom());
  }

  void requireFineGrid() const
  {
    const double room = 0.5 * this->Options.gapSize;
    if (room <= this->largestRoom())
    {
      return;
    }
    const auto& samples = this->Options.sampleDimensions;
    const double size = this->Bounds.sizes().maxCoeff();
    std::ostringstream message;
    message << "SampleDimensions of " << samples[0] << " x " << samples[1] << " x " << samples[2]
            << " and a GapSize of " << this->Options.gapSize << " give cells of "
            << tightGrid(this->Bounds, samples, room).spacing.maxCoeff()
            << " around points that are " << size << " long, expected cells of at most "
            << this->Tuning.largestCell * size << "; set "
            << (this->largestRoom() < 0.0 ? "more samples."
                                          : "a smaller GapSize, or more samples.");
    throw InputError(message.str());
  }

  double cell() const { return this->Grid.spacing.maxCoeff(); }

  SurfaceMesh boundaryOf(const std::vector<float>& field, const Execution& execution) const
  {
    IsosurfaceOptions options;
    options.fillCavities = true;
    options.relaxationSweeps = 1;
    const SurfaceMesh surface = isosurface(this->Grid, field, options, execution);
    const SurfaceMesh kept = dropSmallComponents(surface, SpeckCells * this->cell());
    return kept.faceCount() > 0 ? kept : surface;
  }

  /// The surface around what balls cannot come to; empty where they come in everywhere.
  SurfaceMesh leftBy(const Balls& balls, const Execution& execution) const
  {
    const std::vector<float> field =
      closeGaps(this->Grid, this->Distance, balls.touch, balls.gap, execution.phase(0.0, 0.7));
    return this->boundaryOf(field, execution.phase(0.7, 1.0));
  }

  /// They leave a wall around the points.
  Balls aroundSheet() const
  {
    return { 2.0 * this->Tuning.smallestGap * this->Spacing,
      this->Tuning.wallPerSpacing * this->Spacing };
  }

  /// Points have no area of their own; the surface around them has.
  double meanSpacing(const Execution& execution)
  {
    this->Grid = tightGrid(this->Bounds, this->Options.sampleDimensions, 0.0);
    std::vector<float> field = distanceTo(this->Points, this->Grid, execution.phase(0.0, 0.5));
    for (float& value : field)
    {
      value -= static_cast<float>(2.0 * this->cell());
    }
    const double area = surfaceArea(this->boundaryOf(field, execution.phase(0.5, 1.0)));
    this->Area = area;
    return std::sqrt(area / this->Points.vertexCount());
  }

  /// The volume that balls of a diameter cannot come into.
  double enclosedBy(double gap) const
  {
    InsideSamples samples(this->Grid, this->Distance, 0.5 * gap, this->Run.phase(0.3, 0.3));
    const auto enclosed = fillCavities(samples, this->Run.phase(0.3, 0.3));
    return static_cast<double>(enclosed) * this->Grid.spacing.prod();
  }

  Balls chooseBalls() const
  {
    const double touch = this->Tuning.touchPerCell * this->cell();
    if (this->Options.gapSize > 0.0)
    {
      return { this->Options.gapSize, touch };
    }
    std::vector<double> gaps;
    std::vector<double> volumes;
    for (double k = this->Tuning.smallestGap; k <= this->Tuning.largestGap;
         k += this->Tuning.gapStep)
    {
      if (k * this->Spacing > this->largestGap())
      {
        break;
      }
      gaps.push_back(k * this->Spacing);
      volumes.push_back(this->enclosedBy(gaps.back()));
    }
    if (gaps.empty())
    {
      return this->aroundSheet();
    }
    const double most = *std::max_element(volumes.begin(), volumes.end());
    if (most < this->Tuning.leastThickness * this->Spacing * this->Area)
    {
      return this->aroundSheet();
    }
    const auto first = std::find_if(volumes.begin(), volumes.end(),
      [least = this->Tuning.closedPart * most](double volume) { return volume > least; });
    return { gaps[static_cast<std::size_t>(first - volumes.begin())], touch };
  }

  SurfaceMesh fitted(const SurfaceMesh& surface) const
  {
    EditableSurface editable(surface);
    setUniformSizes(editable, this->Tuning.elementPerSpacing * this->Spacing);
    runWithoutIntersections(editable, &PointSurface::coarsen, this->Run.phase(0.6, 0.6));
    for (int round = 0; round < this->Tuning.fitRounds; ++round)
    {
      const double done = 0.6 + 0.4 * round / this->Tuning.fitRounds;
      const Execution now = this->Run.phase(done, done); // parts may run again
      runWithoutIntersections(
        editable,
        [&](EditableSurface& s)
        {
          fitToPoints(
            s, this->Points.points, this->Tuning.stiffness, this->Tuning.fitIterations, now);
          remeshOnce(s, CurvedReference(s.mesh(), now), {}, now);
        },
        now);
    }
    return editable.mesh();
  }

  static void coarsen(EditableSurface& surface)
  {
    const RemeshingOptions options;
    for (int pass = 0; pass < 3; ++pass)
    {
      collapseShortEdges(surface, options.shortest, options.guards);
      flipForValences(surface);
      surface.compact();
    }
    remeshOnce(surface, CurvedReference(surface.mesh()), options);
  }

  SurfaceMesh Points;
  Box Bounds;
  const ShrinkWrapOptions& Options;
  const PointTuning& Tuning;
  const Execution& Run;
  double Area = 0.0;
  double Spacing = 0.0;
  DistanceGrid Grid;
  std::vector<float> Distance;
};

} // namespace

SurfaceMesh surfaceAmidst(const SurfaceMesh& points, const ShrinkWrapOptions& options,
  const Execution& execution, const PointTuning& tuning)
{
  return PointSurface(points, options, tuning, execution).make();
}

} // namespace evolving
