// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "LabelSurfaces/JunctionFit.h"

#include "LabelSurfaces/LocalVolumes.h"
#include "ParallelLoops.h"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>

namespace evolving
{

namespace
{

/// Beside the unit that a plane has: what holds a vertex where it is.
constexpr double Inertia = 0.1;
constexpr double CurveBending = 1.0;
/// Of nodes, where several curves end: so little that they do not pull at each other.
constexpr double NodeBending = 0.1;
constexpr double Tolerance = 1e-4;
/// Vertices per chunk: of some hundred points each.
constexpr std::int64_t FitGrain = 16;

Vec3 vectorAt(const std::vector<double>& x, Index i)
{
  return { x[at(3 * i)], x[at(3 * i + 1)], x[at(3 * i + 2)] };
}

void put(const Vec3& vector, Index i, std::vector<double>& x)
{
  std::copy(vector.data(), vector.data() + 3, x.begin() + 3 * i);
}

/// The inverses of the blocks of the diagonal.
class BlockDiagonal : public Preconditioner
{
public:
  explicit BlockDiagonal(std::vector<Eigen::Matrix3d> inverses)
    : Inverses(std::move(inverses))
  {
  }
  void apply(
    const std::vector<double>& r, std::vector<double>& z, const Execution& execution) override
  {
    z.resize(r.size());
    forEachIndex(execution, static_cast<std::int64_t>(this->Inverses.size()),
      [&](Index i) { put(this->Inverses[at(i)] * vectorAt(r, i), i, z); });
  }

private:
  std::vector<Eigen::Matrix3d> Inverses;
};

} // namespace

JunctionFit::JunctionFit(const InterfaceNet& net, const NetLimits& limits, double radius)
  : Net(net)
  , Limits(limits)
  , Ends(net, radius)
{
  for (Index i = 0; i < net.vertexCount(); ++i)
  {
    if (isInnerJunction(net, i))
    {
      this->Vertices.push_back(i);
    }
  }
  this->A = this->bendingMatrix();
  this->Transposed = this->A.transpose();
  this->Planes.resize(this->Vertices.size());
  this->Pulls.resize(this->Vertices.size());
}

/// Mean of the neighbours along curves less the vertex; nothing where one of them is not fitted.
SparseMatrix JunctionFit::bendingMatrix() const
{
  const auto count = static_cast<Index>(this->Vertices.size());
  const auto numberOf = [this](Index vertex)
  {
    const auto found = std::lower_bound(this->Vertices.begin(), this->Vertices.end(), vertex);
    return static_cast<Index>(found - this->Vertices.begin());
  };
  std::vector<Eigen::Triplet<double, Index>> entries;
  for (Index i = 0; i < count; ++i)
  {
    const Index vertex = this->Vertices[at(i)];
    std::vector<Index> others;
    bool areFitted = true;
    for (Index edge = this->Net.edgeOffsets[at(vertex)];
         edge < this->Net.edgeOffsets[at(vertex) + 1]; ++edge)
    {
      if (this->Net.isJunction[at(edge)] != 0)
      {
        others.push_back(this->Net.edgeEnds[at(edge)]);
        areFitted = areFitted && isInnerJunction(this->Net, others.back());
      }
    }
    if (!areFitted || others.empty())
    {
      continue;
    }
    const bool isCurve = this->Net.kinds[at(vertex)] == VertexKind::Curve;
    const double factor = std::sqrt(isCurve ? CurveBending : NodeBending);
    entries.emplace_back(i, i, -factor);
    for (const Index other : others)
    {
      entries.emplace_back(i, numberOf(other), factor / static_cast<double>(others.size()));
    }
  }
  SparseMatrix matrix(count, count);
  matrix.setFromTriplets(entries.begin(), entries.end());
  return matrix;
}

void JunctionFit::fit(Index number, const std::vector<Vec3>& points, const std::vector<Vec3>& areas)
{
  this->Planes[at(number)].setZero();
  this->Pulls[at(number)].setZero();
  if (!this->Limits.slides(this->Vertices[at(number)]))
  {
    return;
  }
  for (const SheetPlane& plane : this->Ends.planes(this->Vertices[at(number)], points, areas))
  {
    this->Planes[at(number)] += plane.weight * plane.normal * plane.normal.transpose();
    this->Pulls[at(number)] += plane.weight * plane.offset * plane.normal;
  }
}

std::vector<Vec3> JunctionFit::bending(const std::vector<Vec3>& x, const Execution& execution) const
{
  std::vector<Vec3> curvatures;
  multiply(this->A, x, curvatures, execution);
  std::vector<Vec3> bending;
  multiply(this->Transposed, curvatures, bending, execution);
  return bending;
}

void JunctionFit::apply(
  const std::vector<double>& x, std::vector<double>& y, const Execution& execution) const
{
  const auto count = static_cast<std::int64_t>(this->Vertices.size());
  std::vector<Vec3> moves(this->Vertices.size());
  forEachIndex(execution, count, [&](Index i) { moves[at(i)] = vectorAt(x, i); });
  const std::vector<Vec3> bent = this->bending(moves, execution);
  y.resize(x.size());
  forEachIndex(execution, count,
    [&](Index i)
    { put(Inertia * moves[at(i)] + this->Planes[at(i)] * moves[at(i)] + bent[at(i)], i, y); });
}

void JunctionFit::apply(std::vector<Vec3>& points, const Execution& execution)
{
  if (this->Vertices.empty())
  {
    return;
  }
  const auto count = static_cast<std::int64_t>(this->Vertices.size());
  const std::vector<Vec3> areas = sheetAreas(this->Net, points, execution);
  execution.phase(0.0, 0.8).forRangeReporting(count, FitGrain,
    [&](std::int64_t begin, std::int64_t end)
    {
      for (auto i = static_cast<Index>(begin); i < end; ++i)
      {
        this->fit(i, points, areas);
      }
    });
  std::vector<Vec3> own(this->Vertices.size());
  forEachIndex(execution, count, [&](Index i) { own[at(i)] = points[at(this->Vertices[at(i)])]; });
  const std::vector<Vec3> bent = this->bending(own, execution);
  std::vector<double> b(3 * own.size());
  std::vector<Eigen::Matrix3d> blocks(own.size());
  forEachIndex(execution, count,
    [&](Index i)
    {
      put(this->Pulls[at(i)] - bent[at(i)], i, b);
      double diagonal = Inertia;
      forEachEntry(this->Transposed, i, [&](Index, double value) { diagonal += value * value; });
      blocks[at(i)] = (this->Planes[at(i)] + diagonal * Eigen::Matrix3d::Identity()).inverse();
    });
  std::vector<double> moves;
  SolverLimits limits;
  limits.tolerance = Tolerance;
  BlockDiagonal inverses(std::move(blocks));
  minimalResidual(*this, b, moves, limits, inverses, execution.phase(0.8, 1.0));
  forEachIndex(
    execution, count, [&](Index i) { points[at(this->Vertices[at(i)])] += vectorAt(moves, i); });
}

} // namespace evolving
