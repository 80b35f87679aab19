// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * vtkShrinkWrap beside CGAL's alpha_wrap_3 on the models that engineers have: by the eye's
 * measures, with the same number of points, in one run.
 */

#include "Arguments.h"
#include "CGALPeer.h"
#include "FilterRun.h"
#include "LengthSearch.h"
#include "Models.h"
#include "Report.h"
#include "WrapFigures.h"

#include "Mesh/TopologySummary.h"

#include "vtkNew.h"
#include "vtkShrinkWrap.h"

#include <cmath>
#include <exception>
#include <filesystem>
#include <map>
#include <optional>
#include <vector>

using namespace benchmark;

namespace
{

using evolving::SurfaceMesh;

constexpr int DefaultPoints = 9000; ///< of vtkShrinkWrap on smooth models, about

/// The offset that CGAL takes when it is given none is this part of alpha.
constexpr double OffsetPart = 1.0 / 30.0;

/// At which the models of this project's tables have always been compared: as many points as
/// alpha_wrap_3 made of them when the first of those tables was filled.
int usualPoints(const std::string& file)
{
  static const std::map<std::string, int> points{ { "flange", 9000 }, { "gears", 5950 },
    { "knight", 9000 }, { "mixer", 9000 }, { "motorbike", 7200 }, { "pi_case", 8070 },
    { "plate_holes", 9100 }, { "propeller", 13600 }, { "tray", 8800 } };
  const auto found = points.find(std::filesystem::path(file).stem().string());
  return found != points.end() ? found->second : DefaultPoints;
}

/// A surface and how long it took.
struct Wrap
{
  SurfaceMesh surface; ///< without faces where there is none
  Seconds time;
  std::string remark = {}; ///< the error, in one line
};

Wrap shrinkWrap(vtkPolyData* model, int points, const Arguments& arguments)
{
  vtkNew<vtkShrinkWrap> filter;
  filter->SetInputData(model);
  filter->SetTargetNumberOfPoints(points);
  const FilterRun run = runFilter(filter, arguments);
  return { kernelMesh(filter->GetOutput()), run.time, run.error };
}

/// Of the alpha for which the number of points is the asked one.
Wrap alphaWrap(const SurfaceMesh& target, int points)
{
  if (CGALPeer::version().empty())
  {
    return { {}, {}, "not available (install libcgal-dev)" };
  }
  try
  {
    CGALPeer peer(target);
    std::map<double, Wrap> tried; // a search repeats nothing: some models take a minute each time
    const double guess = std::sqrt(2.0 * evolving::surfaceArea(target) / (points * std::sqrt(3.0)));
    const double alpha = lengthForVertices(points, guess,
      [&](double length)
      {
        const Seconds time = timed([&] { peer.wrap(length, OffsetPart * length); });
        tried[length] = { peer.result(), time };
        return static_cast<double>(tried[length].surface.vertexCount());
      });
    return tried.at(alpha);
  }
  catch (const std::exception& error)
  {
    const std::string message = error.what();
    return { {}, {}, message.substr(0, message.find('\n')) };
  }
}

void addRow(Table& table, const std::string& model, const std::string& method, const Wrap& wrap,
  const std::optional<WrapFigures>& figures, const std::optional<WrapFigures>& others,
  vtkPolyData* target)
{
  std::vector<std::string> row{ model, method };
  if (!figures)
  {
    table.add(row, wrap.remark);
    return;
  }
  const WrapFigures nothing(figures->size(), std::nan(""));
  const std::vector<std::string> texts = withStars(*figures, others.value_or(nothing), target);
  row.insert(row.end(), texts.begin(), texts.end());
  table.add(row);
}

void compare(const std::string& path, int points, const Arguments& arguments, Table& table)
{
  const Model model = readModel(path);
  const vtkSmartPointer<vtkPolyData> target = readScan(path, 0).surface;
  const SurfaceMesh mesh = kernelMesh(target);
  if (mesh.faceCount() == 0)
  {
    table.add({ model.name }, "has no faces");
    return;
  }
  const auto figuresOf = [&](const Wrap& wrap)
  {
    return wrap.surface.faceCount() > 0
      ? std::optional<WrapFigures>(wrapFigures(wrap.surface, target, wrap.time))
      : std::nullopt;
  };
  const Wrap theirs = alphaWrap(mesh, points);
  const Wrap ours = shrinkWrap(model.surface, points, arguments);
  const std::optional<WrapFigures> their = figuresOf(theirs);
  const std::optional<WrapFigures> our = figuresOf(ours);
  addRow(table, model.name, "alpha_wrap_3", theirs, their, our, target);
  addRow(table, "", "vtkShrinkWrap", ours, our, their, target);
}

} // namespace

int main(int argc, char** argv)
{
  Arguments defaults;
  defaults.models = { dataFolder() };
  defaults.runs = 1;
  const Arguments arguments = readArguments(argc, argv, defaults,
    "vtkShrinkWrap beside CGAL's alpha_wrap_3 (offset: alpha/30) with the same number of points,"
    " model by model: --sizes, or the number that a table has always had for models of its name.");
  printHeader("EngineeringComparison", arguments);
  std::vector<std::string> columns{ "model", "method" };
  const std::vector<std::string> names = figureNames();
  columns.insert(columns.end(), names.begin(), names.end());
  Table table("The same number of points", columns, 2);
  for (const std::string& path : arguments.models)
  {
    for (const int points :
      arguments.sizes.empty() ? std::vector<int>{ usualPoints(path) } : arguments.sizes)
    {
      compare(path, points, arguments, table);
    }
  }
  for (const std::string& note : figureNotes())
  {
    table.note(note);
  }
  table.note(CGALPeer::version() +
    ": one thread, alpha searched for; seconds, of the clock, are those of the run with that "
    "alpha.");
  table.print();
  return 0;
}
