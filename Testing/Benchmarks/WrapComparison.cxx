// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * vtkShrinkWrap beside CGAL's alpha_wrap_3 and isotropic_remeshing: the same inputs, the same
 * number of vertices, measured by the same code in one run.
 */

#include "Arguments.h"
#include "CGALPeer.h"
#include "FilterRun.h"
#include "LengthSearch.h"
#include "Models.h"
#include "Report.h"
#include "SurfaceMeasures.h"
#include "Timing.h"

#include "Mesh/TopologySummary.h"

#include "vtkNew.h"
#include "vtkShrinkWrap.h"

#include <cmath>
#include <functional>
#include <stdexcept>
#include <vector>

using namespace benchmark;

namespace
{

using evolving::SurfaceMesh;

constexpr int DefaultVertices = 9000; ///< of vtkShrinkWrap, about

/// Of alpha, the offset that CGAL takes when it is given none, and one for better elements.
constexpr int OffsetParts[] = { 30, 6 };

const char* const Adapt = "--adapt";
const char* const Features = "--features";

/// A model as its reader gives it, and what the results are measured against.
struct Input
{
  Model model;
  SurfaceMesh mesh; ///< welded triangles, or points alone

  explicit Input(const std::string& path)
    : model(readModel(path))
    , mesh(kernelMesh(readScan(path, 0).surface))
  {
    if (this->mesh.faceCount() == 0)
    {
      this->mesh = kernelMesh(this->model.surface);
    }
  }

  bool isPointSet() const { return this->mesh.faceCount() == 0; }
  double diagonal() const { return evolving::boundingBox(this->mesh).diagonal().norm(); }
  /// Of equilateral triangles on as many vertices; of points, whose area nobody knows, a guess.
  double edgeLength(int vertices) const
  {
    return this->isPointSet()
      ? this->diagonal() / std::sqrt(vertices)
      : std::sqrt(2.0 * evolving::surfaceArea(this->mesh) / (vertices * std::sqrt(3.0)));
  }
};

/// What isotropic_remeshing does not take.
std::string describeFaults(const Input& input)
{
  if (input.isPointSet())
  {
    return "needs triangles, this is a point set";
  }
  const evolving::TopologySummary topology = evolving::summarizeTopology(input.mesh);
  return "needs a manifold mesh; edges of more than two faces: " +
    std::to_string(topology.nonManifoldEdges) +
    ", between faces of opposite orientation: " + std::to_string(topology.flippedEdges) +
    ", vertices where fans of faces meet: " + std::to_string(topology.nonManifoldVertices);
}

std::vector<std::string> joined(
  std::vector<std::string> first, const std::vector<std::string>& second)
{
  first.insert(first.end(), second.begin(), second.end());
  return first;
}

/// A table to which the methods add a row per model.
class Comparison
{
public:
  Comparison(int vertices, const Arguments& arguments)
    : Results("About " + std::to_string(vertices) + " vertices",
        joined({ "model", "method", "seconds", "CPU s" }, measureNames()), 2)
    , Vertices(vertices)
    , Settings(arguments)
  {
  }

  void add(const Input& input)
  {
    const int vertices = this->addShrinkWrap(input);
    if (!CGALPeer::version().empty())
    {
      this->addPeers(input, vertices);
    }
  }
  void print();

private:
  int addShrinkWrap(const Input& input);
  void addPeers(const Input& input, int vertices);
  void addPeer(const Input& input, const std::string& name, const CGALPeer& peer, double length,
    int vertices, const std::function<void(double)>& run);
  void addRow(
    const Input& input, const std::string& method, const Seconds& time, const SurfaceMesh& surface);

