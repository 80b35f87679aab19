// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * The cost of splitting the root box of a model, as figure 5.3 of the thesis draws it: eight
 * samples between the ends, the parabolas through them and the split they lead to.
 */

#include "Arguments.h"
#include "Models.h"
#include "Report.h"
#include "Timing.h"

#include "Trees/SurfaceAreaSplit.h"

#include <algorithm>

using namespace benchmark;
using evolving::SplitInterval;
using evolving::SplitSearch;
using evolving::Vec3;

namespace
{

/// The root box along its longest axis, as the tree's construction sees it.
struct Root
{
  Vec3 sides = Vec3::Zero();
  int axis = 0;
  std::vector<SplitInterval> intervals;
};

Root rootOf(const evolving::SurfaceMesh& mesh)
{
  const evolving::Box box = evolving::boundingBox(mesh);
  Root root;
  root.sides = box.sizes();
  const double length = root.sides.maxCoeff(&root.axis);
  for (evolving::Index f = 0; f < mesh.faceCount(); ++f)
  {
    evolving::Box triangle;
    for (evolving::Index k = 0; k < 3; ++k)
    {
      triangle.extend(mesh.facePoint(f, k));
    }
    const Vec3 low = (triangle.min() - box.min()) / length;
    const Vec3 high = (triangle.max() - box.min()) / length;
    root.intervals.push_back(
      { static_cast<float>(low[root.axis]), static_cast<float>(high[root.axis]) });
  }
  return root;
}

/// The cost by its definition: triangles counted at the position, areas of the two boxes.
double exactCost(const Root& root, double position)
{
  const double a = root.sides[(root.axis + 1) % 3];
  const double b = root.sides[(root.axis + 2) % 3];
  const auto area = [&](double part)
  { return 2.0 * (a * b + part * root.sides[root.axis] * (a + b)); };
  double left = 0.0;
  double right = 0.0;
  for (const SplitInterval& interval : root.intervals)
  {
    left += static_cast<double>(interval.low) < position ? 1.0 : 0.0;
    right += static_cast<double>(interval.high) > position ? 1.0 : 0.0;
  }
  return (left * area(position) + right * area(1.0 - position)) / area(1.0);
}

void printSearch(const Model& model, const Root& root, const Arguments& arguments)
{
  SplitSearch search;
  const Seconds time = medianOf(
    arguments.runs, [&] { search = evolving::searchSplit(root.sides, root.axis, root.intervals); });
  Table table("Split search in the root box: " + model.name + ", axis " + "xyz" [root.axis],
    {
      "sample", "position", "N_L", "N_R", "cost / N", "parabola to the next: lowest at", "cost / N"
    });
  const auto count = static_cast<double>(root.intervals.size());
  for (std::size_t k = 0; k < search.samples.size(); ++k)
  {
    const auto& sample = search.samples[k];
    std::vector<std::string> row{ std::to_string(k), fixed(sample.position, 4),
      fixed(sample.leftCount, 0), fixed(sample.rightCount, 0), fixed(sample.cost / count, 4) };
    if (k < search.parabolas.size())
    {
      const float lowest = search.parabolas[k].lowest();
      row.push_back(fixed(lowest, 4));
      row.push_back(fixed(search.parabolas[k].at(lowest) / count, 4));
    }
    table.add(row);
  }
  constexpr int Positions = 1000;
  int best = 1;
  for (int p = 1; p < Positions; ++p)
  {
    best =
      exactCost(root, p * 1.0 / Positions) < exactCost(root, best * 1.0 / Positions) ? p : best;
  }
  table.note("split found: " + fixed(search.position, 4) + ", cost / N by the parabola " +
    fixed(search.cost / count, 4) + ", counted there " +
    fixed(exactCost(root, search.position) / count, 4));
  table.note("best of " + std::to_string(Positions) +
    " counted positions: " + fixed(best * 1.0 / Positions, 4) + ", cost / N " +
    fixed(exactCost(root, best * 1.0 / Positions) / count, 4));
  table.note("time of the search: " + fixed(1e3 * time.wall, 3) + " ms, " +
    fixed(1e9 * time.wall / count, 2) + " ns a triangle, one thread");
  table.print();
}

/// The curve of the figure beside its parabolas.
void printCurve(const Model& model, const Root& root)
{
  const SplitSearch search = evolving::searchSplit(root.sides, root.axis, root.intervals);
  Table table(
    "f_cost(x) / N of figure 5.3: " + model.name, { "x", "counted", "parabolas", "difference" });
  const auto count = static_cast<double>(root.intervals.size());
  for (int p = 0; p <= 20; ++p)
  {
    const double x = 0.05 * p;
    std::size_t piece = 0;
    while (
      piece + 1 < search.parabolas.size() && static_cast<double>(search.parabolas[piece].to) < x)
    {
      ++piece;
    }
    const double counted = exactCost(root, x) / count;
    const double parabola =
      static_cast<double>(search.parabolas[piece].at(static_cast<float>(x))) / count;
    table.add({ fixed(x, 2), fixed(counted, 4), fixed(parabola, 4), fixed(parabola - counted, 4) });
  }
  table.note("The thesis draws this curve for the bunny's root node and prints no numbers.");
  table.print();
}

} // namespace

int main(int argc, char** argv)
{
  const Arguments arguments = readArguments(
    argc, argv, {}, "The cost of splitting a model's root box (figure 5.3 of the thesis).");
  printHeader("SplitCost", arguments);
  for (const std::string& path : arguments.models)
  {
    const Model scan = readScan(path, arguments.subdivisions);
    const Root root = rootOf(kernelMesh(scan.surface));
    printSearch(scan, root, arguments);
    printCurve(scan, root);
  }
  return 0;
}
