// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Features/FaceNormals.h"

#include "Mesh/Angles.h"
#include "Trees/TriangleGeometry.h"

#include <algorithm>
#include <queue>

namespace evolving
{

namespace
{

constexpr double LowestHeight = 1e-6; ///< of a triangle with a plane, over the diagonal

/// Zero for a sliver.
Vec3 ownNormal(const Triangle& triangle, double lowest)
{
  double longest = 0.0;
  for (std::size_t k = 0; k < 3; ++k)
  {
    longest = std::max(longest, (triangle.corners[(k + 1) % 3] - triangle.corners[k]).norm());
  }
  const Vec3 normal = triangle.doubleAreaNormal();
  const double size = normal.norm();
  return isDegenerate(triangle) || !(size > lowest * longest) ? Vec3::Zero() : Vec3(normal / size);
}

/// Do two corners along the same edge run opposite ways, as in a consistently oriented mesh?
bool agree(const SurfaceMesh& mesh, Index cornerA, Index cornerB)
{
  return TriangleEdges::runsUpwards(mesh, cornerA) != TriangleEdges::runsUpwards(mesh, cornerB);
}

/// Hands normals on to slivers, over the longest edges first (Prim's algorithm).
class NormalSpreading
{
public:
  NormalSpreading(const TargetTriangles& target, std::vector<Vec3>& normals)
    : Target(target)
    , Normals(normals)
  {
  }
  void run()
  {
    for (Index face = 0; face < this->Target.mesh().faceCount(); ++face)
    {
      if (this->isSliver(face))
      {
        this->pushFromNeighbours(face);
      }
    }
    while (!this->Pending.empty())
    {
      const Step step = this->Pending.top();
      this->Pending.pop();
      this->take(step);
    }
  }

private:
  struct Step
  {
    double length;
    Index to;   ///< the corner of the sliver
    Index from; ///< the corner along the same edge of a face with a normal
    bool operator<(const Step& other) const
    {
      return this->length != other.length ? this->length < other.length : this->to > other.to;
    }
  };

  bool isSliver(Index face) const { return this->Normals[at(face)].isZero(); }

  void take(const Step& step)
  {
    const Index face = TargetTriangles::faceOf(step.to);
    if (!this->isSliver(face))
    {
      return;
    }
    const Vec3& normal = this->Normals[at(TargetTriangles::faceOf(step.from))];
    this->Normals[at(face)] = agree(this->Target.mesh(), step.to, step.from) ? normal : -normal;
    for (Index k = 0; k < 3; ++k)
    {
      const Index edge = this->Target.edgeOfFace(face, k);
      for (const Index* c = this->Target.edges().begin(edge); c != this->Target.edges().end(edge);
           ++c)
      {
        if (this->isSliver(TargetTriangles::faceOf(*c)))
        {
          this->Pending.push({ this->Target.edgeLength(edge), *c, 3 * face + k });
        }
      }
    }
  }

  void pushFromNeighbours(Index face)
  {
    for (Index corner = 3 * face; corner < 3 * face + 3; ++corner)
    {
      const Index edge = this->Target.edges().edgeOf(corner);
      const Index* last = this->Target.edges().end(edge);
      const Index* from = std::find_if(this->Target.edges().begin(edge), last,
        [this](Index c) { return !this->isSliver(TargetTriangles::faceOf(c)); });
      if (from != last)
      {
        this->Pending.push({ this->Target.edgeLength(edge), corner, *from });
      }
    }
  }

  const TargetTriangles& Target;
  std::vector<Vec3>& Normals;
  std::priority_queue<Step> Pending;
};

} // namespace

std::vector<Vec3> faceNormals(const TargetTriangles& target)
{
  const SurfaceMesh& mesh = target.mesh();
  const double lowest = LowestHeight * boundingBox(mesh).diagonal().norm();
  std::vector<Vec3> normals;
  normals.reserve(at(mesh.faceCount()));
  for (Index face = 0; face < mesh.faceCount(); ++face)
  {
    normals.push_back(ownNormal(triangleOf(mesh, face), lowest));
  }
  NormalSpreading(target, normals).run();
  return normals;
}

double foldAngle(
  const TargetTriangles& target, const std::vector<Vec3>& normals, Index cornerA, Index cornerB)
{
  const Vec3& a = normals[at(TargetTriangles::faceOf(cornerA))];
  const Vec3& b = normals[at(TargetTriangles::faceOf(cornerB))];
  const bool comparable = agree(target.mesh(), cornerA, cornerB);
  return angleBetween(a, comparable ? b : Vec3(-b)) * DegreesPerRadian;
}

} // namespace evolving
