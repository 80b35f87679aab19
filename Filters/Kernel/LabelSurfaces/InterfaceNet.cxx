// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "LabelSurfaces/InterfaceNet.h"

#include "Errors.h"
#include "LabelSurfaces/CornerOctants.h"
#include "ParallelLoops.h"

#include <algorithm>
#include <limits>
#include <numeric>

namespace evolving
{

namespace
{

/// Rows of corners per chunk: some thousands of corners.
constexpr std::int64_t RowGrain = 16;
/// Quads have three per corner at most, triangles and corners of them twelve times as many.
constexpr GridIndex MostVertices = std::numeric_limits<Index>::max() / 36;

class NetBuilder
{
public:
  NetBuilder(const MaterialGrid& grid, const Execution& execution)
    : Grid(grid)
    , Run(execution)
    , RowCount(static_cast<std::int64_t>(grid.cornerCount(1)) * grid.cornerCount(2))
    , RowOffsets(at(RowCount) + 1, 0)
  {
  }

  InterfaceNet build()
  {
    this->addVertices();
    this->addEdges();
    this->addQuads();
    return std::move(this->Net);
  }

private:
  template <class Visit>
  void forEachVertexOfRow(std::int64_t row, const Visit& visit) const
  {
    std::array<Index, 3> corner = { 0, static_cast<Index>(row % this->Grid.cornerCount(1)),
      static_cast<Index>(row / this->Grid.cornerCount(1)) };
    for (; corner[0] < this->Grid.cornerCount(0); ++corner[0])
    {
      const Octants octants = this->Grid.around(corner);
      if (isVertex(octants))
      {
        visit(corner, octants);
      }
    }
  }

  void addVertices()
  {
    this->Run.phase(0.0, 0.4).forRangeReporting(this->RowCount, RowGrain,
      [this](std::int64_t begin, std::int64_t end)
      {
        for (std::int64_t row = begin; row < end; ++row)
        {
          GridIndex& count = this->RowOffsets[at(row) + 1];
          this->forEachVertexOfRow(
            row, [&count](const std::array<Index, 3>&, const Octants&) { ++count; });
        }
      });
    std::partial_sum(this->RowOffsets.begin(), this->RowOffsets.end(), this->RowOffsets.begin());
    const GridIndex count = this->RowOffsets.back();
    if (count > MostVertices)
    {
      throw InputError("The labels have " + std::to_string(count) +
        " corners of voxels on their borders, expected at most " + std::to_string(MostVertices) +
        "; choose some of the labels, or extract a part of the image.");
    }
    this->Net.corners.resize(at(count));
    this->Net.points.resize(at(count));
    this->Net.fixed.resize(at(count));
    this->Run.phase(0.4, 0.7).forRangeReporting(this->RowCount, RowGrain,
      [this](std::int64_t begin, std::int64_t end)
      {
        for (std::int64_t row = begin; row < end; ++row)
        {
          this->fillRow(row);
        }
      });
  }

  void fillRow(std::int64_t row)
  {
    auto vertex = static_cast<Index>(this->RowOffsets[at(row)]);
    this->forEachVertexOfRow(row,
      [&](const std::array<Index, 3>& corner, const Octants& octants)
      {
        this->Net.corners[at(vertex)] = corner;
        this->Net.points[at(vertex)] = this->Net.cornerPoint(vertex);
        this->Net.fixed[at(vertex)] = fixedCoordinates(octants);
        ++vertex;
      });
  }

  /// Of a corner that is one of the net.
  Index vertexAt(const std::array<Index, 3>& corner) const
  {
    const std::size_t row =
      at(corner[1] + static_cast<GridIndex>(corner[2]) * this->Grid.cornerCount(1));
    const auto begin = this->Net.corners.begin() + this->RowOffsets[row];
    const auto end = this->Net.corners.begin() + this->RowOffsets[row + 1];
    const auto found = std::lower_bound(
      begin, end, corner[0], [](const std::array<Index, 3>& one, Index x) { return one[0] < x; });
    return static_cast<Index>(found - this->Net.corners.begin());
  }

  /// The directions in which edges leave a vertex, by ascending numbers of their other ends.
  template <class Visit>
  static void forEachEdge(const Octants& octants, const Visit& visit)
  {
    constexpr std::array<std::array<unsigned, 2>, 6> Order = { { { 2, 0 }, { 1, 0 }, { 0, 0 },
      { 0, 1 }, { 1, 1 }, { 2, 1 } } };
    for (const auto& [axis, isUpwards] : Order)
    {
      const EdgeKind kind = kindOf(around(octants, axis, isUpwards));
      if (kind.isDrawn)
      {
        visit(axis, isUpwards, kind);
      }
    }
  }

