// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * The distance to a polydata by its definition: the least over all triangles, in long double.
 */

#ifndef ROBUSTNESS_DISTANCE_REFERENCE_H
#define ROBUSTNESS_DISTANCE_REFERENCE_H

#include "Surface.h"

namespace robustness
{

/// Also of triangles without area.
double distanceToTriangle(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c);

/// What the distance must lie between; the same number twice where it is known.
struct DistanceBounds
{
  double lower;
  double upper;
};

/**
 * All triangles, or the points of a point set. A polygon that is not planar or crosses itself may
 * be cut into triangles in several ways: it is nowhere nearer than any triangle of its corners,
 * and its edges are always part of it.
 */
class DistanceReference
{
public:
  /// Triangles with twice the same point do not count to vtkMeshSDF.
  explicit DistanceReference(vtkPolyData* data, bool allCount = false);

  /// Is there nothing to measure to?
  bool isEmpty() const { return this->Triangles.empty() && !this->IsLoose; }
  /// Are there polygons whose triangles are not known?
  bool isLoose() const { return this->IsLoose; }
  /// Triangles to be looked at for a place.
  std::size_t size() const { return this->Triangles.size() + this->Possible.size(); }
  DistanceBounds operator()(const Vec3& place) const;
  /// To one cell of the polydata.
  double toCell(const Vec3& place, std::int64_t cell) const;
  /// Around all of it.
  const evolving::Box& box() const { return this->Around; }
  bool isPointSet() const { return this->OfPoints; }

private:
  void addFaces(const Surface& surface);
  void addPoints(vtkPolyData* data);
  void addLoosePolygon(const Cell& polygon);
  void addTriangle(const Triangle& triangle, std::int64_t cell);
  double toAll(const Vec3& place, const std::vector<Triangle>& triangles) const;

  std::vector<Vec3> Points;
  std::vector<Triangle> Triangles;
  std::vector<std::int64_t> CellOfTriangle;
  ///@{
  /// Of polygons whose triangles are not known: what may be part of them, and what surely is.
  std::vector<Triangle> Possible;
  std::vector<Triangle> Sure;
  std::vector<evolving::Box> Boxes;
  bool IsLoose = false;
  ///@}
  evolving::Box Around;
  bool OfPoints = false;
  bool AllCount = false;
};

} // namespace robustness

#endif
