// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * Start surfaces whose faces have next to no area.
 */

#ifndef EVOLVING_DEGENERATE_STARTS_H
#define EVOLVING_DEGENERATE_STARTS_H

#include "Shapes/MeshVariants.h"
#include "StartSurface/PrimitiveSurfaces.h"

#include <string>
#include <utility>
#include <vector>

namespace evolving::degenerate
{

struct Start
{
  std::string name;
  SurfaceMesh mesh;
};

inline SurfaceMesh needle(double width, const Vec3& at = Vec3::Zero())
{
  SurfaceMesh mesh;
  mesh.points = { at, at + Vec3(width, 0, 0), at + Vec3(0, 0.1, 0) };
  mesh.addFace({ 0, 1, 2 });
  return mesh;
}

inline SurfaceMesh cap(double height)
{
  SurfaceMesh mesh;
  mesh.points = { Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0.5, height, 0) };
  mesh.addFace({ 0, 1, 2 });
  return mesh;
}

/// Needles that have their tip in common.
inline SurfaceMesh fan(double width)
{
  SurfaceMesh mesh;
  mesh.addPoint(Vec3::Zero());
  for (Index i = 0; i < 8; ++i)
  {
    mesh.addPoint(Vec3(1, i * width, 0));
  }
  for (Index i = 1; i < 8; ++i)
  {
    mesh.addFace({ 0, i, i + 1 });
  }
  return mesh;
}

/// A closed surface whose faces all lie on each other, nearly.
inline SurfaceMesh flatTetrahedron(double height)
{
  SurfaceMesh mesh;
  mesh.points = { Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0.3, 0.3, height) };
  mesh.addFace({ 0, 2, 1 });
  mesh.addFace({ 0, 1, 3 });
  mesh.addFace({ 1, 2, 3 });
  mesh.addFace({ 2, 0, 3 });
  return mesh;
}

/// A sphere drawn out along or squeezed across an axis.
inline SurfaceMesh stretchedSphere(const Vec3& factors)
{
  SurfaceMesh mesh = icosphere(2);
  for (Vec3& p : mesh.points)
  {
    p = p.cwiseProduct(factors);
  }
  return mesh;
}

/// With all that is thin as thin as that.
inline std::vector<Start> starts(double width)
{
  const SurfaceMesh apart = needle(width, Vec3(3, 0, 0));
  return { { "needle", needle(width) }, { "cap", cap(width) }, { "fan", fan(width) },
    { "tetrahedron", flatTetrahedron(width) }, { "line", stretchedSphere(Vec3(width, width, 1.0)) },
    { "disk", stretchedSphere(Vec3(width, 1.0, 1.0)) },
    { "needle beside a sphere", shapes::merged(icosphere(2), apart) },
    { "small sphere beside a sphere",
      shapes::merged(icosphere(2), shapes::transformed(icosphere(1), width, Vec3(3, 0, 0))) } };
}

} // namespace evolving::degenerate

#endif
