// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Distance/SignedDistance.h"

#include "Distance/AABBTree.h"
#include "Distance/ClosestPointSweep.h"
#include "Distance/ClosestTriangles.h"
#include "Distance/DistanceGradient.h"
#include "Distance/DistanceOctree.h"
#include "Distance/DistanceTarget.h"
#include "Distance/FastSweeping.h"
#include "Distance/GaussianSmoothing.h"
#include "Distance/InsideOutside.h"
#include "Distance/Pseudonormals.h"
#include "Errors.h"

#include <algorithm>
#include <cmath>
#include <new>
#include <sstream>

namespace evolving
{

namespace
{

std::size_t at(GridIndex i)
{
  return static_cast<std::size_t>(i);
}

void requireOptions(const SignedDistanceOptions& options)
{
  if (!(options.bandWidth >= 0.0) || !(options.smoothingSigma >= 0.0) ||
    !std::isfinite(options.bandWidth) || options.smoothingSigma > 1000.0)
  {
    std::ostringstream message;
    message << "BandWidth is " << options.bandWidth << " and SmoothingSigma is "
            << options.smoothingSigma
            << " cells, expected numbers from 0 on, the latter up to 1000.";
    throw InputError(message.str());
  }
  if (options.numberOfSweeps < 0)
  {
    std::ostringstream message;
    message << "NumberOfSweeps is " << options.numberOfSweeps
            << ", expected 0 or more; 8 reach every sample.";
    throw InputError(message.str());
  }
}

void requireGrid(const DistanceGrid& grid, const Extent& part)
{
  const bool finite = grid.origin.allFinite() && grid.spacing.allFinite();
  if (!finite || !(grid.spacing.minCoeff() > 0.0) || grid.sampleCount() == 0)
  {
    std::ostringstream message;
    message << "The grid has the origin (" << grid.origin.transpose() << "), the spacing ("
            << grid.spacing.transpose() << ") and " << grid.sampleCount()
            << " samples, expected finite numbers, positive spacing and at least one sample.";
    throw InputError(message.str());
  }
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    const std::size_t e = 2 * axis;
    if (part[e] < grid.extent[e] || part[e + 1] > grid.extent[e + 1] || part[e] > part[e + 1])
    {
      std::ostringstream message;
      message << "The part [" << part[e] << ", " << part[e + 1] << "] along axis " << axis
              << " is not in the grid's extent [" << grid.extent[e] << ", " << grid.extent[e + 1]
              << "]; ask for a part of the grid.";
      throw InputError(message.str());
    }
  }
}

/// A field on a grid of its own: the distance without a sign, and what the sign needs.
struct Measured
{
  std::vector<float> distance;
  UnsignedSamples samples;
};

/// The steps from a mesh to the result, with what they hand on.
class Computation
{
public:
  Computation(const DistanceTarget& target, const DistanceGrid& wholeGrid,
    const SignedDistanceOptions& options, const SignChoice& sign, const Execution& execution)
    : Target(target)
    , Whole(wholeGrid)
    , Options(options)
    , Sign(sign.method)
    , Host(execution)
    , Tree(target.mesh, execution.phase(0.0, 0.15))
  {
    this->Whole.origin -= target.center;
  }

  SignedDistanceResult run(const Extent& part)
  {
    const DistanceGrid grid = this->Whole.part(this->workingExtent(part));
    Measured field = this->measure(grid, this->Host.phase(0.15, 0.7));
    const std::vector<char> inside = samplesInside(
      this->Sign, this->Target, this->Tree, grid, field.samples, this->Host.phase(0.7, 0.9));
    for (std::size_t s = 0; s < inside.size(); ++s)
    {
      field.distance[s] = inside[s] ? -field.distance[s] : field.distance[s];
    }
    const Execution last = this->Host.phase(0.9, 1.0);
    smoothGaussian(field.distance, { grid.dimension(0), grid.dimension(1), grid.dimension(2) },
      this->Options.smoothingSigma, last.phase(0.0, 0.5));
    SignedDistanceResult result;
    this->fillArrays(result, grid, part, field, inside, last.phase(0.5, 1.0));
    result.distance = cut(field.distance, 1, grid, part);
    this->clampToBand(result.distance);
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
    const bool smooths = this->Options.smoothingSigma > 0.0;
    const int margin = smooths ? smoothingRadius(this->Options.smoothingSigma) + 1 : 0;
    Extent extent = part;
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      const std::size_t e = 2 * axis;
      extent[e] = std::max(part[e] - margin, this->Whole.extent[e]);
      extent[e + 1] = std::min(part[e + 1] + margin, this->Whole.extent[e + 1]);
    }
    return extent;
  }

