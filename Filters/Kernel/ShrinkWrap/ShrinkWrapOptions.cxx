// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ShrinkWrap/ShrinkWrapOptions.h"

#include "ParameterRange.h"
#include "Remeshing/CoveringTriangles.h"

#include <algorithm>
#include <cmath>

namespace evolving
{

namespace
{

/// Of a cube an edge is then three cells of the default grid long: the grid shows what elements of
/// that size can carry.
constexpr double DefaultVertexCount = 9000.0;
/// Vertices of the wall around the thinnest wire, for each edge length along it: so the wall has
/// not many more in all than the wire is to have.
constexpr double VerticesAroundWire = 22.5;
/// As of an input (FloatRange.cxx): distances of this size, and their squares, are floats.
constexpr double SmallestLength = 1e-31;
constexpr double LargestLength = 1e31;

/// The flow leaves exp(-time) of a distance. The start is half an edge length away: after this time
/// a twentieth of that is left. Four steps are the fewest whose explicit part is well within
/// ExplicitLimits::Advection.
constexpr double IsosurfaceTime = 3.0;
constexpr int IsosurfaceSteps = 4;
/// From a sphere vertices move half an edge of an element in a step at most, and elements are up to
/// six times as large there (FlowTuning): 50 steps lead 150 edge lengths far, beyond any target of
/// that many vertices; those left over end by FlowOptions::convergenceTolerance.
constexpr double IcosphereTime = 25.0;
constexpr int IcosphereSteps = 50;

} // namespace

bool operator==(const ShrinkWrapOptions& a, const ShrinkWrapOptions& b)
{
  return membersOf(a) == membersOf(b);
}

void checkOptions(const ShrinkWrapOptions& options)
{
  const ShrinkWrapOptions& o = options;
  constexpr char Automatic[] = "0 means an automatic one";
  checkRangeOrZero(
    "TargetEdgeLength", o.targetEdgeLength, SmallestLength, LargestLength, Automatic);
  checkRange("TargetNumberOfPoints", o.targetNumberOfPoints, 0.0, AnyNumber, Automatic);
  checkRange("GapSize", o.gapSize, 0.0, LargestLength, Automatic);
  checkRange("OffsetDistance", o.offsetDistance, 0.0, LargestLength, "0 is on the input");
  checkRange("FeatureAngle", o.featureAngle, 0.0, 180.0, "set 45 degrees when in doubt");
  checkRange("NumberOfSteps", o.numberOfSteps, 0.0, AnyNumber, "0 means an automatic number");
}

int stepsOf(const ShrinkWrapOptions& options)
{
  const bool fromSphere = options.start == WrapStart::Icosphere;
  const int automatic = fromSphere ? IcosphereSteps : IsosurfaceSteps;
  return options.numberOfSteps > 0 ? options.numberOfSteps : automatic;
}

double timeStepOf(const ShrinkWrapOptions& options)
{
  const bool fromSphere = options.start == WrapStart::Icosphere;
  return (fromSphere ? IcosphereTime : IsosurfaceTime) / stepsOf(options);
}

double edgeLengthFor(double vertexCount, double area, double length)
{
  return std::max(coveringEdgeLength(area, vertexCount), VerticesAroundWire * length / vertexCount);
}

double defaultEdgeLength(double area, double length)
{
  return edgeLengthFor(DefaultVertexCount, area, length);
}

} // namespace evolving
