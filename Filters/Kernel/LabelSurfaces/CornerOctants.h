// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * What the eight voxels around a corner say about the net there.
 */

#ifndef EVOLVING_CORNER_OCTANTS_H
#define EVOLVING_CORNER_OCTANTS_H

#include "LabelSurfaces/MaterialGrid.h"

#include <algorithm>
#include <array>
#include <cstdint>

namespace evolving
{

/// The octants around the edge that leaves a corner along an axis, in turn.
inline std::array<Material, 4> around(const Octants& octants, unsigned axis, unsigned isUpwards)
{
  const unsigned first = isUpwards << axis;
  const unsigned u = 1U << (axis + 1) % 3;
  const unsigned v = 1U << (axis + 2) % 3;
  return { octants[first], octants[first | u], octants[first | u | v], octants[first | v] };
}

struct EdgeKind
{
  int changes = 0; ///< of material around it
  bool isDrawn = false;
};

inline EdgeKind kindOf(const std::array<Material, 4>& materials)
{
  EdgeKind kind;
  for (std::size_t i = 0; i < 4; ++i)
  {
    const Material next = materials[(i + 1) % 4];
    kind.changes += materials[i] != next ? 1 : 0;
    kind.isDrawn = kind.isDrawn || isInterface(materials[i], next);
  }
  return kind;
}

/// Does a face of the net meet there?
inline bool isVertex(const Octants& octants)
{
  const auto drawn = [](Material material) { return isLabel(material) ? material : Background; };
  return std::any_of(octants.begin() + 1, octants.end(),
    [&](Material material) { return drawn(material) != drawn(octants[0]); });
}

inline std::ptrdiff_t numberOfMaterials(Octants octants)
{
  std::sort(octants.begin(), octants.end());
  return std::unique(octants.begin(), octants.end()) - octants.begin();
}

/// Are there voxels of one material that hang together by no faces among these eight?
inline bool meetsItself(const Octants& octants)
{
  std::array<unsigned, 8> parts = { 0, 1, 2, 3, 4, 5, 6, 7 };
  for (int round = 0; round < 3; ++round)
  {
    for (unsigned b = 0; b < 8; ++b)
    {
      for (const unsigned axis : { 1U, 2U, 4U })
      {
        const bool isSame = octants[b] == octants[b ^ axis];
        parts[b] = isSame ? std::min(parts[b], parts[b ^ axis]) : parts[b];
      }
    }
  }
  for (unsigned b = 0; b < 8; ++b)
  {
    for (unsigned c = 0; c < b; ++c)
    {
      if (isLabel(octants[b]) && octants[b] == octants[c] && parts[b] != parts[c])
      {
        return true;
      }
    }
  }
  return false;
}

/// Bit a: coordinate a is that of an end of the image.
inline std::uint8_t fixedCoordinates(const Octants& octants)
{
  std::uint8_t fixed = 0;
  for (unsigned axis = 0; axis < 3; ++axis)
  {
    for (const unsigned isUpwards : { 0U, 1U })
    {
      const std::array<Material, 4> side = around(octants, axis, isUpwards);
      const bool isEnd = std::all_of(
        side.begin(), side.end(), [](Material material) { return material == OutsideImage; });
      fixed = static_cast<std::uint8_t>(fixed | (isEnd ? 1U << axis : 0U));
    }
  }
  return fixed;
}

} // namespace evolving

#endif
