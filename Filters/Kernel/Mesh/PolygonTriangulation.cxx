// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Mesh/PolygonTriangulation.h"

#include "Mesh/PlanePointTree.h"

#include <cmath>
#include <queue>
#include <utility>

namespace evolving
{

namespace
{

/// The corners as seen along a normal, from the first; all in one place without a normal.
std::vector<Vec2> projected(const std::vector<Vec3>& corners, const Vec3& normal)
{
  const double largest = normal.cwiseAbs().maxCoeff();
  if (!std::isnormal(largest))
  {
    return std::vector<Vec2>(corners.size(), Vec2::Zero());
  }
  const Vec3 z = normal / largest;
  const Vec3 x = z.unitOrthogonal();
  const Vec3 y = z.cross(x).normalized();
  std::vector<Vec2> points;
  points.reserve(corners.size());
  for (const Vec3& corner : corners)
  {
    points.emplace_back((corner - corners[0]).dot(x), (corner - corners[0]).dot(y));
  }
  return points;
}

Vec3 normalOf(const std::vector<Vec3>& corners)
{
  Vec3 normal = Vec3::Zero();
  for (std::size_t k = 1; k + 1 < corners.size(); ++k)
  {
    normal += (corners[k] - corners[0]).cross(corners[k + 1] - corners[0]);
  }
  return normal;
}

/**
 * A polygon from which triangles are cut off one by one: a convex corner whose triangle contains
 * no other corner, of these the one with the shortest cut; without one, the second corner left.
 *
 * Corners wait in the order of their cuts. One that is no ear has a corner in its triangle, and
 * need not be looked at again before that is cut off or a neighbour is.
 */
class EarClipping
{
public:
  explicit EarClipping(const std::vector<Vec3>& corners)
    : Corners(corners)
    , Normal(normalOf(corners))
    , Seen(projected(corners, this->Normal))
    , Left(this->Seen)
    , Neighbours(corners.size())
    , Version(corners.size(), 0)
    , Blocked(corners.size())
    , BlockedByEdges(corners.size())
  {
    const auto count = static_cast<Index>(corners.size());
    for (Index k = 0; k < count; ++k)
    {
      this->Neighbours[at(k)] = { k == 0 ? count - 1 : k - 1, k + 1 == count ? 0 : k + 1 };
    }
    for (Index k = 0; k < count; ++k)
    {
      this->enqueue(k);
    }
  }

  std::array<Index, 3> clip()
  {
    const Index ear = this->bestEar();
    const auto [before, after] = this->Neighbours[at(ear)];
    this->Left.remove(ear);
    this->Neighbours[at(before)].second = after;
    this->Neighbours[at(after)].first = before;
    this->First = ear == this->First ? after : this->First;
    ++this->Version[at(ear)];
    this->renew(before);
    this->renew(after);
    this->reconsider(this->Blocked[at(ear)]);
    return { before, ear, after };
  }

private:
  /// A corner with the neighbours that it had.
  struct Waiting
  {
    Index corner;
    int version;
  };
  struct Candidate
  {
    double squaredCut;
    Waiting waiting;

    /// Is another one the better?
    bool operator<(const Candidate& other) const
    {
      return this->squaredCut != other.squaredCut ? this->squaredCut > other.squaredCut
                                                  : this->waiting.corner > other.waiting.corner;
    }
  };

  const Vec3& corner(Index k) const { return this->Corners[at(k)]; }
  /// Twice the area of a triangle as seen along the normal.
  double area(const Vec3& a, const Vec3& b, const Vec3& c) const
  {
    return this->Normal.dot((b - a).cross(c - a));
  }

  void enqueue(Index k)
  {
    const auto [before, after] = this->Neighbours[at(k)];
    const double squaredCut = (this->corner(after) - this->corner(before)).squaredNorm();
    this->Candidates.push({ squaredCut, { k, this->Version[at(k)] } });
  }

  /// For a corner with a new neighbour.
  void renew(Index k)
  {
    ++this->Version[at(k)];
    this->enqueue(k);
    this->reconsider(this->BlockedByEdges[at(k)]);
    this->BlockedByEdges[at(k)].clear();
  }

  void reconsider(const std::vector<Waiting>& corners)
  {
    for (const Waiting& waiting : corners)
    {
      if (waiting.version == this->Version[at(waiting.corner)])
      {
        this->enqueue(waiting.corner);
      }
    }
  }

