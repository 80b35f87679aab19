// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "LostTopology/LostTopology.h"

#include <algorithm>
#include <sstream>
#include <vector>

namespace evolving
{

namespace
{

/// A sentence that names more of them is not read.
constexpr std::size_t MostNamed = 3;

const char* pluralOf(std::size_t count)
{
  return count == 1 ? "" : "s";
}

void countParts(std::ostream& words, Index genus, Index parts)
{
  words << "genus " << genus << " in " << parts << " part" << pluralOf(at(parts));
}

/// "25 holes or gaps were closed, 0.2 wide at (1 2 3), 0.1 wide at (4 5 6) and 23 more"
class Places
{
public:
  explicit Places(std::ostream& words)
    : Words(words)
  {
  }

  void add(const std::vector<ChangedPlace>& places, const char* one, const char* several,
    const char* extent)
  {
    if (places.empty())
    {
      return;
    }
    this->Words << (this->IsFirst ? ": " : "; ");
    this->IsFirst = false;
    this->Words << places.size() << (places.size() == 1 ? one : several);
    const std::size_t named = std::min(places.size(), MostNamed);
    for (std::size_t i = 0; i < named; ++i)
    {
      const Vec3& p = places[i].middle;
      this->Words << ", " << places[i].width << extent << " at (" << p.x() << ' ' << p.y() << ' '
                  << p.z() << ')';
    }
    if (places.size() > named)
    {
      this->Words << " and " << places.size() - named << " more";
    }
  }

  bool hasNone() const { return this->IsFirst; }

private:
  std::ostream& Words;
  bool IsFirst = true;
};

/// Where no place is known, from the numbers alone.
const char* reasonFor(const LostTopology& lost)
{
  if (lost.genusOfResult < lost.genus)
  {
    return ": holes or handles narrower than about two triangles were closed or lost";
  }
  return lost.genusOfResult > lost.genus || lost.partsOfResult < lost.parts
    ? ": places that are near to each other were joined, or parts lost"
    : ": places thinner than a triangle were lost";
}

void advise(std::ostream& words, const LostTopologyRemedy& remedy)
{
  const char* before = "; use ";
  const auto add = [&](const auto&... what)
  {
    words << before;
    (words << ... << what);
    before = " and ";
  };
  if (remedy.isStart)
  {
    add("the Isosurface start");
  }
  if (remedy.isTooNarrow)
  {
    words << "; triangles cannot be so small: change the input there, or set a GapSize where holes "
             "may close";
  }
  if (remedy.samples)
  {
    add("SampleDimensions of ", *remedy.samples);
  }
  if (remedy.points > 0)
  {
    add("a TargetNumberOfPoints of ", remedy.points);
  }
  else if (remedy.edgeLength > 0.0)
  {
    add("a TargetEdgeLength of ", remedy.edgeLength);
  }
}

} // namespace

std::string inWords(const LostTopology& lost)
{
  std::ostringstream words;
  words << "The target has ";
  countParts(words, lost.genus, lost.parts);
  words << ", the result ";
  countParts(words, lost.genusOfResult, lost.partsOfResult);
  Places places(words);
  places.add(lost.places.missingParts, " part is missing", " parts are missing", " long");
  places.add(lost.places.filled, " hole or gap was closed", " holes or gaps were closed", " wide");
  places.add(
    lost.places.missing, " handle or wall was lost", " handles or walls were lost", " thick");
  if (places.hasNone())
  {
    words << reasonFor(lost);
  }
  advise(words, lost.remedy);
  words << '.';
  return words.str();
}

} // namespace evolving
