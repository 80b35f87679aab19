// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ShrinkWrap/WrapFinish.h"

#include "FeatureCapture/FeatureCapture.h"
#include "FeatureCapture/FeatureReference.h"
#include "Features/TargetFeatures.h"
#include "Remeshing/EditableSurface.h"
#include "Remeshing/IntersectionFreeStages.h"
#include "Remeshing/Relaxation.h"
#include "Remeshing/SizingField.h"
#include "ShrinkWrap/FinishSteps.h"

#include <optional>

namespace evolving
{

namespace
{

constexpr int UniformPasses = 10;
/// More wear off the acute creases that are to be captured.
constexpr int PassesBeforeCapture = 4;
constexpr int CapturePasses = 16;
constexpr int SettleRounds = 2;
constexpr int LandingRounds = 4;
/// Peaks may cost elements their angles down to this, in degrees.
constexpr double LeastUniformAngle = 44.5;
constexpr double LeastAdaptedAngle = 42.5;
/// Small elements must not slip into grooves that are narrower than large ones.
constexpr double LeastAngleOfAdapted = 15.0;
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
/// Farther from their patch, in sizes, faces have no place there.
constexpr double ReachSizes = 2.0;

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
      this->stage(0.3, 0.5, &Finish::adapt, runForAngles);
    }
    this->stage(0.5, 0.6, &Finish::polish);
    this->stage(0.6, 0.75, &Finish::fitAlong);
    if (this->OnFeatures)
    {
      this->stage(0.75, 0.75, &Finish::release);
    }
    this->stage(0.75, 0.85, &Finish::fitUpright, moveWithoutIntersections);
    this->stage(0.85, 0.9, &Finish::repair);
    if (this->IsOnTarget)
    {
      this->stage(0.9, 0.95, &Finish::reachPeaks, moveWithoutIntersections);
    }
    else
    {
      this->stage(0.9, 0.95, &Finish::settle, moveWithoutIntersections);
    }
    this->stage(0.95, 1.0, &Finish::repair);
    if (this->Offset > 0.0)
    {
      this->stage(1.0, 1.0, &Finish::landOften,
        moveWithoutIntersections); // the offset is a promise for vertices
    }
    return { this->Surface.mesh(), this->coverage() };
  }

private:
  using Work = void (Finish::*)(EditableSurface&, const Execution&) const;

  using Guard = Index (*)(EditableSurface&, const RemeshingStage&, const Execution&);

  static Index runForAngles(
    EditableSurface& surface, const RemeshingStage& stage, const Execution& now)
  {
    return runWithoutIntersections(surface, stage, now, LeastAngleOfAdapted);
  }

  static Index runAnyAngles(
    EditableSurface& surface, const RemeshingStage& stage, const Execution& now)
  {
    return runWithoutIntersections(surface, stage, now);
  }

  void stage(double from, double to, Work work, Guard guard = runAnyAngles)
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

  /// In valleys another place of the target is nearer than the one that a vertex has left.
  void landOften(EditableSurface& surface, const Execution& now) const
  {
    for (int round = 0; round < LandingRounds; ++round)
    {
      this->land(surface, now);
    }
  }

  void remesh(EditableSurface& surface, const Execution& now) const
  {
    remeshOften(
      surface, this->reference(), this->canCapture() ? PassesBeforeCapture : UniformPasses, now);
  }

  void capture(EditableSurface& surface, const Execution& now) const
  {
    captureFeatures(surface, *this->Features, now);
    remeshOften(surface, this->reference(), CapturePasses, now);
  }

  void release(EditableSurface& surface, const Execution& now) const
  {
    for (int round = 0; round < ReleaseRounds; ++round)
    {
      if (releaseFeatures(surface, LeastFeatureAngle) == 0)
      {
        return;
      }
      remeshOften(surface, this->reference(), ReleasePasses, now);
      this->polish(surface, now);
      this->fitAlong(surface, now);
    }
  }

  void adapt(EditableSurface& surface, const Execution& now) const
  {
    remeshByCurvature(surface, this->reference(), this->Size, now);
  }

  void polish(EditableSurface& surface, const Execution& now) const
  {
    evolving::polish(surface, this->reference(), now);
  }

  void fitAlong(EditableSurface& surface, const Execution& now) const
  {
    const double inertia = this->Options.adaptToCurvature ? AdaptedInertia : UniformInertia;
    evolving::fitAlong(surface, this->reference(), inertia, now);
  }

  void fitUpright(EditableSurface& surface, const Execution& now) const
  {
    evolving::fitUpright(surface, this->reference(), now);
  }

  void repair(EditableSurface& surface, const Execution& now) const
  {
    evolving::repair(surface, this->reference(), now);
  }

  void reachPeaks(EditableSurface& surface, const Execution& now) const
  {
    evolving::reachPeaks(surface, this->reference(), this->Reference.visible(), this->Size,
      this->Options.adaptToCurvature ? LeastAdaptedAngle : LeastUniformAngle, now);
  }

  /// At rims of walls, rounder than elements can be, the fit lifts vertices off: back they go.
  void settle(EditableSurface& surface, const Execution& now) const
  {
    for (int round = 0; round < SettleRounds; ++round)
    {
      landWhere(
        surface, this->reference(), [this](const Vec3& p) { return this->Reference.isAtSheet(p); },
        now);
      improve(surface, this->reference(), now);
    }
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
