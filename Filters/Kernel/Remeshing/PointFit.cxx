// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Remeshing/PointFit.h"

#include "Algebra/ConjugateGradients.h"
#include "ParallelLoops.h"
#include "Remeshing/InversionFreeMove.h"
#include "Trees/AABBTree.h"
#include "Trees/Barycentric.h"

#include <algorithm>
#include <limits>

namespace evolving
{

namespace
{

/// No vertex moves farther than this fraction of its size at once: two neighbours that come at each
/// other do not pass.
constexpr double LongestMove = 0.5;
/// Of the moves, which are found anew in the next iteration.
constexpr double SolverTolerance = 1e-6;

/// A point as a face sees it.
struct Attachment
{
  Index face = NoIndex;
  Vec3 weights = Vec3::Zero(); ///< of the face's corners
  Vec3 way = Vec3::Zero();     ///< from the surface to the point
};

std::vector<Attachment> attach(
  const EditableSurface& surface, const std::vector<Vec3>& points, const Execution& execution)
{
  const AABBTree tree(surface.mesh(), execution); // compact: faces and slots agree
  std::vector<Attachment> attachments(points.size());
  execution.forRange(static_cast<std::int64_t>(points.size()), Execution::MeshGrain,
    [&](std::int64_t begin, std::int64_t end)
    {
      for (auto i = static_cast<std::size_t>(begin); i < static_cast<std::size_t>(end); ++i)
      {
        const ClosestTriangle closest = tree.closest(points[i]);
        if (closest.triangle == NoIndex)
        {
          continue;
        }
        const Vec3 weights =
          barycentricCoordinates(tree.triangle(closest.triangle), closest.at.point);
        if (weights.allFinite())
        {
          attachments[i] = { closest.triangle, weights, points[i] - closest.at.point };
        }
      }
    });
  return attachments;
}

class PointFit
{
public:
  explicit PointFit(EditableSurface& surface)
    : Surface(surface)
    , Normals(at(surface.vertexSlots()))
    , RightSide(at(surface.vertexSlots()), 0.0)
  {
    for (Index v = 0; v < surface.vertexSlots(); ++v)
    {
      this->Normals[at(v)] = surface.normal(v);
    }
  }

  void add(const Attachment& a)
  {
    const Vec3 normal = this->Surface.doubleArea(a.face).stableNormalized();
    for (Index k = 0; k < 3; ++k)
    {
      const Index row = this->Surface.from(3 * a.face + k);
      const double slope = a.weights[k] * this->Normals[at(row)].dot(normal);
      this->RightSide[at(row)] += slope * a.way.dot(normal);
      for (Index l = 0; l < 3; ++l)
      {
        const Index column = this->Surface.from(3 * a.face + l);
        this->Entries.emplace_back(
          row, column, slope * a.weights[l] * this->Normals[at(column)].dot(normal));
      }
    }
  }

  void addStiffness(double stiffness)
  {
    for (Index e = 0; e < this->Surface.edgeSlots(); ++e)
    {
      const Index a = this->Surface.from(e);
      const Index b = this->Surface.to(e);
      this->Entries.emplace_back(a, a, stiffness);
      this->Entries.emplace_back(a, b, -stiffness);
    }
  }

  void move(const Execution& execution)
  {
    const Index count = this->Surface.vertexSlots();
    SparseMatrix matrix(count, count);
    matrix.setFromTriplets(this->Entries.begin(), this->Entries.end());
    SolverLimits limits;
    limits.tolerance = SolverTolerance;
    const std::vector<double> heights =
      approximateSolution(matrix, this->RightSide, limits, execution.phase(0.0, 0.0));
    std::vector<Vec3> points(at(count));
    for (Index v = 0; v < count; ++v)
    {
      const double most = LongestMove * this->Surface.size(v);
      points[at(v)] =
        this->Surface.point(v) + std::clamp(heights[at(v)], -most, most) * this->Normals[at(v)];
    }
    moveWithoutInversion(this->Surface, points, execution);
  }

private:
  EditableSurface& Surface;
  std::vector<Vec3> Normals;
  std::vector<Eigen::Triplet<double, Index>> Entries;
  std::vector<double> RightSide;
};

} // namespace

void fitToPoints(EditableSurface& surface, const std::vector<Vec3>& points, double stiffness,
  int iterations, const Execution& execution)
{
  surface.compact();
  if (surface.faceSlots() == 0)
  {
    return;
  }
  for (int i = 0; i < iterations; ++i)
  {
    PointFit fit(surface);
    for (const Attachment& attachment : attach(surface, points, execution))
    {
      if (attachment.face != NoIndex)
      {
        fit.add(attachment);
      }
    }
    fit.addStiffness(stiffness);
    fit.move(execution);
  }
}

} // namespace evolving
