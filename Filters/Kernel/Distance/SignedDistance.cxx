// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Distance/SignedDistance.h"

#include "Distance/AABBTree.h"
#include "Distance/ClosestPointSweep.h"
#include "Distance/ClosestTriangles.h"
#include "Distance/DistanceGradient.h"
#include "Distance/DistanceTarget.h"
#include "Distance/GaussianSmoothing.h"
#include "Distance/InsideOutside.h"
#include "Distance/SignedDistanceChecks.h"
#include "Distance/UnsignedDistance.h"
#include "Errors.h"

#include <algorithm>
#include <new>
#include <sstream>

namespace evolving
{

namespace
{

/// The part widened by a margin, inside the whole.
Extent grown(const Extent& part, int margin, const Extent& whole)
{
  Extent extent = part;
  for (std::size_t e = 0; e < 6; e += 2)
  {
    extent[e] = std::max(part[e] - margin, whole[e]);
    extent[e + 1] = std::min(part[e + 1] + margin, whole[e + 1]);
  }
  return extent;
}

/// The values of a part of the grid.
template <typename Value>
std::vector<Value> cut(const std::vector<Value>& values, GridIndex components,
  const DistanceGrid& grid, const Extent& part)
{
  const GridIndex width = components * (part[1] - part[0] + 1);
  std::vector<Value> result;
  result.reserve(static_cast<std::size_t>(components * grid.part(part).sampleCount()));
  for (int k = part[4]; k <= part[5]; ++k)
  {
    for (int j = part[2]; j <= part[3]; ++j)
    {
      const auto first = values.begin() + components * grid.index(part[0], j, k);
      result.insert(result.end(), first, first + width);
    }
  }
  return result;
}

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
    , Host(execution)
    , Tree(target.mesh, execution.phase(0.0, 0.15))
  {
    this->Whole.origin -= target.center;
  }

  SignedDistanceResult run(const Extent& part)
  {
    const DistanceGrid grid = this->Whole.part(this->workingExtent(part));
    UnsignedDistance field = this->measure(grid, this->Host.phase(0.15, 0.7));
    const std::vector<char> inside =
      samplesInside(this->Sign, this->Target, this->Tree, grid, field, this->Host.phase(0.7, 0.9));
    for (std::size_t s = 0; s < inside.size(); ++s)
    {
      field.distance[s] = inside[s] ? -field.distance[s] : field.distance[s];
    }
    smoothGaussian(field.distance, { grid.dimension(0), grid.dimension(1), grid.dimension(2) },
      this->Options.smoothingSigma, this->Host.phase(0.9, 0.94));
    SignedDistanceResult result;
    result.distance = cut(field.distance, 1, grid, part);
    this->clampToBand(result.distance);
    this->fillArrays(result, grid, part, field, inside);
    this->Host.report(1.0);
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

  UnsignedDistance measure(const DistanceGrid& grid, const Execution& execution) const
  {
    const Execution first = execution.phase(0.0, 0.9);
    const Execution last = execution.phase(0.9, 1.0);
    if (this->Options.method == DistanceMethod::BruteForce)
    {
      return distanceToTriangles(
        this->Tree, grid, queryClosestTriangles(this->Tree, grid, first), last);
    }
    if (this->Options.method == DistanceMethod::ClosestPoint)
    {
      return distanceToTriangles(
        this->Tree, grid, sweepClosestTriangles(this->Target.mesh, this->Tree, grid, first), last);
    }
    const bool wantsTriangles = this->Sign == SignMethod::Pseudonormal ||
      this->Options.closestPoint || this->Options.closestFace || this->Options.gradient;
    UnsignedDistance field = distanceBySweeping(this->Tree, grid, this->Options.numberOfSweeps,
      execution.phase(0.0, wantsTriangles ? 0.6 : 1.0));
    if (wantsTriangles)
    {
      field.triangle =
        sweepClosestTriangles(this->Target.mesh, this->Tree, grid, execution.phase(0.6, 1.0));
    }
    return field;
  }

  /// Fills the arrays that were asked for.
  void fillArrays(SignedDistanceResult& result, const DistanceGrid& grid, const Extent& part,
    const UnsignedDistance& field, const std::vector<char>& inside) const
  {
    const Execution first = this->Host.phase(0.94, 0.97);
    const Execution last = this->Host.phase(0.97, 1.0);
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
      const auto points =
        closestPoints(this->Tree, grid, field.triangle, this->Target.center, first);
      result.closestPoint = cut(points, 3, grid, part);
    }
    if (this->Options.gradient)
    {
      const bool isSmoothed = this->Options.smoothingSigma > 0.0;
      const bool isSigned = this->Sign != SignMethod::Unsigned;
      const auto gradient = isSmoothed ? normalizedDifferences(grid, field.distance, last)
                                       : awayFromClosest(this->Tree, grid, field.triangle, inside,
                                           isSigned ? &this->Target.mesh : nullptr, last);
      result.gradient = cut(gradient, 3, grid, part);
    }
  }

  void clampToBand(std::vector<float>& distance) const
  {
    const auto band = static_cast<float>(this->Options.bandWidth * this->Whole.spacing.minCoeff());
    for (std::size_t s = 0; band > 0.0F && s < distance.size(); ++s)
    {
      distance[s] = std::clamp(distance[s], -band, band);
    }
  }

  const DistanceTarget& Target;
  DistanceGrid Whole; ///< relative to the target's centre
  const SignedDistanceOptions& Options;
  SignMethod Sign;
  const Execution& Host;
  AABBTree Tree;
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
    const DistanceTarget target = makeDistanceTarget(mesh);
    const SignChoice sign = chooseSignMethod(options.sign, target);
    SignedDistanceResult result =
      Computation(target, grid, options, sign.method, execution).run(part);
    result.sign = sign.method;
    result.signReason = sign.reason;
    return result;
  }
  catch (const std::bad_alloc&)
  {
    std::ostringstream message;
    message << "The grid has " << grid.sampleCount()
            << " samples, which do not fit into memory (about " << 24 * grid.sampleCount()
            << " bytes); choose smaller dimensions.";
    throw InputError(message.str());
  }
}

bool canComputeParts(const SignedDistanceOptions& options)
{
  return options.method != DistanceMethod::FastSweeping && options.sign != SignMethod::FloodFill;
}

} // namespace evolving
