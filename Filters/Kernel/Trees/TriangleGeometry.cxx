// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Trees/TriangleGeometry.h"

#include <algorithm>
#include <limits>

namespace evolving
{

namespace
{

TriangleFeature vertexFeature(int corner)
{
  return static_cast<TriangleFeature>(static_cast<int>(TriangleFeature::Vertex0) + corner);
}

TriangleFeature edgeFeature(int edge)
{
  return static_cast<TriangleFeature>(static_cast<int>(TriangleFeature::Edge0) + edge);
}

TrianglePoint at(const Vec3& closest, TriangleFeature feature, const Vec3& point)
{
  return { closest, feature, (point - closest).squaredNorm() };
}

/// From the numerator and denominator of the edge's parameter at the foot of the point.
TrianglePoint onEdge(
  const Triangle& triangle, int edge, double numerator, double denominator, const Vec3& point)
{
  const int next = (edge + 1) % 3;
  const Vec3& from = triangle.corners[static_cast<std::size_t>(edge)];
  const Vec3& to = triangle.corners[static_cast<std::size_t>(next)];
  if (numerator <= 0.0 || denominator <= 0.0)
  {
    return at(from, vertexFeature(edge), point);
  }
  if (numerator >= denominator)
  {
    return at(to, vertexFeature(next), point);
  }
  return at(from + numerator / denominator * (to - from), edgeFeature(edge), point);
}

/// The closest point on those edges that lie opposite a corner with a weight <= 0.
TrianglePoint closestOnEdges(
  const Vec3& point, const Triangle& triangle, const std::array<double, 3>& cornerWeights)
{
  TrianglePoint best;
  best.squaredDistance = std::numeric_limits<double>::infinity();
  for (int edge = 0; edge < 3; ++edge)
  {
    if (cornerWeights[static_cast<std::size_t>((edge + 2) % 3)] > 0.0)
    {
      continue;
    }
    const Vec3& from = triangle.corners[static_cast<std::size_t>(edge)];
    const Vec3 along = triangle.corners[static_cast<std::size_t>((edge + 1) % 3)] - from;
    const TrianglePoint candidate =
      onEdge(triangle, edge, along.dot(point - from), along.squaredNorm(), point);
    if (candidate.squaredDistance < best.squaredDistance)
    {
      best = candidate;
    }
  }
  return best;
}

/// The same from the squared lengths of two edges and their cross product. The third edge is at
/// most their sum, which is close enough.
bool isDegenerate(double firstSquared, double secondSquared, const Vec3& normal)
{
  constexpr double LowestSquared = 1e-16; // where both treatments are off by as little
  const double longestSquared = std::max(firstSquared, secondSquared);
  return !(normal.squaredNorm() > LowestSquared * longestSquared * longestSquared);
}

/// Do the triangle's corners, projected to the axis, leave [-radius, radius]?
bool separates(const Vec3& axis, const std::array<Vec3, 3>& corners, double radius)
{
  const double p0 = axis.dot(corners[0]);
  const double p1 = axis.dot(corners[1]);
  const double p2 = axis.dot(corners[2]);
  return std::min({ p0, p1, p2 }) > radius || std::max({ p0, p1, p2 }) < -radius;
}

} // namespace

Vec3 Triangle::doubleAreaNormal() const
{
  return (this->corners[1] - this->corners[0]).cross(this->corners[2] - this->corners[0]);
}

Box Triangle::box() const
{
  Box result(this->corners[0]);
  result.extend(this->corners[1]);
  result.extend(this->corners[2]);
  return result;
}

std::vector<Triangle> trianglesOf(const SurfaceMesh& mesh)
{
  std::vector<Triangle> triangles;
  triangles.reserve(static_cast<std::size_t>(mesh.faceCount()));
  for (Index face = 0; face < mesh.faceCount(); ++face)
  {
    triangles.push_back(triangleOf(mesh, face));
  }
  return triangles;
}

bool isDegenerate(const Triangle& triangle)
{
  const Vec3 ab = triangle.corners[1] - triangle.corners[0];
  const Vec3 ac = triangle.corners[2] - triangle.corners[0];
  return isDegenerate(ab.squaredNorm(), ac.squaredNorm(), ab.cross(ac));
}

TrianglePoint closestPointOnTriangle(const Vec3& point, const Triangle& triangle)
{
  const Vec3& a = triangle.corners[0];
  const Vec3 ab = triangle.corners[1] - a;
  const Vec3 ac = triangle.corners[2] - a;
  const Vec3 ap = point - a;
  const double abSquared = ab.squaredNorm();
  const double acSquared = ac.squaredNorm();
  const double abac = ab.dot(ac);
  const Vec3 normal = ab.cross(ac);
  if (isDegenerate(abSquared, acSquared, normal))
  {
    return closestOnEdges(point, triangle, { 0.0, 0.0, 0.0 });
  }
  const double abap = ab.dot(ap);
  const double acap = ac.dot(ap);
  // The barycentric coordinates of the foot in the plane, times the squared double area.
  const double inB = abap * acSquared - acap * abac;
  const double inC = acap * abSquared - abap * abac;
  const double total = normal.squaredNorm();
  const double inA = total - inB - inC;
  if (inA > 0.0 && inB > 0.0 && inC > 0.0)
  {
    const double height = normal.dot(ap) / total;
    TrianglePoint result{ point - height * normal, TriangleFeature::Face, 0.0 };
    result.squaredDistance = height * height * total;
    return result;
  }
  return closestOnEdges(point, triangle, { inA, inB, inC });
}

bool overlaps(const Triangle& triangle, const Box& box)
{
  const Vec3 half = 0.5 * box.sizes();
  const Vec3 center = box.center();
  std::array<Vec3, 3> corners;
  for (std::size_t k = 0; k < 3; ++k)
  {
    corners[k] = triangle.corners[k] - center;
  }
  const Vec3 low = corners[0].cwiseMin(corners[1]).cwiseMin(corners[2]);
  const Vec3 high = corners[0].cwiseMax(corners[1]).cwiseMax(corners[2]);
  if ((low.array() > half.array()).any() || (high.array() < -half.array()).any())
  {
    return false;
  }
  const Vec3 normal = triangle.doubleAreaNormal();
  if (separates(normal, corners, half.dot(normal.cwiseAbs())))
  {
    return false;
  }
  for (std::size_t k = 0; k < 3; ++k)
  {
    const Vec3 edge = triangle.corners[(k + 1) % 3] - triangle.corners[k];
    for (int side = 0; side < 3; ++side)
    {
      const Vec3 axis = Vec3::Unit(side).cross(edge);
      if (separates(axis, corners, half.dot(axis.cwiseAbs())))
      {
        return false;
      }
    }
  }
  return true;
}

} // namespace evolving
