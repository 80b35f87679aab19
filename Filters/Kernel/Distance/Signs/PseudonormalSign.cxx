// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Distance/Signs/PseudonormalSign.h"

#include "Distance/Signs/Pseudonormals.h"

#include <limits>

namespace evolving
{

namespace
{

class Sides
{
public:
  Sides(const DistanceTarget& target, const DistanceGrid& grid, const UnsignedDistance& samples)
    : Mesh(target.mesh)
    , Normals(target.mesh, target.orientation.edgeOfCorner)
    , CanCarry(needsTrianglesNearSurfaceOnly(target.orientation))
    , Grid(grid)
    , Triangle(samples.triangle)
    , LowerBound(samples.lowerBound())
    , Inside(samples.triangle.size(), 0)
    , Near(static_cast<float>(1.5 * grid.spacing.maxCoeff()))
  {
  }

  std::vector<char> find(const Execution& execution)
  {
    this->findFirstOfSlices();
    execution.forRangeReporting(this->Grid.dimension(2), 1,
      [this](std::int64_t begin, std::int64_t end)
      {
        for (auto k = static_cast<int>(begin); k < static_cast<int>(end); ++k)
        {
          this->fillSlice(k);
        }
      });
    return std::move(this->Inside);
  }

private:
  GridIndex sampleAt(int i, int j, int k) const
  {
    const Extent& e = this->Grid.extent;
    return this->Grid.index(e[0] + i, e[2] + j, e[4] + k);
  }
  Vec3 point(int i, int j, int k) const
  {
    const Extent& e = this->Grid.extent;
    return this->Grid.point(e[0] + i, e[2] + j, e[4] + k);
  }
  bool isKnown(GridIndex sample) const { return this->Triangle[at(sample)] != NoIndex; }

  /// Can the surface not pass between two samples one step apart?
  bool onSameSide(GridIndex a, GridIndex b, int axis) const
  {
    constexpr double Rounding = 1.0 + 1e-5;
    const double sum =
      static_cast<double>(this->LowerBound[at(a)]) + static_cast<double>(this->LowerBound[at(b)]);
    return this->CanCarry && sum > Rounding * this->Grid.spacing[axis];
  }

  bool isBehind(const Vec3& place, Index face) const
  {
    return this->Normals.isInside(
      place, face, closestPointOnTriangle(place, triangleOf(this->Mesh, face)));
  }
  bool isBehind(int i, int j, int k) const
  {
    const Vec3 place = this->point(i, j, k);
    const Index face = this->Triangle[at(this->sampleAt(i, j, k))];
    return this->isBehind(place, face != NoIndex ? face : this->closestFace(place));
  }

  /// For the rare sample that has nothing to be carried on from and no triangle.
  Index closestFace(const Vec3& place) const
  {
    Index closest = 0;
    double squaredDistance = std::numeric_limits<double>::infinity();
    for (Index face = 0; face < this->Mesh.faceCount(); ++face)
    {
      const double squared =
        closestPointOnTriangle(place, triangleOf(this->Mesh, face)).squaredDistance;
      closest = squared < squaredDistance ? face : closest;
      squaredDistance = std::min(squaredDistance, squared);
    }
    return closest;
  }

  void findFirstOfSlices()
  {
    for (int k = 0; k < this->Grid.dimension(2); ++k)
    {
      const GridIndex sample = this->sampleAt(0, 0, k);
      const bool carried = k > 0 && this->onSameSide(sample, this->sampleAt(0, 0, k - 1), 2);
      this->Inside[at(sample)] =
        carried ? this->Inside[at(this->sampleAt(0, 0, k - 1))] : char(this->isBehind(0, 0, k));
    }
  }

  void fillSlice(int k)
  {
    for (int j = 0; j < this->Grid.dimension(1); ++j)
    {
      const GridIndex first = this->sampleAt(0, j, k);
      if (j > 0)
      {
        const GridIndex before = this->sampleAt(0, j - 1, k);
        const bool carried = this->onSameSide(first, before, 1);
        this->Inside[at(first)] =
          carried ? this->Inside[at(before)] : char(this->isBehind(0, j, k));
      }
      if (!this->carryAlongRow(j, k))
      {
        this->fillRow(j, k);
      }
    }
  }

  /// @return false when two ways to know a side contradict each other
  bool carryAlongRow(int j, int k)
  {
    const GridIndex first = this->sampleAt(0, j, k);
    for (int i = 1; i < this->Grid.dimension(0); ++i)
    {
      const GridIndex sample = first + i;
      const bool carried = this->onSameSide(sample, sample - 1, 0);
      const bool isNear = this->LowerBound[at(sample)] < this->Near && this->isKnown(sample);
      char side = this->Inside[at(sample - 1)];
      if (isNear || !carried)
      {
        side = char(this->isBehind(i, j, k));
      }
      if (carried && side != this->Inside[at(sample - 1)])
      {
        return false;
      }
      this->Inside[at(sample)] = side;
    }
    return true;
  }

  /// Every sample of a row for itself, where its triangle is known.
  void fillRow(int j, int k)
  {
    for (int i = 0; i < this->Grid.dimension(0); ++i)
    {
      const GridIndex sample = this->sampleAt(i, j, k);
      const bool isTold = i == 0 || this->isKnown(sample) || !this->CanCarry;
      this->Inside[at(sample)] =
        isTold ? char(this->isBehind(i, j, k)) : this->Inside[at(sample - 1)];
    }
  }

  const SurfaceMesh& Mesh;
  Pseudonormals Normals;
  bool CanCarry;
  const DistanceGrid& Grid;
  const std::vector<Index>& Triangle;
  const std::vector<float>& LowerBound;
  std::vector<char> Inside;
  float Near;
};

} // namespace

bool needsTrianglesNearSurfaceOnly(const OrientationSummary& surface)
{
  return surface.isClosed() && surface.isOriented() && !surface.componentsOverlap;
}

std::vector<char> insideByPseudonormal(const DistanceTarget& target, const DistanceGrid& grid,
  const UnsignedDistance& samples, const Execution& execution)
{
  return Sides(target, grid, samples).find(execution);
}

} // namespace evolving
