// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * A surface as a judge sees it, and what it measures of it: by definition, without the code under
 * test. Only the exact predicates of two triangles are the kernel's.
 */

#ifndef ROBUSTNESS_SURFACE_H
#define ROBUSTNESS_SURFACE_H

#include "Model.h"

class vtkPolyData;

namespace robustness
{

struct Surface
{
  std::vector<Vec3> points;
  std::vector<Cell> faces;
  std::vector<std::int64_t> cellOfFace; ///< in the polydata

  const Vec3& corner(const Cell& face, std::size_t k) const
  {
    return this->points[static_cast<std::size_t>(face[k])];
  }
};

/// Polygons, and strips as triangles, however wrong they are.
Surface surfaceOf(vtkPolyData* data);

/// Are all point numbers there, and have all faces three corners or more?
bool hasUsableFaces(const Surface& surface);
/// Have all points that faces use numbers as coordinates?
bool hasFiniteCorners(const Surface& surface);

/// Points with equal coordinates are one, but for those of parts that are closed as they are; faces
/// that then use one twice are left out.
Surface welded(const Surface& surface);

struct Topology
{
  std::int64_t vertices = 0; ///< that faces use
  std::int64_t edges = 0;
  std::int64_t faces = 0;
  std::int64_t components = 0;
  std::int64_t borderEdges = 0;
  std::int64_t crowdedEdges = 0; ///< of more than two faces
  std::int64_t turnedEdges = 0;  ///< that two faces run along in the same direction
  std::int64_t crowdedVertices = 0;

  bool isClosed() const { return this->borderEdges == 0 && this->crowdedEdges == 0; }
  bool isManifold() const { return this->crowdedEdges == 0 && this->crowdedVertices == 0; }
  bool isOriented() const { return this->turnedEdges == 0; }
  std::int64_t genus() const
  {
    return (2 * this->components - (this->vertices - this->edges + this->faces)) / 2;
  }
};

Topology topologyOf(const Surface& surface);

/// The smallest angle between neighbouring edges of all faces, in degrees.
double smallestAngleOf(const Surface& surface);
double areaOf(const Surface& surface);
/// About a point.
double volumeOf(const Surface& surface, const Vec3& centre);
Vec3 middleOf(const Surface& surface);

/// Pairs of triangles with area that have more in common than their shared corners. Every pair.
std::int64_t intersectionsOf(const Surface& surface);

/// Of every component that no other one surrounds, the smallest volume.
double smallestOuterVolume(const Surface& surface);

/// How often the triangles wind around a point: 1 inside, 0 outside.
double windingNumber(
  const std::vector<Vec3>& points, const std::vector<Triangle>& triangles, const Vec3& place);

} // namespace robustness

#endif
