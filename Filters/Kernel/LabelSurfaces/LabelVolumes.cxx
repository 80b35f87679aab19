// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "LabelSurfaces/LabelVolumes.h"

#include "Algebra/Factorization.h"
#include "ParallelLoops.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace evolving
{

namespace
{

/// Two or three take away what two rounds of local volumes have left; more where boxes hold points.
constexpr int MostRounds = 20;
/// Of a volume: far below what a box holds back, far above rounding.
constexpr double SmallEnough = 1e-10;
/// Rounds that take less than this of the error away are the last ones.
constexpr double LeastProgress = 0.1;
constexpr int MostIdleRounds = 4;
/// Of a multiplier's own term: labels that lie within others entirely leave one that is free.
constexpr double Regularization = 1e-9;

/// Sums by a key, in chunks of indices, which meet few keys each.
using Key = std::pair<Index, Index>;
using KeyedSums = std::map<Key, double>;

template <class Visit>
KeyedSums sumByKey(std::int64_t count, const Execution& execution, const Visit& visit)
{
  std::vector<KeyedSums> parts(static_cast<std::size_t>((count + LoopGrain - 1) / LoopGrain));
  execution.forRange(count, LoopGrain,
    [&](std::int64_t begin, std::int64_t end)
    {
      KeyedSums& sums = parts[static_cast<std::size_t>(begin / LoopGrain)];
      for (std::int64_t i = begin; i < end; ++i)
      {
        visit(static_cast<Index>(i), sums);
      }
    });
  KeyedSums whole;
  for (const KeyedSums& part : parts)
  {
    for (const auto& [key, value] : part)
    {
      whole[key] += value;
    }
  }
  return whole;
}

/// The gradients of the volumes of all labels at a vertex, and a third of the triangles' area.
struct VertexGradients
{
  std::vector<std::pair<Material, Vec3>> ofLabels;
  double area = 0.0;

  void add(Material label, const Vec3& gradient)
  {
    const auto same = std::find_if(this->ofLabels.begin(), this->ofLabels.end(),
      [label](const auto& one) { return one.first == label; });
    if (same != this->ofLabels.end())
    {
      same->second += gradient;
    }
    else if (isLabel(label))
    {
      this->ofLabels.emplace_back(label, gradient);
    }
  }
};

VertexGradients gradientsAt(const InterfaceNet& net, const InterfaceTriangles& triangles,
  const CornersOfVertices& corners, const std::vector<Vec3>& points, Index vertex)
{
  VertexGradients gradients;
  for (Index k = corners.offsets[at(vertex)]; k < corners.offsets[at(vertex) + 1]; ++k)
  {
    const Index triangle = corners.corners[at(k)] / 3;
    const Index* v = &triangles.corners[at(3 * triangle)];
    const Vec3 a = points[at(v[0])];
    const Vec3 third = (points[at(v[1])] - a).cross(points[at(v[2])] - a) / 6.0;
    const NetQuad& quad = net.quads[at(triangles.quads[at(triangle)])];
    gradients.area += third.norm();
    gradients.add(quad.sides[0], third);
    gradients.add(quad.sides[1], -third);
  }
  for (auto& [label, gradient] : gradients.ofLabels)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      gradient[axis] *= (net.fixed[at(vertex)] >> axis & 1U) != 0 ? 0.0 : 1.0;
    }
  }
  return gradients;
}

SparseMatrix matrixOf(const KeyedSums& sums, std::size_t labelCount)
{
  const auto count = static_cast<Index>(labelCount);
  std::vector<Eigen::Triplet<double, Index>> entries;
  entries.reserve(sums.size() + labelCount);
  std::vector<char> hasDiagonal(labelCount, 0);
  for (const auto& [key, value] : sums)
  {
    const bool isDiagonal = key.first == key.second;
    hasDiagonal[at(key.first)] |= static_cast<char>(isDiagonal && value > 0.0);
    entries.emplace_back(
      key.first, key.second, isDiagonal ? value * (1.0 + Regularization) : value);
  }
  for (Index label = 0; label < count; ++label)
  {
    entries.emplace_back(label, label, hasDiagonal[at(label)] != 0 ? 0.0 : 1.0);
  }
  SparseMatrix matrix(count, count);
  matrix.setFromTriplets(entries.begin(), entries.end());
  return matrix;
}

} // namespace

