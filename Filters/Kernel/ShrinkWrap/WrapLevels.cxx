// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ShrinkWrap/WrapLevels.h"

#include "ParallelLoops.h"
#include "ShrinkWrap/SheetOpenness.h"

#include <algorithm>

namespace evolving
{

namespace
{

/// A part of a triangle, with the openness at its corners.
struct Piece
{
  std::array<Vec3, 3> corners;
  std::array<double, 3> openness;
};

/// Cuts the longest edge in halves until it is short enough.
class Cutter
{
public:
  Cutter(const SheetOpenness& openness, Index triangle, double longest)
    : Openness(openness)
    , Number(triangle)
    , SquaredLongest(longest * longest)
  {
  }

  std::vector<Piece> cut(const Triangle& triangle)
  {
    const auto& [a, b, c] = triangle.corners;
    this->cut({ triangle.corners, { at(a), at(b), at(c) } });
    return std::move(this->Pieces);
  }

private:
  double at(const Vec3& point) const { return this->Openness.at(this->Number, point); }

  void cut(const Piece& piece)
  {
    std::array<double, 3> squares{};
    for (std::size_t k = 0; k < 3; ++k)
    {
      squares[k] = (piece.corners[(k + 1) % 3] - piece.corners[k]).squaredNorm();
    }
    const auto longest = std::max_element(squares.begin(), squares.end());
    if (*longest <= this->SquaredLongest)
    {
      this->Pieces.push_back(piece);
      return;
    }
    const auto from = static_cast<std::size_t>(longest - squares.begin());
    const std::size_t to = (from + 1) % 3;
    const Vec3 middle = 0.5 * (piece.corners[from] + piece.corners[to]);
    const double openness = at(middle);
    for (const std::size_t end : { from, to })
    {
      Piece half = piece;
      half.corners[end] = middle;
      half.openness[end] = openness;
      this->cut(half);
    }
  }

  const SheetOpenness& Openness;
  Index Number;
  double SquaredLongest;
  std::vector<Piece> Pieces;
};

Piece atOffset(const Triangle& triangle)
{
  return { triangle.corners, { 0.0, 0.0, 0.0 } };
}

std::vector<Piece> piecesOf(
  const Triangle& triangle, Index number, const SheetOpenness& openness, double longest)
{
  switch (openness.sidesOf(number))
  {
    case SidesOpen::One:
      return { atOffset(triangle) };
    case SidesOpen::Both:
      return { { triangle.corners, { 1.0, 1.0, 1.0 } } };
    default:
      return Cutter(openness, number, longest).cut(triangle);
  }
}

} // namespace

double WrapLevels::maximum(Index triangle) const
{
  const std::array<double, 3>& levels = this->atCorners[static_cast<std::size_t>(triangle)];
  return *std::max_element(levels.begin(), levels.end());
}

WrapLevels wrapLevels(const SurfaceMesh& target, const AABBTree& tree,
  const std::vector<char>& hasInside, const OuterRegion& region, double offset, double wall,
  const Execution& execution)
{
  const SheetOpenness openness(tree, region);
  std::vector<std::vector<Piece>> pieces(at(tree.triangleCount()));
  execution.forRange(tree.triangleCount(), Execution::MeshGrain,
    [&](std::int64_t begin, std::int64_t end)
    {
      for (auto t = static_cast<Index>(begin); t < static_cast<Index>(end); ++t)
      {
        pieces[at(t)] = hasInside[at(t)] != 0
          ? std::vector<Piece>{ atOffset(tree.triangle(t)) }
          : piecesOf(tree.triangle(t), t, openness, region.radius());
      }
    });
  WrapLevels levels;
  levels.triangles.points = target.points;
  for (Index t = 0; t < tree.triangleCount(); ++t)
  {
    const bool isWhole = pieces[at(t)].size() == 1;
    for (const Piece& piece : pieces[at(t)])
    {
      std::array<Index, 3> corners{};
      auto& heights = levels.atCorners.emplace_back();
      for (std::size_t k = 0; k < 3; ++k)
      {
        corners[k] = isWhole ? target.faceVertex(t, static_cast<Index>(k))
                             : levels.triangles.addPoint(piece.corners[k]);
        heights[k] = std::max(offset, wall * piece.openness[k]);
      }
      levels.triangles.addFace({ corners[0], corners[1], corners[2] });
    }
  }
  return levels;
}

} // namespace evolving
