// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "WrapConstantList.h"

#include <utility>

namespace benchmark
{

namespace
{

using evolving::FeaturePreservation;
using evolving::FinishTuning;
using evolving::FlowTuning;
using evolving::PointTuning;
using evolving::ShrinkWrapOptions;
using evolving::TargetTuning;
using evolving::WrapTuning;

template <typename Part, typename Value>
WrapConstant constant(
  std::string name, Part WrapTuning::*part, Value Part::*member, std::vector<double> others)
{
  const WrapTuning defaults;
  return { std::move(name), static_cast<double>((defaults.*part).*member), std::move(others),
    [part, member](WrapTuning& tuning, double value)
    { (tuning.*part).*member = static_cast<Value>(value); } };
}

WrapConstant ofTarget(const char* name, double TargetTuning::*member, std::vector<double> others)
{
  return constant(name, &WrapTuning::target, member, std::move(others));
}

template <typename Value>
WrapConstant ofFlow(const char* name, Value FlowTuning::*member, std::vector<double> others)
{
  return constant(name, &WrapTuning::flow, member, std::move(others));
}

template <typename Value>
WrapConstant ofFinish(const char* name, Value FinishTuning::*member, std::vector<double> others)
{
  return constant(name, &WrapTuning::finish, member, std::move(others));
}

template <typename Value>
WrapConstant ofPoints(const char* name, Value PointTuning::*member, std::vector<double> others)
{
  return constant(name, &WrapTuning::points, member, std::move(others));
}

WrapCase uniform()
{
  return { "--uniform", "Elements of one size", {}, 0.0, false,
    {
      ofTarget("startPerEdge", &TargetTuning::startPerEdge, { 0.3, 0.75 }),
      ofTarget("startPerCell", &TargetTuning::startPerCell, { 0.4, 1.2 }),
      ofTarget("wallPerEdge", &TargetTuning::wallPerEdge, { 0.3, 0.7 }),
      ofTarget("largestCrackEdges", &TargetTuning::largestCrackEdges, { 1.0, 4.0 }),
      ofTarget("crackStepEdges", &TargetTuning::crackStepEdges, { 0.25, 1.0 }),
      ofTarget("closedPart", &TargetTuning::closedPart, { 0.25, 0.75 }),
      ofTarget("narrowEdges", &TargetTuning::narrowEdges, { 3.0, 12.0 }),
      ofFlow("curvaturePerStep", &FlowTuning::curvaturePerStep, { 0.0, 0.05, 0.2 }),
      ofFlow("anglePerStep", &FlowTuning::anglePerStep, { 0.0, 0.4 }),
      ofFlow("longestAdvection", &FlowTuning::longestAdvection, { 0.25, 1.0 }),
      ofFinish("shortening", &FinishTuning::shortening, { 0.94, 1.0 }),
      ofFinish("uniformPasses", &FinishTuning::uniformPasses, { 5, 20 }),
      ofFinish("polishPasses", &FinishTuning::polishPasses, { 0, 1, 6 }),
      ofFinish("uniformInertia", &FinishTuning::uniformInertia, { 0.5, 3.0 }),
      ofFinish("wantedAngle", &FinishTuning::wantedAngle, { 42.0, 50.0 }),
      ofFinish("starRounds", &FinishTuning::starRounds, { 2, 10 }),
      ofFinish("soundAngle", &FinishTuning::soundAngle, { 36.0, 45.0 }),
      ofFinish("farthestPeak", &FinishTuning::farthestPeak, { 0.75, 2.5 }),
      ofFinish("deepestValley", &FinishTuning::deepestValley, { 0.2, 0.6 }),
      ofFinish("bearableAngle", &FinishTuning::bearableAngle, { 34.0, 42.0 }),
      ofFinish("leastUniformAngle", &FinishTuning::leastUniformAngle, { 42.0, 46.0 }),
      ofFinish("peakRounds", &FinishTuning::peakRounds, { 0, 1, 4 }),
      ofFinish("sampleSpacing", &FinishTuning::sampleSpacing, { 0.2, 0.8 }),
      ofFinish("nearlyPeak", &FinishTuning::nearlyPeak, { 0.25, 1.0 }),
      ofFinish("settleRounds", &FinishTuning::settleRounds, { 1, 4 }),
    } };
}

WrapCase adaptive()
{
  ShrinkWrapOptions options;
  options.adaptToCurvature = true;
  return { "--adapt", "AdaptToCurvature", options, 0.0, false,
    {
      ofFinish("adaptivePasses", &FinishTuning::adaptivePasses, { 4, 16 }),
      ofFinish("smallestSize", &FinishTuning::smallestSize, { 0.25, 0.6 }),
      ofFinish("largestSize", &FinishTuning::largestSize, { 1.25, 2.5 }),
      ofFinish("verticesPerExpected", &FinishTuning::verticesPerExpected, { 0.9, 1.0 }),
      ofFinish("adaptedInertia", &FinishTuning::adaptedInertia, { 0.25, 1.5 }),
      ofFinish("leastAdaptedAngle", &FinishTuning::leastAdaptedAngle, { 40.0, 44.5 }),
      ofFinish("leastAngleOfAdapted", &FinishTuning::leastAngleOfAdapted, { 0.0, 25.0 }),
    } };
}

WrapCase features()
{
  ShrinkWrapOptions options;
  options.preserveFeatures = FeaturePreservation::On;
  return { "--features", "PreserveFeatures", options, 0.0, false,
    {
      ofFinish("passesBeforeCapture", &FinishTuning::passesBeforeCapture, { 2, 10 }),
      ofFinish("capturePasses", &FinishTuning::capturePasses, { 8, 24 }),
      ofFinish("leastFeatureAngle", &FinishTuning::leastFeatureAngle, { 15.0, 30.0 }),
      ofFinish("releaseRounds", &FinishTuning::releaseRounds, { 1, 5 }),
      ofFinish("recoveringPasses", &FinishTuning::recoveringPasses, { 1, 4 }),
      ofFinish("reachSizes", &FinishTuning::reachSizes, { 1.0, 4.0 }),
    } };
}

WrapCase fromSphere()
{
  ShrinkWrapOptions options;
  options.start = evolving::WrapStart::Icosphere;
  return { "--sphere", "From a sphere", options, 0.0, false,
    {
      ofFlow("sphereCurvaturePerStep", &FlowTuning::sphereCurvaturePerStep, { 0.3, 1.2 }),
      ofFlow("sphereBalance", &FlowTuning::sphereBalance, { 0.1, 0.4 }),
      ofFlow("longestAdvection", &FlowTuning::longestAdvection, { 0.25, 1.0 }),
      ofFlow("arrivedEdges", &FlowTuning::arrivedEdges, { 0.1, 0.4 }),
      ofFlow("stallSteps", &FlowTuning::stallSteps, { 8, 30 }),
      ofFlow("farGrowth", &FlowTuning::farGrowth, { 0.2, 0.8 }),
      ofFlow("farLargestSize", &FlowTuning::farLargestSize, { 3.0, 12.0 }),
      ofFlow("farGradation", &FlowTuning::farGradation, { 0.15, 0.6 }),
      ofFlow("frontSizes", &FlowTuning::frontSizes, { 0.75, 3.0 }),
    } };
}

WrapCase atOffset()
{
  return { "--offset", "At an offset of an edge length", {}, 1.0, false,
    { ofFinish("landingRounds", &FinishTuning::landingRounds, { 1, 2, 8 }) } };
}

WrapCase ofNoisyPoints()
{
  return { "--points", "Noisy points", {}, 0.0, true,
    {
      ofPoints("smallestGap", &PointTuning::smallestGap, { 1.0, 3.0 }),
      ofPoints("largestGap", &PointTuning::largestGap, { 6.0, 20.0 }),
      ofPoints("gapStep", &PointTuning::gapStep, { 0.25, 1.0 }),
      ofPoints("closedPart", &PointTuning::closedPart, { 0.25, 0.75 }),
      ofPoints("leastThickness", &PointTuning::leastThickness, { 0.25, 1.0 }),
      ofPoints("touchPerCell", &PointTuning::touchPerCell, { 0.02, 0.5 }),
      ofPoints("wallPerSpacing", &PointTuning::wallPerSpacing, { 0.4, 0.9 }),
      ofPoints("elementPerSpacing", &PointTuning::elementPerSpacing, { 0.9, 1.6 }),
      ofPoints("stiffness", &PointTuning::stiffness, { 0.125, 2.0 }),
      ofPoints("fitRounds", &PointTuning::fitRounds, { 1, 2, 6 }),
      ofPoints("fitIterations", &PointTuning::fitIterations, { 1, 4 }),
    } };
}

} // namespace

std::vector<WrapCase> wrapCases()
{
  return { uniform(), adaptive(), features(), fromSphere(), atOffset(), ofNoisyPoints() };
}

} // namespace benchmark
