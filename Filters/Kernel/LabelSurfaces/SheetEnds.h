// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * The planes in which sheets end at a vertex where they meet.
 */

#ifndef EVOLVING_SHEET_ENDS_H
#define EVOLVING_SHEET_ENDS_H

#include "LabelSurfaces/InterfaceNet.h"
#include "LabelSurfaces/SheetFit.h"
#include "Types.h"

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

namespace evolving
{

/**
 * By quadrics through the vertices of each sheet that are near (fitSheet). Where three sheets meet
 * and two of them go on smoothly into each other, as the outside of a body that is cut in two,
 * these count as one, which is known much better than its two ends.
 */
class SheetEnds
{
public:
  /// @param radius of the part of a sheet that counts, in voxels
  SheetEnds(const InterfaceNet& net, double radius);

  /// @param areas as of sheetAreas()
  std::vector<SheetPlane> planes(
    Index vertex, const std::vector<Vec3>& points, const std::vector<Vec3>& areas) const;

private:
  struct End
  {
    std::array<Material, 2> sides;
    std::vector<Index> vertices;
    Vec3 normal; ///< a mean, towards the larger material
    std::optional<SheetPlane> plane;
  };
  struct Pair
  {
    std::array<std::size_t, 2> ends;
    Vec3 normal;
    double cosine; ///< of the angle between them; 1: smooth
  };

  std::vector<End> endsAt(Index vertex, const std::vector<Vec3>& areas) const;
  std::vector<Index> verticesNear(Index vertex, const std::array<Material, 2>& sides) const;
  std::optional<SheetPlane> planeOf(const std::vector<Index>& vertices, const Vec3& normal,
    Index vertex, const std::vector<Vec3>& points) const;
  static Pair smoothestPair(const std::vector<End>& ends);

  const InterfaceNet& Net;
  double Radius;
  int Rings; ///< of quads around a vertex that are looked at
};

} // namespace evolving

#endif
