// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "VolumeFlows/HeldVolumes.h"

#include "Errors.h"
#include "Mesh/VertexNormals.h"
#include "Operators/EnclosedVolume.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <sstream>

namespace evolving
{

namespace
{

/// Newton's method doubles the digits: from a step's change of a hundredth it takes four rounds.
constexpr int MostRounds = 30;
/// What must be reached at least: a tenth of what is promised, in parts of the volume, ...
constexpr double LargestError = 1e-9;
/// ... and of the cube of the size, for sheets that enclose next to nothing.
constexpr double LargestErrorOfSize = 1e-13;

/// The components' numbers by increasing volume.
std::vector<std::size_t> byVolume(const std::vector<double>& volumes)
{
  std::vector<std::size_t> order(volumes.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(),
    [&](std::size_t a, std::size_t b) { return volumes[a] < volumes[b]; });
  return order;
}

void shareOut(double lost, std::vector<double>& volumes)
{
  double whole = 0.0;
  for (const double volume : volumes)
  {
    whole += std::abs(volume);
  }
  for (double& volume : volumes)
  {
    volume += whole > 0.0 ? lost * std::abs(volume) / whole : 0.0;
  }
}

double sum(const std::vector<double>& values)
{
  return std::accumulate(values.begin(), values.end(), 0.0);
}

/// d/d lambda of every component's volume.
std::vector<double> ratesOf(
  const SurfaceMesh& mesh, const MeshTopology& topology, const std::vector<Vec3>& directions)
{
  const std::vector<Vec3> gradient = volumeGradient(mesh);
  std::vector<double> rates(at(topology.componentCount()), 0.0);
  for (Index i = 0; i < mesh.vertexCount(); ++i)
  {
    const Index component = topology.componentOfVertex()[at(i)];
    if (component != NoIndex)
    {
      rates[at(component)] += gradient[at(i)].dot(directions[at(i)]);
    }
  }
  return rates;
}

[[noreturn]] void throwNotHeld(double error)
{
  std::ostringstream message;
  message << "no multiplier keeps the volume of a component, which is off by " << error
          << ", expected none; a smaller time step helps.";
  throw SolverError(message.str());
}

} // namespace

HeldVolumes::HeldVolumes(const SurfaceMesh& start, const MeshTopology& topology)
  : Topology(topology)
  , Volumes(componentVolumes(start, topology))
{
}

HeldVolumes::HeldVolumes(
  const SurfaceMesh& surface, const MeshTopology& topology, const std::vector<double>& before)
  : HeldVolumes(surface, topology)
{
  if (before.size() != this->Volumes.size())
  {
    shareOut(sum(before) - sum(this->Volumes), this->Volumes);
    return;
  }
  const std::vector<std::size_t> from = byVolume(before);
  const std::vector<std::size_t> to = byVolume(this->Volumes);
  for (std::size_t i = 0; i < from.size(); ++i)
  {
    this->Volumes[to[i]] = before[from[i]];
  }
}

/// The next round's multipliers; all zero at the end.
std::vector<double> HeldVolumes::multipliers(const SurfaceMesh& mesh,
  const std::vector<Vec3>& directions, double negligible, std::vector<double>& errors) const
{
  const std::vector<double> now = componentVolumes(mesh, this->Topology);
  const std::vector<double> rates = ratesOf(mesh, this->Topology, directions);
  std::vector<double> multipliers(now.size(), 0.0);
  for (std::size_t c = 0; c < now.size(); ++c)
  {
    const double missing = this->Volumes[c] - now[c];
    const bool isExact =
      std::abs(missing) <= LargestError * std::abs(this->Volumes[c]) + negligible;
    // What is exact enough becomes more so, as long as rounding lets it.
    const bool becomesBetter = rates[c] != 0.0 && std::abs(missing) < 0.5 * errors[c];
    if (!isExact && !(std::abs(rates[c]) > 0.0))
    {
      throwNotHeld(std::abs(missing));
    }
    multipliers[c] = isExact && !becomesBetter ? 0.0 : missing / rates[c];
    errors[c] = std::abs(missing);
  }
  return multipliers;
}

void HeldVolumes::restore(SurfaceMesh& mesh, const std::vector<Vec3>& directions) const
{
  const double size = boundingBox(mesh).diagonal().norm();
  const double negligible = LargestErrorOfSize * size * size * size;
  std::vector<double> errors(this->Volumes.size(), std::numeric_limits<double>::infinity());
  for (int round = 0; round < MostRounds; ++round)
  {
    const std::vector<double> lambda = this->multipliers(mesh, directions, negligible, errors);
    if (std::all_of(lambda.begin(), lambda.end(), [](double value) { return value == 0.0; }))
    {
      return;
    }
    for (Index i = 0; i < mesh.vertexCount(); ++i)
    {
      const Index component = this->Topology.componentOfVertex()[at(i)];
      if (component != NoIndex)
      {
        mesh.points[at(i)] += lambda[at(component)] * directions[at(i)];
      }
    }
  }
  throwNotHeld(*std::max_element(errors.begin(), errors.end()));
}

void giveBackVolumes(
  const std::vector<double>& before, SurfaceMesh& renewed, const Execution& execution)
{
  if (before.empty())
  {
    return;
  }
  const MeshTopology topology(renewed);
  std::vector<Vec3> directions = angleWeightedNormals(renewed, topology, execution);
  for (Index i = 0; i < renewed.vertexCount(); ++i)
  {
    if (topology.isBoundary(i))
    {
      directions[at(i)].setZero();
    }
  }
  HeldVolumes(renewed, topology, before).restore(renewed, directions);
}

} // namespace evolving
