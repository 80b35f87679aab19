// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef EVOLVING_NEAREST_FIELD_HXX
#define EVOLVING_NEAREST_FIELD_HXX

#include "Distance/NearestField.h"

#include <cmath>

namespace evolving
{

template <typename Scalar>
NearestField<Scalar>::NearestField(const AABBTree& tree, const DistanceGrid& grid)
  : Samples(static_cast<std::size_t>(grid.sampleCount()))
{
  const double unit = grid.spacing.maxCoeff();
  const Extent& e = grid.extent;
  const Vec3 first = grid.point(e[0], e[2], e[4]);
  const Vec3 middle = 0.5 * (first + grid.point(e[1], e[3], e[5]));
  this->Grid.dimensions = { grid.dimension(0), grid.dimension(1), grid.dimension(2) };
  this->Grid.spacing = grid.spacing / unit;
  this->Grid.origin = (first - middle) / unit;
  this->Triangles.reserve(tree.triangles().size());
  this->Boxes.reserve(tree.triangles().size());
  for (const Triangle& triangle : tree.triangles())
  {
    Triangle scaled = triangle;
    for (Vec3& corner : scaled.corners)
    {
      corner = (corner - middle) / unit;
    }
    this->Triangles.emplace_back(scaled);
    this->Boxes.push_back(scaled.box());
  }
}

template <typename Scalar>
void NearestField<Scalar>::drawBand(const Execution& execution)
{
  drawSurfaceBand(this->Triangles, this->Boxes, this->Grid, BandReach, this->Samples, execution);
}

template <typename Scalar>
NeighbourRow NearestField<Scalar>::neighbourRow(int j, int k, int otherJ, int otherK) const
{
  if (otherJ < 0 || otherJ >= this->rows() || otherK < 0 || otherK >= this->slices())
  {
    return {};
  }
  const Vec3 way = this->Grid.point(0, j, k) - this->Grid.point(0, otherJ, otherK);
  return { this->row(otherJ, otherK), static_cast<float>(way.norm()) };
}

template <typename Scalar>
inline void NearestField<Scalar>::tryTriangle(
  Nearest& sample, Index triangle, const Vector& point) const
{
  const Scalar squared = this->Triangles[static_cast<std::size_t>(triangle)].squaredDistance(point);
  const auto current = static_cast<Scalar>(sample.distance);
  if (squared < current * current)
  {
    // Closer as floats, too: of two at the same distance the first stays.
    const auto distance = static_cast<float>(std::sqrt(squared));
    sample = distance < sample.distance ? Nearest{ distance, triangle } : sample;
  }
}

template <typename Scalar>
inline void NearestField<Scalar>::tryNeighbour(Nearest& sample, const Nearest& neighbour,
  const Vector& point, float step, TriedTriangles& tried) const
{
  // A triangle cannot be closer than its distance from the neighbour less the way from there.
  const bool hopeless = neighbour.triangle == sample.triangle ||
    neighbour.distance >= sample.distance + step || neighbour.triangle == NoIndex;
  if (!hopeless && tried.insert(neighbour.triangle))
  {
    this->tryTriangle(sample, neighbour.triangle, point);
  }
}

} // namespace evolving

#endif