std::vector<double> labelVolumes(const InterfaceNet& net, const InterfaceTriangles& triangles,
  const std::vector<Vec3>& points, std::size_t labelCount, const Execution& execution)
{
  const KeyedSums sums = sumByKey(triangles.count(), execution,
    [&](Index triangle, KeyedSums& part)
    {
      const Index* v = &triangles.corners[at(3 * triangle)];
      const double volume = points[at(v[0])].dot(points[at(v[1])].cross(points[at(v[2])])) / 6.0;
      const NetQuad& quad = net.quads[at(triangles.quads[at(triangle)])];
      part[{ quad.sides[0], 0 }] += volume;
      part[{ quad.sides[1], 0 }] -= volume;
    });
  std::vector<double> volumes(labelCount, 0.0);
  for (const auto& [key, value] : sums)
  {
    if (isLabel(static_cast<Material>(key.first)))
    {
      volumes[at(key.first - 1)] = value;
    }
  }
  return volumes;
}

LabelVolumes::LabelVolumes(const InterfaceNet& net, const InterfaceTriangles& triangles,
  const NetLimits& limits, std::vector<double> volumes)
  : Net(net)
  , Triangles(triangles)
  , Corners(cornersOfVertices(triangles, net.vertexCount()))
  , Limits(limits)
  , Volumes(std::move(volumes))
{
}

/// d volume l / d multiplier m is the sum of the products of both gradients over the areas.
std::vector<double> LabelVolumes::multipliers(const std::vector<double>& missing,
  const std::vector<char>& rests, const std::vector<Vec3>& points, const Execution& execution) const
{
  const KeyedSums rates = sumByKey(this->Net.vertexCount(), execution,
    [&](Index i, KeyedSums& part)
    {
      if (rests[at(i)] != 0)
      {
        return;
      }
      const VertexGradients gradients =
        gradientsAt(this->Net, this->Triangles, this->Corners, points, i);
      for (const auto& [l, first] : gradients.ofLabels)
      {
        for (const auto& [m, second] : gradients.ofLabels)
        {
          part[{ l - 1, m - 1 }] += gradients.area > 0.0 ? first.dot(second) / gradients.area : 0.0;
        }
      }
    });
  Factorization factors;
  factors.build(matrixOf(rates, missing.size()));
  std::vector<double> multipliers;
  factors.apply(missing, multipliers, execution);
  return multipliers;
}

double LabelVolumes::largestError(const std::vector<double>& missing) const
{
  double largest = 0.0;
  for (std::size_t l = 0; l < missing.size(); ++l)
  {
    const double wanted = this->Volumes[l];
    largest = std::max(largest, wanted > 0.0 ? std::abs(missing[l]) / wanted : 0.0);
  }
  return largest;
}

double LabelVolumes::restore(
  const std::vector<char>& rests, std::vector<Vec3>& points, const Execution& execution) const
{
  double least = std::numeric_limits<double>::infinity();
  int idleRounds = 0;
  for (int round = 0;; ++round)
  {
    execution.report(static_cast<double>(round) / MostRounds);
    std::vector<double> missing =
      labelVolumes(this->Net, this->Triangles, points, this->Volumes.size(), execution);
    for (std::size_t l = 0; l < missing.size(); ++l)
    {
      missing[l] = this->Volumes[l] - missing[l];
    }
    const double error = this->largestError(missing);
    idleRounds = error < (1.0 - LeastProgress) * least ? 0 : idleRounds + 1;
    least = std::min(least, error);
    if (error < SmallEnough || round == MostRounds || idleRounds == MostIdleRounds)
    {
      return error;
    }
    const std::vector<double> lambda = this->multipliers(missing, rests, points, execution);
    std::vector<Vec3> moved = points;
    forEachIndex(execution, this->Net.vertexCount(),
      [&](Index i)
      {
        const VertexGradients gradients =
          gradientsAt(this->Net, this->Triangles, this->Corners, points, i);
        if (rests[at(i)] != 0 || !(gradients.area > 0.0))
        {
          return;
        }
        Vec3 wanted = points[at(i)];
        for (const auto& [label, gradient] : gradients.ofLabels)
        {
          wanted += lambda[static_cast<std::size_t>(label) - 1] / gradients.area * gradient;
        }
        moved[at(i)] = this->Limits.limited(this->Net, i, wanted);
      });
    points.swap(moved);
  }
}

} // namespace evolving
