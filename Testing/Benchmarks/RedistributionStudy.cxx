// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * What vtkTangentialRedistribution makes of the elements of a surface, setting by setting, beside
 * plain smoothing; and how far it takes points from the surface.
 */

#include "Arguments.h"
#include "ElementQuality.h"
#include "FilterRun.h"
#include "Models.h"
#include "Report.h"
#include "Timing.h"
#include "UmbrellaSmoothing.h"

#include "Trees/AABBTree.h"

#include "vtkNew.h"
#include "vtkSmoothPolyDataFilter.h"
#include "vtkTangentialRedistribution.h"

#include <algorithm>
#include <iostream>
#include <vector>

using namespace benchmark;

namespace
{

using evolving::Index;

struct Setting
{
  const char* name;
  void (*choose)(vtkTangentialRedistribution& filter); ///< from the defaults
};

const Setting Settings[] = {
  { "by volume, omega = 1",
    [](vtkTangentialRedistribution& filter)
    {
      filter.SetVolumeRedistribution(1.0);
      filter.SetAngleRedistribution(0.0);
    } },
  { "by angle as in (3.24), omega = 3",
    [](vtkTangentialRedistribution& filter)
    {
      filter.SetAngleMethodToWeightedEdges();
      filter.SetAngleRedistribution(3.0);
    } },
  { "default", [](vtkTangentialRedistribution&) {} },
  { "default, 200 steps",
    [](vtkTangentialRedistribution& filter) { filter.SetNumberOfSteps(200); } },
  { "default, and by volume, omega = 1",
    [](vtkTangentialRedistribution& filter) { filter.SetVolumeRedistribution(1.0); } },
};

/// The surface before, for all that is measured against it.
struct Input
{
  Model model;
  evolving::SurfaceMesh mesh;
  evolving::AABBTree tree;

  explicit Input(const Model& read)
    : model(read)
    , mesh(kernelMesh(read.surface))
    , tree(this->mesh)
  {
  }