  Index bestEar()
  {
    while (!this->Candidates.empty())
    {
      const Waiting best = this->Candidates.top().waiting;
      this->Candidates.pop();
      if (best.version == this->Version[at(best.corner)] && this->isEar(best))
      {
        return best.corner;
      }
    }
    return this->Neighbours[at(this->First)].second;
  }

  /// Is a corner in the place of a triangle's corner, from where its edges do not enter the
  /// triangle? Polygons with holes have such twins at the ends of the slits that lead there.
  bool isTwinOutside(Index twin, const std::array<Index, 3>& triangle) const
  {
    const Vec3& p = this->corner(twin);
    for (std::size_t k = 0; k < 3; ++k)
    {
      if (this->corner(triangle[k]) == p)
      {
        const Vec3& next = this->corner(triangle[(k + 1) % 3]);
        const Vec3& last = this->corner(triangle[(k + 2) % 3]);
        const auto enters = [&](Index to)
        {
          return this->area(p, next, this->corner(to)) > 0.0 &&
            this->area(p, this->corner(to), last) > 0.0;
        };
        const auto [before, after] = this->Neighbours[at(twin)];
        return !enters(before) && !enters(after);
      }
    }
    return false;
  }

  /// Notes down what it waits for if it is none.
  bool isEar(const Waiting& candidate)
  {
    const auto [before, after] = this->Neighbours[at(candidate.corner)];
    const Vec3& a = this->corner(before);
    const Vec3& b = this->corner(candidate.corner);
    const Vec3& c = this->corner(after);
    if (!(this->area(a, b, c) > 0.0))
    {
      return false;
    }
    const std::array<Index, 3> own{ before, candidate.corner, after };
    const auto blocks = [&](Index other)
    {
      const Vec3& p = this->corner(other);
      const bool isInside = other != own[0] && other != own[1] && other != own[2] &&
        this->area(a, b, p) >= 0.0 && this->area(b, c, p) >= 0.0 && this->area(c, a, p) >= 0.0 &&
        !this->isTwinOutside(other, own);
      if (isInside)
      {
        this->Blocked[at(other)].push_back(candidate);
        if (p == a || p == b || p == c)
        {
          this->BlockedByEdges[at(other)].push_back(candidate);
        }
      }
      return isInside;
    };
    return !this->Left.visitTriangle(
      { this->Seen[at(own[0])], this->Seen[at(own[1])], this->Seen[at(own[2])] }, blocks);
  }

  const std::vector<Vec3>& Corners;
  Vec3 Normal;
  std::vector<Vec2> Seen; ///< along the normal
  PlanePointTree Left;
  std::vector<std::pair<Index, Index>> Neighbours;  ///< left before and after each
  std::vector<int> Version;                         ///< of a corner's neighbours
  std::vector<std::vector<Waiting>> Blocked;        ///< by each corner
  std::vector<std::vector<Waiting>> BlockedByEdges; ///< of each corner, a twin of one of theirs
  std::priority_queue<Candidate> Candidates;
  Index First = 0; ///< that is left
};

} // namespace

std::vector<std::array<Index, 3>> triangulatePolygon(
  const std::vector<Vec3>& corners, const Execution& execution)
{
  std::vector<std::array<Index, 3>> triangles;
  if (corners.size() < 3)
  {
    return triangles;
  }
  constexpr std::size_t Step = 1024; // far less than a second
  triangles.reserve(corners.size() - 2);
  EarClipping polygon(corners);
  while (triangles.size() < corners.size() - 2)
  {
    triangles.push_back(polygon.clip());
    if (triangles.size() % Step == 0)
    {
      execution.report(static_cast<double>(triangles.size()) / static_cast<double>(corners.size()));
    }
  }
  return triangles;
}

SurfaceMesh triangulate(
  const SurfaceMesh& mesh, std::vector<Index>& oldFace, const Execution& execution)
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
    const double begin = static_cast<double>(face) / mesh.faceCount();
    const double end = static_cast<double>(face + 1) / mesh.faceCount();
    for (const auto& triangle : triangulatePolygon(corners, execution.phase(begin, end)))
    {
      triangles.addFace({ mesh.faceVertex(face, triangle[0]), mesh.faceVertex(face, triangle[1]),
        mesh.faceVertex(face, triangle[2]) });
      oldFace.push_back(face);
    }
  }
  return triangles;
}

} // namespace evolving
