// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Shapes/HoleyShapes.h"

#include "Shapes/MeshVariants.h"
#include "Shapes/Sheets.h"
#include "Shapes/Spheres.h"

#include <cmath>

namespace evolving::shapes
{

SurfaceMesh drilledSphere(const std::vector<Vec3>& directions, double angle, int level)
{
  return facesWhere(unitIcosphere(level),
    [&](const Vec3& p)
    {
      for (const Vec3& direction : directions)
      {
        if (p.normalized().dot(direction.normalized()) > std::cos(angle))
        {
          return false;
        }
      }
      return true;
    });
}

SurfaceMesh sheetWithHole(Index n, double holeSide)
{
  SurfaceMesh mesh = triangleSheet(n + 1, n + 1);
  for (Vec3& point : mesh.points)
  {
    point = point / n - Vec3(0.5, 0.5, 0.0);
  }
  return facesWhere(mesh, [&](const Vec3& p) { return p.cwiseAbs().maxCoeff() > 0.5 * holeSide; });
}

} // namespace evolving::shapes
