// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Mesh/FloatPoints.h"

#include "Mesh/Angles.h"

#include <algorithm>

namespace evolving
{

std::vector<Vec3> roundedToFloats(std::vector<Vec3> points)
{
  // By way of an array of floats: in one loop, GCC 12 leaves some numbers as they are from -O2 on.
  std::vector<Eigen::Vector3f> floats(points.size());
  std::transform(points.begin(), points.end(), floats.begin(),
    [](const Vec3& point) { return Eigen::Vector3f(point.cast<float>()); });
  std::transform(floats.begin(), floats.end(), points.begin(),
    [](const Eigen::Vector3f& point) { return Vec3(point.cast<double>()); });
  return points;
}

bool floatsHold(const SurfaceMesh& mesh)
{
  constexpr double Degree = Pi / 180.0;
  const std::vector<Vec3> rounded = roundedToFloats(mesh.points);
  double lengths = 0.0;
  double changes = 0.0;
  for (Index face = 0; face < mesh.faceCount(); ++face)
  {
    Index from = mesh.faceVertex(face, mesh.faceSize(face) - 1);
    for (Index k = 0; k < mesh.faceSize(face); ++k)
    {
      const Index to = mesh.faceVertex(face, k);
      const Vec3 edge = mesh.points[at(to)] - mesh.points[at(from)];
      lengths += edge.norm();
      changes += (rounded[at(to)] - rounded[at(from)] - edge).norm();
      from = to;
    }
  }
  // Two edges meet in an angle.
  return 2.0 * changes <= Degree * lengths;
}

} // namespace evolving
