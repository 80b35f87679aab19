// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * The closest triangles of all samples of a block of the grid at once. Included once for every
 * instruction set, inside a namespace of its own: no guard, no includes.
 *
 * A block takes over from the block around it the boxes that may hold the closest triangle of one
 * of its samples, and opens those that are large beside it. Some triangle is known to be close,
 * and the distance to it is at most u(p). The distance d to a box is a convex function, so that
 * d(p) >= d(c) + grad d(c) . (p - c), c the block's centre; u is convex, too, and so is the
 * difference. Where the right side is not below u at any of the eight corners it is not in the
 * block, and the box is out: a bound that is as good far from the surface as beside it.
 *
 * A block of 4 x 4 x 4 samples, a brick, is divided into eight groups of eight. The same bound
 * about the groups' centres leaves each group its triangles, and these are measured.
 */

/// Eight points, as ways from one that they are all measured from.
struct EightPoints
{
  Lanes way[3];
};

/// A lower bound of a distance: at a centre, and its slope times half the block's size.
struct LinearBound
{
  Lanes atCenter;
  Lanes slope[3];
};

/// From a triangle's anchor to a point, which may be far from the origin as the triangle may be.
struct WayFromAnchor
{
  float way[3];

  WayFromAnchor(const FramedTriangle& triangle, const double point[3])
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      this->way[axis] = static_cast<float>(point[axis] - triangle.anchor[axis]);
    }
  }
};

inline void toFrame(const FramedTriangle& triangle, const WayFromAnchor& from,
  const EightPoints& points, Lanes local[3])
{
  const Lanes x = from.way[0] + points.way[0];
  const Lanes y = from.way[1] + points.way[1];
  const Lanes z = from.way[2] + points.way[2];
  local[0] = x * triangle.along[0] + y * triangle.along[1] + z * triangle.along[2];
  local[1] = x * triangle.beside[0] + y * triangle.beside[1] + z * triangle.beside[2];
  local[2] = x * triangle.normal[0] + y * triangle.normal[1] + z * triangle.normal[2];
}

inline Lanes clampedTo(Lanes value, float upper)
{
  return smaller(larger(value, all(0.0F)), all(upper));
}

/// The squared distances of eight points from a triangle, without a branch.
inline Lanes squaredDistances(
  const FramedTriangle& triangle, const WayFromAnchor& from, const EightPoints& points)
{
  Lanes local[3];
  toFrame(triangle, from, points, local);
  const Lanes x = local[0];
  const Lanes y = local[1];
  const FramedTriangle::Edge& b = triangle.second;
  const FramedTriangle::Edge& c = triangle.third;
  const Lanes alongB = (x * b.directionX + y * b.directionY) - b.beginAlong;
  const Lanes besideB = (y * b.directionX - x * b.directionY) - b.beginBeside;
  const Lanes alongC = (x * c.directionX + y * c.directionY) - c.beginAlong;
  const Lanes besideC = (y * c.directionX - x * c.directionY) - c.beginBeside;
  const Lanes gapA = x - clampedTo(x, triangle.length);
  const Lanes gapB = alongB - clampedTo(alongB, b.length);
  const Lanes gapC = alongC - clampedTo(alongC, c.length);
  const Lanes toEdges = smaller(
    gapA * gapA + y * y, smaller(gapB * gapB + besideB * besideB, gapC * gapC + besideC * besideC));
  const Lanes inside = smaller(y, smaller(besideB, besideC));
  const Lanes inPlane = inside > 0.0F ? all(0.0F) : toEdges;
  return local[2] * local[2] + inPlane;
}

inline Lanes roughDot(const Lanes a[3], Lanes x, Lanes y, Lanes z)
{
  return roughSum(a[0], x, roughSum(a[1], y, a[2] * z));
}

