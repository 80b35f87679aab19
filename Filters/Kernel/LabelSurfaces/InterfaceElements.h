// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * How good the triangles of interfaces are, and which way they face.
 */

#ifndef EVOLVING_INTERFACE_ELEMENTS_H
#define EVOLVING_INTERFACE_ELEMENTS_H

#include "LabelSurfaces/EditableInterfaces.h"
#include "Types.h"

#include <vector>

namespace evolving
{

/// Zero where a vector is.
inline Vec3 directionOf(const Vec3& vector)
{
  const double length = vector.norm();
  return length > 0.0 ? Vec3(vector / length) : Vec3(Vec3::Zero());
}

/**
 * Elements are judged by the sine of their smallest angle, by the sign of their area as seen along
 * the sheet's normal, which is a mean over neighbours: so what is turned over counts below zero.
 */
class InterfaceElements
{
public:
  explicit InterfaceElements(EditableInterfaces& mesh);

  double quality(const EditableInterfaces::Corners& corners, const Vec3& normal) const;
  double quality(Index triangle) const;
  /// Of the triangles around a vertex; with the vertex elsewhere.
  double worst(Index vertex) const;
  double worst(Index vertex, const Vec3& place);

  const Vec3& normal(Index triangle) const { return this->Normals[at(triangle)]; }
  void setNormal(Index triangle, const Vec3& normal) { this->Normals[at(triangle)] = normal; }
  Vec3 normalAt(Index vertex) const;

private:
  void findNormals();

  EditableInterfaces& Mesh;
  std::vector<Vec3> Normals; ///< unit vectors
};

} // namespace evolving

#endif
