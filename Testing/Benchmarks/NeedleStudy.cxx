// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * How the time of a search for the closest triangle grows with the number of needles that lie side
 * by side, as revolved profiles have them.
 */

#include "Arguments.h"
#include "Report.h"
#include "Timing.h"

#include "Trees/AABBTree.h"

#include <cmath>
#include <random>

using namespace benchmark;
using evolving::Index;
using evolving::SurfaceMesh;
using evolving::Vec3;

namespace
{

/// A cylinder, a cone and a flat ring in so many segments.
SurfaceMesh revolved(int segments)
{
  constexpr int Rows = 4;
  const double radius[Rows] = { 0.2, 0.2, 0.6, 1.0 };
  const double height[Rows] = { 0.0, 1.0, 1.5, 1.5 };
  SurfaceMesh mesh;
  for (int s = 0; s < segments; ++s)
  {
    const double angle = 2.0 * std::acos(-1.0) * s / segments;
    for (int row = 0; row < Rows; ++row)
    {
      mesh.addPoint(
        Vec3(radius[row] * std::cos(angle), radius[row] * std::sin(angle), height[row]));
    }
  }
  for (Index s = 0; s < segments; ++s)
  {
    const Index next = (s + 1) % segments;
    for (Index row = 0; row + 1 < Rows; ++row)
    {
      mesh.addFace({ Rows * s + row, Rows * next + row, Rows * next + row + 1 });
      mesh.addFace({ Rows * s + row, Rows * next + row + 1, Rows * s + row + 1 });
    }
  }
  return mesh;
}

/// Places a fiftieth of the model's length off the surface.
std::vector<Vec3> placesBeside(const SurfaceMesh& mesh, int count)
{
  std::mt19937 random(1);
  std::normal_distribution<double> normal(0.0, 0.04);
  std::vector<Vec3> places;
  for (int n = 0; n < count; ++n)
  {
    const auto face = static_cast<Index>(random() % static_cast<unsigned>(mesh.faceCount()));
    const Vec3 off(normal(random), normal(random), normal(random));
    places.push_back(evolving::triangleOf(mesh, face).centroid() + off);
  }
  return places;
}

std::vector<std::string> rowOf(int segments, int runs)
{
  constexpr int Places = 20000;
  const SurfaceMesh mesh = revolved(segments);
  const std::vector<Vec3> places = placesBeside(mesh, Places);
  const Seconds build = medianOf(runs, [&] { evolving::AABBTree tree(mesh); });
  const evolving::AABBTree tree(mesh);
  double sum = 0.0; // so that the searches are not left out
  const Seconds search = medianOf(runs,
    [&]
    {
      for (const Vec3& place : places)
      {
        sum += tree.closest(place).at.squaredDistance;
      }
    });
  return { std::to_string(segments), std::to_string(mesh.faceCount()), fixed(build.cpu, 3),
    std::isfinite(sum) ? fixed(1e6 * search.cpu / Places, 2) : "" };
}

} // namespace

int main(int argc, char** argv)
{
  Arguments defaults;
  defaults.sizes = { 30, 300, 3000, 30000 };
  const Arguments arguments = readArguments(argc, argv, defaults,
    "Searches for the closest triangle of a profile revolved in --sizes segments, one thread.");
  printHeader("NeedleStudy", arguments);
  Table table("AABBTree::closest() among needles side by side",
    { "segments", "triangles", "processor time of the tree, s", "of a search, us" });
  for (const int segments : arguments.sizes)
  {
    table.add(rowOf(segments, arguments.runs));
  }
  table.print();
  return 0;
}