/// The bound about eight points, from the rectangle around a triangle.
inline LinearBound boundAt(const FramedTriangle& triangle, const WayFromAnchor& from,
  const EightPoints& points, const float halfSize[3])
{
  const Lanes way[3] = { from.way[0] + points.way[0], from.way[1] + points.way[1],
    from.way[2] + points.way[2] };
  const float* along = triangle.along;
  const float* beside = triangle.beside;
  const float* normal = triangle.normal;
  const Lanes x = roughDot(way, all(along[0]), all(along[1]), all(along[2]));
  const Lanes y = roughDot(way, all(beside[0]), all(beside[1]), all(beside[2]));
  const Lanes gap[3] = { x - clampedTo(x, triangle.length), y - clampedTo(y, triangle.height),
    roughDot(way, all(normal[0]), all(normal[1]), all(normal[2])) };
  LinearBound bound;
  bound.atCenter = squareRoot(roughDot(gap, gap[0], gap[1], gap[2]));
  const Lanes inverse = 1.0F / larger(bound.atCenter, all(1e-20F));
  for (int axis = 0; axis < 3; ++axis)
  {
    bound.slope[axis] = roughDot(gap, all(along[axis]), all(beside[axis]), all(normal[axis])) *
      inverse * halfSize[axis];
  }
  return bound;
}

/// The bounds about one point, from the eight boxes of a fan.
inline LinearBound boundAt(const BoxFan& fan, const float point[3], const float halfSize[3])
{
  const Lanes way[3] = { point[0] - load(fan.center[0]), point[1] - load(fan.center[1]),
    point[2] - load(fan.center[2]) };
  Lanes squared = all(0.0F);
  Lanes gradient[3] = { all(0.0F), all(0.0F), all(0.0F) };
  for (int k = 0; k < 3; ++k)
  {
    const Lanes axis[3] = { load(fan.axis[k][0]), load(fan.axis[k][1]), load(fan.axis[k][2]) };
    const Lanes local = roughDot(way, axis[0], axis[1], axis[2]);
    const Lanes gap = larger(magnitude(local) - load(fan.halfSize[k]), all(0.0F));
    const Lanes signedGap = withSignOf(gap, local);
    squared = roughSum(gap, gap, squared);
    for (int a = 0; a < 3; ++a)
    {
      gradient[a] = roughSum(signedGap, axis[a], gradient[a]);
    }
  }
  LinearBound bound;
  bound.atCenter = squareRoot(squared);
  const Lanes inverse = 1.0F / larger(bound.atCenter, all(1e-20F));
  for (int a = 0; a < 3; ++a)
  {
    bound.slope[a] = gradient[a] * inverse * halfSize[a];
  }
  return bound;
}

/// Where the bound is below the known distance at a corner; corner k lies on the upper side
/// along x, y, z where bit 0, 1, 2 of k is set.
inline unsigned mayBeCloser(const LinearBound& bound, const Lanes known[8])
{
  const Lanes sum = bound.slope[0] + bound.slope[1];
  const Lanes difference = bound.slope[0] - bound.slope[1];
  const Lanes z = bound.slope[2];
  const Lanes low = larger(larger(known[0] + (sum + z), known[1] - (difference - z)),
    larger(known[2] + (difference + z), known[3] - (sum - z)));
  const Lanes high = larger(larger(known[4] + (sum - z), known[5] - (difference + z)),
    larger(known[6] + (difference - z), known[7] - (sum + z)));
  return maskOf(bound.atCenter < larger(low, high));
}

/// The closest triangle of eight samples so far; of two at the same distance the one with the
/// smaller number, so that the order in which they are tried does not matter.
struct NearestOfEight
{
  Lanes squared;
  IntLanes number;

  void tryTriangle(
    const FramedTriangle& triangle, const WayFromAnchor& from, const EightPoints& points)
  {
    const Lanes distance = squaredDistances(triangle, from, points);
    const IntLanes candidate = all(triangle.number);
    const IntLanes isBetter =
      (distance < this->squared) | ((distance == this->squared) & (candidate < this->number));
    this->squared = isBetter ? distance : this->squared;
    this->number = isBetter ? candidate : this->number;
  }
};

