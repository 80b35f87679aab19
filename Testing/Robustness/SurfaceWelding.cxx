// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Surface.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <map>
#include <numeric>
#include <set>
#include <utility>

namespace robustness
{

namespace
{

bool isUsedTwice(const Cell& face)
{
  Cell sorted = face;
  std::sort(sorted.begin(), sorted.end());
  return std::adjacent_find(sorted.begin(), sorted.end()) != sorted.end();
}

/// Without corners that follow themselves.
Cell withoutRepetitions(Cell face)
{
  face.erase(std::unique(face.begin(), face.end()), face.end());
  while (face.size() > 1 && face.front() == face.back())
  {
    face.pop_back();
  }
  return face;
}

/// Of every point the part that it belongs to, by a point of that; -1 where a part is not closed:
/// where an edge has not two faces in opposite directions, or a face two corners at one place.
std::vector<std::int64_t> closedPartsOf(const Surface& surface)
{
  std::vector<std::int64_t> parts(surface.points.size());
  std::iota(parts.begin(), parts.end(), std::int64_t(0));
  const auto find = [&](std::int64_t id)
  {
    while (parts[static_cast<std::size_t>(id)] != id)
    {
      id = parts[static_cast<std::size_t>(id)];
    }
    return id;
  };
  std::map<std::pair<std::int64_t, std::int64_t>, std::pair<int, int>> edges;
  std::set<std::int64_t> open;
  for (const Cell& face : surface.faces)
  {
    for (std::size_t k = 0; k < face.size(); ++k)
    {
      const std::int64_t from = face[k];
      const std::int64_t to = face[(k + 1) % face.size()];
      parts[static_cast<std::size_t>(find(from))] = find(to);
      auto& runs = edges[std::minmax(from, to)];
      ++(from < to ? runs.first : runs.second);
      for (std::size_t l = 0; l < k; ++l)
      {
        if (surface.corner(face, k) == surface.corner(face, l))
        {
          open.insert(from);
        }
      }
    }
  }
  for (const auto& [ends, runs] : edges)
  {
    if (runs.first != 1 || runs.second != 1)
    {
      open.insert(ends.first);
    }
  }
  std::set<std::int64_t> openParts;
  std::transform(open.begin(), open.end(), std::inserter(openParts, openParts.end()), find);
  std::vector<std::int64_t> found(parts.size());
  for (std::size_t i = 0; i < parts.size(); ++i)
  {
    const std::int64_t part = find(static_cast<std::int64_t>(i));
    found[i] = openParts.count(part) > 0 ? -1 : part;
  }
  return found;
}

} // namespace

Surface welded(const Surface& surface)
{
  const std::vector<std::int64_t> closedParts = closedPartsOf(surface);
  std::map<std::array<double, 4>, std::int64_t> places;
  Surface result;
  for (std::size_t f = 0; f < surface.faces.size(); ++f)
  {
    Cell face;
    for (const std::int64_t id : surface.faces[f])
    {
      const auto i = static_cast<std::size_t>(id);
      const Vec3& p = surface.points[i];
      // Of a closed part every point is a place of its own.
      const double own = closedParts[i] < 0 ? -1.0 : double(id);
      const auto next = static_cast<std::int64_t>(places.size());
      face.push_back(places.try_emplace({ p.x(), p.y(), p.z(), own }, next).first->second);
    }
    face = withoutRepetitions(face);
    if (face.size() >= 3 && !isUsedTwice(face))
    {
      result.faces.push_back(face);
      result.cellOfFace.push_back(surface.cellOfFace[f]);
    }
  }
  result.points.resize(places.size());
  for (const auto& [place, id] : places)
  {
    result.points[static_cast<std::size_t>(id)] = { place[0], place[1], place[2] };
  }
  return result;
}

} // namespace robustness
