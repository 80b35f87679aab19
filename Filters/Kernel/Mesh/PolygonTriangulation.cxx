// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Mesh/PolygonTriangulation.h"

#include <algorithm>
#include <limits>
#include <numeric>

namespace evolving
{

namespace
{

/// A polygon from which triangles are cut off one by one.
class EarClipping
{
public:
  explicit EarClipping(const std::vector<Vec3>& corners)
    : Corners(corners)
    , Left(corners.size())
  {
    std::iota(this->Left.begin(), this->Left.end(), 0);
    for (std::size_t k = 1; k + 1 < corners.size(); ++k)
    {
      this->Normal += (corners[k] - corners[0]).cross(corners[k + 1] - corners[0]);
    }
  }

  std::array<Index, 3> clip()
  {
    const std::size_t ear = this->bestEar();
    const std::array<Index, 3> triangle{ this->left(ear + this->Left.size() - 1), this->left(ear),
      this->left(ear + 1) };
    this->Left.erase(this->Left.begin() + static_cast<std::ptrdiff_t>(ear));
    return triangle;
  }

private:
  Index left(std::size_t k) const { return this->Left[k % this->Left.size()]; }
  const Vec3& corner(std::size_t k) const
  {
    return this->Corners[static_cast<std::size_t>(this->left(k))];
  }
  /// Twice the area of a triangle as seen along the normal.
  double area(const Vec3& a, const Vec3& b, const Vec3& c) const
  {
    return this->Normal.dot((b - a).cross(c - a));
  }

  /// A convex corner whose triangle contains no other; without one, any corner.
  std::size_t bestEar() const
  {
    std::size_t best = 1;
    double shortest = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < this->Left.size(); ++k)
    {
      const double cut =
        (this->corner(k + 1) - this->corner(k + this->Left.size() - 1)).squaredNorm();
      if (cut < shortest && this->isEar(k))
      {
        best = k;
        shortest = cut;
      }
    }
    return best;
  }

  bool isEar(std::size_t k) const
  {
    const Vec3& a = this->corner(k + this->Left.size() - 1);
    const Vec3& b = this->corner(k);
    const Vec3& c = this->corner(k + 1);
    if (!(this->area(a, b, c) > 0.0))
    {
      return false;
    }
    for (std::size_t other = k + 2; other < k + this->Left.size() - 1; ++other)
    {
      const Vec3& p = this->corner(other);
      if (this->area(a, b, p) >= 0.0 && this->area(b, c, p) >= 0.0 && this->area(c, a, p) >= 0.0)
      {
        return false;
      }
    }
    return true;
  }

  const std::vector<Vec3>& Corners;
  std::vector<Index> Left;
  Vec3 Normal = Vec3::Zero();
};

} // namespace

std::vector<std::array<Index, 3>> triangulatePolygon(const std::vector<Vec3>& corners)
{
  std::vector<std::array<Index, 3>> triangles;
  EarClipping polygon(corners);
  for (std::size_t k = 2; k < corners.size(); ++k)
  {
    triangles.push_back(polygon.clip());
  }
  return triangles;
}

SurfaceMesh triangulate(const SurfaceMesh& mesh, std::vector<Index>& oldFace)
{
  SurfaceMesh triangles;
  triangles.points = mesh.points;
  triangles.cornerVertices.reserve(mesh.cornerVertices.size());
  triangles.faceOffsets.reserve(mesh.faceOffsets.size());
  oldFace.clear();
  std::vector<Vec3> corners;
  for (Index face = 0; face < mesh.faceCount(); ++face)
  {
    if (mesh.faceSize(face) == 3)
    {
      triangles.addFace(
        { mesh.faceVertex(face, 0), mesh.faceVertex(face, 1), mesh.faceVertex(face, 2) });
      oldFace.push_back(face);
      continue;
    }
    corners.clear();
    for (Index k = 0; k < mesh.faceSize(face); ++k)
    {
      corners.push_back(mesh.facePoint(face, k));
    }
    for (const std::array<Index, 3>& triangle : triangulatePolygon(corners))
    {
      triangles.addFace({ mesh.faceVertex(face, triangle[0]), mesh.faceVertex(face, triangle[1]),
        mesh.faceVertex(face, triangle[2]) });
      oldFace.push_back(face);
    }
  }
  return triangles;
}

} // namespace evolving
