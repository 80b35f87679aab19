// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "LabelSurfaces/NetSmoothing.h"

#include "LabelSurfaces/JunctionFit.h"
#include "LabelSurfaces/LocalVolumes.h"
#include "LabelSurfaces/NetFairing.h"

#include <algorithm>
#include <cmath>

namespace evolving
{

namespace
{

/// One step would round a torus of radius 7 voxels, many keep long waves and end short ones; with
/// eight, normals of balls, ellipsoids and tori are within a tenth of what 16 reach.
constexpr int Steps = 8;
/// The filter counts neighbours, whose mean is a quarter of the Laplacian: of two, a sixteenth.
constexpr double LaplacianOfNeighbours = 16.0;
/// Stairs go to and fro over this many smoothing lengths: of 1 to 4, what leaves normals best and
/// threads of one voxel as thick as they are.
constexpr double ExchangeLengths = 2.5;
/// Of the part of a sheet that tells where it ends: of 1.4 to 2.2, what leaves curves best.
constexpr double FitLengths = 1.75;
/// Of that part, in voxels: below there are too few vertices, above nothing is gained.
constexpr double SmallestFit = 1.5;
constexpr double LargestFit = 4.0;

} // namespace

void smoothNet(
  const NetLimits& limits, double length, InterfaceNet& net, const Execution& execution)
{
  if (!(length > 0.0))
  {
    return;
  }
  const double strength = LaplacianOfNeighbours * std::pow(length, 4) / Steps;
  const NetFairing fairing(net, strength, execution);
  const LocalVolumes volumes(net, ExchangeLengths * length, execution);
  JunctionFit junctions(net, limits, std::clamp(FitLengths * length, SmallestFit, LargestFit));
  std::vector<Vec3>& points = net.points;
  for (int step = 0; step < Steps; ++step)
  {
    const auto begin = static_cast<double>(step);
    const Execution phase = execution.phase(begin / Steps, (begin + 1.0) / Steps);
    phase.report(0.0);
    const std::vector<Vec3> before = points;
    fairing.apply(points, phase.phase(0.0, 0.0));
    phase.report(0.4);
    volumes.giveBack(before, points, phase.phase(0.4, 0.4));
    junctions.apply(points, phase.phase(0.5, 1.0));
    const std::vector<Vec3> areas = sheetAreas(net, points, execution);
    limits.apply(net, directionsOf(areas, execution), points, execution);
  }
}

} // namespace evolving
