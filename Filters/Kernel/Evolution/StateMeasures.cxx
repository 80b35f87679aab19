// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Evolution/StateMeasures.h"

#include "Evolution/FiniteVolumes.h"
#include "ParallelLoops.h"
#include "Mesh/Angles.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace evolving
{

namespace
{

constexpr double Infinity = std::numeric_limits<double>::infinity();

/// Its corners share their sine, twice the area. A triangle without area has an angle of 0.
double largestCotangent(const Vec3& a, const Vec3& b, const Vec3& c)
{
  const Vec3 ab = b - a;
  const Vec3 bc = c - b;
  const Vec3 ca = a - c;
  const double cosine = -std::min({ ca.dot(ab), ab.dot(bc), bc.dot(ca) });
  const double sine = ab.cross(bc).norm();
  return sine > 0.0 ? cosine / sine : Infinity;
}

/// Of a face; cotangents fall as angles grow, and cost no inverse function.
double largestCotangent(const SurfaceMesh& mesh, Index face)
{
  const Index size = mesh.faceSize(face);
  if (size == 3)
  {
    return largestCotangent(
      mesh.facePoint(face, 0), mesh.facePoint(face, 1), mesh.facePoint(face, 2));
  }
  double largest = -Infinity;
  for (Index k = 0; k < size; ++k)
  {
    const Vec3& corner = mesh.facePoint(face, k);
    const Vec3 a = mesh.facePoint(face, (k + 1) % size) - corner;
    const Vec3 b = mesh.facePoint(face, (k + size - 1) % size) - corner;
    const double cosine = a.dot(b);
    const double sine = a.cross(b).norm();
    const double straight = cosine < 0.0 ? -Infinity : Infinity; // 180 or 0 degrees
    largest = std::max(largest, sine > 0.0 ? cosine / sine : straight);
  }
  return largest;
}

} // namespace

double smallestCornerAngle(const SurfaceMesh& mesh, const Execution& execution)
{
  const std::int64_t faces = mesh.faceCount();
  std::vector<double> largest(static_cast<std::size_t>(faces / LoopGrain + 1), -Infinity);
  execution.forRange(faces, LoopGrain,
    [&](std::int64_t begin, std::int64_t end)
    {
      double& ofChunk = largest[static_cast<std::size_t>(begin / LoopGrain)];
      for (auto face = static_cast<Index>(begin); face < static_cast<Index>(end); ++face)
      {
        ofChunk = std::max(ofChunk, largestCotangent(mesh, face));
      }
    });
  const double cotangent = *std::max_element(largest.begin(), largest.end());
  return faces > 0 ? DegreesPerRadian * std::atan2(1.0, cotangent) : 0.0;
}

void measureState(const SurfaceMesh& mesh, const Vec3& center, const FlowArrays& arrays,
  FlowRecord& record, const Execution& execution)
{
  record.area = totalArea(arrays.coVolume, execution);
  record.volume = signedVolume(mesh, center);
  record.minAngle = smallestCornerAngle(mesh, execution);
  record.meanDistance = 0.0;
  record.maxDistance = 0.0;
  for (std::size_t i = 0; i < arrays.distance.size(); ++i)
  {
    const double distance = std::abs(arrays.distance[i]);
    record.meanDistance += arrays.coVolume[i] * distance / record.area;
    record.maxDistance = std::max(record.maxDistance, distance);
  }
}

} // namespace evolving
