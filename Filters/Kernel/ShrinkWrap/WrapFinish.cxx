// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ShrinkWrap/WrapFinish.h"

#include "FeatureCapture/FeatureCapture.h"
#include "FeatureCapture/FeatureReference.h"
#include "FeatureCapture/FeatureRelease.h"
#include "Features/TargetFeatures.h"
#include "Remeshing/EditableSurface.h"
#include "Remeshing/IntersectionFreeStages.h"
#include "Remeshing/Relaxation.h"
#include "Remeshing/SizingField.h"
#include "ShrinkWrap/FinishSteps.h"
#include "ShrinkWrap/WrapFeatures.h"

#include <functional>
#include <optional>
#include <vector>

namespace evolving
{

namespace
{

/// To see which creases the result carries: distances of points on them, four an element, and from
/// them, in sizes, as much as an element may cut off a bend.
constexpr double CoverageSpacing = 0.25;
constexpr double CoverageTolerance = 0.1;
/// What is left of the first one may be next to where it had to be undone again.
constexpr int MostMendings = 2;

class Finish
{
public:
  Finish(const SurfaceMesh& surface, const WrapTarget& target, const WrapReference& reference,
    const ShrinkWrapOptions& options, const Execution& execution)
    : Surface(surface)
    , Target(target)
    , Reference(reference)
    , Options(options)
    , Tuning(target.tuning.finish)
    , Size(target.elementSize())
    , Offset(target.offset)
    , IsOnTarget(reference.isOnTarget())
    , Run(execution)
  {
    setSizesAround(this->Surface, target);
    if (options.preserveFeatures != FeaturePreservation::Off)
    {
      this->Features.emplace(findFeatures(reference.visible(),
        wantedFeatures(options, reference, target.shortestEdge()), execution.phase(0.0, 0.0)));
      this->Worth = creaseWorth(options, *this->Features, this->Tuning);
    }
  }

  FinishedWrap run()
  {
    this->stage(0.0, 0.05, &FinishSteps::land);
    this->stage(0.05, 0.2,
      this->remeshing(
        this->canCapture() ? this->Tuning.passesBeforeCapture : this->Tuning.uniformPasses));
    if (this->canCapture())
    {
      this->captureOrLeave();
    }
    if (this->Options.adaptToCurvature)
    {
      this->stage(0.3, 0.5, &FinishSteps::remeshByCurvature,
        [this](EditableSurface& surface, const RemeshingStage& adapt, const Execution& now)
        {
          this->Adaptation =
            runWithoutIntersections(surface, adapt, now, this->Tuning.leastAngleOfAdapted);
        });
    }
    this->stage(0.5, 0.6, &FinishSteps::polish);
    this->stage(0.6, 0.75,
      [this](const FinishSteps& steps, EditableSurface& surface)
      { steps.fitAlong(surface, this->inertia()); });
    this->stage(0.75, 0.8, &FinishSteps::fitUpright, moveWithoutIntersections);
    this->stage(0.8, 0.85, &FinishSteps::repair);
    for (; this->EasingRound <= this->Tuning.releaseRounds + 1 && this->isCramped();
         ++this->EasingRound)
    {
      this->stage(0.85, 0.85,
        [this](const FinishSteps& steps, EditableSurface& surface)
        { steps.easeCreases(surface, this->Worth, this->EasingRound, this->inertia()); });
      this->stage(0.85, 0.9, &FinishSteps::repair);
    }
    for (int round = 0; round < MostMendings && this->hasSlivers(); ++round)
    {
      this->stage(0.9, 0.9, &FinishSteps::mend);
      this->stage(0.9, 0.9, &FinishSteps::repair);
    }
    if (this->IsOnTarget)
    {
      this->reachPeaks();
    }
    else
    {
      this->settle();
    }
    this->repairOrLeave();
    if (this->hasWallsWithRidges())
    {
      this->fairOrLeave();
    }
    if (this->Offset > 0.0)
    {
      // The offset is a promise for vertices.
      this->stage(1.0, 1.0, &FinishSteps::landOften, moveWithoutIntersections);
    }
    return { this->Surface.mesh(), this->coverage(), this->Adaptation };
  }

private:
  /// Where a blade is thinner than its elements new ones run through its other side, and what is
  /// smoothed for that may be slivers, with no stage left to mend them.
  void repairOrLeave()
  {
    const EditableSurface before = this->Surface;
    const bool hadSlivers = this->hasSlivers();
    this->stage(0.95, 1.0, &FinishSteps::repair);
    if (!hadSlivers && this->hasSlivers())
    {
      this->Surface = before;
    }
  }

  /// Of elements nearly as large as the model all edges are ridges, and it would shrink.
  void fairOrLeave()
  {
    const EditableSurface before = this->Surface;
    this->stage(1.0, 1.0, &FinishSteps::fairRidges, moveWithoutIntersections);
    if (this->hasShrunk(before, this->Tuning.leastVolumeAfterFairing))
    {
      this->Surface = before;
    }
  }