/// Some boxes of a fan.
struct Candidates
{
  Index fan;
  unsigned boxes;
};

class BlockSearch
{
public:
  BlockSearch(const OrientedBoxTree& tree, const SearchGrid& grid, GridClosest& result)
    : Fans(tree.fans().data())
    , Triangles(tree.triangles().data())
    , Grid(grid)
    , Result(result)
  {
    const float none[3] = { 0.0F, 0.0F, 0.0F };
    for (std::size_t level = 0; level < Levels; ++level)
    {
      const int side = SearchGrid::BlockSide >> level;
      this->Corners[level] = this->eightPoints(none, static_cast<float>(side - 1));
    }
    const float middle[3] = { 0.5F, 0.5F, 0.5F };
    this->GroupCenters = this->eightPoints(middle, 2.0F);
    for (int g = 0; g < 8; ++g)
    {
      const float corner[3] = { static_cast<float>(2 * (g & 1)),
        static_cast<float>(2 * (g >> 1 & 1)), static_cast<float>(2 * (g >> 2)) };
      this->GroupSamples[g] = this->eightPoints(corner, 1.0F);
    }
  }

  /// Fills the samples of a block of SearchGrid::BlockSide that are in the grid.
  void search(const int corner[3])
  {
    this->Lists[0].assign(1, { 0, this->Fans[0].allBoxes() });
    this->searchBlock({ { corner[0], corner[1], corner[2] }, SearchGrid::BlockSide }, 0, 0);
  }

private:
  static constexpr int BrickSide = 4;
  static constexpr std::size_t Levels = 3; ///< of blocks, bricks the last

  struct Block
  {
    int corner[3];
    int side; ///< in samples
  };

  /// Distances known at eight corners: number k of the first index is the corner.
  struct KnownDistances
  {
    Lanes at[8];
  };

  /// A triangle that matters to a brick.
  struct Listed
  {
    const FramedTriangle* triangle;
    WayFromAnchor toBrick;
  };

  /// Eight points at the corners of a box of some samples' side, from its corner.
  EightPoints eightPoints(const float first[3], float apart) const
  {
    EightPoints points;
    for (int axis = 0; axis < 3; ++axis)
    {
      for (int k = 0; k < LaneCount; ++k)
      {
        const float sample = first[axis] + ((k >> axis & 1) != 0 ? apart : 0.0F);
        points.way[axis][k] = sample * static_cast<float>(this->Grid.step[axis]);
      }
    }
    return points;
  }

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
    const bool isBrick = block.side == BrickSide;
    guess = this->closerGuess(this->boundCandidates(middle, level), middle, guess);
    const float largest = isBrick ? 0.0F : 0.5F * static_cast<float>(block.side);
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
      this->searchBrick(block.corner, this->Lists[level + 1], guess);
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
    Lanes distance = all(std::numeric_limits<float>::infinity());
    IntLanes fan = all(0);

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
    const unsigned boxes = mayBeCloser(bound, known.at) & candidates.boxes;
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

  void searchBrick(const int corner[3], const std::vector<Candidates>& candidates, Index guess)
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
      for (unsigned rest = mayBeCloser(bound[n], known.at); rest != 0; rest &= rest - 1)
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
    this->Grid.forEachRowOf(corner, BrickSide,
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
  std::array<EightPoints, Levels> Corners; ///< of blocks, from their first
  EightPoints GroupCenters;                ///< of a brick, from its corner
  EightPoints GroupSamples[8];             ///< of each group

  std::array<std::vector<Candidates>, Levels + 1>
    Lists;                           ///< of the blocks around, from the outermost
  std::vector<LinearBound> FanBound; ///< of a list
  std::vector<Index> Opened;         ///< fans
  std::vector<Listed> Triangle;      ///< those that matter to a brick
  std::vector<LinearBound> Bound;
  std::vector<std::uint32_t> Group[8]; ///< places in the list of triangles
  std::uint32_t* GroupEnd[8] = {};
};
