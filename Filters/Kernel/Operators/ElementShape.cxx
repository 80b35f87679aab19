// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Operators/ElementShape.h"

#include "Mesh/Angles.h"
#include "Mesh/Orthogonal.h"
#include "ParallelLoops.h"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>

namespace evolving
{

namespace
{

/// Elements count as no worse than this, a needle of 3 degrees: from far outside of it a Newton
/// step would only double the area, and one without area would say nothing.
constexpr double WorstShape = 10.0;

using Vec2 = Eigen::Vector2d;
using Mat2 = Eigen::Matrix2d;

/// The corner of a regular polygon.
struct RegularCorner
{
  double cosine;
  double sine;

  explicit RegularCorner(Index faceSize)
  {
    switch (faceSize)
    {
      case 3:
        this->cosine = 0.5;
        this->sine = 0.86602540378443865;
        break;
      case 4:
        this->cosine = 0.0;
        this->sine = 1.0;
        break;
      default:
        this->cosine = std::cos(Pi * (faceSize - 2) / faceSize);
        this->sine = std::sin(Pi * (faceSize - 2) / faceSize);
    }
  }
  double lengths(const Vec3& e1, const Vec3& e2) const
  {
    return e1.squaredNorm() + e2.squaredNorm() - 2.0 * this->cosine * e1.dot(e2);
  }
};

/// Coordinates in the tangent plane at a vertex; along the curve only, where there is one.
struct TangentBasis
{
  Vec3 first;
  Vec3 second;

  TangentBasis(const Vec3& normal, const Vec3& curveTangent)
  {
    this->first = orthogonalTo(normal).normalized();
    this->second = normal.cross(this->first);
    if (!curveTangent.isZero(0.0))
    {
      this->first = curveTangent;
      this->second = Vec3::Zero();
    }
  }
  Vec2 coordinates(const Vec3& vector) const
  {
    return { vector.dot(this->first), vector.dot(this->second) };
  }
};

/// Gradient and second derivative of the sum of squared shapes in the position of one vertex.
class ShapeEnergy
{
public:
  /**
   * @param normal of the tangent plane
   * @param upward the side that faces are to show
   */
  ShapeEnergy(const Vec3& normal, const Vec3& upward, const Vec3& curveTangent)
    : Upward(upward)
    , Basis(normal, curveTangent)
  {
  }

  /**
   * Adds a corner.
   * @param d1 d2 by how much of the vertex's move the edges e1 and e2 change: -1, 0 or 1
   * @param count how many corners like it
   */
  void add(const RegularCorner& regular, const Vec3& e1, double d1, const Vec3& e2, double d2,
    double count = 1.0)
  {
    const Vec3 cross = e1.cross(e2);
    const double area = cross.norm();
    const double lengths = regular.lengths(e1, e2);
    const double smallest = lengths / (2.0 * regular.sine * WorstShape);
    if (!(smallest > 0.0))
    {
      return; // all its points are one
    }
    // A corner that is turned over has no area to lose: it is to gain some.
    const double side = cross.dot(this->Upward) < 0.0 ? -1.0 : 1.0;
    const Vec3 up = area > smallest ? Vec3(side / area * cross) : this->Upward;
    const Vec3 growth = d1 * e2.cross(up) + d2 * up.cross(e1);
    const double c = regular.cosine;
    const Vec2 n = this->Basis.coordinates(2.0 * d1 * (e1 - c * e2) + 2.0 * d2 * (e2 - c * e1));
    const Vec2 a = this->Basis.coordinates(2.0 * regular.sine * growth);
    const double A = 2.0 * regular.sine * std::max(side * area, smallest);
    this->addQuotient({ lengths, n, 2.0 * (d1 * d1 + d2 * d2 - 2.0 * c * d1 * d2) }, A, a, count);
  }

  /// Where the energy's second-order model is least.
  Vec3 newtonStep() const
  {
    Mat2 H = this->Second;
    if (this->Basis.second.isZero(0.0))
    {
      H(1, 1) = 1.0;
    }
    const Vec2 step = H.determinant() > 0.0 ? Vec2(-H.inverse() * this->Gradient) : Vec2(0.0, 0.0);
    return step.x() * this->Basis.first + step.y() * this->Basis.second;
  }

private:
  /// Sum of squared lengths: value, gradient, and its second derivative, a multiple of one.
  struct Lengths
  {
    double value;
    Vec2 gradient;
    double second;
  };

  /// q = lengths / A with the gradient a of A: adds q^2 / 2, `count` times.
  void addQuotient(const Lengths& n, double A, const Vec2& a, double count)
  {
    const double q = n.value / A;
    const Vec2 gradient = (n.gradient - q * a) / A;
    const Mat2 mixed = n.gradient * a.transpose();
    const Mat2 second = (n.second * Mat2::Identity() -
                          (mixed + mixed.transpose() - 2.0 * q * a * a.transpose()) / A) /
      A;
    this->Gradient += count * q * gradient;
    this->Second += count * (gradient * gradient.transpose() + q * second);
  }

  Vec3 Upward;
  TangentBasis Basis;
  Vec2 Gradient = Vec2::Zero();
  Mat2 Second = Mat2::Zero();
};

} // namespace

double cornerShape(const Vec3& e1, const Vec3& e2, Index faceSize)
{
  const RegularCorner regular(faceSize);
  return regular.lengths(e1, e2) / (2.0 * regular.sine * e1.cross(e2).norm());
}

namespace
{

/// The side that the faces at a vertex show: its pseudonormal, but where that means nothing, as at
/// a vertex outside of its ring, the direction of their vector area.
Vec3 upwardAt(
  const SurfaceMesh& mesh, const MeshTopology& topology, Index vertex, const Vec3& normal)
{
  Vec3 area = Vec3::Zero();
  for (const Index corner : topology.ringCorners(vertex))
  {
    area += faceVectorArea(mesh, topology.faceOf(corner));
  }
  const Vec3 direction = area.stableNormalized();
  return direction.dot(normal) > 0.5 ? normal : direction;
}

} // namespace

Vec3 bestShapeMove(const SurfaceMesh& mesh, const MeshTopology& topology, Index vertex,
  const Vec3& normal, const Vec3& tangent)
{
  const Vec3 upward = upwardAt(mesh, topology, vertex, normal);
  if (upward.isZero(0.0))
  {
    return Vec3::Zero();
  }
  ShapeEnergy energy(normal.isZero(0.0) ? upward : normal, upward, tangent);
  const auto edge = [&](Index from, Index to) -> Vec3
  { return mesh.points[at(topology.vertexOf(to))] - mesh.points[at(topology.vertexOf(from))]; };
  for (const Index own : topology.ringCorners(vertex))
  {
    const Index next = topology.next(own);
    const Index previous = topology.previous(own);
    const Index faceSize = mesh.faceSize(topology.faceOf(own));
    const RegularCorner regular(faceSize);
    if (faceSize == 3) // its corners have one shape, see cornerShape()
    {
      energy.add(regular, edge(own, next), -1.0, edge(own, previous), -1.0, 3.0);
      continue;
    }
    energy.add(regular, edge(own, next), -1.0, edge(own, previous), -1.0);
    energy.add(regular, edge(next, topology.next(next)), 0.0, edge(next, own), 1.0);
    energy.add(regular, edge(previous, own), 1.0, edge(previous, topology.previous(previous)), 0.0);
  }
  return energy.newtonStep();
}

} // namespace evolving
