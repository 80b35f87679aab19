// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Redistribution/SurfaceRedistribution.h"

#include "Errors.h"
#include "Mesh/MeshQuality.h"
#include "Operators/SpoiledElements.h"
#include "ParallelLoops.h"
#include "ParameterRange.h"
#include "Redistribution/SubSteps.h"
#include "Redistribution/SurfaceCurves.h"
#include "Redistribution/SurfaceProjector.h"
#include "Redistribution/TangentialVelocity.h"

#include <algorithm>
#include <memory>

namespace evolving
{

namespace
{

/// Where areas count, elements may lose angle as long as their smallest one stays above this, in
/// degrees.
constexpr double GoodAngle = 10.0;
/// Where angles count, meshes better than this may lose some: a quad mesh of rectangles could not
/// move else.
constexpr double ExcellentAngle = 40.0;
/// Moves are halved this often before they are given up.
constexpr int MostHalvings = 5;
/// psi moves points that are projected afterwards: a rough solution does.
constexpr double PotentialTolerance = 1e-8;

void checkInput(const SurfaceMesh& surface, const SurfaceRedistributionOptions& options)
{
  validate(surface);
  if (surface.faceCount() == 0)
  {
    throw InputError("The surface has no faces, expected at least one.");
  }
  checkOptions(options.redistribution);
  checkRange("TimeStep", options.timeStep, AboveZero, 1e300, "set 0.1 when in doubt");
  checkRange("NumberOfSteps", options.numberOfSteps, 0.0, AnyNumber, "0 leaves all as it is");
  checkRange("FeatureAngle", options.featureAngle, 0.0, 180.0, "set 45 degrees when in doubt");
}

RedistributionOptions ratesOf(
  const SurfaceMesh& surface, const SurfaceRedistributionOptions& options, double subStep)
{
  RedistributionOptions rates = limitRates(options.redistribution, subStep);
  rates.curvatureControlAlpha *= 0.5 * boundingBox(surface).diagonal().norm();
  return rates;
}

/// The angle below which no element may lose any, in degrees.
double guardedAngle(
  const SurfaceMesh& surface, const RedistributionOptions& rates, const Execution& execution)
{
  const double floor = rates.angle > 0.0 && rates.volume == 0.0 ? 0.0 : GoodAngle;
  const double smallest = rates.angle > 0.0 ? smallestAngle(surface, execution) : 0.0;
  return std::max(floor, std::min(ExcellentAngle, smallest) * (1.0 - 1e-12)); // not by rounding
}

/// A surface whose points move along it.
class MovingSurface
{
public:
  MovingSurface(const SurfaceMesh& surface, const SurfaceRedistributionOptions& options,
    double timeStep, const Execution& execution)
    : Options(options)
    , TimeStep(timeStep)
    , Mesh(surface)
    , Topology(surface)
    , Curves(surface, this->Topology, options.featureAngle, options.featureAngle)
    , OnCurves(this->Curves.startPositions())
    , Geometry(this->Topology)
    , Tangential(this->Topology, this->Curves, ratesOf(surface, options, timeStep),
        options.boundaryMode, PotentialTolerance)
    , NoVelocity(surface.points.size(), Vec3::Zero())
    , SmallestAngle(guardedAngle(surface, options.redistribution, execution))
  {
    if (options.preserveShape)
    {
      this->Projector = std::make_unique<SurfaceProjector>(surface, execution);
    }
  }

  /// Geometry and velocity of the current points.
  void evaluate(const Execution& execution)
  {
    this->Geometry.update(this->Mesh, execution);
    this->Velocity = this->Tangential.velocity(
      { this->Mesh, this->Geometry, this->NoVelocity, this->NoDistance, 1.0, this->TimeStep },
      execution);
  }

  void move(const Execution& execution);
  SurfaceRedistributionResult result() const;

private:
  void place(const std::vector<char>& changed, const Execution& execution);
  bool shortenSpoilingMoves(int attempt, std::vector<char>& changed, const Execution& execution);
  bool slides(Index vertex) const
  {
    const bool isFree = this->Options.boundaryMode == BoundaryMode::Free;
    return this->Curves.isOnCurve(vertex) && !(isFree && this->Topology.isBoundary(vertex));
  }

