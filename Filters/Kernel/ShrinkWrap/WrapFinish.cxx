// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ShrinkWrap/WrapFinish.h"

#include "Remeshing/EdgeFlipping.h"
#include "Remeshing/EditableSurface.h"
#include "Remeshing/ElementRepair.h"
#include "Remeshing/PeakFit.h"
#include "Remeshing/Relaxation.h"
#include "Remeshing/Remeshing.h"
#include "Remeshing/SizingField.h"
#include "Remeshing/StageGuard.h"
#include "Remeshing/StarOptimization.h"
#include "Remeshing/SurfaceFit.h"
#include "Remeshing/TargetSamples.h"

#include <cmath>
#include <limits>

namespace evolving
{

namespace
{

constexpr int UniformPasses = 10;
constexpr int AdaptivePasses = 8;
constexpr int PolishPasses = 3;
/// Smallest angles up to this are worth a search, in degrees; and how many rounds of it.
constexpr double WantedAngle = 46.0;
constexpr int StarRounds = 5;
/// Triangles with smaller angles may be replaced by others.
constexpr double SoundAngle = 42.0;
/// For a peak's sake angles may fall to this, to recover afterwards.
constexpr double BearableAngle = 38.0;
constexpr double LeastUniformAngle = 44.5;
constexpr double LeastAdaptedAngle = 42.5;
/// What moving along the surface costs in the first fit: less finds ridges better and leaves worse
/// elements.
constexpr double TangentialInertia = 1.5;
/// Adaptive sizes, in those of uniform ones.
constexpr double SmallestSize = 0.4;
constexpr double LargestSize = 1.5;
/// Remeshing ends with this fraction of the vertices that the sizes ask for.
constexpr double VerticesPerExpected = 0.95;
/// Samples nearer than this part of the tolerance will be no peaks either.
constexpr double NearlyPeak = 0.5;
/// Of the target, to find what the triangles cut off; in sizes.
constexpr double SampleSpacing = 0.4;

class Finish
{
public:
  Finish(const SurfaceMesh& surface, const WrapTarget& target, const WrapReference& reference,
    const ShrinkWrapOptions& options, const Execution& execution)
    : Surface(surface)
    , Reference(reference)
    , Options(options)
    , Size(sizeForEdges(target.edgeLength))
    , Offset(target.offset)
    , IsOnTarget(reference.isOnTarget())
    , Run(execution)
  {
    setUniformSizes(this->Surface, this->Size);
  }

  SurfaceMesh run()
  {
    this->stage(0.0, 0.05, &Finish::land);
    this->stage(0.05, 0.3, &Finish::remesh);
    if (this->Options.adaptToCurvature)
    {
      this->stage(0.3, 0.5, &Finish::adapt);
    }
    this->stage(0.5, 0.6, &Finish::polish);
    this->stage(0.6, 0.75, &Finish::fitAlong);
    this->stage(0.75, 0.85, &Finish::fit);
    this->stage(0.85, 0.9, &Finish::repair);
    if (this->IsOnTarget)
    {
      this->stage(0.9, 0.95, &Finish::reachPeaks);
    }
    this->stage(0.95, 1.0, &Finish::repair);
    if (this->Offset > 0.0)
    {
      this->stage(1.0, 1.0, &Finish::land); // the offset is a promise for vertices
    }
    return this->Surface.mesh();
  }

private:
  using Work = void (Finish::*)(EditableSurface&, const Execution&) const;

  void stage(double from, double to, Work work)
  {
    this->Run.phase(from, to).report(0.0);
    const Execution now = this->Run.phase(from, from); // parts run again and again
    runGuarded(
      this->Surface, [&](EditableSurface& surface) { (this->*work)(surface, now); }, now);
  }

  void land(EditableSurface& surface, const Execution& now) const
  {
    evolving::land(surface, this->Reference, now);
  }

  void remesh(EditableSurface& surface, const Execution& now) const
  {
    for (int pass = 0; pass < UniformPasses; ++pass)
    {
      remeshOnce(surface, this->Reference, {}, now);
    }
  }

  /// As many vertices as of one size.
  void adapt(EditableSurface& surface, const Execution& now) const
  {
    setUniformSizes(surface, this->Size);
    const double vertices = expectedVertices(surface) / VerticesPerExpected;
    const CurvatureSizing sizing{ SmallestSize * this->Size, LargestSize * this->Size };
    for (int pass = 0; pass < AdaptivePasses; ++pass)
    {
      setSizesForVertexCount(surface, sizing, vertices);
      remeshOnce(surface, this->Reference, {}, now);
    }
  }

  void polish(EditableSurface& surface, const Execution& now) const
  {
    for (int pass = 0; pass < PolishPasses; ++pass)
    {
      polishOnce(surface, this->Reference, {}, now);
    }
  }

  /// Vertices find the ridges, and elements recover.
  void fitAlong(EditableSurface& surface, const Execution& now) const
  {
    fitToReference(surface, this->Reference, { 3, 1.0, TangentialInertia }, now);
    flipForAngles(surface);
    this->improve(surface, now);
    flipForAngles(surface);
    this->improve(surface, now);
  }

  void fit(EditableSurface& surface, const Execution& now) const
  {
    constexpr double NormalOnly = std::numeric_limits<double>::infinity();
    fitToReference(surface, this->Reference, { 3, 1.0, NormalOnly }, now);
    this->improve(surface, now);
    fitToReference(surface, this->Reference, { 1, 0.5, NormalOnly }, now);
    this->improve(surface, now);
  }

  void improve(EditableSurface& surface, const Execution& now) const
  {
    optimizeStars(surface, this->Reference, WantedAngle, StarRounds, now);
  }

  void repair(EditableSurface& surface, const Execution& now) const
  {
    repairElements(surface, this->Reference, SoundAngle, now);
  }

  void reachPeaks(EditableSurface& surface, const Execution& now) const
  {
    PeakFitOptions options;
    const std::vector<Vec3> samples =
      samplesBeyond(surface, samplesOf(this->Reference.visible(), SampleSpacing * this->Size),
        NearlyPeak * options.tolerance, now);
    options.leastAngle = BearableAngle;
    for (int round = 0; round < 2; ++round)
    {
      fitPeaks(surface, this->Reference, samples, options, now);
      this->improve(surface, now);
    }
    options.leastAngle = this->Options.adaptToCurvature ? LeastAdaptedAngle : LeastUniformAngle;
    fitPeaks(surface, this->Reference, samples, options, now);
  }

  EditableSurface Surface;
  const WrapReference& Reference;
  const ShrinkWrapOptions& Options;
  double Size;
  double Offset;
  bool IsOnTarget;
  const Execution& Run;
};

} // namespace

double sizeForEdges(double edgeLength)
{
  constexpr double Shortening = 0.97;
  return Shortening * edgeLength;
}

SurfaceMesh finishWrap(const SurfaceMesh& surface, const WrapTarget& target,
  const WrapReference& reference, const ShrinkWrapOptions& options, const Execution& execution)
{
  return Finish(surface, target, reference, options, execution).run();
}

} // namespace evolving
