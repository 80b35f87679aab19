// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ShrinkWrap/WrapFinish.h"

#include "FeatureCapture/FeatureCapture.h"
#include "FeatureCapture/FeatureReference.h"
#include "Features/TargetFeatures.h"
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
#include <optional>

namespace evolving
{

namespace
{

constexpr int UniformPasses = 10;
/// More wear off the acute creases that are to be captured.
constexpr int PassesBeforeCapture = 4;
constexpr int CapturePasses = 10;
constexpr int AdaptivePasses = 8;
constexpr int PolishPasses = 3;
/// Smallest angles up to this are worth a search, in degrees; and how many rounds of it.
constexpr double WantedAngle = 46.0;
constexpr int StarRounds = 5;
constexpr int PeakRounds = 2;
constexpr int SettleRounds = 2;
/// Triangles with smaller angles may be replaced by others.
constexpr double SoundAngle = 42.0;
/// For a peak's sake angles may fall to this, to recover afterwards.
constexpr double BearableAngle = 38.0;
constexpr double LeastUniformAngle = 44.5;
constexpr double LeastAdaptedAngle = 42.5;
/// Creases that leave elements smaller angles than this are let go; remeshing may need some rounds.
constexpr double LeastFeatureAngle = 30.0;
constexpr int ReleaseRounds = 3;
constexpr int ReleasePasses = 2;
/// To see which creases the result carries: distances on them, and from them, in sizes.
constexpr double CoverageSpacing = 0.25;
constexpr double CoverageTolerance = 0.1;
/// What moving along the surface costs in the first fit: less finds ridges better and leaves worse
/// elements.
constexpr double UniformInertia = 1.5;
constexpr double AdaptedInertia = 0.5;
/// Farther from their patch faces have no place there.
constexpr double ReachSizes = 2.0;
/// Adaptive sizes, in those of uniform ones.
constexpr double SmallestSize = 0.4;
constexpr double LargestSize = 1.5;
/// Remeshing ends with this fraction of the vertices that the sizes ask for.
constexpr double VerticesPerExpected = 0.95;
/// In sizes.
constexpr double FarthestPeak = 1.5;
constexpr double DeepestValley = 0.35;
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
    if (options.preserveFeatures)
    {
      const FeatureOptions features{ options.featureAngle, target.edgeLength };
      this->Features.emplace(
        findFeatures(reference.visible(), features, execution.phase(0.0, 0.0)));
    }
  }

  FinishedWrap run()
  {
    this->stage(0.0, 0.05, &Finish::land);
    this->stage(0.05, 0.2, &Finish::remesh);
    if (this->canCapture())
    {
      this->OnFeatures.emplace(
        this->Reference, *this->Features, ReachSizes * this->Size, this->Run.phase(0.2, 0.2));
      this->stage(0.2, 0.3, &Finish::capture);
    }
    if (this->Options.adaptToCurvature)
    {
      this->stage(0.3, 0.5, &Finish::adapt);
    }
    this->stage(0.5, 0.6, &Finish::polish);
    this->stage(0.6, 0.75, &Finish::fitAlong);
    if (this->OnFeatures)
    {
      this->stage(0.75, 0.75, &Finish::release);
    }
    this->stage(0.75, 0.85, &Finish::fit, runMoves);
    this->stage(0.85, 0.9, &Finish::repair);
    if (this->IsOnTarget)
    {
      this->stage(0.9, 0.95, &Finish::reachPeaks, runMoves);
    }
    else
    {
      this->stage(0.9, 0.95, &Finish::settle, runMoves);
    }
    this->stage(0.95, 1.0, &Finish::repair);
    if (this->Offset > 0.0)
    {
      this->stage(1.0, 1.0, &Finish::land, runMoves); // the offset is a promise for vertices
    }
    return { this->Surface.mesh(), this->coverage() };
  }

private:
  using Work = void (Finish::*)(EditableSurface&, const Execution&) const;

  using Guard = Index (*)(EditableSurface&, const RemeshingStage&, const Execution&);

  void stage(double from, double to, Work work, Guard guard = runGuarded)
  {
    this->Run.phase(from, to).report(0.0);
    const Execution now = this->Run.phase(from, from); // parts run again and again
    guard(
      this->Surface, [&](EditableSurface& surface) { (this->*work)(surface, now); }, now);
  }

  /// Without creases nothing may change.
  bool canCapture() const
  {
    return this->Features && this->IsOnTarget && !this->Features->curves().curves().empty();
  }