  void addEdges()
  {
    InterfaceNet& net = this->Net;
    const Index count = net.vertexCount();
    net.kinds.resize(at(count));
    net.edgeOffsets.assign(at(count) + 1, 0);
    forEachIndex(this->Run, count,
      [&](Index i)
      {
        forEachEdge(this->Grid.around(net.corners[at(i)]),
          [&](unsigned, unsigned, const EdgeKind&) { ++net.edgeOffsets[at(i) + 1]; });
      });
    std::partial_sum(net.edgeOffsets.begin(), net.edgeOffsets.end(), net.edgeOffsets.begin());
    net.edgeEnds.resize(at(net.edgeOffsets.back()));
    net.isJunction.resize(net.edgeEnds.size());
    this->Run.phase(0.7, 0.8).report(0.0);
    forEachIndex(this->Run, count, [&](Index i) { this->fillEdges(i); });
  }

  void fillEdges(Index i)
  {
    InterfaceNet& net = this->Net;
    const Octants octants = this->Grid.around(net.corners[at(i)]);
    std::size_t edge = at(net.edgeOffsets[at(i)]);
    int junctions = 0;
    forEachEdge(octants,
      [&](unsigned axis, unsigned isUpwards, const EdgeKind& kind)
      {
        std::array<Index, 3> end = net.corners[at(i)];
        end[axis] += isUpwards != 0 ? 1 : -1;
        net.edgeEnds[edge] = this->vertexAt(end);
        net.isJunction[edge] = kind.changes > 2 ? 1 : 0;
        junctions += net.isJunction[edge];
        ++edge;
      });
    const VertexKind ofMore = junctions == 2 ? VertexKind::Curve : VertexKind::Node;
    net.kinds[at(i)] = numberOfMaterials(octants) == 2 ? VertexKind::Sheet : ofMore;
  }

  /// The faces that have a vertex as their lowest corner.
  template <class Visit>
  void forEachQuad(Index i, const Visit& visit) const
  {
    const std::array<Index, 3>& corner = this->Net.corners[at(i)];
    const GridIndex behind = this->Grid.voxel(corner[0], corner[1], corner[2]);
    const Octants octants = this->Grid.around(corner);
    for (unsigned axis = 0; axis < 3; ++axis)
    {
      const std::array<Material, 2> sides = { octants[7U ^ 1U << axis], octants[7] };
      if (isInterface(sides[0], sides[1]))
      {
        const GridIndex before = behind - this->Grid.stride(static_cast<int>(axis));
        visit(axis, sides, std::array<GridIndex, 2>{ before, behind });
      }
    }
  }

  void addQuads()
  {
    InterfaceNet& net = this->Net;
    std::vector<Index> offsets(at(net.vertexCount()) + 1, 0);
    forEachIndex(this->Run, net.vertexCount(),
      [&](Index i)
      { this->forEachQuad(i, [&](unsigned, const auto&, const auto&) { ++offsets[at(i) + 1]; }); });
    std::partial_sum(offsets.begin(), offsets.end(), offsets.begin());
    net.quads.resize(at(offsets.back()));
    this->Run.phase(0.8, 0.9).report(0.0);
    forEachIndex(this->Run, net.vertexCount(),
      [&](Index i)
      {
        std::size_t quad = at(offsets[at(i)]);
        this->forEachQuad(i,
          [&](unsigned axis, const auto& sides, const auto& voxels) {
            net.quads[quad++] = { this->cornersOfQuad(net.corners[at(i)], axis), sides, voxels };
          });
      });
    this->listQuadsOfVertices();
    this->Run.report(1.0);
  }

  std::array<Index, 4> cornersOfQuad(const std::array<Index, 3>& corner, unsigned axis) const
  {
    std::array<Index, 3> second = corner;
    ++second[(axis + 1) % 3];
    std::array<Index, 3> fourth = corner;
    ++fourth[(axis + 2) % 3];
    std::array<Index, 3> third = second;
    ++third[(axis + 2) % 3];
    return { this->vertexAt(corner), this->vertexAt(second), this->vertexAt(third),
      this->vertexAt(fourth) };
  }

  void listQuadsOfVertices()
  {
    InterfaceNet& net = this->Net;
    net.quadOffsets.assign(at(net.vertexCount()) + 1, 0);
    for (const NetQuad& quad : net.quads)
    {
      for (const Index vertex : quad.vertices)
      {
        ++net.quadOffsets[at(vertex) + 1];
      }
    }
    std::partial_sum(net.quadOffsets.begin(), net.quadOffsets.end(), net.quadOffsets.begin());
    net.quadsOfVertices.resize(at(net.quadOffsets.back()));
    std::vector<Index> next(net.quadOffsets.begin(), net.quadOffsets.end() - 1);
    for (Index quad = 0; quad < net.quadCount(); ++quad)
    {
      for (const Index vertex : net.quads[at(quad)].vertices)
      {
        net.quadsOfVertices[at(next[at(vertex)]++)] = quad;
      }
    }
  }

  const MaterialGrid& Grid;
  const Execution& Run;
  std::int64_t RowCount;
  std::vector<GridIndex> RowOffsets;
  InterfaceNet Net;
};

} // namespace

InterfaceNet interfaceNet(const MaterialGrid& grid, const Execution& execution)
{
  return NetBuilder(grid, execution).build();
}

} // namespace evolving
