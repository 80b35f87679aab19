// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ElementQuality.h"

#include "Mesh/MeshQuality.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

namespace benchmark
{

namespace
{

using evolving::Index;

double meanOf(const std::vector<double>& values)
{
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

/// Population's standard deviation by the mean; 0 when all vanishes.
double spreadOf(const std::vector<double>& values)
{
  const double mean = meanOf(values);
  double squares = 0.0;
  for (const double value : values)
  {
    squares += (value - mean) * (value - mean);
  }
  return mean > 0.0 ? std::sqrt(squares / static_cast<double>(values.size())) / mean : 0.0;
}

double percentile(const std::vector<double>& ascending, double part)
{
  const double place = part * static_cast<double>(ascending.size() - 1);
  const auto below = static_cast<std::size_t>(place);
  const std::size_t above = std::min(below + 1, ascending.size() - 1);
  return ascending[below] +
    (place - static_cast<double>(below)) * (ascending[above] - ascending[below]);
}

/// 2 r / R = 16 A^2 / (perimeter a b c); 0 where an edge vanishes.
double radiusRatio(const evolving::SurfaceMesh& mesh, Index face, double area)
{
  const double a = (mesh.facePoint(face, 1) - mesh.facePoint(face, 2)).norm();
  const double b = (mesh.facePoint(face, 2) - mesh.facePoint(face, 0)).norm();
  const double c = (mesh.facePoint(face, 0) - mesh.facePoint(face, 1)).norm();
  const double edges = (a + b + c) * a * b * c;
  return edges > 0.0 ? 16.0 * area * area / edges : 0.0;
}

/// A third of the area of every face around a point.
std::vector<double> coVolumes(const evolving::SurfaceMesh& mesh, const std::vector<double>& areas)
{
  std::vector<double> mu(mesh.points.size(), 0.0);
  for (std::size_t corner = 0; corner < mesh.cornerVertices.size(); ++corner)
  {
    mu[static_cast<std::size_t>(mesh.cornerVertices[corner])] += areas[corner / 3] / 3.0;
  }
  return mu;
}

} // namespace

ElementQuality elementQuality(const evolving::SurfaceMesh& mesh)
{
  std::vector<double> angles;
  std::vector<double> areas;
  std::vector<double> ratios;
  for (Index face = 0; face < mesh.faceCount(); ++face)
  {
    angles.push_back(evolving::smallestAngle(mesh, face));
    areas.push_back(evolving::faceVectorArea(mesh, face).norm());
    ratios.push_back(radiusRatio(mesh, face, areas.back()));
  }
  std::sort(angles.begin(), angles.end());
  const auto below30 = std::lower_bound(angles.begin(), angles.end(), 30.0) - angles.begin();
  ElementQuality quality;
  quality.smallestAngle = angles.front();
  quality.firstPercentile = percentile(angles, 0.01);
  quality.meanAngle = meanOf(angles);
  quality.partBelow30 = static_cast<double>(below30) / static_cast<double>(angles.size());
  quality.radiusRatio = meanOf(ratios);
  quality.areaSpread = spreadOf(areas);
  quality.coVolumeSpread = spreadOf(coVolumes(mesh, areas));
  return quality;
}

} // namespace benchmark
