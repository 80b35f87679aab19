// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Distance/Sweeping/DistanceOctree.h"

#include "Errors.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

namespace evolving
{

namespace
{

void requireCubic(const DistanceGrid& grid)
{
  if (!grid.isCubic())
  {
    std::ostringstream message;
    message << "The octree needs cubic cells, got cells of " << grid.spacing.x() << " x "
            << grid.spacing.y() << " x " << grid.spacing.z()
            << "; set ModelBounds and SampleDimensions that give cubes, or an automatic box.";
    throw InputError(message.str());
  }
}

void requireFewCells(std::size_t cells, std::size_t most, int side)
{
  if (cells > most)
  {
    std::ostringstream message;
    message << "The octree has " << cells << " cells of " << side
            << " samples along each side, expected at most " << most
            << " of any size; lower SampleDimensions.";
    throw InputError(message.str());
  }
}

/// The samples of an axis whose cells the interval [low, high] reaches.
std::array<int, 2> samplesAround(const DistanceGrid& grid, int axis, double low, double high)
{
  const auto entry = static_cast<std::size_t>(2 * axis);
  const double first = grid.extent[entry];
  const double last = grid.extent[entry + 1];
  const double from = std::floor((low - grid.origin[axis]) / grid.spacing[axis] + 0.5);
  const double to = std::floor((high - grid.origin[axis]) / grid.spacing[axis] + 0.5);
  // An interval that ends on a cell's lower face touches the cell below, too.
  return { static_cast<int>(std::clamp(from - 1.0, first, last + 1.0)),
    static_cast<int>(std::clamp(to, first - 1.0, last)) };
}

} // namespace

DistanceOctree::DistanceOctree(const AABBTree& tree, const DistanceGrid& grid,
  const Execution& execution, int maximumDepth, std::size_t mostCells)
  : Grid(grid)
{
  requireCubic(grid);
  this->setRoot(tree);
  while (
    !this->Levels.empty() && this->Levels.back().front().side > 1 && this->depth() < maximumDepth)
  {
    // A level takes about four times as long as the one before it.
    const double side = this->Levels.back().front().side;
    const Execution level =
      execution.phase(0.0, 0.7).phase(1.0 / (side * side), 4.0 / (side * side));
    std::vector<Cell> children = this->openChildren(tree, this->Levels.back(), level);
    if (children.empty())
    {
      this->Levels.clear(); // the root met the mesh's box, but no cell with a sample the mesh
      break;
    }
    requireFewCells(children.size(), mostCells, children.front().side);
    this->Levels.push_back(std::move(children));
  }
  this->measureLeaves(tree, execution.phase(0.7, 1.0));
}

Box DistanceOctree::box(const Cell& cell) const
{
  const auto& [i, j, k] = cell.corner;
  const Vec3 half = 0.5 * this->Grid.spacing;
  const int last = cell.side - 1;
  return { Vec3(this->Grid.point(i, j, k) - half),
    Vec3(this->Grid.point(i + last, j + last, k + last) + half) };
}

Box DistanceOctree::closure(const Cell& cell) const
{
  // Neighbours' faces differ by the rounding of their coordinates: a triangle in the crack between
  // them would be lost.
  constexpr double OfACell = 1e-9;
  constexpr double OfACoordinate = 4.0 * std::numeric_limits<double>::epsilon();
  const Box box = this->box(cell);
  const Vec3 farthest = box.min().cwiseAbs().cwiseMax(box.max().cwiseAbs());
  const Vec3 margin = (OfACell * this->Grid.spacing).cwiseMax(OfACoordinate * farthest);
  return { Vec3(box.min() - margin), Vec3(box.max() + margin) };
}

void DistanceOctree::setRoot(const AABBTree& tree)
{
  if (tree.isEmpty())
  {
    return;
  }
  const Box& mesh = tree.nodes().front().box;
  Cell root;
  int samples = 1;
  for (int axis = 0; axis < 3; ++axis)
  {
    const auto [from, to] = samplesAround(this->Grid, axis, mesh.min()[axis], mesh.max()[axis]);
    if (from > to)
    {
      return; // beside the grid
    }
    root.corner[static_cast<std::size_t>(axis)] = from;
    samples = std::max(samples, to - from + 1);
  }
  while (root.side < samples)
  {
    root.side *= 2;
  }
  if (tree.meets(this->closure(root)))
  {
    this->Levels.push_back({ root });
  }
}

bool DistanceOctree::hasSample(const Cell& cell) const
{
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    if (cell.corner[axis] > this->Grid.extent[2 * axis + 1] ||
      cell.corner[axis] + cell.side <= this->Grid.extent[2 * axis])
    {
      return false;
    }
  }
  return true;
}

std::vector<DistanceOctree::Cell> DistanceOctree::openChildren(
  const AABBTree& tree, const std::vector<Cell>& parents, const Execution& execution) const
{
  std::vector<Cell> candidates;
  candidates.reserve(8 * parents.size());
  for (const Cell& parent : parents)
  {
    const int side = parent.side / 2;
    for (int child = 0; child < 8; ++child)
    {
      const Cell cell{ { parent.corner[0] + (child & 1) * side,
                         parent.corner[1] + (child >> 1 & 1) * side,
                         parent.corner[2] + (child >> 2) * side },
        side };
      if (this->hasSample(cell))
      {
        candidates.push_back(cell);
      }
    }
  }
  constexpr std::int64_t Grain = 256;
  std::vector<char> isOpen(candidates.size());
  const auto count = static_cast<std::int64_t>(candidates.size());
  execution.forRangeReporting(count, Grain,
    [&](std::int64_t begin, std::int64_t end)
    {
      for (auto c = static_cast<std::size_t>(begin); c < static_cast<std::size_t>(end); ++c)
      {
        isOpen[c] = tree.meets(this->closure(candidates[c]));
      }
    });
  std::size_t kept = 0;
  for (std::size_t c = 0; c < candidates.size(); ++c)
  {
    if (isOpen[c])
    {
      candidates[kept++] = candidates[c];
    }
  }
  candidates.resize(kept);
  return candidates;
}

void DistanceOctree::measureLeaves(const AABBTree& tree, const Execution& execution)
{
  if (this->Levels.empty())
  {
    return;
  }
  const std::vector<Cell>& cells = this->Levels.back();
  this->Leaves.resize(cells.size());
  constexpr std::int64_t Grain = 256;
  execution.forRangeReporting(static_cast<std::int64_t>(cells.size()), Grain,
    [&](std::int64_t begin, std::int64_t end)
    {
      for (auto c = static_cast<std::size_t>(begin); c < static_cast<std::size_t>(end); ++c)
      {
        const ClosestTriangle closest = tree.closest(this->center(cells[c]));
        this->Leaves[c] = { cells[c], closest.triangle, closest.at.squaredDistance };
      }
    });
}

} // namespace evolving
