// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Redistribution/LengthRedistribution.h"

#include "Operators/SurfaceGeometry.h"
#include "ParallelLoops.h"
#include "Redistribution/EdgeChains.h"

#include <algorithm>

namespace evolving
{

namespace
{

/// Chains per task: they differ in length from one edge to thousands.
constexpr std::int64_t ChainGrain = 64;

bool isEnd(const VertexChain& chain, Index k)
{
  return !chain.isClosed && (k == 0 || k == chain.size() - 1);
}

Vec3 tangent(const VertexChain& chain, const std::vector<Vec3>& points, Index k)
{
  return (points[at(chain.vertex(k + 1))] - points[at(chain.vertex(k - 1))]).normalized();
}

/// k . v_N at an inner vertex: the change of the unit tangent per length.
double curvatureTimesVelocity(const VertexChain& chain, const std::vector<Vec3>& points,
  const std::vector<Vec3>& normalVelocity, Index k)
{
  const Vec3 in = points[at(chain.vertex(k))] - points[at(chain.vertex(k - 1))];
  const Vec3 out = points[at(chain.vertex(k + 1))] - points[at(chain.vertex(k))];
  const double length = 0.5 * (in.norm() + out.norm());
  const Vec3 turn = out.normalized() - in.normalized();
  return length > 0.0 ? turn.dot(normalVelocity[at(chain.vertex(k))]) / length : 0.0;
}

double sumOf(const std::vector<double>& values)
{
  double sum = 0.0;
  for (const double value : values)
  {
    sum += value;
  }
  return sum;
}

} // namespace

std::vector<double> chainSpeeds(const VertexChain& chain, const std::vector<Vec3>& points,
  const std::vector<Vec3>& normalVelocity, double rate, double largestRate)
{
  const Index n = chain.size();
  const Index m = chain.edgeCount();
  std::vector<double> shortening(at(n), 0.0); // k . v_N at the vertices
  for (Index k = 0; k < n; ++k)
  {
    if (!isEnd(chain, k))
    {
      shortening[at(k)] = std::clamp(
        curvatureTimesVelocity(chain, points, normalVelocity, k), -largestRate, largestRate);
    }
  }
  std::vector<double> length(at(m));
  std::vector<double> loss(at(m)); // l_k (k . v_N)_k
  for (Index k = 0; k < m; ++k)
  {
    length[at(k)] = (points[at(chain.vertex(k + 1))] - points[at(chain.vertex(k))]).norm();
    loss[at(k)] = length[at(k)] * 0.5 * (shortening[at(k)] + shortening[at((k + 1) % n)]);
  }
  const double total = sumOf(length);
  const double mean = total > 0.0 ? sumOf(loss) / total : 0.0;
  std::vector<double> speed(at(n), 0.0);
  for (Index k = 0; k + 1 < n; ++k)
  {
    speed[at(k + 1)] =
      speed[at(k)] + loss[at(k)] - length[at(k)] * mean + rate * (total / m - length[at(k)]);
  }
  if (chain.isClosed)
  {
    const double average = sumOf(speed) / n;
    for (double& value : speed)
    {
      value -= average;
    }
  }
  else
  {
    speed.back() = 0.0; // up to rounding it is
  }
  return speed;
}

LengthRedistribution::LengthRedistribution(
  const MeshTopology& topology, const SurfaceCurves& curves)
  : Chains(curves.chains())
  , EntryOffsets(1, 0)
{
  const std::vector<VertexChain> inner = edgeChains(topology, curves);
  this->Chains.insert(this->Chains.end(), inner.begin(), inner.end());
  for (const VertexChain& chain : this->Chains)
  {
    this->EntryOffsets.push_back(this->EntryOffsets.back() + chain.size());
  }
}

std::vector<Vec3> LengthRedistribution::velocity(const SurfaceMesh& mesh,
  const std::vector<Vec3>& normals, const std::vector<Vec3>& normalVelocity, double rate,
  double largestRate, const Execution& execution) const
{
  std::vector<Vec3> entries(at(this->EntryOffsets.back()), Vec3::Zero());
  execution.forRange(static_cast<std::int64_t>(this->Chains.size()), ChainGrain,
    [&](std::int64_t begin, std::int64_t end)
    {
      for (auto c = static_cast<std::size_t>(begin); c < static_cast<std::size_t>(end); ++c)
      {
        const VertexChain& chain = this->Chains[c];
        const std::vector<double> speed =
          chainSpeeds(chain, mesh.points, normalVelocity, rate, largestRate);
        for (Index k = 0; k < chain.size(); ++k)
        {
          entries[at(this->EntryOffsets[c] + k)] = isEnd(chain, k)
            ? Vec3(Vec3::Zero())
            : Vec3(speed[at(k)] * tangent(chain, mesh.points, k));
        }
      }
    });
  std::vector<Vec3> velocity(mesh.points.size(), Vec3::Zero());
  std::vector<int> chainsAt(mesh.points.size(), 0);
  for (std::size_t c = 0; c < this->Chains.size(); ++c)
  {
    for (Index k = 0; k < this->Chains[c].size(); ++k)
    {
      const std::size_t v = at(this->Chains[c].vertex(k));
      velocity[v] += entries[at(this->EntryOffsets[c] + k)];
      chainsAt[v] += isEnd(this->Chains[c], k) ? 0 : 1;
    }
  }
  forEachIndex(execution, mesh.vertexCount(),
    [&](Index i)
    {
      velocity[at(i)] =
        tangentialPart(velocity[at(i)] / std::max(1, chainsAt[at(i)]), normals[at(i)]);
    });
  return velocity;
}

} // namespace evolving
