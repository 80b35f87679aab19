// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "LabelSurfaces/LabelSurfaces.h"

#include "Errors.h"
#include "LabelSurfaces/ClosedSurfaces.h"
#include "LabelSurfaces/InterfaceNet.h"
#include "LabelSurfaces/InterfaceTriangles.h"
#include "LabelSurfaces/LabelVolumes.h"
#include "LabelSurfaces/LocalVolumes.h"
#include "LabelSurfaces/NetFairing.h"
#include "LabelSurfaces/NetLimits.h"
#include "Mesh/FloatPoints.h"
#include "Mesh/SelfIntersections.h"
#include "Mesh/TriangleView.h"
#include "ParallelLoops.h"

#include <algorithm>
#include <cmath>
#include <utility>

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
/// Rounds of taking intersecting triangles back by half their way, before they go all the way.
constexpr int HalvingRounds = 6;

SurfaceMesh meshOf(std::vector<Vec3> points, const std::vector<Index>& corners)
{
  SurfaceMesh mesh;
  mesh.points = std::move(points);
  mesh.cornerVertices = corners;
  mesh.faceOffsets.resize(corners.size() / 3 + 1);
  for (std::size_t face = 0; face < mesh.faceOffsets.size(); ++face)
  {
    mesh.faceOffsets[face] = static_cast<Index>(3 * face);
  }
  return mesh;
}

std::vector<double> voxelCounts(const LabelImage& image)
{
  std::vector<double> counts(image.labelCount, 0.0);
  for (const Material material : image.materials)
  {
    if (isLabel(material))
    {
      counts[static_cast<std::size_t>(material) - 1] += 1.0;
    }
  }
  return counts;
}

/// Makes the surfaces of one image.
class SurfaceMaker
{
public:
  SurfaceMaker(const LabelImage& image, double smoothingLength, const Execution& execution)
    : Image(image)
    , Length(smoothingLength)
    , Run(execution)
    , Grid(image.sizes, image.materials)
    , Net(interfaceNet(this->Grid, execution.phase(0.0, 0.1)))
    , Limits(this->Grid, this->Net, execution)
  {
  }

  LabelSurfaces make()
  {
    LabelSurfaces result;
    std::vector<Vec3>& points = this->Net.points;
    if (this->Length > 0.0)
    {
      this->smooth(points);
    }
    std::vector<Vec3> places = this->inSpace(points);
    InterfaceTriangles triangles = splitNet(this->Net, places, this->Run);
    result.pointsAreFloats = floatsHold(meshOf(places, triangles.corners));
    this->AreFloats = result.pointsAreFloats;
    if (this->Length > 0.0)
    {
      this->finish(triangles, points);
    }
    this->measure(triangles, points, result);
    places = this->inSpace(points);
    if (this->Image.toSpace.linear().determinant() < 0.0)
    {
      this->turnAround(triangles);
    }
    ClosedSurfaces closed = closedSurfaces(this->Net, triangles, places, this->Run.phase(0.9, 1.0));
    this->write(std::move(closed), triangles, this->rounded(std::move(places)), result);
    return result;
  }

private:
  void smooth(std::vector<Vec3>& points) const
  {
    const double strength = LaplacianOfNeighbours * std::pow(this->Length, 4) / Steps;
    const NetFairing fairing(this->Net, strength, this->Run);
    const LocalVolumes volumes(this->Net, ExchangeLengths * this->Length, this->Run);
    for (int step = 0; step < Steps; ++step)
    {
      const Execution phase =
        this->Run.phase(0.1 + 0.6 * step / Steps, 0.1 + 0.6 * (step + 1) / Steps);
      phase.report(0.0);
      const std::vector<Vec3> before = points;
      fairing.apply(points, phase.phase(0.0, 0.0));
      phase.report(0.6);
      volumes.giveBack(before, points, phase.phase(0.6, 0.6));
      const std::vector<Vec3> areas = sheetAreas(this->Net, points, this->Run);
      this->Limits.apply(this->Net, directionsOf(areas, this->Run), points, this->Run);
    }
  }

  std::vector<Vec3> rounded(std::vector<Vec3> places) const
  {
    return this->AreFloats ? roundedToFloats(std::move(places)) : std::move(places);
  }

  std::vector<Vec3> inSpace(const std::vector<Vec3>& points) const
  {
    std::vector<Vec3> places(points.size());
    forEachIndex(this->Run, this->Net.vertexCount(),
      [&](Index i) { places[at(i)] = this->Image.toSpace * points[at(i)]; });
    return places;
  }

