// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Distance/SignedDistance.h"

#include "Distance/ClosestPoint/ClosestOnGrid.h"
#include "Distance/ClosestTriangles.h"
#include "Distance/DistanceGradient.h"
#include "Distance/DistanceTarget.h"
#include "Distance/GaussianSmoothing.h"
#include "Distance/GridParts.h"
#include "Distance/SignedDistanceChecks.h"
#include "Distance/Signs/InsideOutside.h"
#include "Distance/Signs/PseudonormalSign.h"
#include "Distance/UnsignedDistance.h"
#include "Errors.h"
#include "Trees/AABBTree.h"

#include <algorithm>
#include <limits>
#include <new>
#include <sstream>

namespace evolving
{

namespace
{

/// The steps from a mesh to the result, with what they hand on.
class Computation
{
public:
  Computation(const DistanceTarget& target, const DistanceGrid& grid,
    const SignedDistanceOptions& options, SignMethod sign, const Execution& execution)
    : Target(target)
    , Whole(grid)
    , Options(options)
    , Sign(sign)
    , Run(execution)
  {
    this->Whole.origin -= target.center;
  }

  SignedDistanceResult run(const Extent& part)
  {
    const DistanceGrid grid = this->Whole.part(this->workingExtent(part));
    UnsignedDistance field = this->measure(grid, this->Run.phase(0.0, 0.8));
    const std::vector<char> inside =
      samplesInside(this->Sign, this->Target, grid, field, this->Run.phase(0.8, 0.9));
    this->applySigns(inside, field.distance);
    smoothGaussian(field.distance, { grid.dimension(0), grid.dimension(1), grid.dimension(2) },
      this->Options.smoothingSigma, this->Run.phase(0.9, 0.94));
    SignedDistanceResult result;
    this->fillArrays(result, grid, part, field, inside);
    result.distance = cut(std::move(field.distance), 1, grid, part);
    this->clampToBand(result.distance);
    this->Run.report(1.0);
    return result;
  }

private:
  /// What has to be computed for a part.
  Extent workingExtent(const Extent& part) const
  {
    if (this->Options.method == DistanceMethod::FastSweeping || this->Sign == SignMethod::FloodFill)
    {
      return this->Whole.extent;
    }
    // The gradient of a smoothed field needs one sample more on every side.
    const double sigma = this->Options.smoothingSigma;
    return grown(part, sigma > 0.0 ? smoothingRadius(sigma) + 1 : 0, this->Whole.extent);
  }

  bool wantsArrays() const
  {
    return this->Options.closestPoint || this->Options.closestFace || this->Options.gradient;
  }

  /// How far from the surface the closest triangles of samples are asked for.
  double triangleReach() const
  {
    const bool everywhere = this->wantsArrays() ||
      (this->Sign == SignMethod::Pseudonormal &&
        !needsTrianglesNearSurfaceOnly(this->Target.orientation));
    constexpr double SideIsSure = 3.0; // beyond so many cells it is carried on
    return everywhere ? std::numeric_limits<double>::infinity()
                      : SideIsSure * this->Whole.spacing.maxCoeff();
  }

  /// How far from the surface distances matter; smoothing takes them from anywhere.
  double distanceReach() const
  {
    return this->Options.bandWidth == 0.0 || this->Options.smoothingSigma > 0.0
      ? std::numeric_limits<double>::infinity()
      : this->Options.bandWidth * this->Whole.spacing.maxCoeff();
  }

  UnsignedDistance measure(const DistanceGrid& grid, const Execution& execution) const
  {
    switch (this->Options.method)
    {
      case DistanceMethod::ClosestPoint:
        return this->measureClosest(
          grid, std::max(this->triangleReach(), this->distanceReach()), execution);
      case DistanceMethod::FastSweeping:
        return this->sweep(grid, execution);
      case DistanceMethod::BruteForce:
        break;
    }
    return this->measureByQueries(grid, execution);
  }

  UnsignedDistance measureClosest(
    const DistanceGrid& grid, double reach, const Execution& execution) const
  {
    if (!isWithinReachOfFloats(this->Target.mesh, grid))
    {
      return this->measureByQueries(grid, execution);
    }
    GridClosest closest = closestOnGrid(this->Target.mesh, grid, reach, execution);
    return { std::move(closest.distance), std::move(closest.triangle), {} };
  }

