// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Evolution/UnreachedTarget.h"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace evolving
{

namespace
{

/// A sentence that names more of them is not read.
constexpr std::size_t MostNamed = 3;

/// ", 0.2 wide at (1 2 3), 0.1 wide at (4 5 6) and 23 more"
void list(std::ostream& words, const std::vector<UnreachedPlace>& places, const char* extent)
{
  const std::size_t named = std::min(places.size(), MostNamed);
  for (std::size_t i = 0; i < named; ++i)
  {
    const Vec3& p = places[i].middle;
    words << ", " << places[i].width << extent << " at (" << p.x() << ' ' << p.y() << ' ' << p.z()
          << ')';
  }
  if (places.size() > named)
  {
    words << " and " << places.size() - named << " more";
  }
}

/// Two digits, and never nothing.
std::string percent(double part)
{
  std::ostringstream words;
  words.precision(2);
  words << std::max(100.0 * part, 0.01) << " %";
  return words.str();
}

} // namespace

std::string inWords(const UnreachedTarget& unreached)
{
  if (unreached.isNothing())
  {
    return {};
  }
  std::ostringstream words;
  words.precision(3);
  words << "The surface is not everywhere on the zero level of the field: ";
  if (!unreached.membranes.empty())
  {
    const bool isOne = unreached.membranes.size() == 1;
    words << unreached.membranes.size()
          << (isOne ? " membrane spans a hole, a hollow or a gap between parts"
                    : " membranes span holes, hollows or gaps between parts");
    list(words, unreached.membranes, " wide");
    words << (unreached.pieces.empty() ? "" : "; ");
  }
  if (!unreached.pieces.empty())
  {
    words << percent(unreached.part) << " of the level's area is not reached, in "
          << unreached.pieces.size() << (unreached.pieces.size() == 1 ? " piece" : " pieces");
    list(words, unreached.pieces, " long");
  }
  words << (unreached.membranes.empty()
      ? "; narrow hollows take more NumberOfSteps, thin parts a smaller TargetEdgeLength, and what "
        "lies within the target or apart from it a start of its own."
      : "; a flow keeps the holes and the parts of its start: start from a surface that has those "
        "of the target, as vtkShrinkWrap makes one, or vtkFlyingEdges3D a contour of the field.");
  return words.str();
}

} // namespace evolving
