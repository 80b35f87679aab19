// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Evolution/StateMeasures.h"

#include "Mesh/MeshQuality.h"
#include "Operators/FiniteVolumes.h"

#include <algorithm>
#include <cmath>

namespace evolving
{

void measureState(const SurfaceMesh& mesh, const Vec3& center, const StateArrays& arrays,
  FlowRecord& record, const Execution& execution)
{
  record.area = totalArea(arrays.coVolume, execution);
  record.volume = signedVolume(mesh, center);
  record.minAngle = smallestAngle(mesh, execution);
  record.meanDistance = 0.0;
  record.maxDistance = 0.0;
  for (std::size_t i = 0; i < arrays.distance.size(); ++i)
  {
    const double distance = std::abs(arrays.distance[i]);
    record.meanDistance += arrays.coVolume[i] * distance / record.area;
    record.maxDistance = std::max(record.maxDistance, distance);
  }
}

double farthestNormalMove(
  const std::vector<Vec3>& before, const std::vector<Vec3>& after, const std::vector<Vec3>& normals)
{
  double farthest = 0.0;
  for (std::size_t i = 0; i < before.size(); ++i)
  {
    farthest = std::max(farthest, std::abs((after[i] - before[i]).dot(normals[i])));
  }
  return farthest;
}

} // namespace evolving
