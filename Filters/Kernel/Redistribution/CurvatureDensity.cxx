// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Redistribution/CurvatureDensity.h"

#include "ParallelLoops.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace evolving
{

namespace
{

/// |H| averaged over each vertex and its neighbours.
std::vector<double> averagedCurvature(const SurfaceGeometry& geometry, const Execution& execution)
{
  const MeshTopology& topology = geometry.topology();
  std::vector<double> average(at(topology.vertexCount()));
  forEachIndex(execution, topology.vertexCount(),
    [&](Index i)
    {
      const MeshTopology::Run ring = topology.ringVertices(i);
      double sum = std::abs(geometry.meanCurvature(i));
      for (const Index j : ring)
      {
        sum += std::abs(geometry.meanCurvature(j));
      }
      average[at(i)] = sum / (1.0 + ring.size());
    });
  return average;
}

/// log f(H) (3.21): exponentials would overflow, and ratios of f are all that counts.
double logarithmOfControl(double curvature, CurvatureControl control, double alpha)
{
  switch (control)
  {
    case CurvatureControl::CubeRoot:
      return std::log(curvature) / 3.0;
    case CurvatureControl::TwoThirds:
      return std::log(curvature) * 2.0 / 3.0;
    case CurvatureControl::Exponential:
      return alpha * curvature;
    default:
      return 0.0;
  }
}

/// Moves log f, one value per vertex of a component, into a window of width log 10.
void limitSpread(std::vector<double>& logarithms)
{
  const double half = 0.5 * std::log(LargestAreaRatio);
  std::vector<double> sorted = logarithms;
  const auto middle = sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 2);
  std::nth_element(sorted.begin(), middle, sorted.end());
  double centre = *middle;
  if (!std::isfinite(centre)) // more than half is flat: log 0
  {
    centre = *std::max_element(middle, sorted.end()) - half;
  }
  for (double& value : logarithms)
  {
    value = std::isfinite(centre) ? std::clamp(value - centre, -half, half) : 0.0;
  }
}

std::vector<std::vector<Index>> verticesOfComponents(const MeshTopology& topology)
{
  std::vector<std::vector<Index>> vertices(at(topology.componentCount()));
  for (Index i = 0; i < topology.vertexCount(); ++i)
  {
    const Index component = topology.componentOfVertex()[at(i)];
    if (component != NoIndex)
    {
      vertices[at(component)].push_back(i);
    }
  }
  return vertices;
}

/// Distributes the area of one component.
void distributeArea(const std::vector<Index>& vertices, const std::vector<double>& coVolumes,
  std::vector<double> logarithms, std::vector<double>& wanted)
{
  limitSpread(logarithms);
  double area = 0.0;
  double sum = 0.0;
  for (std::size_t k = 0; k < vertices.size(); ++k)
  {
    area += coVolumes[at(vertices[k])];
    sum += std::exp(-logarithms[k]);
  }
  for (std::size_t k = 0; k < vertices.size(); ++k)
  {
    wanted[at(vertices[k])] = area * std::exp(-logarithms[k]) / sum;
  }
}

/// A / n of every component.
std::vector<double> equalCoVolumes(const SurfaceGeometry& geometry)
{
  const std::vector<Index>& component = geometry.topology().componentOfVertex();
  std::vector<double> area(at(geometry.topology().componentCount()), 0.0);
  std::vector<Index> vertices(area.size(), 0);
  for (std::size_t i = 0; i < component.size(); ++i)
  {
    if (component[i] != NoIndex)
    {
      area[at(component[i])] += geometry.coVolumes()[i];
      ++vertices[at(component[i])];
    }
  }
  std::vector<double> wanted(component.size(), 0.0);
  for (std::size_t i = 0; i < component.size(); ++i)
  {
    const Index c = component[i];
    wanted[i] = c == NoIndex ? 0.0 : area[at(c)] / vertices[at(c)];
  }
  return wanted;
}

} // namespace

std::vector<double> wantedCoVolumes(const SurfaceGeometry& geometry, CurvatureControl control,
  double alpha, const Execution& execution)
{
  if (control == CurvatureControl::None)
  {
    return equalCoVolumes(geometry);
  }
  const std::vector<double> curvature = averagedCurvature(geometry, execution);
  std::vector<double> wanted(curvature.size(), 0.0);
  for (const std::vector<Index>& vertices : verticesOfComponents(geometry.topology()))
  {
    std::vector<double> logarithms;
    for (const Index i : vertices)
    {
      logarithms.push_back(logarithmOfControl(curvature[at(i)], control, alpha));
    }
    distributeArea(vertices, geometry.coVolumes(), std::move(logarithms), wanted);
  }
  return wanted;
}

} // namespace evolving