  Table Results;
  int Vertices;
  Arguments Settings;
};

void Comparison::addRow(
  const Input& input, const std::string& method, const Seconds& time, const SurfaceMesh& surface)
{
  this->Results.add(joined({ input.model.name, method, fixed(time.wall, 2), fixed(time.cpu, 2) },
    surfaceMeasures(surface, input.mesh)));
}

/// @return how many vertices the others shall make
int Comparison::addShrinkWrap(const Input& input)
{
  vtkNew<vtkShrinkWrap> filter;
  filter->SetInputData(input.model.surface);
  filter->SetAdaptToCurvature(this->Settings.isOn(Adapt));
  filter->SetPreserveFeatures(
    this->Settings.isOn(Features) ? vtkShrinkWrap::ON : vtkShrinkWrap::AUTOMATIC);
  if (this->Vertices != DefaultVertices && !input.isPointSet())
  {
    filter->SetTargetEdgeLength(input.edgeLength(this->Vertices));
  }
  const FilterRun run = runFilter(filter, this->Settings);
  const SurfaceMesh surface = kernelMesh(filter->GetOutput());
  if (surface.faceCount() == 0)
  {
    this->Results.add({ input.model.name, "vtkShrinkWrap" }, run.error);
    return this->Vertices;
  }
  this->addRow(input, "vtkShrinkWrap", run.time, surface);
  if (!run.error.empty())
  {
    this->Results.note(input.model.name + ": " + run.error);
  }
  return static_cast<int>(surface.vertexCount());
}

void Comparison::addPeers(const Input& input, int vertices)
{
  CGALPeer peer(input.mesh);
  const double length = input.edgeLength(vertices);
  for (const int part : OffsetParts)
  {
    this->addPeer(input, "alpha_wrap_3 (a/" + std::to_string(part) + ")", peer, length, vertices,
      [&](double alpha) { peer.wrap(alpha, alpha / part); });
  }
  if (!peer.canRemesh())
  {
    this->Results.add({ input.model.name, "isotropic_remeshing" }, describeFaults(input));
    return;
  }
  const double sharp =
    this->Settings.isOn(Features) ? vtkNew<vtkShrinkWrap>()->GetFeatureAngle() : 0.0;
  this->addPeer(input, "isotropic_remeshing", peer, length, vertices,
    [&](double edgeLength) { peer.remesh(edgeLength, sharp); });
}

void Comparison::addPeer(const Input& input, const std::string& name, const CGALPeer& peer,
  double length, int vertices, const std::function<void(double)>& run)
{
  try
  {
    const double found = lengthForVertices(vertices, length,
      [&](double tried)
      {
        run(tried);
        return static_cast<double>(peer.result().vertexCount());
      });
    const Seconds time = medianOf(this->Settings.runs, [&] { run(found); });
    const std::string part = ", d/" + fixed(input.diagonal() / found, 1);
    this->addRow(input, name + part, time, peer.result());
  }
  catch (const std::exception& error)
  {
    const std::string message = error.what();
    this->Results.add({ input.model.name, name }, message.substr(0, message.find('\n')));
  }
}

void Comparison::print()
{
  const std::string version = CGALPeer::version();
  for (const std::string& note : measureNotes())
  {
    this->Results.note(note);
  }
  if (version.empty())
  {
    this->Results.note("alpha_wrap_3, isotropic_remeshing: not available (install libcgal-dev)");
  }
  else
  {
    this->Results.note(version +
      ": d/... is alpha or the edge length, searched for as many vertices as"
      " vtkShrinkWrap makes before the clock starts; a/... the offset; one thread.");
  }
  this->Results.print();
}

} // namespace

int main(int argc, char** argv)
{
  Arguments defaults;
  defaults.models = { dataFolder() };
  defaults.sizes = { DefaultVertices };
  defaults.runs = 1;
  defaults.switches = { { Adapt, false }, { Features, false } };
  const Arguments arguments = readArguments(argc, argv, defaults,
    "vtkShrinkWrap beside CGAL's alpha_wrap_3 and isotropic_remeshing, with about --sizes"
    " vertices. --adapt turns AdaptToCurvature on, --features PreserveFeatures.");
  printHeader("WrapComparison", arguments);
  for (const int vertices : arguments.sizes)
  {
    Comparison comparison(vertices, arguments);
    for (const std::string& path : arguments.models)
    {
      comparison.add(Input(path));
    }
    comparison.print();
  }
  return 0;
}
