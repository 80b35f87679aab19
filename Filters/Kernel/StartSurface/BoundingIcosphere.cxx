// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "StartSurface/BoundingIcosphere.h"

#include "Errors.h"
#include "StartSurface/PrimitiveSurfaces.h"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace evolving
{

namespace
{

void requireExtended(const Box& box)
{
  if (box.isEmpty() || !box.min().allFinite() || !box.max().allFinite() ||
    !(box.diagonal().norm() > 0.0))
  {
    throw InputError("The target's bounding box has no extent, expected points that differ and are "
                     "finite; check the input.");
  }
}

void requireMargin(double margin)
{
  if (!(margin >= 0.0) || !std::isfinite(margin))
  {
    std::ostringstream message;
    message << "The margin of the start sphere is " << margin
            << ", expected a number not below 0; choose for example 0.1.";
    throw InputError(message.str());
  }
}

} // namespace

double icosphereInradius(int level)
{
  // The faces at the corners of the icosahedron's faces differ in size: look at all of them.
  const SurfaceMesh sphere = icosphere(level);
  double inradius = 1.0;
  for (Index face = 0; face < sphere.faceCount(); ++face)
  {
    const Vec3 normal = faceVectorArea(sphere, face).normalized();
    inradius = std::min(inradius, normal.dot(sphere.facePoint(face, 0)));
  }
  return inradius;
}

SurfaceMesh boundingIcosphere(const Box& box, int level, double margin)
{
  requireExtended(box);
  requireMargin(margin);
  const double enclosed = (1.0 + margin) * 0.5 * box.diagonal().norm();
  return icosphere(level, enclosed / icosphereInradius(level), box.center());
}

} // namespace evolving
