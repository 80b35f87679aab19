// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "LabelSurfaces/InterfaceElements.h"

#include <algorithm>
#include <cmath>

namespace evolving
{

namespace
{

using Corners = EditableInterfaces::Corners;

/// The normal of a triangle is a mean over the triangles around its vertices: so many times.
constexpr int NormalRounds = 3;

} // namespace

InterfaceElements::InterfaceElements(EditableInterfaces& mesh)
  : Mesh(mesh)
{
  this->findNormals();
}

/// Folds have small areas, of both signs; the mean over some rings is that of what lies flat.
void InterfaceElements::findNormals()
{
  const Index count = this->Mesh.triangleCount();
  this->Normals.resize(at(count));
  for (Index triangle = 0; triangle < count; ++triangle)
  {
    const Corners& c = this->Mesh.corners(triangle);
    const Vec3& a = this->Mesh.place(c[0]);
    this->Normals[at(triangle)] = (this->Mesh.place(c[1]) - a).cross(this->Mesh.place(c[2]) - a);
  }
  for (int round = 0; round < NormalRounds; ++round)
  {
    const std::vector<Vec3> before = this->Normals;
    for (Index triangle = 0; triangle < count; ++triangle)
    {
      Vec3 sum = Vec3::Zero();
      for (const Index corner : this->Mesh.corners(triangle))
      {
        for (const Index other : this->Mesh.star(corner))
        {
          const bool isSame = this->Mesh.sheet(other) == this->Mesh.sheet(triangle);
          sum += isSame ? before[at(other)] : Vec3(Vec3::Zero());
        }
      }
      this->Normals[at(triangle)] = sum;
    }
  }
  std::transform(this->Normals.begin(), this->Normals.end(), this->Normals.begin(), directionOf);
}

/// The sine of the smallest angle, by the sign of the area as seen along the normal.
double InterfaceElements::quality(const Corners& corners, const Vec3& normal) const
{
  const Vec3& a = this->Mesh.place(corners[0]);
  const Vec3& b = this->Mesh.place(corners[1]);
  const Vec3& c = this->Mesh.place(corners[2]);
  const double ab = (b - a).squaredNorm();
  const double bc = (c - b).squaredNorm();
  const double ca = (a - c).squaredNorm();
  const double product = std::sqrt(std::max({ ab * bc, bc * ca, ca * ab }));
  return product > 0.0 ? (b - a).cross(c - a).dot(normal) / product : 0.0;
}

double InterfaceElements::quality(Index triangle) const
{
  return this->quality(this->Mesh.corners(triangle), this->Normals[at(triangle)]);
}

double InterfaceElements::worst(Index vertex) const
{
  double least = 1.0;
  for (const Index triangle : this->Mesh.star(vertex))
  {
    least = std::min(least, this->quality(triangle));
  }
  return least;
}

double InterfaceElements::worst(Index vertex, const Vec3& place)
{
  const Vec3 before = this->Mesh.place(vertex);
  this->Mesh.move(vertex, place);
  const double least = this->worst(vertex);
  this->Mesh.move(vertex, before);
  return least;
}

Vec3 InterfaceElements::normalAt(Index vertex) const
{
  Vec3 sum = Vec3::Zero();
  for (const Index triangle : this->Mesh.star(vertex))
  {
    sum += this->Normals[at(triangle)];
  }
  return directionOf(sum);
}

} // namespace evolving
