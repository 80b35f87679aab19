// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ShrinkWrap/FinishSteps.h"

#include "Remeshing/EdgeFlipping.h"
#include "Remeshing/ElementRepair.h"
#include "Remeshing/FaceShape.h"
#include "Remeshing/PeakFit.h"
#include "Remeshing/Relaxation.h"
#include "Remeshing/Remeshing.h"
#include "Remeshing/RidgeFairing.h"
#include "Remeshing/SizingField.h"
#include "Remeshing/StarOptimization.h"
#include "Remeshing/SurfaceFit.h"
#include "Remeshing/TargetSamples.h"
#include "Remeshing/VerticesNear.h"

#include <limits>
#include <vector>

namespace evolving
{

namespace
{

SurfaceMesh meshOf(const EditableSurface& surface, const std::vector<Index>& faces)
{
  SurfaceMesh mesh;
  for (const Index face : faces)
  {
    const Index first = mesh.addPoint(surface.corner(face, 0));
    mesh.addPoint(surface.corner(face, 1));
    mesh.addPoint(surface.corner(face, 2));
    mesh.addFace({ first, first + 1, first + 2 });
  }
  return mesh;
}

} // namespace

void FinishSteps::land(EditableSurface& surface) const
{
  evolving::land(surface, this->Reference, this->Run);
}

void FinishSteps::landOften(EditableSurface& surface) const
{
  for (int round = 0; round < this->Tuning.landingRounds; ++round)
  {
    this->land(surface);
  }
}

void FinishSteps::settle(
  EditableSurface& surface, const std::function<bool(const Vec3&)>& isAtWall) const
{
  for (int round = 0; round < this->Tuning.settleRounds; ++round)
  {
    landWhere(surface, this->Reference, isAtWall, this->Run);
    this->improve(surface);
  }
}

void FinishSteps::fairRidges(EditableSurface& surface) const
{
  if (evolving::fairRidges(surface, this->Reference, {}, this->Run) > 0)
  {
    this->improve(surface);
  }
}

void FinishSteps::remesh(EditableSurface& surface, int passes) const
{
  for (int pass = 0; pass < passes; ++pass)
  {
    if (this->Target.besideCreases) // and vertices have moved
    {
      setSizesAround(surface, this->Target);
    }
    remeshOnce(surface, this->Reference, {}, this->Run);
  }
}

void FinishSteps::remeshByCurvature(EditableSurface& surface) const
{
  setUniformSizes(surface, this->Size);
  const double vertices = expectedVertices(surface) / this->Tuning.verticesPerExpected;
  const CurvatureSizing sizing{ this->Tuning.smallestSize * this->Size,
    this->Tuning.largestSize * this->Size };
  for (int pass = 0; pass < this->Tuning.adaptivePasses; ++pass)
  {
    setSizesForVertexCount(surface, sizing, vertices);
    remeshOnce(surface, this->Reference, {}, this->Run);
  }
}

void FinishSteps::polish(EditableSurface& surface) const
{
  for (int pass = 0; pass < this->Tuning.polishPasses; ++pass)
  {
    polishOnce(surface, this->Reference, {}, this->Run);
  }
}

void FinishSteps::improve(EditableSurface& surface) const
{
  optimizeStars(
    surface, this->Reference, this->Tuning.wantedAngle, this->Tuning.starRounds, this->Run);
}

void FinishSteps::fitAlong(EditableSurface& surface, double inertia) const
{
  fitToReference(surface, this->Reference, { 3, 1.0, inertia }, this->Run);
  flipForAngles(surface);
  this->improve(surface);
  flipForAngles(surface);
  this->improve(surface);
}

void FinishSteps::fitUpright(EditableSurface& surface) const
{
  constexpr double NormalOnly = std::numeric_limits<double>::infinity();
  fitToReference(surface, this->Reference, { 2, 1.0, NormalOnly }, this->Run);
  this->improve(surface);
  fitToReference(surface, this->Reference, { 1, 0.5, NormalOnly }, this->Run);
  this->improve(surface);
}

void FinishSteps::repair(EditableSurface& surface) const
{
  repairElements(surface, this->Reference, this->Tuning.soundAngle, this->Run);
}

bool FinishSteps::hasSlivers(const EditableSurface& surface) const
{
  return !this->slivers(surface).empty();
}

std::vector<Index> FinishSteps::slivers(const EditableSurface& surface) const
{
  std::vector<Index> faces;
  for (Index f = 0; f < surface.faceSlots(); ++f)
  {
    if (surface.hasFace(f) && smallestAngle(surface, f) < this->Tuning.sliverAngle)
    {
      faces.push_back(f);
    }
  }
  return faces;
}

void FinishSteps::mend(EditableSurface& surface) const
{
  this->lockFarFrom(surface, meshOf(surface, this->slivers(surface)));
  this->remesh(surface, this->Tuning.mendingPasses);
  this->polish(surface);
}

void FinishSteps::easeCreases(
  EditableSurface& surface, const CreaseWorth& worth, int round, double inertia) const
{
  const std::vector<Index> faces = crampedFaces(surface, worth);
  const std::vector<Index> vertices = creaseVertices(surface, faces);
  if (round > this->Tuning.releaseRounds)
  {
    releaseFeatures(surface, vertices, worth);
  }
  else if (round > 0)
  {
    releaseWeakest(surface, faces, worth);
  }
  this->recover(surface, vertices, inertia);
}

void FinishSteps::recover(
  EditableSurface& surface, const std::vector<Index>& vertices, double inertia) const
{
  std::vector<Index> faces;
  for (const Index v : vertices)
  {
    surface.forEachOutgoing(v, [&](Index e) { faces.push_back(EditableSurface::faceOf(e)); });
  }
  this->lockFarFrom(surface, meshOf(surface, faces));
  this->remesh(surface, this->Tuning.recoveringPasses);
  this->polish(surface);
  this->fitAlong(surface, inertia);
}

void FinishSteps::lockFarFrom(EditableSurface& surface, const SurfaceMesh& faces) const
{
  const std::vector<char> isNear = verticesNear(surface, faces, this->Tuning.mendedSizes);
  for (Index v = 0; v < surface.vertexSlots(); ++v)
  {
    if (surface.hasVertex(v) && isNear[at(v)] == 0)
    {
      surface.setLocked(v);
    }
  }
}

void FinishSteps::reachTips(EditableSurface& surface, const std::vector<Vec3>& tips) const
{
  PeakFitOptions options;
  options.farthest = this->Tuning.farthestTip * this->Size;
  options.deepest = this->Tuning.deepestValley * this->Size;
  options.leastAngle = this->Tuning.leastAngleBeforeCapture;
  fitPeaks(surface, this->Reference, tips, options, this->Run);
}

void FinishSteps::reachPeaks(
  EditableSurface& surface, const SurfaceMesh& target, double leastAngle) const
{
  PeakFitOptions options;
  options.farthest = this->Tuning.farthestPeak * this->Size;
  options.deepest = this->Tuning.deepestValley * this->Size;
  PeakFit fit(surface, this->Reference, samplesOf(target, this->Tuning.sampleSpacing * this->Size),
    this->Tuning.nearlyPeak * options.tolerance, this->Run);
  options.leastAngle = this->Tuning.bearableAngle;
  for (int round = 0; round < this->Tuning.peakRounds; ++round)
  {
    fit.run(options);
    this->improve(surface);
  }
  options.leastAngle = leastAngle;
  fit.run(options);
}

} // namespace evolving
