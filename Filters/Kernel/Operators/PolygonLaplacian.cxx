// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Operators/PolygonLaplacian.h"

#include <Eigen/Dense>

#include <algorithm>

namespace evolving
{

namespace
{

/// Twice the smallest area of a triangle, in units of its longest edge's square.
constexpr double SmallestDoubleArea = 1e-8;

Vec3 meanOf(const std::vector<Vec3>& points)
{
  Vec3 sum = Vec3::Zero();
  for (const Vec3& point : points)
  {
    sum += point;
  }
  return sum / static_cast<double>(points.size());
}

/**
 * Minimises sum_i |(x_i+1 - x_i) x (x - x_i)|^2 over points x relative to `centre`. A direction
 * in which nothing changes (all edges parallel) keeps the centre.
 */
Vec3 smallestFanPoint(const std::vector<Vec3>& corners, const Vec3& centre)
{
  Eigen::Matrix3d A = Eigen::Matrix3d::Zero();
  Vec3 b = Vec3::Zero();
  for (std::size_t i = 0; i < corners.size(); ++i)
  {
    const Vec3 edge = corners[(i + 1) % corners.size()] - corners[i];
    const Eigen::Matrix3d term =
      edge.squaredNorm() * Eigen::Matrix3d::Identity() - edge * edge.transpose();
    A += term;
    b += term * (corners[i] - centre);
  }
  const Eigen::LDLT<Eigen::Matrix3d> factors(A);
  const Vec3 pivots = factors.vectorD();
  const bool regular = pivots.minCoeff() > 1e-12 * pivots.maxCoeff();
  return regular ? Vec3(factors.solve(b)) : Vec3(Vec3::Zero());
}

/// The weights of smallest norm with sum 1 whose combination of the corners is centre + offset.
std::vector<double> smallestWeights(
  const std::vector<Vec3>& corners, const Vec3& centre, const Vec3& offset)
{
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
  for (const Vec3& corner : corners)
  {
    covariance += (corner - centre) * (corner - centre).transpose();
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> eigen(covariance);
  const double largest = eigen.eigenvalues()[2];
  Vec3 multiplier = Vec3::Zero();
  for (int k = 0; k < 3; ++k)
  {
    const Vec3 axis = eigen.eigenvectors().col(k);
    if (eigen.eigenvalues()[k] > 1e-12 * largest) // planar polygons have a zero one
    {
      multiplier += axis * (axis.dot(offset) / eigen.eigenvalues()[k]);
    }
  }
  std::vector<double> weights;
  for (const Vec3& corner : corners)
  {
    weights.push_back(1.0 / static_cast<double>(corners.size()) + multiplier.dot(corner - centre));
  }
  return weights;
}

void computeTriangleStencil(const std::vector<Vec3>& corners, FaceStencil& stencil)
{
  const std::array<double, 3> w = halfCotangents(corners[0], corners[1], corners[2]);
  stencil.pairWeights.assign({ w[2], w[1], w[0], w[2], w[1], w[0] });
  stencil.cornerAreas.assign(3, triangleArea(corners[0], corners[1], corners[2]) / 3.0);
}

/// The triangles of a fan before folding: areas, and the weights of their edges.
struct Fan
{
  std::vector<double> area;       ///< of triangle (i, i + 1, virtual)
  std::vector<double> edgeWeight; ///< of edge (i, i + 1)
  std::vector<double> spoke;      ///< of edge (i, virtual), from both its triangles

  Fan(const std::vector<Vec3>& corners, const Vec3& apex)
    : area(corners.size())
    , edgeWeight(corners.size())
    , spoke(corners.size(), 0.0)
  {
    for (std::size_t i = 0; i < corners.size(); ++i)
    {
      const std::size_t next = (i + 1) % corners.size();
      const std::array<double, 3> w = halfCotangents(corners[i], corners[next], apex);
      this->area[i] = triangleArea(corners[i], corners[next], apex);
      this->edgeWeight[i] = w[2];
      this->spoke[i] += w[1];
      this->spoke[next] += w[0];
    }
  }
};

double sumOf(const std::vector<double>& values)
{
  double sum = 0.0;
  for (const double value : values)
  {
    sum += value;
  }
  return sum;
}

void computePolygonStencil(const std::vector<Vec3>& corners, FaceStencil& stencil)
{
  const std::size_t n = corners.size();
  const VirtualVertex apex = virtualVertex(corners);
  const std::vector<double>& p = apex.weights;
  const Fan fan(corners, apex.point);
  const double spokes = sumOf(fan.spoke);
  const double area = sumOf(fan.area);
  stencil.pairWeights.clear();
  stencil.cornerAreas.clear();
  for (std::size_t i = 0; i < n; ++i)
  {
    const std::size_t last = (i + n - 1) % n;
    for (std::size_t j = (i + 1) % n; j != i; j = (j + 1) % n)
    {
      const double edge =
        (j == (i + 1) % n ? fan.edgeWeight[i] : 0.0) + (j == last ? fan.edgeWeight[j] : 0.0);
      const double folded = fan.spoke[i] * p[j] + fan.spoke[j] * p[i] - spokes * (p[i] * p[j]);
      stencil.pairWeights.push_back(edge + folded);
    }
    stencil.cornerAreas.push_back((fan.area[i] + fan.area[last] + p[i] * area) / 3.0);
  }
}

/// Area times gradient of the linear function with the values f at a triangle's corners.
Vec3 areaTimesGradient(const Vec3& a, const Vec3& b, const Vec3& c, const std::array<double, 3>& f)
{
  const Vec3 normal = (b - a).cross(c - a);
  const double doubleArea = normal.norm();
  // Differences only: a constant function has an exactly vanishing gradient.
  const Vec3 rotated = (f[1] - f[0]) * (a - c) + (f[2] - f[0]) * (b - a);
  return (doubleArea > 0.0 ? 0.5 / doubleArea : 0.0) * normal.cross(rotated);
}

} // namespace

std::array<double, 3> halfCotangents(const Vec3& a, const Vec3& b, const Vec3& c)
{
  const Vec3 ab = b - a;
  const Vec3 bc = c - b;
  const Vec3 ca = a - c;
  const double longest = std::max({ ab.squaredNorm(), bc.squaredNorm(), ca.squaredNorm() });
  const double doubleArea = std::max(ab.cross(ca).norm(), SmallestDoubleArea * longest);
  if (!(doubleArea > 0.0))
  {
    return { 0.0, 0.0, 0.0 };
  }
  const double scale = -0.5 / doubleArea;
  return { scale * ab.dot(ca), scale * bc.dot(ab), scale * ca.dot(bc) };
}

double triangleArea(const Vec3& a, const Vec3& b, const Vec3& c)
{
  return 0.5 * (b - a).cross(c - a).norm();
}

VirtualVertex virtualVertex(const std::vector<Vec3>& corners)
{
  const Vec3 centre = meanOf(corners);
  VirtualVertex vertex;
  vertex.weights = smallestWeights(corners, centre, smallestFanPoint(corners, centre));
  vertex.point = centre;
  for (std::size_t i = 0; i < corners.size(); ++i)
  {
    vertex.point += vertex.weights[i] * (corners[i] - centre);
  }
  return vertex;
}

void computeFaceStencil(const std::vector<Vec3>& corners, FaceStencil& stencil)
{
  if (corners.size() == 3)
  {
    computeTriangleStencil(corners, stencil);
  }
  else
  {
    computePolygonStencil(corners, stencil);
  }
}

void computeFaceGradient(const std::vector<Vec3>& corners, const std::vector<double>& values,
  std::vector<Vec3>& cornerGradients)
{
  const std::size_t n = corners.size();
  const VirtualVertex apex = virtualVertex(corners);
  double apexValue = 0.0;
  for (std::size_t i = 0; i < n; ++i)
  {
    apexValue += apex.weights[i] * values[i];
  }
  cornerGradients.assign(n, Vec3::Zero());
  Vec3 sum = Vec3::Zero();
  for (std::size_t i = 0; i < n; ++i)
  {
    const std::size_t next = (i + 1) % n;
    const Vec3 third = areaTimesGradient(corners[i], corners[next], apex.point,
                         { values[i], values[next], apexValue }) /
      3.0;
    cornerGradients[i] += third;
    cornerGradients[next] += third;
    sum += third;
  }
  for (std::size_t i = 0; i < n; ++i)
  {
    cornerGradients[i] += apex.weights[i] * sum;
  }
}

} // namespace evolving
