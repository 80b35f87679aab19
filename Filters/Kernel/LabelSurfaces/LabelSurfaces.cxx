// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "LabelSurfaces/LabelSurfaces.h"

#include "Errors.h"
#include "LabelSurfaces/ClosedSurfaces.h"
#include "LabelSurfaces/InterfaceFinish.h"
#include "LabelSurfaces/InterfaceNet.h"
#include "LabelSurfaces/InterfaceTriangles.h"
#include "LabelSurfaces/LabelVolumes.h"
#include "LabelSurfaces/NetLimits.h"
#include "LabelSurfaces/NetSmoothing.h"
#include "Mesh/FloatPoints.h"
#include "Mesh/PointWelding.h"
#include "Mesh/SelfIntersections.h"
#include "ParallelLoops.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace evolving
{

namespace
{

/// Of a label's volume: what floats may take away or add.
constexpr double MostRounding = 1e-3;

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
    smoothNet(this->Limits, this->Length, this->Net, this->Run.phase(0.1, 0.7));
    const std::vector<Vec3>& points = this->Net.points;
    const std::vector<Vec3> places = inSpace(points, this->Image.toSpace, this->Run);
    const InterfaceTriangles triangles = splitNet(this->Net, places, this->Run);
    this->AreFloats =
      this->volumesHold(triangles, points) && floatsHold(meshOf(places, triangles.corners));
    LabelSurfaces result = this->finished(triangles);
    // The middle of an edge that is passed twice is not quite on it, as floats have it.
    if (this->IsSplit && this->AreFloats &&
      !selfIntersections(result.interfaces, this->Run).empty())
    {
      this->AreFloats = false;
      result = this->finished(triangles);
    }
    return result;
  }

private:
  LabelSurfaces finished(InterfaceTriangles triangles)
  {
    LabelSurfaces result;
    result.pointsAreFloats = this->AreFloats;
    std::vector<Vec3> points = this->Net.points;
    if (this->Length > 0.0)
    {
      InterfaceFinish finish(this->Grid, this->Net, this->Limits, this->Image.toSpace,
        voxelCounts(this->Image), this->AreFloats);
      triangles = finish.run(points, this->Run.phase(0.7, 0.9));
    }
    this->measure(triangles, points, result);
    std::vector<Vec3> places = inSpace(points, this->Image.toSpace, this->Run);
    if (this->Image.toSpace.linear().determinant() < 0.0)
    {
      this->turnAround(triangles);
    }
    ClosedSurfaces closed = closedSurfaces(this->Net, triangles, places, this->Run.phase(0.9, 1.0));
    this->IsSplit = places.size() > points.size();
    this->write(std::move(closed), triangles, this->rounded(std::move(places)), result);
    return result;
  }

  std::vector<Vec3> rounded(std::vector<Vec3> places) const
  {
    return this->AreFloats ? roundedToFloats(std::move(places)) : std::move(places);
  }

  std::vector<double> volumesOf(
    const InterfaceTriangles& triangles, const std::vector<Vec3>& points) const
  {
    return labelVolumes(this->Net, triangles, points, this->Image.labelCount, this->Run);
  }

  /// In voxels, of points as they are written.
  std::vector<double> volumesWritten(
    const InterfaceTriangles& triangles, const std::vector<Vec3>& points) const
  {
    const Eigen::Affine3d& toSpace = this->Image.toSpace;
    return this->volumesOf(triangles,
      inSpace(this->rounded(inSpace(points, toSpace, this->Run)), toSpace.inverse(), this->Run));
  }

  /// Do labels keep their volumes when the points become floats?
  bool volumesHold(const InterfaceTriangles& triangles, const std::vector<Vec3>& points) const
  {
    const std::vector<double> wanted = voxelCounts(this->Image);
    const std::vector<double> computed = this->volumesOf(triangles, points);
    const std::vector<double> written = this->volumesWritten(triangles, points);
    for (std::size_t l = 0; l < wanted.size(); ++l)
    {
      if (std::abs(written[l] - computed[l]) > MostRounding * wanted[l])
      {
        return false;
      }
    }
    return true;
  }

  /// Errors as computed, and volumes of the points as they are written.
  void measure(const InterfaceTriangles& triangles, const std::vector<Vec3>& points,
    LabelSurfaces& result) const
  {
    const std::vector<double> wanted = voxelCounts(this->Image);
    const std::vector<double> computed = this->volumesOf(triangles, points);
    result.volumes = this->volumesWritten(triangles, points);
    result.voxelVolumes = wanted;
    const double ofVoxel = std::abs(this->Image.toSpace.linear().determinant());
    for (std::size_t l = 0; l < wanted.size(); ++l)
    {
      const double error = std::abs(computed[l] - wanted[l]);
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
    dropUnusedPoints(result.interfaces); // of vertices that others have taken the place of
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
  bool IsSplit = false; ///< edges have got a vertex in their middle
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
