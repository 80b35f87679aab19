// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * Distances, and lower bounds of distances, of eight points or to eight boxes at once. Included
 * once for every instruction set, inside a namespace of its own: no guard, no includes.
 *
 * The distance d to a box is a convex function: d(p) >= d(c) + grad d(c) . (p - c). What is known
 * of a block of samples, the distance u to some triangle that is close, is convex, too, and so is
 * the difference u - d(c) - grad d(c) . (p - c). Where that is not positive at any of the block's
 * eight corners it is not in the block, and the box is out: a bound that is as good far from the
 * surface as beside it.
 */

/// Eight points, as ways from one that they are all measured from.
struct EightPoints
{
  Lanes way[3];
};

/// Eight points at the corners of a box of samples, `apart` from each other, from its corner.
inline EightPoints eightPoints(const double step[3], const float first[3], float apart)
{
  EightPoints points;
  for (int axis = 0; axis < 3; ++axis)
  {
    for (int k = 0; k < LaneCount; ++k)
    {
      const float sample = first[axis] + ((k >> axis & 1) != 0 ? apart : 0.0F);
      points.way[axis][k] = sample * static_cast<float>(step[axis]);
    }
  }
  return points;
}

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

/// Distances known at eight corners: number k of the first index is the corner.
struct KnownDistances
{
  Lanes at[8];
};

/// Where the bound is below the known distance at a corner; corner k lies on the upper side
/// along x, y, z where bit 0, 1, 2 of k is set.
inline unsigned mayBeCloser(const LinearBound& bound, const KnownDistances& knownDistances)
{
  const Lanes* known = knownDistances.at;
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
