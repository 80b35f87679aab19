// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Surface.h"

#include "Mesh/TrianglePairs.h"

#include <algorithm>
#include <limits>
#include <map>
#include <numeric>

namespace robustness
{

namespace
{

/// Sets that are joined; each has the smallest member as its name.
class Sets
{
public:
  explicit Sets(std::size_t count)
    : Parent(count)
  {
    std::iota(this->Parent.begin(), this->Parent.end(), std::size_t(0));
  }
  std::size_t find(std::size_t i)
  {
    while (this->Parent[i] != i)
    {
      i = this->Parent[i] = this->Parent[this->Parent[i]];
    }
    return i;
  }
  void join(std::size_t i, std::size_t j)
  {
    const std::size_t a = this->find(i), b = this->find(j);
    this->Parent[std::max(a, b)] = std::min(a, b);
  }

private:
  std::vector<std::size_t> Parent;
};

/// One use of an edge by a face, and the face's corners at its two ends.
struct Use
{
  bool isForward;
  std::size_t cornerAtLow;
  std::size_t cornerAtHigh;
};

using Edges = std::map<std::pair<std::int64_t, std::int64_t>, std::vector<Use>>;

Edges edgesOf(const Surface& surface)
{
  Edges edges;
  std::size_t first = 0;
  for (const Cell& face : surface.faces)
  {
    const std::size_t n = face.size();
    for (std::size_t k = 0; k < n; ++k)
    {
      const std::int64_t a = face[k], b = face[(k + 1) % n];
      const std::size_t at = first + k, next = first + (k + 1) % n;
      edges[std::minmax(a, b)].push_back({ a < b, a < b ? at : next, a < b ? next : at });
    }
    first += n;
  }
  return edges;
}

/// Vertices with corners that are not joined by faces that share an edge there.
std::int64_t countCrowdedVertices(const Surface& surface, const Edges& edges)
{
  std::vector<std::int64_t> vertexOfCorner;
  for (const Cell& face : surface.faces)
  {
    vertexOfCorner.insert(vertexOfCorner.end(), face.begin(), face.end());
  }
  Sets fans(vertexOfCorner.size());
  for (const auto& [edge, uses] : edges)
  {
    for (const Use& use : uses)
    {
      fans.join(uses.front().cornerAtLow, use.cornerAtLow);
      fans.join(uses.front().cornerAtHigh, use.cornerAtHigh);
    }
  }
  std::map<std::int64_t, int> fansAt;
  for (std::size_t c = 0; c < vertexOfCorner.size(); ++c)
  {
    fansAt[vertexOfCorner[c]] += fans.find(c) == c ? 1 : 0;
  }
  return std::count_if(
    fansAt.begin(), fansAt.end(), [](const auto& entry) { return entry.second > 1; });
}

/// For every face the number of its component.
std::vector<std::size_t> componentsOf(const Surface& surface, std::size_t& count)
{
  Sets vertices(surface.points.size());
  for (const Cell& face : surface.faces)
  {
    for (const std::int64_t id : face)
    {
      vertices.join(static_cast<std::size_t>(face.front()), static_cast<std::size_t>(id));
    }
  }
  std::map<std::size_t, std::size_t> numbers;
  std::vector<std::size_t> ofFace;
  for (const Cell& face : surface.faces)
  {
    const std::size_t root = vertices.find(static_cast<std::size_t>(face.front()));
    ofFace.push_back(numbers.try_emplace(root, numbers.size()).first->second);
  }
  count = numbers.size();
  return ofFace;
}

evolving::Box boxOf(const Surface& surface, const Cell& face)
{
  evolving::Box box;
  for (std::size_t k = 0; k < face.size(); ++k)
  {
    box.extend(surface.corner(face, k));
  }
  return box;
}

std::vector<Triangle> trianglesOf(const Surface& surface)
{
  std::vector<Triangle> triangles;
  for (const Cell& face : surface.faces)
  {
    for (std::size_t k = 1; k + 1 < face.size(); ++k)
    {
      triangles.push_back({ face[0], face[k], face[k + 1] });
    }
  }
  return triangles;
}

} // namespace

Topology topologyOf(const Surface& surface)
{
  Topology topology;
  const Edges edges = edgesOf(surface);
  for (const auto& [edge, uses] : edges)
  {
    topology.borderEdges += uses.size() == 1 ? 1 : 0;
    topology.crowdedEdges += uses.size() > 2 ? 1 : 0;
    topology.turnedEdges += uses.size() == 2 && uses[0].isForward == uses[1].isForward ? 1 : 0;
  }
  topology.edges = static_cast<std::int64_t>(edges.size());
  topology.faces = static_cast<std::int64_t>(surface.faces.size());
  topology.crowdedVertices = countCrowdedVertices(surface, edges);
  std::size_t components = 0;
  componentsOf(surface, components);
  topology.components = static_cast<std::int64_t>(components);
  std::vector<char> used(surface.points.size(), 0);
  for (const Cell& face : surface.faces)
  {
    for (const std::int64_t id : face)
    {
      used[static_cast<std::size_t>(id)] = 1;
    }
  }
  topology.vertices = std::count(used.begin(), used.end(), 1);
  return topology;
}

std::int64_t intersectionsOf(const Surface& surface)
{
  using evolving::Index;
  std::vector<evolving::TriangleVertices> triangles;
  std::vector<evolving::Box> boxes;
  for (const Cell& face : surface.faces)
  {
    const evolving::TriangleVertices t{ static_cast<Index>(face[0]), static_cast<Index>(face[1]),
      static_cast<Index>(face[2]) };
    if (evolving::hasArea(surface.points, t))
    {
      triangles.push_back(t);
      boxes.push_back(boxOf(surface, face));
    }
  }
  // In the order of their lower x, a triangle need only be held against those that begin before
  // it ends.
  std::vector<std::size_t> order(triangles.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  std::sort(order.begin(), order.end(),
    [&](std::size_t a, std::size_t b) { return boxes[a].min().x() < boxes[b].min().x(); });
  std::int64_t count = 0;
  for (std::size_t i = 0; i < order.size(); ++i)
  {
    const evolving::Box& box = boxes[order[i]];
    for (std::size_t j = i + 1; j < order.size() && boxes[order[j]].min().x() <= box.max().x(); ++j)
    {
      count += box.intersects(boxes[order[j]]) &&
          evolving::intersectBeyondShared(surface.points, triangles[order[i]], triangles[order[j]])
        ? 1
        : 0;
    }
  }
  return count;
}

double smallestOuterVolume(const Surface& surface)
{
  std::size_t count = 0;
  const std::vector<std::size_t> ofFace = componentsOf(surface, count);
  std::vector<Surface> parts(count);
  for (std::size_t f = 0; f < surface.faces.size(); ++f)
  {
    Surface& part = parts[ofFace[f]];
    part.points = part.points.empty() ? surface.points : part.points;
    part.faces.push_back(surface.faces[f]);
  }
  double smallest = std::numeric_limits<double>::infinity();
  for (std::size_t p = 0; p < count; ++p)
  {
    const Vec3 place = parts[p].corner(parts[p].faces.front(), 0);
    bool isInAnother = false;
    for (std::size_t q = 0; q < count && !isInAnother; ++q)
    {
      isInAnother =
        q != p && std::abs(windingNumber(surface.points, trianglesOf(parts[q]), place)) > 0.5;
    }
    smallest = isInAnother ? smallest : std::min(smallest, volumeOf(parts[p], middleOf(parts[p])));
  }
  return smallest;
}

} // namespace robustness
