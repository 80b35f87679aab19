// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ShrinkWrap/CoarseParts.h"

#include "Mesh/ConnectedComponents.h"

#include <cmath>
#include <vector>

namespace evolving
{

namespace
{

/// An icosahedron has as many: the fewest with which a ball is round in every direction.
constexpr Index FewestTriangles = 20;
/// A volume of less than this, in areas to the power of 3/2, is none: rounding leaves as much.
constexpr double LeastVolume = 1e-12;

struct Component
{
  Box box;
  Index triangles = 0;
  double area = 0.0;
  double volume = 0.0;

  double extent() const { return this->box.diagonal().norm(); }
  bool isFlat() const { return this->volume <= LeastVolume * this->area * std::sqrt(this->area); }
};

std::vector<Component> componentsOf(const SurfaceMesh& surface)
{
  const ConnectedComponents components = connectedComponents(surface);
  std::vector<Component> all(at(components.count));
  const auto componentOf = [&](Index face) -> Component&
  { return all[at(components.ofVertex[at(surface.faceVertex(face, 0))])]; };
  for (Index face = 0; face < surface.faceCount(); ++face)
  {
    Component& component = componentOf(face);
    ++component.triangles;
    for (Index k = 0; k < 3; ++k)
    {
      component.box.extend(surface.facePoint(face, k));
    }
  }
  for (Index face = 0; face < surface.faceCount(); ++face)
  {
    Component& component = componentOf(face);
    const Vec3 area = faceVectorArea(surface, face);
    component.area += area.norm();
    component.volume += area.dot(surface.facePoint(face, 0) - component.box.center()) / 3.0;
  }
  return all;
}

/// Keeps the smallest extent, and a place on the component that has it.
void keepSmallest(const Component& component, double& extent, Vec3& place)
{
  if (extent == 0.0 || component.extent() < extent)
  {
    extent = component.extent();
    place = component.box.center();
  }
}

} // namespace

CoarseParts findCoarseParts(const SurfaceMesh& surface)
{
  CoarseParts parts;
  double area = 0.0;
  for (const Component& component : componentsOf(surface))
  {
    area += component.area;
    if (component.triangles < FewestTriangles)
    {
      parts.areaPart += component.area;
      keepSmallest(component, parts.extent, parts.place);
    }
    if (component.isFlat())
    {
      ++parts.flat;
      keepSmallest(component, parts.flatExtent, parts.flatPlace);
    }
  }
  parts.areaPart = area > 0.0 ? parts.areaPart / area : 0.0;
  return parts;
}

} // namespace evolving
