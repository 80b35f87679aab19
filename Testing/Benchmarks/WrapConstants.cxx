// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * What the constants of shrink-wrapping (ShrinkWrap/WrapTuning.h) were chosen by: all models are
 * wrapped with one constant after the other varied, and measured.
 */

#include "Arguments.h"
#include "ElementQuality.h"
#include "Models.h"
#include "Report.h"
#include "SurfaceDeviation.h"
#include "Timing.h"
#include "WrapConstantList.h"

#include "Evolution/SurfaceFlow.h"
#include "Mesh/SelfIntersections.h"
#include "Mesh/TopologySummary.h"
#include "ShrinkWrap/ShrinkWrap.h"

#include <algorithm>
#include <cmath>
#include <exception>
#include <optional>
#include <random>
#include <vector>

using namespace benchmark;

namespace
{

using evolving::SurfaceMesh;

/// Of one model.
struct Measures
{
  ElementQuality elements;
  SurfaceDeviation off;
  std::size_t crossings = 0;
  evolving::Index genus = 0; ///< of all components together
  evolving::Index components = 0;
  double seconds = 0.0;
};

SurfaceMesh wrap(const SurfaceMesh& mesh, const WrapCase& how, double edgeLength,
  const evolving::WrapTuning& tuning, const evolving::Execution& execution)
{
  evolving::ShrinkWrapOptions options = how.options;
  options.targetEdgeLength = edgeLength;
  options.offsetDistance = how.offset * edgeLength;
  const auto problem = evolving::prepareShrinkWrap(mesh, options, execution, tuning);
  evolving::SurfaceFlow flow(
    problem.start, problem.field, problem.remesher, problem.flow, execution);
  while (!flow.isFinished())
  {
    flow.step();
  }
  return flow.mesh();
}

/// Its points alone, moved by a tenth of their mean distance.
SurfaceMesh noisyPoints(const SurfaceMesh& mesh)
{
  const double spacing = std::sqrt(evolving::surfaceArea(mesh) / mesh.vertexCount());
  std::mt19937 random(1);
  std::normal_distribution<double> noise(0.0, 0.1 * spacing);
  SurfaceMesh points;
  points.points = mesh.points;
  for (evolving::Vec3& point : points.points)
  {
    const double x = noise(random);
    const double y = noise(random);
    point += evolving::Vec3(x, y, noise(random));
  }
  return points;
}

/// Nothing where the wrap refuses.
std::optional<Measures> measure(const SurfaceMesh& mesh, const WrapCase& how, double vertices,
  const evolving::WrapTuning& tuning, const evolving::Execution& execution)
{
  const double edgeLength =
    std::sqrt(2.0 * evolving::surfaceArea(mesh) / (vertices * std::sqrt(3.0)));
  try
  {
    const SurfaceMesh input = how.asPoints ? noisyPoints(mesh) : mesh;
    SurfaceMesh surface;
    Measures measures;
    measures.seconds =
      timed([&] { surface = wrap(input, how, edgeLength, tuning, execution); }).cpu;
    measures.elements = elementQuality(surface);
    measures.off = deviation(surface, mesh);
    measures.crossings = evolving::selfIntersections(surface).size();
    const evolving::TopologySummary topology = evolving::summarizeTopology(surface);
    measures.components = topology.components;
    measures.genus = topology.isClosed() && topology.isManifold() ? topology.genus() : -1;
    return measures;
  }
  catch (const std::exception&)
  {
    return std::nullopt;
  }
}

using Results = std::vector<std::optional<Measures>>; ///< one a model

const std::vector<std::string> Columns{ "constant", "value", "refused", "topology", "crossings",
  "least angle", "mean least", "p1", "radius ratio", "hausdorff", "forward rms", "backward rms",
  "CPU s" };

const std::vector<std::string> Notes{
  "Topology: on how many models it is another than with the chosen value, marked *. Crossings:"
  " pairs of triangles, of all models.",
  "Angles: least of all models; means over the models of each one's least and of its first"
  " percentile, in degrees.",
  "Distances: geometric means over the models, by what they are with the chosen value."
};

/// The rows of one constant are compared on the models that all runs wrap.
class Row
{
public:
  Row(const Results& results, const Results& chosen)
  {
    for (std::size_t m = 0; m < results.size(); ++m)
    {
      if (!results[m] || !chosen[m])
      {
        this->Refused += results[m] ? 0 : 1;
        continue;
      }
      this->add(*results[m], *chosen[m]);
    }
  }

