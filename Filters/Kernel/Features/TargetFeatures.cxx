// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Features/TargetFeatures.h"

#include "Errors.h"
#include "Features/CarriableFeatures.h"
#include "Features/DartCharts.h"
#include "Features/TargetTips.h"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace evolving
{

namespace
{

std::vector<char> excludedPatches(
  const TriangleLabels& patches, const std::vector<char>& isExcludedTriangle)
{
  std::vector<char> isExcluded(at(patches.count), 0);
  for (std::size_t f = 0; f < isExcludedTriangle.size(); ++f)
  {
    char& flag = isExcluded[at(patches.ofTriangle[f])];
    flag = flag != 0 || isExcludedTriangle[f] != 0;
  }
  return isExcluded;
}

SharpEdges carriableEdges(const TargetTriangles& target, const FeatureOptions& options,
  const std::vector<char>& isExcluded, const Execution& execution, OmittedCreases& excluded,
  OmittedCreases& leftOut)
{
  SharpEdges sharp = capturableCreases(target, options, isExcluded, excluded, execution);
  const std::vector<Index> wanted = sharp.list();
  keepCarriable(target, sharp, options.edgeLength, execution);
  leftOut = omittedOf(target, wanted, sharp);
  return sharp;
}

/// What labels beside darts have at least: two elements, of the target where no size is given.
double stripWidth(
  const TargetTriangles& target, const SharpEdges& sharp, const FeatureOptions& options)
{
  const std::vector<Index> edges = sharp.list();
  const double own =
    edges.empty() ? 0.0 : lengthOf(target, edges) / static_cast<double>(edges.size());
  return 2.0 * (options.edgeLength > 0.0 ? options.edgeLength : own);
}

/// The triangles of one label, with their numbers there.
SurfaceMesh partOf(const SurfaceMesh& mesh, const std::vector<Index>& faces)
{
  SurfaceMesh part;
  for (const Index face : faces)
  {
    const Index first = part.vertexCount();
    for (Index k = 0; k < 3; ++k)
    {
      part.addPoint(mesh.facePoint(face, k));
    }
    part.addFace({ first, first + 1, first + 2 });
  }
  return part;
}

SurfaceMesh pointsAsTriangles(const TargetTriangles& target, const std::vector<Index>& vertices)
{
  SurfaceMesh mesh;
  for (const Index vertex : vertices)
  {
    const Index point = mesh.addPoint(target.point(vertex));
    mesh.addFace({ point, point, point });
  }
  return mesh;
}

std::vector<std::vector<Index>> trianglesByLabel(const TriangleLabels& labels)
{
  std::vector<std::vector<Index>> triangles(at(labels.count));
  for (std::size_t face = 0; face < labels.ofTriangle.size(); ++face)
  {
    triangles[at(labels.ofTriangle[face])].push_back(static_cast<Index>(face));
  }
  return triangles;
}

void requireUsable(const FeatureOptions& options)
{
  std::ostringstream message;
  if (!(options.angle >= 0.0 && options.angle <= 180.0))
  {
    message << "The feature angle is " << options.angle
            << ", expected 0 to 180 degrees; set it to 45 for what looks like a crease.";
    throw InputError(message.str());
  }
  if (!(options.edgeLength >= 0.0) || !std::isfinite(options.edgeLength))
  {
    message << "The edge length that has to carry the features is " << options.edgeLength
            << ", expected a finite length of at least 0; set 0 to keep all features.";
    throw InputError(message.str());
  }
}

} // namespace

TargetFeatures::TargetFeatures(
  const SurfaceMesh& surface, const FeatureOptions& options, const Execution& execution)
  : Target(surface, execution.phase(0.0, 0.2))
  , IsExcluded(excludedTriangles(this->Target, options))
  , Sharp(carriableEdges(this->Target, options, this->IsExcluded, execution.phase(0.2, 0.4),
      this->Excluded, this->LeftOut))
  , Patches(surfacePatches(this->Target, this->Sharp))
  , IsExcludedPatch(excludedPatches(this->Patches, this->IsExcluded))
  , Labels(separatingLabels(
      this->Target, this->Sharp, this->Patches, stripWidth(this->Target, this->Sharp, options)))
  , Network(this->Target, this->Sharp)
  , Borders(this->Target, this->Sharp, this->Labels)
  , Tips(tipsOf(this->Target))
  , Tree(this->Target.mesh(), execution.phase(0.6, 0.8))
  , TrianglesOfLabel(trianglesByLabel(this->Labels))
  , CurveTree(this->Target, this->Sharp.list())
  , CornerTree(pointsAsTriangles(this->Target, this->Network.corners()))
{
  const Execution rest = execution.phase(0.8, 1.0);
  this->TreeOfLabel.reserve(this->TrianglesOfLabel.size());
  for (const std::vector<Index>& triangles : this->TrianglesOfLabel)
  {
    if (this->labelCount() > 1)
    {
      this->TreeOfLabel.emplace_back(partOf(this->Target.mesh(), triangles));
    }
    rest.report(static_cast<double>(this->TreeOfLabel.size()) / this->labelCount());
  }
}

LabelledPoint TargetFeatures::closestPoint(const Vec3& point) const
{
  const ClosestTriangle found = this->Tree.closest(point);
  return { found.triangle, this->Labels[found.triangle], found.at.point, found.at.squaredDistance };
}

LabelledPoint TargetFeatures::closestPointWithLabel(
  const Vec3& point, Index label, double squaredBound) const
{
  const AABBTree& tree = this->labelCount() > 1 ? this->TreeOfLabel[at(label)] : this->Tree;
  const ClosestTriangle found = tree.closest(point, squaredBound);
  if (found.triangle == NoIndex)
  {
    return {};
  }
  return { this->TrianglesOfLabel[at(label)][at(found.triangle)], label, found.at.point,
    found.at.squaredDistance };
}

Index TargetFeatures::closestCorner(const Vec3& point) const
{
  const ClosestTriangle found = this->CornerTree.closest(point);
  return found.triangle == NoIndex ? NoIndex : this->Network.corners()[at(found.triangle)];
}

TargetFeatures findFeatures(
  const SurfaceMesh& surface, const FeatureOptions& options, const Execution& execution)
{
  requireUsable(options);
  return TargetFeatures(surface, options, execution);
}

} // namespace evolving
