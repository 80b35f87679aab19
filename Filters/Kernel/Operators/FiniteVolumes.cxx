// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Operators/FiniteVolumes.h"

#include "Operators/PolygonLaplacian.h"
#include "ParallelLoops.h"

#include <algorithm>
#include <cmath>

namespace evolving
{

namespace
{

/// The vertices that share a face with `vertex`, itself included, ascending.
void collectColumns(const MeshTopology& topology, Index vertex, std::vector<Index>& columns)
{
  columns.assign(1, vertex);
  for (const Index corner : topology.ringCorners(vertex))
  {
    for (Index c = topology.next(corner); c != corner; c = topology.next(c))
    {
      columns.push_back(topology.vertexOf(c));
    }
  }
  std::sort(columns.begin(), columns.end());
  columns.erase(std::unique(columns.begin(), columns.end()), columns.end());
}

} // namespace

FiniteVolumes::FiniteVolumes(const MeshTopology& topology)
  : Topology(topology)
{
  this->buildPattern();
  this->locatePairs();
  this->CoVolumes.resize(at(topology.vertexCount()));
  this->CornerAreas.resize(at(topology.cornerCount()));
  this->PairWeights.resize(this->PairPositions.size());
}

void FiniteVolumes::buildPattern()
{
  const Index count = this->Topology.vertexCount();
  std::vector<Index> outer(1, 0);
  std::vector<Index> inner;
  std::vector<Index> columns;
  for (Index row = 0; row < count; ++row)
  {
    collectColumns(this->Topology, row, columns);
    const auto own = std::lower_bound(columns.begin(), columns.end(), row);
    this->Diagonal.push_back(outer.back() + static_cast<Index>(own - columns.begin()));
    inner.insert(inner.end(), columns.begin(), columns.end());
    outer.push_back(static_cast<Index>(inner.size()));
  }
  const std::vector<double> values(inner.size(), 0.0);
  this->L = Eigen::Map<const SparseMatrix>(count, count, static_cast<Eigen::Index>(inner.size()),
    outer.data(), inner.data(), values.data());
}

void FiniteVolumes::locatePairs()
{
  const Index* inner = this->L.innerIndexPtr();
  const Index* outer = this->L.outerIndexPtr();
  this->PairOffsets.assign(1, 0);
  for (Index corner = 0; corner < this->Topology.cornerCount(); ++corner)
  {
    const Index row = this->Topology.vertexOf(corner);
    for (Index c = this->Topology.next(corner); c != corner; c = this->Topology.next(c))
    {
      const Index* entry =
        std::lower_bound(inner + outer[row], inner + outer[row + 1], this->Topology.vertexOf(c));
      this->PairPositions.push_back(static_cast<Index>(entry - inner));
    }
    this->PairOffsets.push_back(static_cast<Index>(this->PairPositions.size()));
  }
}

void FiniteVolumes::update(const SurfaceMesh& mesh, const Execution& execution)
{
  this->computeFaces(mesh, execution);
  forEachIndex(
    execution, this->Topology.vertexCount(), [this](Index row) { this->gatherRow(row); });
  this->raiseVanishingCoVolumes(execution);
}

void FiniteVolumes::computeFaces(const SurfaceMesh& mesh, const Execution& execution)
{
  execution.forRange(mesh.faceCount(), LoopGrain,
    [&](std::int64_t begin, std::int64_t end)
    {
      FaceStencil stencil;
      std::vector<Vec3> corners;
      for (auto face = static_cast<Index>(begin); face < static_cast<Index>(end); ++face)
      {
        corners.clear();
        for (Index k = 0; k < mesh.faceSize(face); ++k)
        {
          corners.push_back(mesh.facePoint(face, k));
        }
        computeFaceStencil(corners, stencil);
        const std::size_t corner = at(mesh.faceOffsets[at(face)]);
        std::copy(stencil.cornerAreas.begin(), stencil.cornerAreas.end(),
          this->CornerAreas.begin() + static_cast<std::ptrdiff_t>(corner));
        std::copy(stencil.pairWeights.begin(), stencil.pairWeights.end(),
          this->PairWeights.begin() + this->PairOffsets[corner]);
      }
    });
}

void FiniteVolumes::gatherRow(Index row)
{
  double* values = this->L.valuePtr();
  std::fill(values + this->L.outerIndexPtr()[row], values + this->L.outerIndexPtr()[row + 1], 0.0);
  double area = 0.0;
  double diagonal = 0.0;
  for (const Index corner : this->Topology.ringCorners(row))
  {
    area += this->CornerAreas[at(corner)];
    for (Index pair = this->PairOffsets[at(corner)]; pair < this->PairOffsets[at(corner) + 1];
         ++pair)
    {
      const double weight = this->PairWeights[at(pair)];
      values[this->PairPositions[at(pair)]] -= weight;
      diagonal += weight;
    }
  }
  values[this->Diagonal[at(row)]] += diagonal;
  this->CoVolumes[at(row)] = area;
}

void FiniteVolumes::raiseVanishingCoVolumes(const Execution& execution)
{
  const double mean = totalArea(this->CoVolumes, execution) /
    std::max(1.0, static_cast<double>(this->CoVolumes.size()));
  const double smallest = mean > 0.0 ? 1e-12 * mean : 1.0;
  forEachIndex(execution, this->Topology.vertexCount(),
    [&](Index i) { this->CoVolumes[at(i)] = std::max(this->CoVolumes[at(i)], smallest); });
}

std::vector<Vec3> FiniteVolumes::curvatureVectors(
  const SurfaceMesh& mesh, const Execution& execution) const
{
  std::vector<Vec3> h(mesh.points.size());
  forEachIndex(execution, this->Topology.vertexCount(),
    [&](Index row)
    {
      Vec3 sum = Vec3::Zero();
      forEachEntry(this->L, row,
        [&](Index column, double value)
        { sum += value * (mesh.points[at(row)] - mesh.points[at(column)]); });
      h[at(row)] = sum / this->CoVolumes[at(row)]; // -M^-1 L F: the entries are -w_ij
    });
  return h;
}

double totalArea(const std::vector<double>& coVolumes, const Execution& execution)
{
  return sumEachIndex(execution, static_cast<std::int64_t>(coVolumes.size()),
    [&](Index i) { return coVolumes[at(i)]; });
}

} // namespace evolving
