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
#include "ShrinkWrap/TightGrid.h"
#include "StartSurface/GapClosing.h"
#include "StartSurface/InsideSamples.h"
#include "StartSurface/Isosurface.h"
#include "StartSurface/SurfaceComponents.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <set>
#include <sstream>
#include <tuple>
#include <vector>

namespace evolving
{

namespace
{

/// Diameters of balls that are tried, in mean distances between points.
constexpr double SmallestGap = 2.0;
constexpr double LargestGap = 12.0;
constexpr double GapStep = 0.5;
/// A ball that comes in leaves nothing of the inside, or specks: less than this part of what the
/// best one leaves.
constexpr double ClosedPart = 0.5;
/// An inside that is on average thinner than this, in distances between points, is none.
constexpr double LeastThickness = 0.5;
/// How near balls come to the points: in cells around an inside, in distances around a sheet.
constexpr double TouchPerCell = 0.1;
constexpr double WallPerSpacing = 0.6;
/// Of the surface's elements, in distances between points.
constexpr double ElementPerSpacing = 1.2;
constexpr double Stiffness = 0.5;
constexpr int FitRounds = 3;
constexpr int FitIterations = 2;

SurfaceMesh differentPoints(const SurfaceMesh& points)
{
  std::set<std::tuple<double, double, double>> seen;
  SurfaceMesh different;
  for (const Vec3& p : points.points)
  {
    if (seen.emplace(p.x(), p.y(), p.z()).second)
    {
      different.addPoint(p);
    }
  }
  return different;
}

/// Along the axis of the second largest spread, as a part of the largest one.
double spreadBesideLine(const SurfaceMesh& points)
{
  const Box box = boundingBox(points);
  Eigen::Matrix3d moments = Eigen::Matrix3d::Zero();
  Vec3 mean = Vec3::Zero();
  for (const Vec3& point : points.points)
  {
    const Vec3 p = (point - box.center()) / box.diagonal().norm(); // no under- or overflow
    mean += p / points.vertexCount();
    moments += p * p.transpose() / points.vertexCount();
  }
  moments -= mean * mean.transpose();
  const Vec3 spread = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(moments).eigenvalues();
  return std::sqrt(std::max(0.0, spread[1]) / spread[2]);
}

void requireExtent(const SurfaceMesh& points)
{
  constexpr Index Fewest = 4;
  constexpr double StraightLine = 1e-6;
  if (points.vertexCount() < Fewest || spreadBesideLine(points) < StraightLine)
  {
    std::ostringstream message;
    message << "The input has no faces and " << points.vertexCount()
            << " different points, too few or all on a line; expected at least " << Fewest
            << " points on a surface, or faces.";
    throw InputError(message.str());
  }
}

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
  PointSurface(
    const SurfaceMesh& points, const ShrinkWrapOptions& options, const Execution& execution)
    : Points(differentPoints(points))
    , Bounds(boundingBox(this->Points))
    , Options(options)
    , Run(execution)
  {
  }

  SurfaceMesh make()
  {
    requireExtent(this->Points);
    this->Spacing = this->meanSpacing(this->Run.phase(0.0, 0.2));
    const double largest = std::max(this->Options.gapSize, LargestGap * this->Spacing);
    this->Grid = tightGrid(this->Bounds, this->Options.sampleDimensions, 0.5 * largest);
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
  double cell() const { return this->Grid.spacing.maxCoeff(); }

  SurfaceMesh boundaryOf(const std::vector<float>& field, const Execution& execution) const
  {
    IsosurfaceOptions options;
    options.fillCavities = true;
    options.relaxationSweeps = 1;
    const SurfaceMesh surface = isosurface(this->Grid, field, options, execution);
    const SurfaceMesh kept = dropSmallComponents(surface, 4.0 * this->cell());
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
    return { 2.0 * SmallestGap * this->Spacing, WallPerSpacing * this->Spacing };
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
    const double touch = TouchPerCell * this->cell();
    if (this->Options.gapSize > 0.0)
    {
      return { this->Options.gapSize, touch };
    }
    std::vector<double> gaps;
    std::vector<double> volumes;
    for (double k = SmallestGap; k <= LargestGap; k += GapStep)
    {
      gaps.push_back(k * this->Spacing);
      volumes.push_back(this->enclosedBy(gaps.back()));
    }
    const double most = *std::max_element(volumes.begin(), volumes.end());
    if (most < LeastThickness * this->Spacing * this->Area)
    {
      return this->aroundSheet();
    }
    const auto first = std::find_if(
      volumes.begin(), volumes.end(), [most](double volume) { return volume > ClosedPart * most; });
    return { gaps[static_cast<std::size_t>(first - volumes.begin())], touch };
  }

  SurfaceMesh fitted(const SurfaceMesh& surface) const
  {
    EditableSurface editable(surface);
    setUniformSizes(editable, ElementPerSpacing * this->Spacing);
    runWithoutIntersections(editable, &PointSurface::coarsen, this->Run.phase(0.6, 0.6));
    for (int round = 0; round < FitRounds; ++round)
    {
      const double done = 0.6 + 0.4 * round / FitRounds;
      const Execution now = this->Run.phase(done, done); // parts may run again
      runWithoutIntersections(
        editable,
        [&](EditableSurface& s)
        {
          fitToPoints(s, this->Points.points, Stiffness, FitIterations, now);
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
  const Execution& Run;
  double Area = 0.0;
  double Spacing = 0.0;
  DistanceGrid Grid;
  std::vector<float> Distance;
};

} // namespace

SurfaceMesh surfaceAmidst(
  const SurfaceMesh& points, const ShrinkWrapOptions& options, const Execution& execution)
{
  return PointSurface(points, options, execution).make();
}

} // namespace evolving
