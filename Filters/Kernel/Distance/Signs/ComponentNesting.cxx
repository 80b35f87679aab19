// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Distance/Signs/ComponentNesting.h"

#include "Trees/AABBTree.h"
#include "Trees/TriangleGeometry.h"

#include <algorithm>
#include <map>
#include <numeric>

namespace evolving
{

namespace
{

/// Marks the components whose directed faces do not cancel along the edge as open.
void markOpen(const SurfaceMesh& mesh, const TriangleEdges& edges, Index edge,
  const std::vector<Index>& componentOfFace, std::vector<SurfaceComponent>& components)
{
  for (const Index* first = edges.begin(edge); first != edges.end(edge); ++first)
  {
    const Index component = componentOfFace[at(*first / 3)];
    int upwards = 0;
    for (const Index* corner = edges.begin(edge); corner != edges.end(edge); ++corner)
    {
      if (componentOfFace[at(*corner / 3)] == component)
      {
        upwards += TriangleEdges::runsUpwards(mesh, *corner) ? 1 : -1;
      }
    }
    components[at(component)].isClosed = components[at(component)].isClosed && upwards == 0;
  }
}

/// Six times the volume of the tetrahedron between a face and a point.
double sixfoldVolume(const SurfaceMesh& mesh, Index face, const Vec3& apex)
{
  const Vec3 a = mesh.facePoint(face, 0) - apex;
  const Vec3 b = mesh.facePoint(face, 1) - apex;
  const Vec3 c = mesh.facePoint(face, 2) - apex;
  return a.dot(b.cross(c));
}

/// How often a ray from the middle of a component's largest face crosses each component.
std::map<Index, int> crossings(const SurfaceMesh& mesh, const AABBTree& tree,
  const std::vector<Index>& componentOfFace, Index face)
{
  const Vec3 start = triangleOf(mesh, face).centroid();
  const Vec3 direction(0.6180339, 0.2876543, 0.7318642); // along no edge anybody models
  std::map<Index, int> count;
  for (const RayHit& hit : tree.hits(Ray(start, direction)))
  {
    ++count[componentOfFace[at(hit.triangle)]];
  }
  return count;
}

} // namespace

std::vector<SurfaceComponent> surfaceComponents(const SurfaceMesh& mesh, const TriangleEdges& edges,
  const std::vector<Index>& componentOfFace, Index count)
{
  std::vector<SurfaceComponent> components(at(count));
  std::vector<double> largest(at(count), -1.0);
  for (Index face = 0; face < mesh.faceCount(); ++face)
  {
    SurfaceComponent& component = components[at(componentOfFace[at(face)])];
    for (Index k = 0; k < 3; ++k)
    {
      component.box.extend(mesh.facePoint(face, k));
    }
    const double area = faceVectorArea(mesh, face).norm();
    component.area += area;
    component.isClosed = true;
    if (area > largest[at(componentOfFace[at(face)])])
    {
      largest[at(componentOfFace[at(face)])] = area;
      component.largestFace = face;
    }
  }
  for (Index face = 0; face < mesh.faceCount(); ++face)
  {
    SurfaceComponent& component = components[at(componentOfFace[at(face)])];
    component.volume += sixfoldVolume(mesh, face, component.box.center()) / 6.0;
  }
  for (Index edge = 0; edge < edges.edgeCount(); ++edge)
  {
    markOpen(mesh, edges, edge, componentOfFace, components);
  }
  return components;
}

bool boxesIntersect(const std::vector<SurfaceComponent>& components)
{
  constexpr std::size_t TooManyToTell = 5000;
  if (components.size() > TooManyToTell)
  {
    return true;
  }
  std::vector<std::size_t> order(components.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  std::sort(order.begin(), order.end(),
    [&](std::size_t a, std::size_t b)
    { return components[a].box.min().x() < components[b].box.min().x(); });
  for (std::size_t i = 0; i < order.size(); ++i)
  {
    const Box& box = components[order[i]].box;
    for (std::size_t j = i + 1; j < order.size(); ++j)
    {
      const Box& other = components[order[j]].box;
      if (other.min().x() > box.max().x())
      {
        break;
      }
      if (box.intersects(other))
      {
        return true;
      }
    }
  }
  return false;
}

std::vector<Index> outermostEnclosing(const SurfaceMesh& mesh,
  const std::vector<SurfaceComponent>& components, const std::vector<Index>& componentOfFace)
{
  const AABBTree tree(mesh);
  std::vector<std::vector<Index>> enclosing(components.size());
  for (std::size_t c = 0; c < components.size(); ++c)
  {
    if (!components[c].isClosed)
    {
      continue;
    }
    const auto count = crossings(mesh, tree, componentOfFace, components[c].largestFace);
    for (const auto& [other, times] : count)
    {
      // One point says nothing of the rest of a component that crosses the other.
      if (at(other) != c && components[at(other)].isClosed && times % 2 == 1 &&
        components[at(other)].box.contains(components[c].box))
      {
        enclosing[c].push_back(other);
      }
    }
  }
  std::vector<Index> outermost(components.size());
  for (std::size_t c = 0; c < components.size(); ++c)
  {
    const auto root = std::find_if(enclosing[c].begin(), enclosing[c].end(),
      [&](Index other) { return enclosing[at(other)].empty(); });
    outermost[c] = root != enclosing[c].end() ? *root : static_cast<Index>(c);
  }
  return outermost;
}

} // namespace evolving
