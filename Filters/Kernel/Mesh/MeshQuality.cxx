// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Mesh/MeshQuality.h"

#include "Mesh/Angles.h"
#include "ParallelLoops.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

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

/// Of a face.
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
    largest = std::max(largest, cotangentBetween(a, b));
  }
  return largest;
}

double cornerAngle(const SurfaceMesh& mesh, Index face, Index k)
{
  const Index size = mesh.faceSize(face);
  const Vec3& corner = mesh.facePoint(face, k);
  const Vec3 a = mesh.facePoint(face, (k + 1) % size) - corner;
  const Vec3 b = mesh.facePoint(face, (k + size - 1) % size) - corner;
  return DegreesPerRadian * angleBetween(a, b);
}

std::vector<double> smallestAngles(const SurfaceMesh& mesh)
{
  std::vector<double> angles(static_cast<std::size_t>(mesh.faceCount()));
  for (Index face = 0; face < mesh.faceCount(); ++face)
  {
    angles[static_cast<std::size_t>(face)] = smallestAngle(mesh, face);
  }
  return angles;
}

} // namespace

double smallestAngle(const SurfaceMesh& mesh, Index face)
{
  double smallest = std::numeric_limits<double>::max();
  for (Index k = 0; k < mesh.faceSize(face); ++k)
  {
    smallest = std::min(smallest, cornerAngle(mesh, face, k));
  }
  return smallest;
}

AngleSummary summarizeAngles(const SurfaceMesh& mesh)
{
  std::vector<double> angles = smallestAngles(mesh);
  if (angles.empty())
  {
    return {};
  }
  AngleSummary summary;
  summary.mean =
    std::accumulate(angles.begin(), angles.end(), 0.0) / static_cast<double>(angles.size());
  const auto percentile = angles.begin() + static_cast<std::ptrdiff_t>(angles.size() / 100);
  std::nth_element(angles.begin(), percentile, angles.end());
  summary.firstPercentile = *percentile;
  summary.smallest = *std::min_element(angles.begin(), percentile + 1);
  return summary;
}

double smallestAngle(const SurfaceMesh& mesh, const Execution& execution)
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

double meanEdgeLength(const SurfaceMesh& mesh)
{
  double sum = 0.0;
  for (Index face = 0; face < mesh.faceCount(); ++face)
  {
    const Index size = mesh.faceSize(face);
    for (Index k = 0; k < size; ++k)
    {
      sum += (mesh.facePoint(face, (k + 1) % size) - mesh.facePoint(face, k)).norm();
    }
  }
  return mesh.cornerCount() > 0 ? sum / static_cast<double>(mesh.cornerCount()) : 0.0;
}

} // namespace evolving
