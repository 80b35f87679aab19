// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * The closest triangles of all samples of a block of the grid. Included once for every instruction
 * set, inside a namespace of its own: no guard, no includes.
 *
 * A block takes over from the block around it the boxes that may hold the closest triangle of one
 * of its samples, keeps those that still may, by the bound of DistanceLanes.hxx, and opens those
 * that are large beside it. Its eight parts do the same, down to bricks.
 */

class BlockSearch
{
public:
  BlockSearch(const OrientedBoxTree& tree, const SearchGrid& grid, GridClosest& result)
    : Fans(tree.fans().data())
    , Triangles(tree.triangles().data())
    , Grid(grid)
    , Result(result)
    , Bricks(tree, grid, result)
  {
    const float none[3] = { 0.0F, 0.0F, 0.0F };
    for (std::size_t level = 0; level < Levels; ++level)
    {
      const int side = SearchGrid::BlockSide >> level;
      this->Corners[level] = eightPoints(grid.step, none, static_cast<float>(side - 1));
    }
  }

  /// Fills the samples of a block of SearchGrid::BlockSide that are in the grid.
  void search(const int corner[3])
  {
    this->Lists[0].assign(1, { 0, this->Fans[0].allBoxes() });
    this->searchBlock({ { corner[0], corner[1], corner[2] }, SearchGrid::BlockSide }, 0, 0);
  }

private:
  static constexpr std::size_t Levels = 3; ///< of blocks, bricks the last

  struct Block
  {
    int corner[3];
    int side; ///< in samples
  };

  /// The middle of a block, and half its size.
  struct Middle
  {
    double exact[3];
    float rounded[3];
    float halfSize[3];
  };

  Middle middleOf(const Block& block) const
  {
    Middle middle;
    const double half = 0.5 * (block.side - 1);
    for (int axis = 0; axis < 3; ++axis)
    {
      middle.exact[axis] = (block.corner[axis] + half) * this->Grid.step[axis];
      middle.rounded[axis] = static_cast<float>(middle.exact[axis]);
      middle.halfSize[axis] = static_cast<float>(half * this->Grid.step[axis]);
    }
    return middle;
  }

  /// Finds the boxes for a block in those of the block around it; then its parts.
  void searchBlock(const Block& block, std::size_t level, Index guess)
  {
    const Middle middle = this->middleOf(block);
    const bool isBrick = block.side == BrickSearch::Side;
    guess = this->closerGuess(this->boundCandidates(middle, level), middle, guess);
    // A brick is handed triangles: no box is small enough to stay closed, not even a point's.
    const float largest = isBrick ? -1.0F : 0.5F * static_cast<float>(block.side);
    const float nearest =
      this->select(this->cornerDistances(block, level, guess), middle, largest, level);
    const float* half = middle.halfSize;
    if (nearest - std::sqrt(half[0] * half[0] + half[1] * half[1] + half[2] * half[2]) >
      this->Grid.band)
    {
      this->leaveOut(block);
    }
    else if (isBrick)
    {
      this->Bricks.search(block.corner, this->Lists[level + 1], guess);
    }
    else
    {
      this->searchParts(block, level + 1, guess);
    }
  }

  void searchParts(const Block& block, std::size_t level, Index guess)
  {
    const int half = block.side / 2;
    for (int part = 0; part < 8; ++part)
    {
      const Block child{ { block.corner[0] + half * (part & 1),
                           block.corner[1] + half * (part >> 1 & 1),
                           block.corner[2] + half * (part >> 2) },
        half };
      if (this->Grid.meets(child.corner, half))
      {
        this->searchBlock(child, level, guess);
      }
    }
  }

  float squaredDistance(Index triangle, const double point[3]) const
  {
    const FramedTriangle& framed = this->Triangles[triangle];
    const EightPoints here{ { all(0.0F), all(0.0F), all(0.0F) } };
    return squaredDistances(framed, WayFromAnchor(framed, point), here)[0];
  }

  /// A box of a fan and how far it is.
  struct NearestBox
  {
    Lanes distance;
    IntLanes fan;

    // Written out: GCC does not compile an implicit one for the instruction set asked for.
    NearestBox()
      : distance(all(std::numeric_limits<float>::infinity()))
      , fan(all(0))
    {
    }

    void tryFan(Index number, unsigned boxes, Lanes distances)
    {
      const IntLanes bits = { 1, 2, 4, 8, 16, 32, 64, 128 };
      const IntLanes isNearer =
        (distances < this->distance) & ((all(static_cast<int>(boxes)) & bits) != 0);
      this->distance = isNearer ? distances : this->distance;
      this->fan = isNearer ? all(number) : this->fan;
    }
    int lane() const
    {
      int best = 0;
      for (int k = 1; k < LaneCount; ++k)
      {
        best = this->distance[k] < this->distance[best] ? k : best;
      }
      return best;
    }
  };

