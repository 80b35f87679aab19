// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Features/NarrowPatches.h"

#include "Features/CarriableFeatures.h"
#include "Features/SurfacePatches.h"
#include "Mesh/DisjointSets.h"
#include "Trees/TriangleGeometry.h"

#include <algorithm>
#include <functional>
#include <limits>
#include <map>
#include <queue>
#include <utility>
#include <vector>

namespace evolving
{

namespace
{

constexpr double LongBorder = 0.5; ///< of a neighbour to merge with, over the longest

/// What two patches share.
struct SharedBorder
{
  double length = 0.0;
  double foldTimesLength = 0.0;

  double fold() const { return this->foldTimesLength / this->length; }
  void add(const SharedBorder& other)
  {
    this->length += other.length;
    this->foldTimesLength += other.foldTimesLength;
  }
};

struct Patch
{
  double area = 0.0;
  double outerBorder = 0.0;              ///< the surface's boundary
  std::map<Index, SharedBorder> borders; ///< by neighbour
  double listedWidth = -1.0;             ///< in the queue

  double width() const
  {
    double border = this->outerBorder;
    for (const auto& [neighbour, shared] : this->borders)
    {
      border += shared.length;
    }
    return border > 0.0 ? 2.0 * this->area / border : std::numeric_limits<double>::infinity();
  }
};

class PatchMerging
{
public:
  PatchMerging(const TargetTriangles& target, const SharpEdges& sharp)
    : Target(target)
    , Labels(surfacePatches(target, sharp))
    , Sets(static_cast<std::size_t>(this->Labels.count))
    , Patches(static_cast<std::size_t>(this->Labels.count))
  {
    const SurfaceMesh& mesh = target.mesh();
    for (Index face = 0; face < mesh.faceCount(); ++face)
    {
      this->patch(this->Labels[face]).area += faceVectorArea(mesh, face).norm();
    }
    for (Index edge = 0; edge < target.edges().edgeCount(); ++edge)
    {
      this->addEdge(sharp, edge);
    }
  }

  /// @return whether any two patches were merged
  bool run(double width)
  {
    for (Index p = 0; p < this->Labels.count; ++p)
    {
      this->listWidth(p);
    }
    bool merged = false;
    while (!this->Narrowest.empty() && this->Narrowest.top().first < width)
    {
      const auto [listedWidth, p] = this->Narrowest.top();
      this->Narrowest.pop();
      // What was merged since is listed again, or part of another.
      const bool isCurrent = listedWidth == this->patch(p).listedWidth;
      const Index q = isCurrent ? this->bestNeighbour(p) : NoIndex;
      if (q != NoIndex)
      {
        this->listWidth(this->merge(p, q));
        merged = true;
      }
    }
    return merged;
  }

  /// Were any two faces of an edge parts of different patches that are one now?
  bool areMergedAt(Index edge)
  {
    const Index* last = this->Target.edges().end(edge);
    for (const Index* a = this->Target.edges().begin(edge); a != last; ++a)
    {
      for (const Index* b = a + 1; b != last; ++b)
      {
        const Index p = this->Labels[TargetTriangles::faceOf(*a)];
        const Index q = this->Labels[TargetTriangles::faceOf(*b)];
        if (p != q && this->Sets.find(p) == this->Sets.find(q))
        {
          return true;
        }
      }
    }
    return false;
  }

private:
  using ListedWidth = std::pair<double, Index>;

  void listWidth(Index p)
  {
    this->patch(p).listedWidth = this->patch(p).width();
    this->Narrowest.emplace(this->patch(p).listedWidth, p);
  }

  Patch& patch(Index p) { return this->Patches[static_cast<std::size_t>(p)]; }

  void addEdge(const SharpEdges& sharp, Index edge)
  {
    const Index* first = this->Target.edges().begin(edge);
    const Index* last = this->Target.edges().end(edge);
    const double length = this->Target.edgeLength(edge);
    if (last - first == 1)
    {
      this->patch(this->Labels[TargetTriangles::faceOf(*first)]).outerBorder += length;
    }
    const SharedBorder border{ length, length * sharp.fold(edge) };
    for (const Index* a = first; a != last && sharp.isSharp(edge); ++a)
    {
      for (const Index* b = first; b != last; ++b)
      {
        const Index p = this->Labels[TargetTriangles::faceOf(*a)];
        const Index q = this->Labels[TargetTriangles::faceOf(*b)];
        if (p != q)
        {
          this->patch(p).borders[q].add(border);
        }
      }
    }
  }

  /// By the words of keepCarriable(); NoIndex when there is none.
  Index bestNeighbour(Index p)
  {
    double longest = 0.0;
    for (const auto& [q, border] : this->patch(p).borders)
    {
      longest = std::max(longest, border.length);
    }
    double weakest = std::numeric_limits<double>::infinity();
    for (const auto& [q, border] : this->patch(p).borders)
    {
      weakest = border.length >= LongBorder * longest ? std::min(weakest, border.fold()) : weakest;
    }
    Index best = NoIndex;
    for (const auto& [q, border] : this->patch(p).borders)
    {
      const bool mayBe =
        border.length >= LongBorder * longest && border.fold() <= weakest + SimilarFold;
      if (mayBe &&
        (best == NoIndex || this->patch(q).area > (1.0 + SimilarSize) * this->patch(best).area))
      {
        best = q;
      }
    }
    return best;
  }

  Index merge(Index p, Index q)
  {
    this->Sets.join(p, q);
    const Index whole = std::min(p, q);
    const Index part = std::max(p, q);
    Patch taken = std::move(this->patch(part));
    this->patch(part) = {};
    this->patch(whole).area += taken.area;
    this->patch(whole).outerBorder += taken.outerBorder;
    this->patch(whole).borders.erase(part);
    for (const auto& [neighbour, border] : taken.borders)
    {
      if (neighbour != whole)
      {
        this->patch(whole).borders[neighbour].add(border);
        this->patch(neighbour).borders[whole].add(border);
        this->patch(neighbour).borders.erase(part);
      }
    }
    return whole;
  }

  const TargetTriangles& Target;
  TriangleLabels Labels;
  DisjointSets Sets;
  std::vector<Patch> Patches; ///< those whose number is their set's are current
  std::priority_queue<ListedWidth, std::vector<ListedWidth>, std::greater<>> Narrowest;
};

} // namespace

bool mergeNarrowPatches(const TargetTriangles& target, SharpEdges& sharp, double width)
{
  PatchMerging merging(target, sharp);
  if (!merging.run(width))
  {
    return false;
  }
  for (const Index edge : sharp.list())
  {
    if (merging.areMergedAt(edge))
    {
      sharp.leaveOut(edge);
    }
  }
  return true;
}

} // namespace evolving