  /// Volumes as wanted, and no intersections: the latter decides where both cannot be.
  void finish(const InterfaceTriangles& triangles, std::vector<Vec3>& points) const
  {
    const LabelVolumes volumes(this->Net, triangles, this->Limits, voxelCounts(this->Image));
    std::vector<char> rests(points.size(), 0);
    const Execution phase = this->Run.phase(0.7, 0.9);
    for (int round = 0;; ++round)
    {
      if (round <= HalvingRounds)
      {
        volumes.restore(rests, points, phase.phase(0.0, 0.5));
      }
      const std::vector<Vec3> places = this->rounded(this->inSpace(points));
      const auto pairs =
        selfIntersections(TriangleView(places, triangles.corners), phase.phase(0.5, 1.0));
      if (pairs.empty())
      {
        break;
      }
      const double left = round < HalvingRounds ? 0.5 : 0.0;
      this->takeBack(pairs, triangles, left, rests, points);
    }
  }

  /// Vertices of triangles that intersect go a part of their way back and rest there.
  void takeBack(const std::vector<std::pair<Index, Index>>& pairs,
    const InterfaceTriangles& triangles, double left, std::vector<char>& rests,
    std::vector<Vec3>& points) const
  {
    std::vector<char> goesBack(points.size(), 0);
    for (const auto& pair : pairs)
    {
      for (const Index triangle : { pair.first, pair.second })
      {
        for (std::size_t k = 0; k < 3; ++k)
        {
          goesBack[at(triangles.corners[at(3 * triangle) + k])] = 1;
        }
      }
    }
    for (Index i = 0; i < this->Net.vertexCount(); ++i)
    {
      if (goesBack[at(i)] != 0)
      {
        const Vec3 corner = this->Net.cornerPoint(i);
        points[at(i)] = corner + left * (points[at(i)] - corner);
        rests[at(i)] = 1;
      }
    }
  }

  void measure(const InterfaceTriangles& triangles, const std::vector<Vec3>& points,
    LabelSurfaces& result) const
  {
    const std::vector<double> wanted = voxelCounts(this->Image);
    result.volumes = labelVolumes(this->Net, triangles, points, wanted.size(), this->Run);
    result.voxelVolumes = wanted;
    const double ofVoxel = std::abs(this->Image.toSpace.linear().determinant());
    for (std::size_t l = 0; l < wanted.size(); ++l)
    {
      const double error = std::abs(result.volumes[l] - wanted[l]);
      result.largestVolumeError =
        std::max(result.largestVolumeError, wanted[l] > 0.0 ? error / wanted[l] : 0.0);
      result.volumes[l] *= ofVoxel;
      result.voxelVolumes[l] *= ofVoxel;
    }
  }

  /// In a mirrored image the first side of a triangle is seen from where the second was.
  static void turnAround(InterfaceTriangles& triangles)
  {
    for (std::size_t first = 0; first < triangles.corners.size(); first += 3)
    {
      std::swap(triangles.corners[first + 1], triangles.corners[first + 2]);
    }
  }

  void write(ClosedSurfaces closed, const InterfaceTriangles& triangles, std::vector<Vec3> places,
    LabelSurfaces& result) const
  {
    result.surfaces = std::move(closed.mesh);
    result.surfaces.points = this->rounded(std::move(result.surfaces.points));
    result.labels = std::move(closed.labels);
    result.others = std::move(closed.others);
    result.interfaces = meshOf(std::move(places), triangles.corners);
    result.sides.resize(triangles.quads.size());
    forEachIndex(this->Run, triangles.count(),
      [&](Index i) { result.sides[at(i)] = this->Net.quads[at(triangles.quads[at(i)])].sides; });
  }

  const LabelImage& Image;
  double Length;
  const Execution& Run;
  MaterialGrid Grid;
  InterfaceNet Net;
  NetLimits Limits;
  bool AreFloats = true;
};

} // namespace

LabelSurfaces labelSurfaces(
  const LabelImage& image, const LabelSurfacesOptions& options, const Execution& execution)
{
  if (!(options.smoothingLength >= 0.0) || !std::isfinite(options.smoothingLength))
  {
    throw InputError("SmoothingLength is " + std::to_string(options.smoothingLength) +
      " voxels, expected 0 or more; 2 takes the stairs away.");
  }
  return SurfaceMaker(image, options.smoothingLength, execution).make();
}

} // namespace evolving
