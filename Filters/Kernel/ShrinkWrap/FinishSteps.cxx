// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ShrinkWrap/FinishSteps.h"

#include "Remeshing/EdgeFlipping.h"
#include "Remeshing/ElementRepair.h"
#include "Remeshing/PeakFit.h"
#include "Remeshing/Remeshing.h"
#include "Remeshing/SizingField.h"
#include "Remeshing/StarOptimization.h"
#include "Remeshing/SurfaceFit.h"
#include "Remeshing/TargetSamples.h"

#include <limits>

namespace evolving
{

namespace
{

constexpr int AdaptivePasses = 8;
constexpr int PolishPasses = 3;
/// Smallest angles up to this are worth a search, in degrees; and how many rounds of it.
constexpr double WantedAngle = 46.0;
constexpr int StarRounds = 5;
/// Triangles with smaller angles may be replaced by others.
constexpr double SoundAngle = 42.0;
/// For a peak's sake angles may fall to this, to recover afterwards.
constexpr double BearableAngle = 38.0;
constexpr int PeakRounds = 2;
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

} // namespace

void remeshOften(EditableSurface& surface, const ReferenceSurface& reference, int passes,
  const Execution& execution)
{
  for (int pass = 0; pass < passes; ++pass)
  {
    remeshOnce(surface, reference, {}, execution);
  }
}

void remeshByCurvature(EditableSurface& surface, const ReferenceSurface& reference, double size,
  const Execution& execution)
{
  setUniformSizes(surface, size);
  const double vertices = expectedVertices(surface) / VerticesPerExpected;
  const CurvatureSizing sizing{ SmallestSize * size, LargestSize * size };
  for (int pass = 0; pass < AdaptivePasses; ++pass)
  {
    setSizesForVertexCount(surface, sizing, vertices);
    remeshOnce(surface, reference, {}, execution);
  }
}

void polish(EditableSurface& surface, const ReferenceSurface& reference, const Execution& execution)
{
  for (int pass = 0; pass < PolishPasses; ++pass)
  {
    polishOnce(surface, reference, {}, execution);
  }
}

void improve(
  EditableSurface& surface, const ReferenceSurface& reference, const Execution& execution)
{
  optimizeStars(surface, reference, WantedAngle, StarRounds, execution);
}

void fitAlong(EditableSurface& surface, const ReferenceSurface& reference, double inertia,
  const Execution& execution)
{
  fitToReference(surface, reference, { 3, 1.0, inertia }, execution);
  flipForAngles(surface);
  improve(surface, reference, execution);
  flipForAngles(surface);
  improve(surface, reference, execution);
}

void fitUpright(
  EditableSurface& surface, const ReferenceSurface& reference, const Execution& execution)
{
  constexpr double NormalOnly = std::numeric_limits<double>::infinity();
  fitToReference(surface, reference, { 2, 1.0, NormalOnly }, execution);
  improve(surface, reference, execution);
  fitToReference(surface, reference, { 1, 0.5, NormalOnly }, execution);
  improve(surface, reference, execution);
}

void repair(EditableSurface& surface, const ReferenceSurface& reference, const Execution& execution)
{
  repairElements(surface, reference, SoundAngle, execution);
}

void reachPeaks(EditableSurface& surface, const ReferenceSurface& reference,
  const SurfaceMesh& target, double size, double leastAngle, const Execution& execution)
{
  PeakFitOptions options;
  options.farthest = FarthestPeak * size;
  options.deepest = DeepestValley * size;
  PeakFit fit(surface, reference, samplesOf(target, SampleSpacing * size),
    NearlyPeak * options.tolerance, execution);
  options.leastAngle = BearableAngle;
  for (int round = 0; round < PeakRounds; ++round)
  {
    fit.run(options);
    improve(surface, reference, execution);
  }
  options.leastAngle = leastAngle;
  fit.run(options);
}

} // namespace evolving