  UnsignedDistance measureByQueries(const DistanceGrid& grid, const Execution& execution) const
  {
    const AABBTree tree(this->Target.mesh, execution.phase(0.0, 0.15));
    return distanceToTriangles(this->Target.mesh, grid,
      queryClosestTriangles(tree, grid, execution.phase(0.15, 0.9)), execution.phase(0.9, 1.0));
  }

  UnsignedDistance sweep(const DistanceGrid& grid, const Execution& execution) const
  {
    const AABBTree tree(this->Target.mesh, execution.phase(0.0, 0.2));
    const bool wantsTriangles = this->wantsArrays() || this->Sign == SignMethod::Pseudonormal;
    UnsignedDistance field = distanceBySweeping(
      tree, grid, this->Options.numberOfSweeps, execution.phase(0.2, wantsTriangles ? 0.6 : 1.0));
    if (wantsTriangles)
    {
      UnsignedDistance closest =
        this->measureClosest(grid, this->triangleReach(), execution.phase(0.6, 1.0));
      field.triangle = std::move(closest.triangle);
      field.clearance = std::move(closest.distance);
    }
    return field;
  }

  void applySigns(const std::vector<char>& inside, std::vector<float>& distance) const
  {
    this->Run.forRange(static_cast<std::int64_t>(inside.size()), SampleGrain,
      [&](std::int64_t begin, std::int64_t end)
      {
        for (auto s = static_cast<std::size_t>(begin); s < static_cast<std::size_t>(end); ++s)
        {
          distance[s] = inside[s] ? -distance[s] : distance[s];
        }
      });
  }

  /// Fills the arrays that were asked for.
  void fillArrays(SignedDistanceResult& result, const DistanceGrid& grid, const Extent& part,
    const UnsignedDistance& field, const std::vector<char>& inside) const
  {
    const Execution first = this->Run.phase(0.94, 0.97);
    const Execution last = this->Run.phase(0.97, 1.0);
    const SurfaceMesh& mesh = this->Target.mesh;
    if (this->Options.closestFace)
    {
      result.closestFace = cut(field.triangle, 1, grid, part);
      for (Index& face : result.closestFace)
      {
        face = this->Target.oldNumber[static_cast<std::size_t>(face)];
      }
    }
    if (this->Options.closestPoint)
    {
      auto points = closestPoints(mesh, grid, field.triangle, this->Target.center, first);
      result.closestPoint = cut(std::move(points), 3, grid, part);
    }
    if (this->Options.gradient)
    {
      auto gradient = this->Options.smoothingSigma > 0.0
        ? normalizedDifferences(grid, field.distance, last)
        : awayFromClosest(
            this->Target, grid, field.triangle, inside, this->Sign != SignMethod::Unsigned, last);
      result.gradient = cut(std::move(gradient), 3, grid, part);
    }
  }

  void clampToBand(std::vector<float>& distance) const
  {
    if (this->Options.bandWidth == 0.0)
    {
      return;
    }
    // A float of 0 where the band is narrower than floats are: it has no sample all the same.
    const auto band = static_cast<float>(this->Options.bandWidth * this->Whole.spacing.minCoeff());
    for (float& value : distance)
    {
      value = std::clamp(value, -band, band);
    }
  }

  static constexpr std::int64_t SampleGrain = 1 << 16;

  const DistanceTarget& Target;
  DistanceGrid Whole; ///< relative to the target's centre
  const SignedDistanceOptions& Options;
  SignMethod Sign;
  Execution Run;
};

} // namespace

SignedDistanceResult signedDistance(const SurfaceMesh& mesh, const DistanceGrid& grid,
  const Extent& part, const SignedDistanceOptions& options, const Execution& execution)
{
  requireUsable(options);
  requireUsable(grid, part);
  execution.report(0.0);
  try
  {
    const DistanceTarget target = makeDistanceTarget(mesh, execution.phase(0.0, 0.03));
    const SignChoice sign = chooseSignMethod(options.sign, target, execution.phase(0.03, 0.05));
    SignedDistanceResult result =
      Computation(target, grid, options, sign.method, execution.phase(0.05, 1.0)).run(part);
    result.sign = sign.method;
    result.signReason = sign.reason;
    return result;
  }
  catch (const std::bad_alloc&)
  {
    std::ostringstream message;
    message << "The grid has " << grid.sampleCount()
            << " samples, which do not fit into memory (about "
            << peakBytesPerSample(options) * grid.sampleCount()
            << " bytes); choose smaller dimensions.";
    throw InputError(message.str());
  }
}

} // namespace evolving