  Measured measure(const DistanceGrid& grid, const Execution& execution) const
  {
    switch (this->Options.method)
    {
      case DistanceMethod::BruteForce:
        return this->measureTo(grid,
          queryClosestTriangles(this->Tree, grid, execution.phase(0.0, 0.9)),
          execution.phase(0.9, 1.0));
      case DistanceMethod::FastSweeping:
        return this->measureBySweeping(grid, execution);
      case DistanceMethod::ClosestPoint:
        break;
    }
    return this->measureTo(grid,
      sweepClosestTriangles(this->Target.mesh, this->Tree, grid, execution.phase(0.0, 0.9)),
      execution.phase(0.9, 1.0));
  }

  Measured measureTo(
    const DistanceGrid& grid, std::vector<Index> triangles, const Execution& execution) const
  {
    Measured field;
    field.distance.resize(triangles.size());
    forEachSample(grid, execution,
      [&](GridIndex s, const Vec3& point)
      {
        const Triangle& triangle = this->Tree.triangle(triangles[at(s)]);
        field.distance[at(s)] =
          static_cast<float>(std::sqrt(closestPointOnTriangle(point, triangle).squaredDistance));
      });
    field.samples.triangle = std::move(triangles);
    field.samples.clearance = field.distance;
    return field;
  }

  Measured measureBySweeping(const DistanceGrid& grid, const Execution& execution) const
  {
    const double h = grid.spacing.maxCoeff();
    const DistanceOctree octree(this->Tree, grid, execution.phase(0.0, 0.3));
    SweptField field({ grid.dimension(0), grid.dimension(1), grid.dimension(2) });
    Measured measured;
    measured.samples.triangle.assign(field.distance.size(), NoIndex);
    // The cube about any other sample meets no triangle.
    const auto halfCell = static_cast<float>(0.50001 * h);
    measured.samples.clearance.assign(field.distance.size(), halfCell);
    for (const DistanceOctree::Leaf& leaf : octree.leaves())
    {
      const auto& [i, j, k] = leaf.cell.corner;
      const GridIndex sample = grid.index(i, j, k);
      const double distance = std::sqrt(leaf.squaredDistance);
      field.freeze(sample, static_cast<float>(distance / h));
      measured.samples.triangle[at(sample)] = leaf.triangle;
      measured.samples.clearance[at(sample)] = static_cast<float>(distance);
    }
    this->freezeBoundary(field, grid, execution.phase(0.3, 0.5));
    sweep(field, this->Options.numberOfSweeps, execution.phase(0.5, 0.8));
    measured.distance = std::move(field.distance);
    for (float& distance : measured.distance)
    {
      distance = static_cast<float>(h * static_cast<double>(distance));
    }
    if (this->Sign == SignMethod::Pseudonormal || this->wantsClosest())
    {
      measured.samples.triangle =
        sweepClosestTriangles(this->Target.mesh, this->Tree, grid, execution.phase(0.8, 1.0));
    }
    return measured;
  }

  /// Where triangles lie outside the grid, the way to them leads past the grid's faces.
  void freezeBoundary(SweptField& field, const DistanceGrid& grid, const Execution& execution) const
  {
    if (containsAll(grid, this->Tree))
    {
      return;
    }
    const double h = grid.spacing.maxCoeff();
    const std::vector<Index> boundary = queryBoundaryTriangles(this->Tree, grid, execution);
    forEachSample(grid, Execution(),
      [&](GridIndex s, const Vec3& point)
      {
        if (boundary[at(s)] != NoIndex)
        {
          const Triangle& triangle = this->Tree.triangle(boundary[at(s)]);
          const double squared = closestPointOnTriangle(point, triangle).squaredDistance;
          field.freeze(s, static_cast<float>(std::sqrt(squared) / h));
        }
      });
  }

  bool wantsClosest() const
  {
    return this->Options.closestPoint || this->Options.closestFace || this->Options.gradient;
  }

