// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * The nearest triangle known so far for every sample of a grid, and how a sample tries another.
 */

#ifndef EVOLVING_NEAREST_FIELD_H
#define EVOLVING_NEAREST_FIELD_H

#include "Distance/AABBTree.h"
#include "Distance/DistanceGrid.h"
#include "Distance/MeasuredTriangle.h"
#include "Distance/SurfaceBand.h"
#include "Types.h"

#include <array>
#include <vector>

namespace evolving
{

/// The last few triangles a sample has tried: neighbours often have the same.
class TriedTriangles
{
public:
  TriedTriangles() { this->Recent.fill(NoIndex); }

  /// False when the triangle is one of them.
  bool insert(Index triangle)
  {
    bool isNew = true;
    for (const Index recent : this->Recent)
    {
      isNew = isNew && recent != triangle;
    }
    this->Recent[this->Next] = isNew ? triangle : this->Recent[this->Next];
    this->Next = (this->Next + (isNew ? 1 : 0)) % this->Recent.size();
    return isNew;
  }

private:
  std::array<Index, 8> Recent;
  std::size_t Next = 0;
};

/// A row of samples beside another, and how far it is from that; none outside the grid.
struct NeighbourRow
{
  const Nearest* samples = nullptr;
  float step = 0.0F;
};

/// Lengths in the grid's longest spacing, places from the grid's middle, distances as Scalar.
template <typename Scalar>
class NearestField
{
public:
  using Vector = Eigen::Matrix<Scalar, 3, 1>;

  /// How far from the surface samples are settled by drawBand() and try nothing any more.
  static constexpr double BandReach = 2.0;

  NearestField(const AABBTree& tree, const DistanceGrid& grid);

  void drawBand(const Execution& execution);

  int width() const { return this->Grid.dimensions[0]; }
  int rows() const { return this->Grid.dimensions[1]; }
  int slices() const { return this->Grid.dimensions[2]; }
  GridIndex index(int i, int j, int k) const { return this->Grid.index(i, j, k); }
  Vector point(int i, int j, int k) const
  {
    return this->Grid.point(i, j, k).template cast<Scalar>();
  }
  Nearest* row(int j, int k) { return this->Samples.data() + this->Grid.index(0, j, k); }
  const Nearest* row(int j, int k) const
  {
    return this->Samples.data() + this->Grid.index(0, j, k);
  }
  NeighbourRow neighbourRow(int j, int k, int otherJ, int otherK) const;
  float stepAlongRow() const { return static_cast<float>(this->Grid.spacing.x()); }

  static bool isSettled(const Nearest& sample) { return sample.distance <= float(BandReach); }

  /// Takes the triangle if it is closer than the sample's.
  void tryTriangle(Nearest& sample, Index triangle, const Vector& point) const;
  /// Takes the neighbour's triangle if it is closer and was not tried already.
  /// @param step between the two samples
  void tryNeighbour(Nearest& sample, const Nearest& neighbour, const Vector& point, float step,
    TriedTriangles& tried) const;

private:
  UnitGrid Grid;
  std::vector<MeasuredTriangle<Scalar>> Triangles;
  std::vector<Box> Boxes;
  std::vector<Nearest> Samples;
};

} // namespace evolving

#include "Distance/NearestField.hxx"

#endif