  std::vector<std::string> cells() const
  {
    const double n = std::max(1.0, this->Count);
    return { fixed(this->Refused, 0), fixed(this->Changed, 0), fixed(this->Crossings, 0),
      fixed(this->Least, 2), fixed(this->LeastSum / n, 2), fixed(this->FirstPercentile / n, 2),
      fixed(this->RadiusRatio / n, 4), fixed(std::exp(this->Hausdorff / n), 3),
      fixed(std::exp(this->Forward / n), 3), fixed(std::exp(this->Backward / n), 3),
      fixed(this->Seconds, 1) };
  }

private:
  void add(const Measures& now, const Measures& chosen)
  {
    const auto byChosen = [](double value, double other)
    { return value > 0.0 && other > 0.0 ? std::log(value / other) : 0.0; };
    this->Count += 1.0;
    this->Changed += now.genus != chosen.genus || now.components != chosen.components ? 1 : 0;
    this->Crossings += static_cast<double>(now.crossings);
    this->Least = std::min(this->Least, now.elements.smallestAngle);
    this->LeastSum += now.elements.smallestAngle;
    this->FirstPercentile += now.elements.firstPercentile;
    this->RadiusRatio += now.elements.radiusRatio;
    this->Hausdorff += byChosen(now.off.hausdorff(), chosen.off.hausdorff());
    this->Forward += byChosen(now.off.forward.rms, chosen.off.forward.rms);
    this->Backward += byChosen(now.off.backward.rms, chosen.off.backward.rms);
    this->Seconds += now.seconds;
  }

  double Count = 0.0;
  double Refused = 0.0;
  double Changed = 0.0;
  double Crossings = 0.0;
  double Least = 180.0;
  double LeastSum = 0.0;
  double FirstPercentile = 0.0;
  double RadiusRatio = 0.0;
  double Hausdorff = 0.0; ///< sums of logarithms, as the next two
  double Forward = 0.0;
  double Backward = 0.0;
  double Seconds = 0.0;
};

class Study
{
public:
  Study(const WrapCase& how, int vertices, const std::vector<SurfaceMesh>& models, int threads)
    : Case(how)
    , Vertices(vertices)
    , Models(models)
    , Run(executionOn(threads))
    , Rows(how.title + ", about " + std::to_string(vertices) + " vertices", Columns, 1)
  {
  }

  void print()
  {
    const Results chosen = this->resultsWith({});
    this->addRow("all as chosen", "*", chosen, chosen);
    for (const WrapConstant& constant : this->Case.constants)
    {
      for (const double value : constant.others)
      {
        evolving::WrapTuning tuning;
        constant.set(tuning, value);
        this->addRow(constant.name + " " + general(constant.chosen, 4) + " *", general(value, 4),
          this->resultsWith(tuning), chosen);
      }
    }
    for (const std::string& note : Notes)
    {
      this->Rows.note(note);
    }
    this->Rows.print();
  }

private:
  Results resultsWith(const evolving::WrapTuning& tuning) const
  {
    Results results;
    for (const SurfaceMesh& mesh : this->Models)
    {
      results.push_back(measure(mesh, this->Case, this->Vertices, tuning, this->Run));
    }
    return results;
  }

  void addRow(const std::string& name, const std::string& value, const Results& results,
    const Results& chosen)
  {
    std::vector<std::string> row{ name, value };
    const std::vector<std::string> cells = Row(results, chosen).cells();
    row.insert(row.end(), cells.begin(), cells.end());
    this->Rows.add(row);
  }

  const WrapCase& Case;
  int Vertices;
  const std::vector<SurfaceMesh>& Models;
  evolving::Execution Run;
  Table Rows;
};

/// Point sets are left out: the area that sizes follow from is not theirs.
std::vector<SurfaceMesh> readModels(const Arguments& arguments)
{
  std::vector<SurfaceMesh> models;
  for (const std::string& path : arguments.models)
  {
    SurfaceMesh mesh = kernelMesh(readScan(path, 0).surface);
    if (mesh.faceCount() > 0)
    {
      models.push_back(std::move(mesh));
    }
  }
  return models;
}

} // namespace

int main(int argc, char** argv)
{
  const std::vector<WrapCase> cases = wrapCases();
  Arguments defaults;
  defaults.models = { dataFolder() };
  defaults.sizes = { 2000 };
  for (const WrapCase& one : cases)
  {
    defaults.switches[one.name] = false;
  }
  const Arguments arguments = readArguments(argc, argv, defaults,
    "What results with other constants of shrink-wrapping, with about --sizes vertices. The"
    " switches choose what is wrapped how; without one all tables are printed.");
  const bool isAny = std::any_of(
    cases.begin(), cases.end(), [&](const WrapCase& one) { return arguments.isOn(one.name); });
  printHeader("WrapConstants", arguments);
  const std::vector<SurfaceMesh> models = readModels(arguments);
  for (const int vertices : arguments.sizes)
  {
    for (const WrapCase& one : cases)
    {
      if (!isAny || arguments.isOn(one.name))
      {
        Study(one, vertices, models, arguments.threads).print();
      }
    }
  }
  return 0;
}
