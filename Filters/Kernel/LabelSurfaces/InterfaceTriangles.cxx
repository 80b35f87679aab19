// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "LabelSurfaces/InterfaceTriangles.h"

#include "Mesh/TriangleView.h"
#include "ParallelLoops.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace evolving
{

namespace
{

/// Cosines that differ by less are equal; then the diagonal is the one from the first corner.
constexpr double Equal = 1e-6;

double cosine(const Vec3& a, const Vec3& b)
{
  const double lengths = a.norm() * b.norm();
  return lengths > 0.0 ? a.dot(b) / lengths : 1.0;
}

/// The largest one, of the smallest angle.
double largestCosine(const Vec3& a, const Vec3& b, const Vec3& c)
{
  return std::max({ cosine(b - a, c - a), cosine(c - b, a - b), cosine(a - c, b - c) });
}

class EdgeSplitting
{
public:
  EdgeSplitting(const std::vector<NetEdge>& edges, Index first, InterfaceTriangles& triangles)
    : Edges(edges)
    , First(first)
    , Triangles(triangles)
  {
  }

  /// The first part takes the triangle's place.
  void split(Index triangle)
  {
    for (std::size_t k = 0; k < 3; ++k)
    {
      const TriangleVertices v = this->vertices(triangle);
      const NetEdge edge = { std::min(v[k], v[(k + 1) % 3]), std::max(v[k], v[(k + 1) % 3]) };
      const auto found = std::lower_bound(this->Edges.begin(), this->Edges.end(), edge);
      if (found != this->Edges.end() && *found == edge)
      {
        const Index middle = this->First + static_cast<Index>(found - this->Edges.begin());
        const Index other = this->Triangles.count();
        this->Triangles.corners[at(3 * triangle) + (k + 1) % 3] = middle;
        this->Triangles.corners.insert(
          this->Triangles.corners.end(), { middle, v[(k + 1) % 3], v[(k + 2) % 3] });
        this->Triangles.quads.push_back(this->Triangles.quads[at(triangle)]);
        this->split(triangle);
        this->split(other);
        return;
      }
    }
  }

private:
  TriangleVertices vertices(Index triangle) const
  {
    const std::size_t first = at(3 * triangle);
    return { this->Triangles.corners[first], this->Triangles.corners[first + 1],
      this->Triangles.corners[first + 2] };
  }

  const std::vector<NetEdge>& Edges;
  Index First;
  InterfaceTriangles& Triangles;
};

} // namespace

InterfaceTriangles splitNet(
  const InterfaceNet& net, const std::vector<Vec3>& points, const Execution& execution)
{
  InterfaceTriangles triangles;
  triangles.corners.resize(6 * net.quads.size());
  triangles.quads.resize(2 * net.quads.size());
  forEachIndex(execution, net.quadCount(),
    [&](Index quad)
    {
      const std::array<Index, 4>& v = net.quads[at(quad)].vertices;
      std::array<Vec3, 4> p;
      std::transform(v.begin(), v.end(), p.begin(), [&](Index i) { return points[at(i)]; });
      const double first =
        std::max(largestCosine(p[0], p[1], p[2]), largestCosine(p[0], p[2], p[3]));
      const double second =
        std::max(largestCosine(p[1], p[2], p[3]), largestCosine(p[1], p[3], p[0]));
      const std::size_t k = second < first - Equal ? 1 : 0;
      const std::array<Index, 6> corners = { v[k], v[k + 1], v[k + 2], v[k], v[k + 2],
        v[(k + 3) % 4] };
      std::copy(corners.begin(), corners.end(), triangles.corners.begin() + 6 * quad);
      triangles.quads[at(2 * quad)] = quad;
      triangles.quads[at(2 * quad + 1)] = quad;
    });
  return triangles;
}

CornersOfVertices cornersOfVertices(const InterfaceTriangles& triangles, Index vertexCount)
{
  CornersOfVertices all;
  all.offsets.assign(at(vertexCount) + 1, 0);
  all.corners.resize(triangles.corners.size());
  for (const Index vertex : triangles.corners)
  {
    ++all.offsets[at(vertex) + 1];
  }
  std::partial_sum(all.offsets.begin(), all.offsets.end(), all.offsets.begin());
  std::vector<Index> next(all.offsets.begin(), all.offsets.end() - 1);
  for (std::size_t corner = 0; corner < triangles.corners.size(); ++corner)
  {
    all.corners[at(next[at(triangles.corners[corner])]++)] = static_cast<Index>(corner);
  }
  return all;
}

void splitEdges(const std::vector<NetEdge>& edges, Index first, InterfaceTriangles& triangles)
{
  EdgeSplitting splitting(edges, first, triangles);
  const Index count = triangles.count();
  for (Index triangle = 0; triangle < count && !edges.empty(); ++triangle)
  {
    splitting.split(triangle);
  }
}

} // namespace evolving