  double diagonal() const { return evolving::boundingBox(this->mesh).diagonal().norm(); }
};

/// Of the points from a surface.
double farthest(const std::vector<evolving::Vec3>& points, const evolving::AABBTree& surface)
{
  double distance = 0.0;
  for (const evolving::Vec3& point : points)
  {
    distance = std::max(distance, (surface.closest(point).at.point - point).norm());
  }
  return distance;
}

/// Elements that face away from the input where it is closest to their middle.
int turnedFaces(const evolving::SurfaceMesh& result, const Input& input)
{
  int count = 0;
  for (Index f = 0; f < result.faceCount(); ++f)
  {
    const evolving::Vec3 middle =
      (result.facePoint(f, 0) + result.facePoint(f, 1) + result.facePoint(f, 2)) / 3.0;
    const Index closest = input.tree.closest(middle).triangle;
    const evolving::Vec3 outwards = input.tree.triangle(closest).doubleAreaNormal();
    count += outwards.dot(evolving::faceVectorArea(result, f)) < 0.0 ? 1 : 0;
  }
  return count;
}

bool areIdsKept(const evolving::SurfaceMesh& result, const Input& input)
{
  return result.vertexCount() == input.mesh.vertexCount() &&
    result.faceOffsets == input.mesh.faceOffsets &&
    result.cornerVertices == input.mesh.cornerVertices;
}

void addRow(Table& table, const char* name, const evolving::SurfaceMesh& result, const Input& input,
  const std::string& seconds)
{
  const ElementQuality quality = elementQuality(result);
  const double off = farthest(result.points, input.tree) / input.diagonal();
  const double lost = farthest(input.mesh.points, evolving::AABBTree(result)) / input.diagonal();
  table.add({ name, fixed(quality.smallestAngle, 3), fixed(quality.firstPercentile, 3),
    fixed(quality.meanAngle, 3), fixed(100.0 * quality.partBelow30, 3) + " %",
    fixed(quality.radiusRatio, 4), fixed(100.0 * quality.areaSpread, 2) + " %",
    fixed(100.0 * quality.coVolumeSpread, 2) + " %", std::to_string(turnedFaces(result, input)),
    general(off, 2), general(lost, 2), areIdsKept(result, input) ? "kept" : "CHANGED", seconds });
}

/// @return why the filter refuses the surface; empty when it has done its work
std::string addSetting(
  Table& table, const Setting& setting, const Input& input, const Arguments& arguments)
{
  vtkNew<vtkTangentialRedistribution> filter;
  filter->SetInputData(input.model.surface);
  setting.choose(*filter);
  const FilterRun run = runFilter(filter, arguments);
  if (run.error.empty())
  {
    addRow(table, setting.name, kernelMesh(filter->GetOutput()), input, fixed(run.time.cpu, 2));
  }
  return run.error;
}

void addUmbrella(Table& table, const char* name, const UmbrellaSmoothing& smoothing,
  const Input& input, const Arguments& arguments)
{
  evolving::SurfaceMesh result;
  const Seconds seconds =
    medianOf(arguments.runs, [&] { result = smoothed(input.mesh, input.tree, smoothing); });
  addRow(table, name, result, input, fixed(seconds.cpu, 2));
}

/// As plain smoothing, boundary points stay and no edge is sharp.
void addSmoothPolyData(Table& table, const Input& input, const Arguments& arguments)
{
  const UmbrellaSmoothing same;
  vtkNew<vtkSmoothPolyDataFilter> filter;
  filter->SetInputData(input.model.surface);
  filter->SetSourceData(input.model.surface);
  filter->SetNumberOfIterations(same.iterations);
  filter->SetRelaxationFactor(same.factor);
  filter->FeatureEdgeSmoothingOff();
  filter->BoundarySmoothingOff();
  const FilterRun run = runFilter(filter, arguments);
  addRow(table, "vtkSmoothPolyDataFilter, 100 steps", kernelMesh(filter->GetOutput()), input,
    fixed(run.time.cpu, 2));
}

void addRows(Table& table, const Input& input, const Arguments& arguments)
{
  addRow(table, "input", input.mesh, input, "");
  for (const Setting& setting : Settings)
  {
    const std::string refusal = addSetting(table, setting, input, arguments);
    if (!refusal.empty())
    {
      table.add({ "refused by the filter" });
      table.note(refusal);
      return;
    }
  }
  addUmbrella(table, "umbrella, 100 steps", {}, input, arguments);
  addUmbrella(table, "umbrella, tangential, 100 steps", { 100, 0.5, true }, input, arguments);
  addSmoothPolyData(table, input, arguments);
}

void printModel(const Model& model, const Arguments& arguments)
{
  Table table(model.name,
    { "", "least angle", "p1", "mean", "below 30", "radius ratio", "areas", "co-volumes",
      "turned over", "off input", "input off", "ids", "CPU s" });
  addRows(table, Input(model), arguments);
  if (model.name.rfind("rocker_arm", 0) == 0)
  {
    table.note(
      "To be reached: p1 24.5 and a mean of 44.5 by angle as in (3.24), 26.5 and 45.9 by the"
      " best setting, and at most 1e-6 off the input.");
  }
  table.print();
}

void explainColumns()
{
  std::cout
    << "Angles: the smallest of every face, in degrees; p1: their first percentile.\n"
       "Areas, co-volumes: standard deviation by mean; the volume-based redistribution makes"
       " co-volumes equal.\n"
       "Turned over: faces that face away from the input where it is closest.\n"
       "Off input: the farthest point, by the diagonal of the box; input off: the input's"
       " point farthest from the result, as of an edge that was cut off.\n";
}

} // namespace

int main(int argc, char** argv)
{
  Arguments defaults;
  defaults.runs = 1;
  defaults.subdivisions = 0;
  const Arguments arguments = readArguments(argc, argv, defaults,
    "Elements of every mesh, cut into triangles, after vtkTangentialRedistribution and after plain"
    " smoothing.");
  printHeader("RedistributionStudy", arguments);
  for (const std::string& path : arguments.models)
  {
    const Model model = readScan(path, arguments.subdivisions);
    if (model.triangles() > 0) // a folder may hold point sets, too
    {
      printModel(model, arguments);
    }
  }
  explainColumns();
  return 0;
}