  /// The bounds of all that the block around handed down. @return the box closest to the centre
  NearestBox boundCandidates(const Middle& middle, std::size_t level)
  {
    const std::vector<Candidates>& candidates = this->Lists[level];
    this->FanBound.resize(std::max(this->FanBound.size(), candidates.size()));
    LinearBound* bound = this->FanBound.data();
    NearestBox nearest;
    for (const Candidates& candidate : candidates)
    {
      *bound = boundAt(this->Fans[candidate.fan], middle.rounded, middle.halfSize);
      nearest.tryFan(candidate.fan, candidate.boxes, bound->atCenter);
      ++bound;
    }
    return nearest;
  }

  /// Follows the closest box down to a triangle, and takes that if it is closer.
  Index closerGuess(const NearestBox& box, const Middle& middle, Index guess) const
  {
    int lane = box.lane();
    const BoxFan* fan = &this->Fans[box.fan[lane]];
    while (!fan->isLeaf)
    {
      const Index number = fan->child[lane];
      fan = &this->Fans[number];
      NearestBox inner;
      inner.tryFan(
        number, fan->allBoxes(), boundAt(*fan, middle.rounded, middle.halfSize).atCenter);
      lane = inner.lane();
    }
    const Index found = fan->child[lane];
    return this->squaredDistance(found, middle.exact) < this->squaredDistance(guess, middle.exact)
      ? found
      : guess;
  }

  /// The distances of a block's corners to a triangle, each in all lanes of its own.
  KnownDistances cornerDistances(const Block& block, std::size_t level, Index triangle) const
  {
    double corner[3];
    for (int axis = 0; axis < 3; ++axis)
    {
      corner[axis] = block.corner[axis] * this->Grid.step[axis];
    }
    const FramedTriangle& framed = this->Triangles[triangle];
    const Lanes distance =
      squareRoot(squaredDistances(framed, WayFromAnchor(framed, corner), this->Corners[level])) +
      this->Grid.margin;
    KnownDistances known;
    for (int k = 0; k < 8; ++k)
    {
      known.at[k] = all(distance[k]);
    }
    return known;
  }

  /// From list `level`, of known bounds, to the next: boxes that may hold a closer triangle,
  /// opened while they are larger than `largest`. @return the distance to the closest of them
  float select(const KnownDistances& known, const Middle& middle, float largest, std::size_t level)
  {
    this->Lists[level + 1].clear();
    this->Opened.clear();
    float nearest = std::numeric_limits<float>::infinity();
    const std::vector<Candidates>& candidates = this->Lists[level];
    for (std::size_t n = 0; n < candidates.size(); ++n)
    {
      const float distance =
        this->selectFrom(candidates[n], this->FanBound[n], known, largest, level + 1);
      nearest = std::min(nearest, distance);
    }
    for (std::size_t n = 0; n < this->Opened.size(); ++n)
    {
      const BoxFan& fan = this->Fans[this->Opened[n]];
      const LinearBound bound = boundAt(fan, middle.rounded, middle.halfSize);
      const float distance =
        this->selectFrom({ this->Opened[n], fan.allBoxes() }, bound, known, largest, level + 1);
      nearest = std::min(nearest, distance);
    }
    return nearest;
  }

  float selectFrom(const Candidates& candidates, const LinearBound& bound,
    const KnownDistances& known, float largest, std::size_t level)
  {
    const unsigned boxes = mayBeCloser(bound, known) & candidates.boxes;
    if (boxes == 0)
    {
      return std::numeric_limits<float>::infinity();
    }
    const BoxFan& fan = this->Fans[candidates.fan];
    float nearest = std::numeric_limits<float>::infinity();
    unsigned kept = boxes;
    for (unsigned rest = boxes; rest != 0; rest &= rest - 1)
    {
      const int k = __builtin_ctz(rest);
      nearest = std::min(nearest, bound.atCenter[k]);
      if (!fan.isLeaf && fan.longestSide[k] > largest)
      {
        kept &= ~(1U << k);
        this->Opened.push_back(fan.child[k]);
      }
    }
    if (kept != 0)
    {
      this->Lists[level].push_back({ candidates.fan, kept });
    }
    return nearest;
  }

  /// The samples of a block that is farther away than the band.
  void leaveOut(const Block& block)
  {
    this->Grid.forEachRowOf(block.corner, block.side,
      [&](const SearchGrid::Row& row)
      {
        std::fill_n(this->Result.distance.data() + row.first, row.count,
          std::numeric_limits<float>::infinity());
        std::fill_n(this->Result.triangle.data() + row.first, row.count, NoIndex);
      });
  }

  const BoxFan* Fans;
  const FramedTriangle* Triangles;
  const SearchGrid& Grid;
  GridClosest& Result;
  BrickSearch Bricks;
  std::array<EightPoints, Levels> Corners; ///< of blocks, from their first sample

  /// Of the blocks around, from the outermost.
  std::array<std::vector<Candidates>, Levels + 1> Lists;
  std::vector<LinearBound> FanBound; ///< of a list
  std::vector<Index> Opened;         ///< fans
};
