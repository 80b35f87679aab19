// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "StartSurface/PrimitiveSurfaces.h"

#include "Errors.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>
#include <unordered_map>
#include <utility>

namespace evolving
{

namespace
{

constexpr double QuarterPi = 0.78539816339744830962;

void requireInRange(const char* what, int value, int lowest, int highest)
{
  if (value < lowest || value > highest)
  {
    std::ostringstream message;
    message << "The " << what << " is " << value << ", expected " << lowest << " to " << highest
            << "; choose a value in this range.";
    throw InputError(message.str());
  }
}

void requirePlaceable(const Vec3& scale, const Vec3& centre)
{
  if (!(scale.minCoeff() > 0.0) || !scale.allFinite() || !centre.allFinite())
  {
    std::ostringstream message;
    message << "The start surface has a Radius, or half sides, of (" << scale.transpose()
            << ") and the Center (" << centre.transpose()
            << "), expected positive finite lengths and a finite place; correct what is not.";
    throw InputError(message.str());
  }
}

void place(SurfaceMesh& mesh, const Vec3& scale, const Vec3& centre)
{
  requirePlaceable(scale, centre);
  for (Vec3& point : mesh.points)
  {
    point = centre + scale.cwiseProduct(point);
  }
}

/// Counter-clockwise from outside, over the vertices as icosahedron() numbers them.
constexpr Index IcosahedronTriangles[20][3] = { { 0, 4, 2 }, { 0, 2, 5 }, { 0, 8, 4 }, { 0, 5, 10 },
  { 0, 10, 8 }, { 1, 3, 6 }, { 1, 7, 3 }, { 1, 6, 8 }, { 1, 10, 7 }, { 1, 8, 10 }, { 2, 4, 9 },
  { 2, 11, 5 }, { 2, 9, 11 }, { 3, 9, 6 }, { 3, 7, 11 }, { 3, 11, 9 }, { 4, 8, 6 }, { 4, 6, 9 },
  { 5, 7, 10 }, { 5, 11, 7 } };

SurfaceMesh icosahedron()
{
  SurfaceMesh mesh;
  const double golden = 0.5 * (1.0 + std::sqrt(5.0));
  for (int axis = 0; axis < 3; ++axis)
  {
    for (const double shortSide : { -1.0, 1.0 })
    {
      for (const double longSide : { -golden, golden })
      {
        Vec3 point = Vec3::Zero();
        point[(axis + 1) % 3] = shortSide;
        point[(axis + 2) % 3] = longSide;
        mesh.addPoint(point.normalized());
      }
    }
  }
  for (const auto& triangle : IcosahedronTriangles)
  {
    mesh.addFace({ triangle[0], triangle[1], triangle[2] });
  }
  return mesh;
}

/// Adds each edge's midpoint, projected to the unit sphere, once.
class Midpoints
{
public:
  explicit Midpoints(std::vector<Vec3>& points, std::size_t edgeCount)
    : Points(points)
  {
    this->OfEdge.reserve(edgeCount);
  }
  Index between(Index a, Index b)
  {
    const auto low = static_cast<std::uint64_t>(std::min(a, b));
    const auto high = static_cast<std::uint64_t>(std::max(a, b));
    const auto next = static_cast<Index>(this->Points.size());
    const auto entry = this->OfEdge.try_emplace((high << 32U) | low, next);
    if (entry.second)
    {
      const Vec3 sum = this->Points[low] + this->Points[high];
      this->Points.push_back(sum.normalized());
    }
    return entry.first->second;
  }

private:
  std::vector<Vec3>& Points;
  std::unordered_map<std::uint64_t, Index> OfEdge;
};

SurfaceMesh quartered(const SurfaceMesh& coarse)
{
  SurfaceMesh fine;
  fine.points = coarse.points;
  Midpoints midpoints(fine.points, coarse.cornerVertices.size() / 2);
  for (Index face = 0; face < coarse.faceCount(); ++face)
  {
    const Index a = coarse.faceVertex(face, 0);
    const Index b = coarse.faceVertex(face, 1);
    const Index c = coarse.faceVertex(face, 2);
    const Index ab = midpoints.between(a, b);
    const Index bc = midpoints.between(b, c);
    const Index ca = midpoints.between(c, a);
    fine.addFace({ a, ab, ca });
    fine.addFace({ ab, b, bc });
    fine.addFace({ ca, bc, c });
    fine.addFace({ ab, bc, ca });
  }
  return fine;
}

/// The vertices of a cube's surface, named by lattice coordinates from 0 to divisions.
class CubeLattice
{
public:
  explicit CubeLattice(int divisions)
    : Divisions(divisions)
  {
    const auto count = static_cast<std::size_t>(divisions);
    this->Vertices.reserve(6 * count * count + 2);
  }
  /// Adds the quad between two lattice corners of a side; u x v is the outward direction.
  void addQuad(std::array<int, 3> corner, int u, int v)
  {
    std::array<Index, 4> quad{};
    quad[0] = this->vertex(corner);
    ++corner[static_cast<std::size_t>(u)];
    quad[1] = this->vertex(corner);
    ++corner[static_cast<std::size_t>(v)];
    quad[2] = this->vertex(corner);
    --corner[static_cast<std::size_t>(u)];
    quad[3] = this->vertex(corner);
    this->Mesh.addFace({ quad[0], quad[1], quad[2], quad[3] });
  }
  SurfaceMesh takeMesh() { return std::move(this->Mesh); }

private:
  Index vertex(const std::array<int, 3>& lattice)
  {
    const auto side = static_cast<GridIndex>(this->Divisions) + 1;
    const GridIndex name = lattice[0] + side * (lattice[1] + side * lattice[2]);
    const auto entry = this->Vertices.try_emplace(name, this->Mesh.vertexCount());
    if (entry.second)
    {
      this->Mesh.addPoint(Vec3(
        this->coordinate(lattice[0]), this->coordinate(lattice[1]), this->coordinate(lattice[2])));
    }
    return entry.first->second;
  }
  /// From -1 to 1, the same bits with opposite sign on either side of the middle.
  double coordinate(int lattice) const
  {
    return static_cast<double>(2 * lattice - this->Divisions) / this->Divisions;
  }

