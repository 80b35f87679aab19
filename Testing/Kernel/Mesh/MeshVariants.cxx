// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "MeshVariants.h"

#include <algorithm>
#include <numeric>

namespace evolving
{

namespace
{

std::vector<Index> faceVertices(const SurfaceMesh& mesh, Index face)
{
  std::vector<Index> vertices;
  for (Index k = 0; k < mesh.faceSize(face); ++k)
  {
    vertices.push_back(mesh.faceVertex(face, k));
  }
  return vertices;
}

} // namespace

SurfaceMesh triangulated(const SurfaceMesh& mesh, std::mt19937& generator)
{
  SurfaceMesh triangles;
  triangles.points = mesh.points;
  for (Index face = 0; face < mesh.faceCount(); ++face)
  {
    const Index size = mesh.faceSize(face);
    const Index apex = std::uniform_int_distribution<Index>(0, size - 1)(generator);
    for (Index k = 1; k + 1 < size; ++k)
    {
      triangles.addFace({ mesh.faceVertex(face, apex), mesh.faceVertex(face, (apex + k) % size),
        mesh.faceVertex(face, (apex + k + 1) % size) });
    }
  }
  return triangles;
}

SurfaceMesh soupOf(const SurfaceMesh& mesh)
{
  SurfaceMesh soup;
  for (Index face = 0; face < mesh.faceCount(); ++face)
  {
    std::vector<Index> vertices;
    for (Index k = 0; k < mesh.faceSize(face); ++k)
    {
      vertices.push_back(soup.addPoint(mesh.facePoint(face, k)));
    }
    soup.addFace(vertices);
  }
  return soup;
}

SurfaceMesh unionOf(const SurfaceMesh& first, const SurfaceMesh& second)
{
  SurfaceMesh both = first;
  both.points.insert(both.points.end(), second.points.begin(), second.points.end());
  for (Index face = 0; face < second.faceCount(); ++face)
  {
    std::vector<Index> vertices = faceVertices(second, face);
    for (Index& vertex : vertices)
    {
      vertex += first.vertexCount();
    }
    both.addFace(vertices);
  }
  return both;
}

SurfaceMesh moved(SurfaceMesh mesh, double scale, const Vec3& offset)
{
  for (Vec3& point : mesh.points)
  {
    point = scale * point + offset;
  }
  return mesh;
}

SurfaceMesh flipped(const SurfaceMesh& mesh)
{
  SurfaceMesh result;
  result.points = mesh.points;
  for (Index face = 0; face < mesh.faceCount(); ++face)
  {
    const std::vector<Index> vertices = faceVertices(mesh, face);
    result.addFace({ vertices.rbegin(), vertices.rend() });
  }
  return result;
}

Vec3 randomPoint(std::mt19937& generator)
{
  std::uniform_real_distribution<double> coordinate(-1.0, 1.0);
  const double x = coordinate(generator);
  const double y = coordinate(generator);
  return { x, y, coordinate(generator) };
}

Eigen::Matrix3d randomRotation(std::mt19937& generator)
{
  std::normal_distribution<double> normal;
  Eigen::Quaterniond quaternion;
  for (double& coefficient : quaternion.coeffs())
  {
    coefficient = normal(generator);
  }
  return quaternion.normalized().toRotationMatrix();
}

SurfaceMesh mapped(SurfaceMesh mesh, const Eigen::Matrix3d& matrix)
{
  for (Vec3& point : mesh.points)
  {
    point = matrix * point;
  }
  return mesh;
}

SurfaceMesh shuffled(const SurfaceMesh& mesh, std::mt19937& generator)
{
  std::vector<Index> number(mesh.points.size());
  std::vector<Index> order(static_cast<std::size_t>(mesh.faceCount()));
  std::iota(number.begin(), number.end(), 0);
  std::iota(order.begin(), order.end(), 0);
  std::shuffle(number.begin(), number.end(), generator);
  std::shuffle(order.begin(), order.end(), generator);
  SurfaceMesh result;
  result.points.resize(mesh.points.size());
  for (std::size_t v = 0; v < number.size(); ++v)
  {
    result.points[static_cast<std::size_t>(number[v])] = mesh.points[v];
  }
  for (const Index face : order)
  {
    const Index size = mesh.faceSize(face);
    const Index shift = std::uniform_int_distribution<Index>(0, size - 1)(generator);
    std::vector<Index> vertices;
    for (Index k = 0; k < size; ++k)
    {
      vertices.push_back(
        number[static_cast<std::size_t>(mesh.faceVertex(face, (k + shift) % size))]);
    }
    result.addFace(vertices);
  }
  return result;
}

} // namespace evolving
