// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "SurfaceDeviation.h"

#include "Trees/AABBTree.h"

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

namespace benchmark
{

namespace
{

using evolving::Index;
using evolving::SurfaceMesh;
using evolving::Vec3;

constexpr int DrawnPoints = 50000;

/// Evenly over a triangle: the square root spreads the rows towards the wide end.
Vec3 pointOn(const SurfaceMesh& mesh, Index face, double r1, double r2)
{
  const double s = std::sqrt(r1);
  return (1.0 - s) * mesh.facePoint(face, 0) + s * (1.0 - r2) * mesh.facePoint(face, 1) +
    s * r2 * mesh.facePoint(face, 2);
}

std::vector<Vec3> samplesOf(const SurfaceMesh& mesh)
{
  std::vector<Vec3> samples = mesh.points;
  std::vector<double> areaUpTo;
  double area = 0.0;
  for (Index face = 0; face < mesh.faceCount(); ++face)
  {
    area += evolving::faceVectorArea(mesh, face).norm();
    areaUpTo.push_back(area);
  }
  std::mt19937 random(1);
  std::uniform_real_distribution<double> part(0.0, 1.0);
  for (int i = 0; area > 0.0 && i < DrawnPoints; ++i)
  {
    const auto drawn = std::upper_bound(areaUpTo.begin(), areaUpTo.end() - 1, part(random) * area);
    const auto face = static_cast<Index>(drawn - areaUpTo.begin());
    const double r1 = part(random);
    samples.push_back(pointOn(mesh, face, r1, part(random)));
  }
  return samples;
}

/// What the tree takes for points: triangles with three equal corners.
SurfaceMesh pointTriangles(const SurfaceMesh& points)
{
  SurfaceMesh triangles = points;
  for (Index p = 0; p < points.vertexCount(); ++p)
  {
    triangles.addFace({ p, p, p });
  }
  return triangles;
}

Distances distances(const SurfaceMesh& from, const SurfaceMesh& to, double unit)
{
  const evolving::AABBTree tree(to.faceCount() > 0 ? to : pointTriangles(to));
  const std::vector<Vec3> samples = samplesOf(from);
  double squares = 0.0;
  Distances result;
  for (const Vec3& sample : samples)
  {
    const double distance = (tree.closest(sample).at.point - sample).norm() / unit;
    squares += distance * distance;
    result.largest = std::max(result.largest, distance);
  }
  result.rms = std::sqrt(squares / static_cast<double>(samples.size()));
  return result;
}

} // namespace

double SurfaceDeviation::hausdorff() const
{
  return std::max(this->forward.largest, this->backward.largest);
}

SurfaceDeviation deviation(const SurfaceMesh& surface, const SurfaceMesh& reference)
{
  const double diagonal = evolving::boundingBox(reference).diagonal().norm();
  return { distances(surface, reference, diagonal), distances(reference, surface, diagonal) };
}

} // namespace benchmark
