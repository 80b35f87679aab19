// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * The clipping of one ear after the other off a polygon.
 */

#ifndef EVOLVING_EAR_CLIPPING_H
#define EVOLVING_EAR_CLIPPING_H

#include "Mesh/PlanePointTree.h"
#include "Types.h"

#include <array>
#include <queue>
#include <utility>
#include <vector>

namespace evolving
{

/**
 * A polygon from which triangles are cut off one by one: a convex corner whose triangle contains
 * no other corner, of these the one with the shortest cut; without one, the second corner left.
 *
 * Corners wait in the order of their cuts. One that is no ear has a corner in its triangle, and
 * need not be looked at again before that is cut off or a neighbour is.
 */
class EarClipping
{
public:
  /// @param corners at least three, which have to outlive this
  explicit EarClipping(const std::vector<Vec3>& corners);

  /// Cuts off one triangle. @return its corners' numbers in the polygon's orientation
  std::array<Index, 3> clip();

private:
  /// A corner with the neighbours that it had.
  struct Waiting
  {
    Index corner;
    int version;
  };
  struct Candidate
  {
    double squaredCut;
    Waiting waiting;

    /// Is another one the better?
    bool operator<(const Candidate& other) const
    {
      return this->squaredCut != other.squaredCut ? this->squaredCut > other.squaredCut
                                                  : this->waiting.corner > other.waiting.corner;
    }
  };

  const Vec3& corner(Index k) const { return this->Corners[at(k)]; }
  /// Twice the area of a triangle as seen along the normal.
  double area(const Vec3& a, const Vec3& b, const Vec3& c) const;

  void enqueue(Index k);
  void renew(Index k);
  void reconsider(const std::vector<Waiting>& corners);
  Index bestEar();
  bool isTwinOutside(Index twin, const std::array<Index, 3>& triangle) const;
  /// Notes down what it waits for if it is none.
  bool isEar(const Waiting& candidate);

  const std::vector<Vec3>& Corners;
  Vec3 Normal;
  std::vector<Vec2> Seen; ///< along the normal
  PlanePointTree Left;
  std::vector<std::pair<Index, Index>> Neighbours;  ///< left before and after each
  std::vector<int> Version;                         ///< of a corner's neighbours
  std::vector<std::vector<Waiting>> Blocked;        ///< by each corner
  std::vector<std::vector<Waiting>> BlockedByEdges; ///< of each corner, a twin of one of theirs
  std::priority_queue<Candidate> Candidates;
  Index First = 0; ///< that is left
};

} // namespace evolving

#endif