  /// Is less than a part of a surface's volume left?
  bool hasShrunk(const EditableSurface& before, double leastPart) const
  {
    return signedVolume(this->Surface.mesh()) < leastPart * signedVolume(before.mesh());
  }

  /// Elements as large as the model itself can collapse onto its corners.
  void captureOrLeave()
  {
    if (this->IsOnTarget && !this->Features->tips().empty())
    {
      this->reachTips();
    }
    const EditableSurface before = this->Surface;
    this->OnFeatures.emplace(this->Reference, *this->Features,
      this->Tuning.reachSizes * this->Target.shortestElement(), this->Run.phase(0.2, 0.2));
    this->stage(0.2, 0.3,
      [this](const FinishSteps& steps, EditableSurface& surface)
      {
        captureFeatures(surface, *this->Features, steps.execution());
        steps.remesh(surface, this->Tuning.capturePasses);
      });
    if (this->hasShrunk(before, this->Tuning.leastVolumeAfterCapture))
    {
      this->Surface = before;
      this->OnFeatures.reset();
    }
  }

  using Work = std::function<void(const FinishSteps&, EditableSurface&)>;

  /// What undoes a stage where it makes intersections.
  using Guard = std::function<void(EditableSurface&, const RemeshingStage&, const Execution&)>;

  static void runGuarded(
    EditableSurface& surface, const RemeshingStage& stage, const Execution& now)
  {
    runWithoutIntersections(surface, stage, now);
  }

  void stage(double from, double to, const Work& work, const Guard& guard = runGuarded)
  {
    this->Run.phase(from, to).report(0.0);
    const Execution now = this->Run.phase(from, from); // parts run again and again
    guard(
      this->Surface, [&](EditableSurface& surface) { work(this->steps(now), surface); }, now);
  }

  /// A wall stands off its sheet, and off the creases of that, which cannot be captured.
  bool hasWallsWithRidges() const
  {
    return this->Features && this->Reference.hasSheets() && !this->Reference.hasOffset();
  }

  /// Without creases nothing may change.
  bool canCapture() const
  {
    return this->Features && !this->Reference.hasOffset() &&
      !this->Features->curves().curves().empty();
  }

  /// What the result lies on.
  const ReferenceSurface& reference() const
  {
    return this->OnFeatures ? static_cast<const ReferenceSurface&>(*this->OnFeatures)
                            : this->Reference;
  }

  FinishSteps steps(const Execution& now) const { return { this->reference(), this->Target, now }; }

  FeatureCoverage coverage() const
  {
    return this->Features ? featureCoverage(this->Surface, *this->Features,
                              CoverageSpacing * this->Size, CoverageTolerance * this->Size)
                          : FeatureCoverage{};
  }

  static Work remeshing(int passes)
  {
    return [passes](const FinishSteps& steps, EditableSurface& surface)
    { steps.remesh(surface, passes); };
  }

  bool isCramped() const
  {
    return this->OnFeatures && !crampedFaces(this->Surface, this->Worth).empty();
  }

  double inertia() const
  {
    return this->Options.adaptToCurvature ? this->Tuning.adaptedInertia
                                          : this->Tuning.uniformInertia;
  }

  bool hasSlivers() const { return this->steps(this->Run).hasSlivers(this->Surface); }

  void reachPeaks()
  {
    const double leastAngle = this->Options.adaptToCurvature ? this->Tuning.leastAdaptedAngle
                                                             : this->Tuning.leastUniformAngle;
    this->stage(
      0.9, 0.95,
      [&](const FinishSteps& steps, EditableSurface& surface)
      { steps.reachPeaks(surface, this->Reference.visible(), leastAngle); },
      moveWithoutIntersections);
  }

  void reachTips()
  {
    std::vector<Vec3> tips;
    for (const Index tip : this->Features->tips())
    {
      tips.push_back(this->Features->target().point(tip));
    }
    this->stage(
      0.2, 0.2,
      [&](const FinishSteps& steps, EditableSurface& surface) { steps.reachTips(surface, tips); },
      moveWithoutIntersections);
  }

  void settle()
  {
    const auto isAtSheet = [this](const Vec3& p) { return this->Reference.isAtSheet(p); };
    this->stage(
      0.9, 0.95,
      [&](const FinishSteps& steps, EditableSurface& surface) { steps.settle(surface, isAtSheet); },
      moveWithoutIntersections);
  }

  EditableSurface Surface;
  const WrapTarget& Target;
  const WrapReference& Reference;
  std::optional<TargetFeatures> Features; ///< where creases are to be preserved
  CreaseWorth Worth;                      ///< what they may cost
  int EasingRound = 0;
  StageRuns Adaptation;
  std::optional<FeatureReference> OnFeatures;
  const ShrinkWrapOptions& Options;
  const FinishTuning& Tuning;
  double Size;
  double Offset;
  bool IsOnTarget;
  const Execution& Run;
};

} // namespace

FinishedWrap finishWrap(const SurfaceMesh& surface, const WrapTarget& target,
  const WrapReference& reference, const ShrinkWrapOptions& options, const Execution& execution)
{
  return Finish(surface, target, reference, options, execution).run();
}

} // namespace evolving