  /// Fills the arrays that were asked for.
  void fillArrays(SignedDistanceResult& result, const DistanceGrid& grid, const Extent& part,
    const Measured& field, const std::vector<char>& inside, const Execution& execution) const
  {
    if (this->Options.closestFace)
    {
      std::vector<Index> faces(field.samples.triangle);
      for (Index& face : faces)
      {
        face = this->Target.oldNumber[at(face)];
      }
      result.closestFace = cut(faces, 1, grid, part);
    }
    if (this->Options.closestPoint)
    {
      result.closestPoint = cut(this->closestPoints(grid, field, execution), 3, grid, part);
    }
    if (this->Options.gradient)
    {
      const bool isSmoothed = this->Options.smoothingSigma > 0.0;
      result.gradient = cut(isSmoothed ? normalizedDifferences(grid, field.distance, execution)
                                       : this->awayFromClosest(grid, field, inside, execution),
        3, grid, part);
    }
  }

  std::vector<float> closestPoints(
    const DistanceGrid& grid, const Measured& field, const Execution& execution) const
  {
    std::vector<float> points(3 * field.distance.size());
    forEachSample(grid, execution,
      [&](GridIndex s, const Vec3& point)
      {
        const Triangle& triangle = this->Tree.triangle(field.samples.triangle[at(s)]);
        const Vec3 closest = closestPointOnTriangle(point, triangle).point + this->Target.center;
        Eigen::Map<Eigen::Vector3f>(points.data() + 3 * s) = closest.cast<float>();
      });
    return points;
  }

  /// Unit vectors from the closest point, turned round inside; on the surface its normal.
  std::vector<float> awayFromClosest(const DistanceGrid& grid, const Measured& field,
    const std::vector<char>& inside, const Execution& execution) const
  {
    std::vector<float> gradient(3 * field.distance.size());
    const bool isSigned = this->Sign != SignMethod::Unsigned;
    const Pseudonormals normals(this->Target.mesh);
    const double tooClose = 1e-6 * grid.spacing.minCoeff();
    forEachSample(grid, execution,
      [&](GridIndex s, const Vec3& point)
      {
        const Index triangle = field.samples.triangle[at(s)];
        const TrianglePoint closest = closestPointOnTriangle(point, this->Tree.triangle(triangle));
        Vec3 direction = point - closest.point;
        direction = inside[at(s)] ? Vec3(-direction) : direction;
        if (direction.norm() <= tooClose)
        {
          direction = isSigned ? normals.at(triangle, closest.feature) : Vec3(Vec3::Zero());
        }
        const double length = direction.norm();
        direction = length > 0.0 ? Vec3(direction / length) : direction;
        Eigen::Map<Eigen::Vector3f>(gradient.data() + 3 * s) = direction.cast<float>();
      });
    return gradient;
  }

  /// The values of a part of the grid.
  template <typename Value>
  static std::vector<Value> cut(const std::vector<Value>& values, GridIndex components,
    const DistanceGrid& grid, const Extent& part)
  {
    if (part == grid.extent)
    {
      return values;
    }
    const GridIndex width = components * (part[1] - part[0] + 1);
    std::vector<Value> result;
    result.reserve(at(components * grid.part(part).sampleCount()));
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

  void clampToBand(std::vector<float>& distance) const
  {
    if (this->Options.bandWidth > 0.0)
    {
      const auto band =
        static_cast<float>(this->Options.bandWidth * this->Whole.spacing.minCoeff());
      for (float& value : distance)
      {
        value = std::clamp(value, -band, band);
      }
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
  requireOptions(options);
  requireGrid(grid, part);
  execution.report(0.0);
  try
  {
    const DistanceTarget target = makeDistanceTarget(mesh);
    const SignChoice sign = chooseSignMethod(options.sign, target);
    SignedDistanceResult result = Computation(target, grid, options, sign, execution).run(part);
    result.sign = sign.method;
    result.signReason = sign.reason;
    return result;
  }
  catch (const std::bad_alloc&)
  {
    std::ostringstream message;
    message << "The grid has " << grid.sampleCount()
            << " samples, which do not fit into memory (about " << 16 * grid.sampleCount()
            << " bytes); choose smaller dimensions.";
    throw InputError(message.str());
  }
}

bool canComputeParts(const SignedDistanceOptions& options)
{
  return options.method != DistanceMethod::FastSweeping && options.sign != SignMethod::FloodFill;
}

} // namespace evolving