  int Divisions;
  SurfaceMesh Mesh;
  std::unordered_map<GridIndex, Index> Vertices;
};

/// The cube [-1, 1]^3 with divisions x divisions equal quads a side.
SurfaceMesh dividedCube(int divisions)
{
  requireInRange("number of divisions", divisions, 1, MaximumCubeDivisions);
  CubeLattice lattice(divisions);
  for (int axis = 0; axis < 3; ++axis)
  {
    const int u = (axis + 1) % 3;
    const int v = (axis + 2) % 3;
    for (const bool upper : { false, true })
    {
      for (int j = 0; j < divisions; ++j)
      {
        for (int i = 0; i < divisions; ++i)
        {
          std::array<int, 3> corner{};
          corner[static_cast<std::size_t>(axis)] = upper ? divisions : 0;
          corner[static_cast<std::size_t>(u)] = i;
          corner[static_cast<std::size_t>(v)] = j;
          lattice.addQuad(corner, upper ? u : v, upper ? v : u);
        }
      }
    }
  }
  return lattice.takeMesh();
}

} // namespace

SurfaceMesh icosphere(int level, double radius, const Vec3& centre)
{
  requireInRange("icosphere level", level, 0, MaximumIcosphereLevel);
  SurfaceMesh mesh = icosahedron();
  for (int step = 0; step < level; ++step)
  {
    mesh = quartered(mesh);
  }
  place(mesh, Vec3::Constant(radius), centre);
  return mesh;
}

SurfaceMesh cubeSphere(int divisions, double radius, const Vec3& centre)
{
  SurfaceMesh mesh = dividedCube(divisions);
  for (Vec3& point : mesh.points)
  {
    // Equal steps of the angle instead of equal steps along the cube's edge.
    point = (QuarterPi * point).array().tan().matrix().normalized().eval();
  }
  place(mesh, Vec3::Constant(radius), centre);
  return mesh;
}

SurfaceMesh subdividedBox(int divisions, const Vec3& halfSides, const Vec3& centre)
{
  SurfaceMesh mesh = dividedCube(divisions);
  place(mesh, halfSides, centre);
  return mesh;
}

} // namespace evolving
