// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Shapes/MeshVariants.h"

#include "Mesh/MeshTopology.h"
#include "Shapes/Draws.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <numeric>
#include <random>

namespace evolving::shapes
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

SurfaceMesh transformed(SurfaceMesh mesh, double scale, const Vec3& offset)
{
  for (Vec3& point : mesh.points)
  {
    point = scale * point + offset;
  }
  return mesh;
}

SurfaceMesh mapped(SurfaceMesh mesh, const Eigen::Matrix3d& matrix)
{
  for (Vec3& point : mesh.points)
  {
    point = matrix * point;
  }
  return mesh;
}

Eigen::Matrix3d someRotation()
{
  return Eigen::AngleAxisd(0.7, Vec3(1.0, 2.0, 3.0).normalized()).toRotationMatrix();
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

Vec3 randomPoint(std::mt19937& generator)
{
  std::uniform_real_distribution<double> coordinate(-1.0, 1.0);
  const double x = coordinate(generator);
  const double y = coordinate(generator);
  return { x, y, coordinate(generator) };
}

SurfaceMesh shaken(SurfaceMesh mesh, double amount, unsigned seed)
{
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> shift(-amount, amount);
  for (Vec3& p : mesh.points)
  {
    p += drawnVector(shift, random);
  }
  return mesh;
}

SurfaceMesh shakenInside(SurfaceMesh mesh, double amount, unsigned seed)
{
  const MeshTopology topology(mesh);
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> shift(-amount, amount);
  for (Index i = 0; i < mesh.vertexCount(); ++i)
  {
    const Vec3 move = drawnInPlane(shift, random);
    mesh.points[static_cast<std::size_t>(i)] += topology.isBoundary(i) ? Vec3(Vec3::Zero()) : move;
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

SurfaceMesh fanned(const SurfaceMesh& mesh)
{
  SurfaceMesh triangles;
  triangles.points = mesh.points;
  for (Index face = 0; face < mesh.faceCount(); ++face)
  {
    for (Index k = 1; k + 1 < mesh.faceSize(face); ++k)
    {
      triangles.addFace(
        { mesh.faceVertex(face, 0), mesh.faceVertex(face, k), mesh.faceVertex(face, k + 1) });
    }
  }
  return triangles;
}

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

SurfaceMesh merged(SurfaceMesh first, const SurfaceMesh& second)
{
  const Index offset = first.vertexCount();
  first.points.insert(first.points.end(), second.points.begin(), second.points.end());
  for (Index face = 0; face < second.faceCount(); ++face)
  {
    std::vector<Index> vertices = faceVertices(second, face);
    for (Index& vertex : vertices)
    {
      vertex += offset;
    }
    first.addFace(vertices);
  }
  return first;
}

SurfaceMesh randomSoup(int count, double size, std::uint32_t seed)
{
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  const auto vector = [&] { return drawnVector(uniform, random); };
  SurfaceMesh mesh;
  for (int t = 0; t < count; ++t)
  {
    const Vec3 a = vector();
    const Vec3 b = t % 16 == 15 ? a : Vec3(a + size * vector());
    const Vec3 c = t % 8 == 7 ? Vec3(0.5 * (a + b)) : Vec3(a + size * vector());
    mesh.addFace({ mesh.addPoint(a), mesh.addPoint(b), mesh.addPoint(c) });
  }
  return mesh;
}

} // namespace evolving::shapes
