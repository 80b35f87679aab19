// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * Simple ways of giving a flow's surface new elements, with known results.
 */

#ifndef EVOLVING_REMESHERS_H
#define EVOLVING_REMESHERS_H

#include "Checks/SurfaceMeasures.h"
#include "Evolution/Remesher.h"
#include "Evolution/SurfaceFlow.h"
#include "Shapes/MeshVariants.h"
#include "StartSurface/PrimitiveSurfaces.h"

#include <algorithm>
#include <functional>
#include <memory>
#include <optional>
#include <set>
#include <utility>

namespace evolving::remeshers
{

using Rule =
  std::function<std::optional<SurfaceMesh>(const SurfaceMesh&, const std::vector<double>&)>;

class ByRule : public Remesher
{
public:
  explicit ByRule(Rule rule)
    : Remesh(std::move(rule))
  {
  }

  std::optional<SurfaceMesh> remesh(
    const RemeshingInput& input, const Execution& /*execution*/) override
  {
    return this->Remesh(input.surface, input.distance);
  }

private:
  Rule Remesh;
};

inline std::shared_ptr<Remesher> byRule(Rule rule)
{
  return std::make_shared<ByRule>(std::move(rule));
}

/// Every triangle in four; new points at the middles of edges, as far from the origin as the ends.
inline SurfaceMesh inFour(const SurfaceMesh& triangles)
{
  return shapes::quartered(triangles,
    [](const Vec3& p, const Vec3& q)
    { return Vec3(0.5 * (p.norm() + q.norm()) * (p + q).normalized()); });
}

/// Refines a surface of fewer than so many vertices, once.
inline std::shared_ptr<Remesher> refiner(Index vertices)
{
  return byRule([vertices](const SurfaceMesh& mesh, const std::vector<double>& /*distance*/)
    { return mesh.vertexCount() < vertices ? std::make_optional(inFour(mesh)) : std::nullopt; });
}

/// Puts an icosphere of the mean radius in the place of a surface of other than its vertices.
inline std::shared_ptr<Remesher> sphereMaker(int level)
{
  return byRule(
    [level](const SurfaceMesh& mesh, const std::vector<double>& /*distance*/)
    {
      SurfaceMesh sphere = icosphere(level, checks::meanRadius(mesh));
      return sphere.vertexCount() == mesh.vertexCount() ? std::nullopt
                                                        : std::make_optional(std::move(sphere));
    });
}

/// Numbers the vertices backwards, every time.
inline std::shared_ptr<Remesher> renumberer()
{
  return byRule(
    [](SurfaceMesh mesh, const std::vector<double>& /*distance*/)
    {
      std::reverse(mesh.points.begin(), mesh.points.end());
      for (Index& vertex : mesh.cornerVertices)
      {
        vertex = mesh.vertexCount() - 1 - vertex;
      }
      return std::make_optional(std::move(mesh));
    });
}

inline SurfaceFlow flowOf(const SurfaceMesh& start, const std::shared_ptr<const ScalarImage>& field,
  const std::shared_ptr<Remesher>& remesher, const FlowOptions& options,
  const Execution& execution = Execution())
{
  return SurfaceFlow(
    std::make_shared<const SurfaceMesh>(start), field, remesher, options, execution);
}

/// Have all arrays a value for each of so many vertices?
inline bool fit(const StateArrays& a, std::size_t count)
{
  const std::set<std::size_t> sizes = { a.distance.size(), a.distanceGradient.size(),
    a.normal.size(), a.meanCurvature.size(), a.coVolume.size(), a.normalVelocity.size(),
    a.tangentialVelocity.size(), a.redistributionPotential.size() };
  return sizes == std::set<std::size_t>{ count };
}

} // namespace evolving::remeshers

#endif