  /// What the result lies on.
  const ReferenceSurface& reference() const
  {
    return this->OnFeatures ? static_cast<const ReferenceSurface&>(*this->OnFeatures)
                            : this->Reference;
  }

  FeatureCoverage coverage() const
  {
    return this->Features ? featureCoverage(this->Surface, *this->Features,
                              CoverageSpacing * this->Size, CoverageTolerance * this->Size)
                          : FeatureCoverage{};
  }

  void land(EditableSurface& surface, const Execution& now) const
  {
    evolving::land(surface, this->reference(), now);
  }

  void remesh(EditableSurface& surface, const Execution& now) const
  {
    const int passes = this->canCapture() ? PassesBeforeCapture : UniformPasses;
    for (int pass = 0; pass < passes; ++pass)
    {
      remeshOnce(surface, this->reference(), {}, now);
    }
  }

  void capture(EditableSurface& surface, const Execution& now) const
  {
    captureFeatures(surface, *this->Features, now);
    for (int pass = 0; pass < CapturePasses; ++pass)
    {
      remeshOnce(surface, this->reference(), {}, now);
    }
  }

  void release(EditableSurface& surface, const Execution& now) const
  {
    for (int round = 0; round < ReleaseRounds; ++round)
    {
      if (releaseFeatures(surface, LeastFeatureAngle) == 0)
      {
        return;
      }
      for (int pass = 0; pass < ReleasePasses; ++pass)
      {
        remeshOnce(surface, this->reference(), {}, now);
      }
      this->polish(surface, now);
      this->fitAlong(surface, now);
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
      remeshOnce(surface, this->reference(), {}, now);
    }
  }

  void polish(EditableSurface& surface, const Execution& now) const
  {
    for (int pass = 0; pass < PolishPasses; ++pass)
    {
      polishOnce(surface, this->reference(), {}, now);
    }
  }

  /// Vertices find the ridges, and elements recover.
  void fitAlong(EditableSurface& surface, const Execution& now) const
  {
    const double inertia = this->Options.adaptToCurvature ? AdaptedInertia : UniformInertia;
    fitToReference(surface, this->reference(), { 3, 1.0, inertia }, now);
    flipForAngles(surface);
    this->improve(surface, now);
    flipForAngles(surface);
    this->improve(surface, now);
  }

  void fit(EditableSurface& surface, const Execution& now) const
  {
    constexpr double NormalOnly = std::numeric_limits<double>::infinity();
    fitToReference(surface, this->reference(), { 2, 1.0, NormalOnly }, now);
    this->improve(surface, now);
    fitToReference(surface, this->reference(), { 1, 0.5, NormalOnly }, now);
    this->improve(surface, now);
  }

  void improve(EditableSurface& surface, const Execution& now) const
  {
    optimizeStars(surface, this->reference(), WantedAngle, StarRounds, now);
  }

  /// At rims of walls, rounder than elements can be, the fit lifts vertices off: back they go.
  void settle(EditableSurface& surface, const Execution& now) const
  {
    for (int round = 0; round < SettleRounds; ++round)
    {
      landWhere(
        surface, this->reference(), [this](const Vec3& p) { return this->Reference.isAtSheet(p); },
        now);
      this->improve(surface, now);
    }
  }

  void repair(EditableSurface& surface, const Execution& now) const
  {
    repairElements(surface, this->reference(), SoundAngle, now);
  }

  void reachPeaks(EditableSurface& surface, const Execution& now) const
  {
    PeakFitOptions options;
    options.farthest = FarthestPeak * this->Size;
    options.deepest = DeepestValley * this->Size;
    PeakFit fit(surface, this->reference(),
      samplesOf(this->Reference.visible(), SampleSpacing * this->Size),
      NearlyPeak * options.tolerance, now);
    options.leastAngle = BearableAngle;
    for (int round = 0; round < PeakRounds; ++round)
    {
      fit.run(options);
      this->improve(surface, now);
    }
    options.leastAngle = this->Options.adaptToCurvature ? LeastAdaptedAngle : LeastUniformAngle;
    fit.run(options);
  }

  EditableSurface Surface;
  const WrapReference& Reference;
  std::optional<TargetFeatures> Features; ///< where creases are to be preserved
  std::optional<FeatureReference> OnFeatures;
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

FinishedWrap finishWrap(const SurfaceMesh& surface, const WrapTarget& target,
  const WrapReference& reference, const ShrinkWrapOptions& options, const Execution& execution)
{
  return Finish(surface, target, reference, options, execution).run();
}

} // namespace evolving
