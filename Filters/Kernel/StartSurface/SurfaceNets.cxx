// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "StartSurface/SurfaceNets.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace evolving
{

namespace
{

/// The smallest distance of crossings from samples, in edges, and of vertices from cell sides: far
/// above rounding, and below what a field of floats and a cell's curvature leave unsure.
constexpr double Inset = 0.02;

/// Where the surface crosses the edge from an inside sample to an outside one, from 0 to 1.
double crossing(double insideValue, double outsideValue)
{
  // Samples that were turned inside have the outside's sign: they count as mirrored.
  const double inner = std::abs(insideValue);
  const double outer = std::abs(outsideValue);
  const double fraction = inner + outer > 0.0 ? inner / (inner + outer) : 0.5;
  return std::clamp(fraction, Inset, 1.0 - Inset);
}

/// Builds the net layer by layer of cells, remembering the vertex numbers of two layers.
class NetBuilder
{
public:
  NetBuilder(const DistanceGrid& grid, const InsideSamples& samples)
    : Grid(grid)
    , Samples(samples)
    , VertexBelow(at(samples.stride(2)), NoIndex)
    , VertexHere(at(samples.stride(2)), NoIndex)
  {
  }

  /// Adds the vertices of cell layer k and the quads that need no later layer.
  void addLayer(int k)
  {
    std::swap(this->VertexBelow, this->VertexHere);
    for (int j = 0; j + 1 < this->Samples.size(1); ++j)
    {
      for (int i = 0; i + 1 < this->Samples.size(0); ++i)
      {
        this->addVertex(i, j, k);
      }
    }
    for (int j = 0; j + 1 < this->Samples.size(1); ++j)
    {
      for (int i = 0; i + 1 < this->Samples.size(0); ++i)
      {
        this->addQuads(i, j, k);
      }
    }
  }

  SurfaceNet takeNet() { return std::move(this->Net); }

private:
  void addVertex(int i, int j, int k)
  {
    const GridIndex cell = this->Samples.sample(i, j, k);
    const unsigned corners = this->Samples.cornersOfCell(cell);
    if (corners == 0 || corners == 0xff)
    {
      return;
    }
    const Vec3 corner = this->cellCorner(i, j, k);
    const Vec3 local = this->meanCrossing(cell, corners);
    this->VertexHere[at(this->Samples.sample(i, j, 0))] =
      this->Net.mesh.addPoint(corner + local.cwiseProduct(this->Grid.spacing));
    this->Net.cellOfVertex.emplace_back(corner, corner + this->Grid.spacing);
  }

  Vec3 cellCorner(int i, int j, int k) const
  {
    const Extent& extent = this->Grid.extent;
    const Vec3 lattice(extent[0] + i - 1.0, extent[2] + j - 1.0, extent[4] + k - 1.0);
    return this->Grid.origin + lattice.cwiseProduct(this->Grid.spacing);
  }

  /// The mean of the crossings of a cell's twelve edges, in units of the cell.
  Vec3 meanCrossing(GridIndex cell, unsigned corners) const
  {
    Vec3 sum = Vec3::Zero();
    int count = 0;
    for (unsigned axis = 0; axis < 3; ++axis)
    {
      for (unsigned b = 0; b < 8; ++b)
      {
        const unsigned end = b | 1U << axis;
        const bool startInside = (corners >> b & 1U) != 0;
        if (end == b || startInside == ((corners >> end & 1U) != 0))
        {
          continue;
        }
        sum += Vec3(b & 1U, b >> 1U & 1U, b >> 2U);
        sum[axis] += this->crossingFromStart(cell, b, end, startInside);
        ++count;
      }
    }
    return sum / count;
  }

  double crossingFromStart(GridIndex cell, unsigned start, unsigned end, bool startInside) const
  {
    const double a = this->Samples.valueAboveIso(cell + this->Samples.cornerOffset(start));
    const double b = this->Samples.valueAboveIso(cell + this->Samples.cornerOffset(end));
    return startInside ? crossing(a, b) : 1.0 - crossing(b, a);
  }

  /// The quads around the edges that leave sample (i, j, k) upwards along the axes. In the outer
  /// layer only edges into the grid are crossed, so the four cells always exist.
  void addQuads(int i, int j, int k)
  {
    const GridIndex sample = this->Samples.sample(i, j, k);
    const bool inside = this->Samples.isInside(sample);
    for (int axis = 0; axis < 3; ++axis)
    {
      if (this->Samples.isInside(sample + this->Samples.stride(axis)) != inside)
      {
        this->addQuad({ i, j, k }, axis, inside);
      }
    }
  }

  /// The quad through the four cells around an edge, counter-clockwise seen along the axis.
  void addQuad(const std::array<int, 3>& cell, int axis, bool outwardAlongAxis)
  {
    const auto u = static_cast<std::size_t>((axis + 1) % 3);
    const auto v = static_cast<std::size_t>((axis + 2) % 3);
    std::array<int, 3> lowU = cell;
    --lowU[u];
    std::array<int, 3> lowV = cell;
    --lowV[v];
    std::array<int, 3> lowBoth = lowU;
    --lowBoth[v];
    const std::array<int, 3> kept = cell;
    const auto& second = outwardAlongAxis ? lowV : lowU;
    const auto& fourth = outwardAlongAxis ? lowU : lowV;
    const int k = cell[2];
    this->Net.mesh.addFace({ this->vertexOf(lowBoth, k), this->vertexOf(second, k),
      this->vertexOf(kept, k), this->vertexOf(fourth, k) });
  }

  Index vertexOf(const std::array<int, 3>& cell, int layer) const
  {
    const std::vector<Index>& vertices = cell[2] == layer ? this->VertexHere : this->VertexBelow;
    return vertices[at(this->Samples.sample(cell[0], cell[1], 0))];
  }

  const DistanceGrid& Grid;
  const InsideSamples& Samples;
  std::vector<Index> VertexBelow;
  std::vector<Index> VertexHere;
  SurfaceNet Net;
};

/// For every vertex the mean of the vertices at the other ends of its edges.
std::vector<Vec3> meanOfNeighbours(const SurfaceMesh& mesh)
{
  std::vector<Vec3> sum(mesh.points.size(), Vec3::Zero());
  std::vector<int> count(mesh.points.size(), 0);
  for (Index face = 0; face < mesh.faceCount(); ++face)
  {
    const Index size = mesh.faceSize(face);
    for (Index k = 0; k < size; ++k)
    {
      // A closed surface has every edge once in each direction.
      const auto vertex = at(mesh.faceVertex(face, k));
      sum[vertex] += mesh.facePoint(face, (k + 1) % size);
      ++count[vertex];
    }
  }
  for (std::size_t v = 0; v < sum.size(); ++v)
  {
    sum[v] = count[v] > 0 ? Vec3(sum[v] / count[v]) : mesh.points[v];
  }
  return sum;
}

Vec3 clampToCell(const Vec3& point, const Box& cell)
{
  const Vec3 inset = Inset * cell.sizes();
  return point.cwiseMax(cell.min() + inset).cwiseMin(cell.max() - inset);
}

} // namespace

SurfaceNet surfaceNet(
  const DistanceGrid& grid, const InsideSamples& samples, const Execution& execution)
{
  NetBuilder builder(grid, samples);
  const int layers = samples.size(2) - 1;
  for (int k = 0; k < layers; ++k)
  {
    execution.report(static_cast<double>(k) / layers);
    builder.addLayer(k);
  }
  return builder.takeNet();
}

void relaxWithinCells(SurfaceNet& net, int sweeps, const Execution& execution)
{
  for (int sweep = 0; sweep < sweeps; ++sweep)
  {
    execution.report(static_cast<double>(sweep) / sweeps);
    const std::vector<Vec3> means = meanOfNeighbours(net.mesh);
    for (std::size_t v = 0; v < means.size(); ++v)
    {
      net.mesh.points[v] = clampToCell(means[v], net.cellOfVertex[v]);
    }
  }
}

} // namespace evolving
