// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * The closest triangles of the samples of a brick, 4 x 4 x 4 of them. Included once for every
 * instruction set, inside a namespace of its own: no guard, no includes.
 *
 * A brick is divided into eight groups of eight samples. The triangles that are left are bounded
 * about the centres of the eight groups at once; each group gets those that may be closer than what
 * it knows, and these are measured.
 */

/// Some boxes of a fan.
struct Candidates
{
  Index fan;
  unsigned boxes;
};

class BrickSearch
{
public:
  static constexpr int Side = 4;

  BrickSearch(const OrientedBoxTree& tree, const SearchGrid& grid, GridClosest& result)
    : Fans(tree.fans().data())
    , Triangles(tree.triangles().data())
    , Grid(grid)
    , Result(result)
  {
    const float middle[3] = { 0.5F, 0.5F, 0.5F };
    this->GroupCenters = eightPoints(grid.step, middle, 2.0F);
    for (int g = 0; g < 8; ++g)
    {
      const float corner[3] = { static_cast<float>(2 * (g & 1)),
        static_cast<float>(2 * (g >> 1 & 1)), static_cast<float>(2 * (g >> 2)) };
      this->GroupSamples[g] = eightPoints(grid.step, corner, 1.0F);
    }
  }

  /// @param corner the brick's first sample
  /// @param candidates the boxes of leaves that may hold closer triangles than the guess
  void search(const int corner[3], const std::vector<Candidates>& candidates, Index guess)
  {
    double place[3];
    for (int axis = 0; axis < 3; ++axis)
    {
      place[axis] = corner[axis] * this->Grid.step[axis];
    }
    this->listTriangles(candidates, place, guess);
    const IntLanes closest = this->boundTriangles();
    NearestOfEight nearest[8];
    KnownDistances known;
    for (int g = 0; g < 8; ++g)
    {
      nearest[g] = { all(std::numeric_limits<float>::infinity()), all(0) };
      this->tryListed(0, g, nearest[g]); // the guess
      this->tryListed(static_cast<std::size_t>(closest[g]), g, nearest[g]);
      const Lanes distance = squareRoot(nearest[g].squared) + this->Grid.margin;
      for (int k = 0; k < 8; ++k)
      {
        known.at[k][g] = distance[k];
      }
    }
    this->distribute(known);
    for (int g = 0; g < 8; ++g)
    {
      for (const std::uint32_t* n = this->Group[g].data(); n != this->GroupEnd[g]; ++n)
      {
        if (static_cast<int>(*n) != closest[g])
        {
          this->tryListed(*n, g, nearest[g]);
        }
      }
    }
    this->store(corner, nearest);
  }

private:
  /// A triangle that matters to the brick.
  struct Listed
  {
    const FramedTriangle* triangle;
    WayFromAnchor toBrick;
  };

  void tryListed(std::size_t n, int group, NearestOfEight& nearest) const
  {
    const Listed& listed = this->Triangle[n];
    nearest.tryTriangle(*listed.triangle, listed.toBrick, this->GroupSamples[group]);
  }

  /// The guess, and then the candidates, among which it is again.
  void listTriangles(const std::vector<Candidates>& candidates, const double place[3], Index guess)
  {
    const auto add = [&](const FramedTriangle& triangle) {
      this->Triangle.push_back({ &triangle, WayFromAnchor(triangle, place) });
    };
    this->Triangle.clear();
    add(this->Triangles[guess]);
    for (const Candidates& candidate : candidates)
    {
      const BoxFan& fan = this->Fans[candidate.fan];
      for (unsigned rest = candidate.boxes; rest != 0; rest &= rest - 1)
      {
        add(this->Triangles[fan.child[__builtin_ctz(rest)]]);
      }
    }
    if (this->Bound.size() < this->Triangle.size())
    {
      this->Bound.resize(2 * this->Triangle.size());
      for (std::vector<std::uint32_t>& group : this->Group)
      {
        group.resize(2 * this->Triangle.size());
      }
    }
  }

  /// Bounds all listed triangles about the groups' centres. @return the closest for each group
  IntLanes boundTriangles()
  {
    const float halfStep[3] = { 0.5F * static_cast<float>(this->Grid.step[0]),
      0.5F * static_cast<float>(this->Grid.step[1]),
      0.5F * static_cast<float>(this->Grid.step[2]) };
    Lanes distance = all(std::numeric_limits<float>::infinity());
    IntLanes closest = all(0);
    LinearBound* bound = this->Bound.data();
    const Listed* listed = this->Triangle.data();
    const auto count = static_cast<int>(this->Triangle.size());
    for (int n = 1; n < count; ++n)
    {
      bound[n] = boundAt(*listed[n].triangle, listed[n].toBrick, this->GroupCenters, halfStep);
      const Lanes atCenter = bound[n].atCenter;
      const IntLanes isCloser = atCenter < distance;
      distance = isCloser ? atCenter : distance;
      closest = isCloser ? all(n) : closest;
    }
    return closest;
  }

  /// Gives every group the triangles that may be closer to one of its samples than what it has.
  void distribute(const KnownDistances& known)
  {
    std::uint32_t* end[8];
    for (int g = 0; g < 8; ++g)
    {
      end[g] = this->Group[g].data();
    }
    const LinearBound* bound = this->Bound.data();
    const auto count = static_cast<std::uint32_t>(this->Triangle.size());
    for (std::uint32_t n = 1; n < count; ++n)
    {
      for (unsigned rest = mayBeCloser(bound[n], known); rest != 0; rest &= rest - 1)
      {
        *end[__builtin_ctz(rest)]++ = n;
      }
    }
    std::copy(end, end + 8, this->GroupEnd);
  }

  void store(const int corner[3], const NearestOfEight nearest[8])
  {
    float distance[64];
    Index number[64];
    for (int g = 0; g < 8; ++g)
    {
      const int first = 2 * (g & 1) + 8 * (g >> 1 & 1) + 32 * (g >> 2);
      this->storeGroup(corner, first, nearest[g], distance, number);
    }
    this->Grid.forEachRowOf(corner, Side,
      [&](const SearchGrid::Row& row)
      {
        const int place = row.i + 4 * row.j + 16 * row.k;
        std::copy_n(distance + place, row.count, this->Result.distance.data() + row.first);
        std::copy_n(number + place, row.count, this->Result.triangle.data() + row.first);
      });
  }

  /// In the grid's unit; beside the surface measured again, in double.
  void storeGroup(const int corner[3], int first, const NearestOfEight& nearest, float distance[64],
    Index number[64]) const
  {
    const Lanes root = squareRoot(nearest.squared);
    const unsigned near = maskOf(root < SearchGrid::Near);
    const Lanes scaled = root * this->Grid.unit;
    for (int k = 0; k < LaneCount; ++k)
    {
      const int place = first + (k & 1) + 4 * (k >> 1 & 1) + 16 * (k >> 2);
      distance[place] = scaled[k];
      number[place] = nearest.number[k];
      if ((near >> k & 1U) != 0)
      {
        distance[place] = this->Grid.exactDistance(corner, place, number[place]);
      }
    }
  }

  const BoxFan* Fans;
  const FramedTriangle* Triangles;
  const SearchGrid& Grid;
  GridClosest& Result;
  EightPoints GroupCenters;    ///< from the brick's first sample
  EightPoints GroupSamples[8]; ///< of each group

  std::vector<Listed> Triangle;
  std::vector<LinearBound> Bound;      ///< of each, about the groups' centres
  std::vector<std::uint32_t> Group[8]; ///< places in the list
  std::uint32_t* GroupEnd[8] = {};
};
