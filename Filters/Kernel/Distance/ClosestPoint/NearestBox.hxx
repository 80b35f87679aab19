// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * The nearest of many boxes of fans, found in all lanes at once. Included once for every
 * instruction set, inside a namespace of its own: no guard, no includes.
 */

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
