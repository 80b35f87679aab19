// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Checks/SurfaceMeasures.h"

#include "Remeshing/TargetSamples.h"
#include "Trees/AABBTree.h"

#include <algorithm>
#include <cmath>

namespace evolving::checks
{

bool areFinite(const std::vector<double>& values)
{
  return std::all_of(values.begin(), values.end(), [](double v) { return std::isfinite(v); });
}

bool areFinite(const std::vector<Vec3>& values)
{
  return std::all_of(values.begin(), values.end(), [](const Vec3& v) { return v.allFinite(); });
}

double relativeSpread(const std::vector<double>& values)
{
  double sum = 0.0;
  for (const double value : values)
  {
    sum += value;
  }
  const double mean = sum / static_cast<double>(values.size());
  double squares = 0.0;
  for (const double value : values)
  {
    squares += (value - mean) * (value - mean);
  }
  return std::sqrt(squares / static_cast<double>(values.size())) / mean;
}

double meanRadius(const SurfaceMesh& mesh)
{
  double sum = 0.0;
  for (const Vec3& p : mesh.points)
  {
    sum += p.norm();
  }
  return sum / mesh.vertexCount();
}

double largestRadialError(const SurfaceMesh& mesh, double radius)
{
  double worst = 0.0;
  for (const Vec3& p : mesh.points)
  {
    worst = std::max(worst, std::abs(p.norm() - radius));
  }
  return worst;
}

double rmsDistance(const std::vector<Vec3>& points, const SurfaceMesh& surface)
{
  const AABBTree tree(surface);
  double squares = 0.0;
  for (const Vec3& p : points)
  {
    squares += tree.closest(p).at.squaredDistance;
  }
  return std::sqrt(squares / static_cast<double>(points.size()));
}

double farthest(const SurfaceMesh& from, const SurfaceMesh& to, double spacing)
{
  const AABBTree tree(to);
  double squared = 0.0;
  for (const Vec3& sample : samplesOf(from, spacing))
  {
    squared = std::max(squared, tree.closest(sample).at.squaredDistance);
  }
  return std::sqrt(squared);
}

double hausdorff(const SurfaceMesh& a, const SurfaceMesh& b, double spacing)
{
  return std::max(farthest(a, b, spacing), farthest(b, a, spacing));
}

} // namespace evolving::checks
