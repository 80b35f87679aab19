// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "SurfaceMeasures.h"

#include "ElementQuality.h"
#include "Report.h"
#include "SurfaceDeviation.h"

#include "Mesh/SelfIntersections.h"
#include "Mesh/TopologySummary.h"

namespace benchmark
{

namespace
{

std::string topologyOf(const evolving::SurfaceMesh& surface)
{
  const evolving::TopologySummary topology = evolving::summarizeTopology(surface);
  if (!topology.isManifold() || !topology.isOriented())
  {
    return "not manifold";
  }
  return topology.isClosed() ? "closed, genus " + std::to_string(topology.genus()) : "open";
}

} // namespace

std::vector<std::string> measureNames()
{
  return { "vertices", "topology", "crossings", "least angle", "p1", "radius ratio", "% below 30",
    "hausdorff", "forward rms", "backward rms" };
}

std::vector<std::string> measureNotes()
{
  return { "Crossings: pairs of triangles. Angles: the smallest of every face, in degrees; p1:"
           " their first percentile.",
    "Distances by the diagonal d of the input's box, forward from the result to the input; of a"
    " point set only how far its points are from the result." };
}

std::vector<std::string> surfaceMeasures(
  const evolving::SurfaceMesh& surface, const evolving::SurfaceMesh& reference)
{
  const ElementQuality quality = elementQuality(surface);
  const SurfaceDeviation off = deviation(surface, reference);
  const bool toPoints = reference.faceCount() == 0;
  return { std::to_string(surface.vertexCount()), topologyOf(surface),
    std::to_string(evolving::selfIntersections(surface).size()), fixed(quality.smallestAngle, 2),
    fixed(quality.firstPercentile, 2), fixed(quality.radiusRatio, 4),
    fixed(100.0 * quality.partBelow30, 2),
    fixed(toPoints ? off.backward.largest : off.hausdorff(), 5),
    toPoints ? "-" : fixed(off.forward.rms, 6), fixed(off.backward.rms, 6) };
}

} // namespace benchmark