  SurfaceRedistributionOptions Options;
  double TimeStep;
  SurfaceMesh Mesh;
  MeshTopology Topology;
  SurfaceCurves Curves;
  SurfaceCurves::Positions OnCurves;
  SurfaceGeometry Geometry;
  TangentialVelocity Tangential;
  std::unique_ptr<SurfaceProjector> Projector; ///< null when the shape may change
  std::vector<Vec3> NoVelocity;                ///< v_N = 0
  std::vector<double> NoDistance;
  double SmallestAngle; ///< below it no element may lose angle
  std::vector<Vec3> Velocity;
  std::vector<Vec3> Before; ///< points at the start of the move
  SurfaceCurves::Positions OnCurvesBefore;
  std::vector<double> Fraction; ///< of the move, per vertex
};

/// Puts the vertices with a flag to their fraction of the move.
void MovingSurface::place(const std::vector<char>& changed, const Execution& execution)
{
  std::vector<Vec3> shortened(this->Before.size());
  std::vector<Vec3> slid = this->Before;
  forEachIndex(execution, this->Mesh.vertexCount(),
    [&](Index i) { shortened[at(i)] = this->Fraction[at(i)] * this->Velocity[at(i)]; });
  this->OnCurves = this->OnCurvesBefore;
  this->Curves.slide(shortened, this->TimeStep, this->OnCurves, slid);
  forEachIndex(execution, this->Mesh.vertexCount(),
    [&](Index i)
    {
      const Vec3& before = this->Before[at(i)];
      if (!changed[at(i)])
      {
        return;
      }
      const bool stays = shortened[at(i)].isZero(0.0);
      const Vec3 moved = before + this->TimeStep * shortened[at(i)];
      this->Mesh.points[at(i)] = this->slides(i) ? slid[at(i)]
        : stays                                  ? before
        : this->Projector ? this->Projector->project(moved, this->Geometry.normals()[at(i)], before)
                          : moved;
    });
}

/**
 * Flags who has to yield where moves spoil a face: the vertices that do so alone, so that one that
 * repairs a sliver goes on; all of them where only together they do.
 */
void flagSpoilers(
  const SpoiledElements& elements, const SurfaceMesh& mesh, Index face, std::vector<char>& flags)
{
  bool isAny = false;
  for (Index k = 0; k < mesh.faceSize(face); ++k)
  {
    const bool spoils = elements.isSpoiledBy(face, k);
    flags[at(mesh.faceVertex(face, k))] |= spoils ? 1 : 0;
    isAny = isAny || spoils;
  }
  for (Index k = 0; !isAny && k < mesh.faceSize(face); ++k)
  {
    flags[at(mesh.faceVertex(face, k))] = 1;
  }
}

/// True when moves had to be shortened; flags their vertices.
bool MovingSurface::shortenSpoilingMoves(
  int attempt, std::vector<char>& changed, const Execution& execution)
{
  const SpoiledElements elements(
    this->Mesh, this->Before, this->Geometry.normals(), this->SmallestAngle);
  const std::vector<char> spoiled = spoiledElements(
    this->Mesh, this->Before, this->Geometry.normals(), this->SmallestAngle, execution);
  std::fill(changed.begin(), changed.end(), 0);
  bool any = false;
  for (Index face = 0; face < this->Mesh.faceCount(); ++face)
  {
    if (spoiled[at(face)])
    {
      flagSpoilers(elements, this->Mesh, face, changed);
      any = true;
    }
  }
  for (std::size_t i = 0; i < changed.size(); ++i)
  {
    this->Fraction[i] *= !changed[i] ? 1.0 : attempt < MostHalvings ? 0.5 : 0.0;
  }
  return any;
}

void MovingSurface::move(const Execution& execution)
{
  this->Before = this->Mesh.points;
  this->OnCurvesBefore = this->OnCurves;
  this->Fraction.assign(this->Before.size(), 1.0);
  std::vector<char> changed(this->Before.size(), 1);
  this->place(changed, execution);
  // Ends: after MostHalvings every round gives up moves, and an element at rest is not spoiled.
  for (int attempt = 0; this->shortenSpoilingMoves(attempt, changed, execution); ++attempt)
  {
    execution.report(1.0);
    this->place(changed, execution);
  }
  // What has been gained is kept.
  this->SmallestAngle = std::max(
    this->SmallestAngle, guardedAngle(this->Mesh, this->Options.redistribution, execution));
}

SurfaceRedistributionResult MovingSurface::result() const
{
  SurfaceRedistributionResult result;
  result.mesh = this->Mesh;
  result.arrays.normal = this->Geometry.normals();
  result.arrays.coVolume = this->Geometry.coVolumes();
  result.arrays.tangentialVelocity = this->Velocity;
  result.arrays.redistributionPotential = this->Tangential.potential();
  result.arrays.normalVelocity.assign(this->Before.size(), 0.0);
  for (Index i = 0; i < this->Mesh.vertexCount(); ++i)
  {
    result.arrays.meanCurvature.push_back(this->Geometry.meanCurvature(i));
  }
  return result;
}

} // namespace

SurfaceRedistributionResult redistributeSurface(const SurfaceMesh& surface,
  const SurfaceRedistributionOptions& options, const Execution& execution)
{
  checkInput(surface, options);
  const SubSteps parts = divideStep(options.timeStep, options.redistribution, 0.0);
  const double total = static_cast<double>(options.numberOfSteps) * parts.count;
  MovingSurface moving(surface, options, parts.timeStep, execution.phase(0.0, 0.05));
  const Execution steps = execution.phase(0.05, 1.0);
  for (double step = 0.0; step < total; ++step)
  {
    const Execution now = steps.phase(step / total, (step + 1.0) / total);
    moving.evaluate(now.phase(0.0, 0.5));
    moving.move(now.phase(0.5, 1.0));
  }
  moving.evaluate(execution.phase(1.0, 1.0));
  return moving.result();
}

} // namespace evolving
