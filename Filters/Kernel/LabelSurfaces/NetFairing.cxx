// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "LabelSurfaces/NetFairing.h"

#include "ParallelLoops.h"

#include <cmath>

namespace evolving
{

namespace
{

/// Of the mean of the outlines that end at a node: enough to take their stairs away where one is a
/// ladder of short edges, and so little that it does not pull labels' common points about.
constexpr double NodeWeight = 0.1;
/// A thousandth of a step's move, itself below a voxel.
constexpr double Tolerance = 1e-3;

double weightOf(VertexKind kind)
{
  return kind == VertexKind::Node ? NodeWeight : 1.0;
}

/// Does an edge count as one to a neighbour?
bool isNeighbour(const InterfaceNet& net, Index vertex, Index edge, bool hasJunctions)
{
  return net.kinds[at(vertex)] == VertexKind::Sheet || !hasJunctions ||
    net.isJunction[at(edge)] != 0;
}

/// The row of one vertex: mean of the neighbours less itself.
void addRow(const InterfaceNet& net, Index i, double factor, SparseMatrix& A)
{
  const Index begin = net.edgeOffsets[at(i)];
  const Index end = net.edgeOffsets[at(i) + 1];
  bool hasJunctions = false;
  for (Index edge = begin; edge < end; ++edge)
  {
    hasJunctions = hasJunctions || net.isJunction[at(edge)] != 0;
  }
  int count = 0;
  for (Index edge = begin; edge < end; ++edge)
  {
    count += isNeighbour(net, i, edge, hasJunctions) ? 1 : 0;
  }
  A.startVec(i);
  bool isDiagonalDone = false;
  for (Index edge = begin; edge < end; ++edge)
  {
    const Index other = net.edgeEnds[at(edge)];
    if (other > i && !isDiagonalDone)
    {
      A.insertBack(i, i) = -factor;
      isDiagonalDone = true;
    }
    if (isNeighbour(net, i, edge, hasJunctions))
    {
      A.insertBack(i, other) = factor / count;
    }
  }
  if (!isDiagonalDone)
  {
    A.insertBack(i, i) = -factor;
  }
}

SparseMatrix bendingMatrix(const InterfaceNet& net, double strength)
{
  SparseMatrix A(net.vertexCount(), net.vertexCount());
  A.reserve(static_cast<Index>(net.edgeEnds.size()) + net.vertexCount());
  for (Index i = 0; i < net.vertexCount(); ++i)
  {
    addRow(net, i, std::sqrt(strength * weightOf(net.kinds[at(i)])), A);
  }
  A.finalize();
  return A;
}

bool isFree(const InterfaceNet& net, Index vertex, int axis)
{
  return !isInnerJunction(net, vertex) && (net.fixed[at(vertex)] >> axis & 1U) == 0;
}

class Diagonal : public Preconditioner
{
public:
  explicit Diagonal(const std::vector<double>& inverse)
    : Inverse(inverse)
  {
  }
  void apply(
    const std::vector<double>& r, std::vector<double>& z, const Execution& execution) override
  {
    z.resize(r.size());
    forEachIndex(execution, static_cast<std::int64_t>(r.size()),
      [&](Index i) { z[at(i)] = this->Inverse[at(i / 3)] * r[at(i)]; });
  }

private:
  const std::vector<double>& Inverse;
};

} // namespace

NetFairing::NetFairing(const InterfaceNet& net, double strength, const Execution& execution)
  : Net(net)
  , A(bendingMatrix(net, strength))
  , Transposed(A.transpose())
  , InverseDiagonal(net.points.size())
{
  forEachIndex(execution, net.vertexCount(),
    [&](Index i)
    {
      double sum = 1.0;
      forEachEntry(this->Transposed, i, [&sum](Index, double value) { sum += value * value; });
      this->InverseDiagonal[at(i)] = 1.0 / sum;
    });
}

/// t A^T W A x, zero for coordinates that are fixed.
std::vector<Vec3> NetFairing::bending(
  const std::vector<Vec3>& points, const Execution& execution) const
{
  std::vector<Vec3> curvatures;
  multiply(this->A, points, curvatures, execution);
  std::vector<Vec3> bending;
  multiply(this->Transposed, curvatures, bending, execution);
  forEachIndex(execution, this->Net.vertexCount(),
    [&](Index i)
    {
      for (int axis = 0; axis < 3; ++axis)
      {
        bending[at(i)][axis] *= isFree(this->Net, i, axis) ? 1.0 : 0.0;
      }
    });
  return bending;
}

void NetFairing::apply(
  const std::vector<double>& x, std::vector<double>& y, const Execution& execution) const
{
  std::vector<Vec3> moves(x.size() / 3);
  forEachIndex(execution, this->Net.vertexCount(),
    [&](Index i) { moves[at(i)] = Vec3(x[at(3 * i)], x[at(3 * i + 1)], x[at(3 * i + 2)]); });
  const std::vector<Vec3> bent = this->bending(moves, execution);
  y.resize(x.size());
  forEachIndex(execution, static_cast<std::int64_t>(x.size()),
    [&](Index i) { y[at(i)] = x[at(i)] + bent[at(i / 3)][i % 3]; });
}

void NetFairing::apply(std::vector<Vec3>& points, const Execution& execution) const
{
  // Solved for the moves, which are zero where a coordinate is fixed.
  const std::vector<Vec3> force = this->bending(points, execution);
  std::vector<double> b(3 * points.size());
  forEachIndex(execution, static_cast<std::int64_t>(b.size()),
    [&](Index i) { b[at(i)] = -force[at(i / 3)][i % 3]; });
  std::vector<double> moves;
  SolverLimits limits;
  limits.tolerance = Tolerance;
  Diagonal inverse(this->InverseDiagonal);
  minimalResidual(*this, b, moves, limits, inverse, execution);
  forEachIndex(execution, this->Net.vertexCount(),
    [&](Index i)
    { points[at(i)] += Vec3(moves[at(3 * i)], moves[at(3 * i + 1)], moves[at(3 * i + 2)]); });
}

} // namespace evolving
