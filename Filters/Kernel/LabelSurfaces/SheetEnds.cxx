// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "LabelSurfaces/SheetEnds.h"

#include "Mesh/Angles.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace evolving
{

namespace
{

/// A sheet's vertices are looked for up to this many radii away, where few are left to count.
constexpr double RadiiAway = 2.0;
/// Sheets meet smoothly below the first of these angles, and do not above the other.
const double CosineOfSmooth = std::cos(20.0 * RadiansPerDegree);
const double CosineOfEdge = std::cos(35.0 * RadiansPerDegree);
/// Of planes farther away, in voxels, nothing is to be learnt.
constexpr double MostOffset = 2.0;

/// A set of corners of voxels near one.
class NearCorners
{
public:
  NearCorners(const std::array<Index, 3>& middle, int reach)
    : First{ middle[0] - reach, middle[1] - reach, middle[2] - reach }
    , Size(2 * reach + 1)
    , Has(static_cast<std::size_t>(this->Size) * static_cast<std::size_t>(this->Size) *
          static_cast<std::size_t>(this->Size),
        0)
  {
  }

  /// @return whether it was not there before
  bool add(const std::array<Index, 3>& corner)
  {
    char& has = this->Has[at(corner[0] - this->First[0] +
      this->Size * (corner[1] - this->First[1] + this->Size * (corner[2] - this->First[2])))];
    const bool isNew = has == 0;
    has = 1;
    return isNew;
  }

private:
  std::array<Index, 3> First;
  Index Size;
  std::vector<char> Has;
};

double smoothness(double cosine)
{
  const double t = (cosine - CosineOfEdge) / (CosineOfSmooth - CosineOfEdge);
  const double clamped = std::clamp(t, 0.0, 1.0);
  return clamped * clamped * (3.0 - 2.0 * clamped);
}

Vec3 towards(Material material, const std::array<Material, 2>& sides, const Vec3& normal)
{
  return material == sides[1] ? normal : Vec3(-normal);
}

bool has(const std::array<Material, 2>& sides, Material material)
{
  return sides[0] == material || sides[1] == material;
}

void add(const std::optional<SheetPlane>& plane, double weight, std::vector<SheetPlane>& planes)
{
  if (plane && weight > 0.0)
  {
    planes.push_back(*plane);
    planes.back().weight *= weight;
  }
}

} // namespace

SheetEnds::SheetEnds(const InterfaceNet& net, double radius)
  : Net(net)
  , Radius(radius)
  , Rings(static_cast<int>(std::ceil(RadiiAway * radius)))
{
}

std::vector<SheetPlane> SheetEnds::planes(
  Index vertex, const std::vector<Vec3>& points, const std::vector<Vec3>& areas) const
{
  std::vector<End> ends = this->endsAt(vertex, areas);
  for (End& end : ends)
  {
    end.plane = this->planeOf(end.vertices, end.normal, vertex, points);
  }
  const Pair pair = smoothestPair(ends);
  const double together = smoothness(pair.cosine);
  std::vector<SheetPlane> planes;
  for (std::size_t i = 0; i < ends.size(); ++i)
  {
    const bool isOfPair = i == pair.ends[0] || i == pair.ends[1];
    add(ends[i].plane, isOfPair ? 1.0 - together : 1.0, planes);
  }
  if (together > 0.0)
  {
    std::vector<Index> both = ends[pair.ends[0]].vertices;
    const std::vector<Index>& others = ends[pair.ends[1]].vertices;
    both.insert(both.end(), others.begin(), others.end());
    add(this->planeOf(both, pair.normal, vertex, points), together, planes);
  }
  return planes;
}

/// Of a sheet, those that can be reached from quad to quad.
std::vector<Index> SheetEnds::verticesNear(Index vertex, const std::array<Material, 2>& sides) const
{
  NearCorners reached(this->Net.corners[at(vertex)], this->Rings);
  reached.add(this->Net.corners[at(vertex)]);
  std::vector<Index> all{ vertex };
  std::size_t begin = 0;
  for (int ring = 0; ring < this->Rings; ++ring)
  {
    const std::size_t end = all.size();
    for (; begin < end; ++begin)
    {
      const Index from = all[begin];
      for (Index k = this->Net.quadOffsets[at(from)]; k < this->Net.quadOffsets[at(from) + 1]; ++k)
      {
        const NetQuad& quad = this->Net.quads[at(this->Net.quadsOfVertices[at(k)])];
        if (sortedSides(quad) == sides)
        {
          std::copy_if(quad.vertices.begin(), quad.vertices.end(), std::back_inserter(all),
            [&](Index other) { return reached.add(this->Net.corners[at(other)]); });
        }
      }
    }
  }
  const auto isNone = [this](Index i) { return !isSheet(this->Net, i); };
  all.erase(std::remove_if(all.begin(), all.end(), isNone), all.end());
  return all;
}

std::vector<SheetEnds::End> SheetEnds::endsAt(Index vertex, const std::vector<Vec3>& areas) const
{
  std::vector<End> ends;
  for (Index k = this->Net.quadOffsets[at(vertex)]; k < this->Net.quadOffsets[at(vertex) + 1]; ++k)
  {
    const auto sides = sortedSides(this->Net.quads[at(this->Net.quadsOfVertices[at(k)])]);
    const bool isNew = std::none_of(
      ends.begin(), ends.end(), [&sides](const End& end) { return end.sides == sides; });
    if (isNew)
    {
      ends.push_back({ sides, this->verticesNear(vertex, sides), Vec3::Zero(), std::nullopt });
    }
  }
  for (End& end : ends)
  {
    for (const Index other : end.vertices)
    {
      const Vec3 way = this->Net.cornerPoint(other) - this->Net.cornerPoint(vertex);
      end.normal +=
        std::exp(-0.5 * way.squaredNorm() / (this->Radius * this->Radius)) * areas[at(other)];
    }
    const double length = end.normal.norm();
    end.normal /= length > 0.0 ? length : 1.0;
  }
  const auto isUnknown = [](const End& end) { return !(end.normal.squaredNorm() > 0.0); };
  ends.erase(std::remove_if(ends.begin(), ends.end(), isUnknown), ends.end());
  return ends;
}

std::optional<SheetPlane> SheetEnds::planeOf(const std::vector<Index>& vertices, const Vec3& normal,
  Index vertex, const std::vector<Vec3>& points) const
{
  std::vector<Vec3> places;
  places.reserve(vertices.size());
  for (const Index other : vertices)
  {
    places.push_back(points[at(other)]);
  }
  const auto plane = fitSheet(places, points[at(vertex)], normal, this->Radius);
  return plane && std::abs(plane->offset) < MostOffset ? plane : std::nullopt;
}

/// The two of three sheets that go on into each other most smoothly, if there are three.
SheetEnds::Pair SheetEnds::smoothestPair(const std::vector<End>& ends)
{
  const auto normalOf = [](const End& end) { return end.plane ? end.plane->normal : end.normal; };
  Pair best{ { ends.size(), ends.size() }, Vec3::Zero(), -1.0 };
  for (std::size_t i = 0; i < ends.size() && ends.size() == 3; ++i)
  {
    for (std::size_t j = i + 1; j < ends.size(); ++j)
    {
      const Material common =
        has(ends[j].sides, ends[i].sides[0]) ? ends[i].sides[0] : ends[i].sides[1];
      const Vec3 first = towards(common, ends[i].sides, normalOf(ends[i]));
      const Vec3 second = towards(common, ends[j].sides, normalOf(ends[j]));
      if (first.dot(second) > best.cosine)
      {
        best = { { i, j }, (first + second).normalized(), first.dot(second) };
      }
    }
  }
  return best;
}

} // namespace evolving
