// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "BaseShapes.h"
#include "EvolutionJudge.h"
#include "FilterCase.h"
#include "OutputChecks.h"

#include "EventLog.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkMeshSDF.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkSurfaceEvolution.h"
#include "vtkTable.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace robustness
{

namespace
{

class EvolutionCase : public FilterCase
{
public:
  EvolutionCase(const Subject& subject, Random& random)
    : FilterCase(subject, random)
  {
    if (random.chance(0.55) && subject.isUsable() && !subject.model.points.empty())
    {
      this->makeField(random);
    }
    this->drawFlow();
    this->drawRedistribution();
    this->drawElements();
    this->drawTime(random);
    this->Filter->SetInputDataObject(0, subject.data);
  }

  vtkAlgorithm* filter() override { return this->Filter; }

  void update() override
  {
    if (this->AsksForTime)
    {
      this->Filter->UpdateTimeStep(this->AskedTime);
    }
    else
    {
      this->Filter->Update();
    }
  }

  std::string describe() override
  {
    const std::string time = this->AsksForTime ? ", at " + std::to_string(this->AskedTime) : "";
    return FilterCase::describe() + this->FieldText + time;
  }

  std::string whyRefuse() const override
  {
    if (this->Input.model.points.empty())
    {
      return "";
    }
    const std::string why = this->whySurfaceIsRefused();
    if (!why.empty())
    {
      return why;
    }
    const Topology& topology = this->Input.topology;
    const bool isStart = topology.isManifold() && topology.isOriented();
    if (!isStart && !this->isSplitFirst())
    {
      return "the start is not an oriented manifold";
    }
    if (this->FieldHasNaN)
    {
      return "the field has values that are no numbers";
    }
    const bool remeshes = this->Filter->GetRemeshing() != vtkSurfaceEvolution::OFF;
    return remeshes && this->Parameters.isNaN("TargetEdgeLength") ? "TargetEdgeLength is NaN"
      : this->Parameters.isNaN("TimeStep")                        ? "TimeStep is NaN"
                                                                  : "";
  }

  bool mustAccept() const override
  {
    return this->Parameters.areSensible() && this->Input.model.isClean && this->Input.isSolid() &&
      !this->FieldHasNaN;
  }

  void judge(std::size_t) override
  {
    vtkPolyData* state = this->Filter->GetOutput();
    judgeState(this->Input, this->Filter->GetRemeshing() != vtkSurfaceEvolution::OFF, state);
    judgeHistory(vtkTable::SafeDownCast(this->Filter->GetOutputDataObject(1)), state,
      { "Time", "Area", "Volume", "MeanDistance", "MaxDistance", "MinAngle" });
    this->judgeTime(state);
    if (fieldNumber(state, "Iteration") == 0.0 && this->Input.topology.isClosed())
    {
      const double volume = fieldNumber(state, "Volume");
      require(volume >= 0.0, Fault::NotOriented, "the closed start has the volume ", volume);
    }
  }

private:
  /// Polygons that use a point twice may be good triangles once they are split.
  bool isSplitFirst() const
  {
    const auto& faces = this->Input.surface.faces;
    const int remeshing = this->Filter->GetRemeshing();
    return (remeshing == vtkSurfaceEvolution::UNIFORM ||
             remeshing == vtkSurfaceEvolution::CURVATURE_ADAPTIVE) &&
      std::any_of(faces.begin(), faces.end(), [](const Cell& face) { return face.size() > 3; });
  }

  /// The published time nearest to the one asked for, or the state in which the flow ended.
  void judgeTime(vtkPolyData* state)
  {
    const double time = fieldNumber(state, "Time");
    const double step = this->publishedStep();
    const int last = this->Filter->GetNumberOfSteps() + this->Filter->GetSmoothingSteps();
    const double end = last * step;
    const double asked = this->AsksForTime ? std::clamp(this->AskedTime, 0.0, end) : end;
    const double half = 0.5 * this->Filter->GetOutputInterval() * step;
    const double iteration = fieldNumber(state, "Iteration");
    const double real = iteration * fieldNumber(state, "TimeStep");
    require(iteration * step <= asked + 1.001 * half && std::abs(time - real) <= 1e-9 * real,
      Fault::Misstated, "the state is of time ", time, ", iteration ", iteration, " by ",
      fieldNumber(state, "TimeStep"), ", asked for was ", asked, " of ", end);
  }

  /// Times count steps where the step is automatic.
  double publishedStep() const
  {
    const double step = this->Filter->GetTimeStep();
    return step > 0.0 ? step : 1.0;
  }

  /// The distance to the start itself or to a ball in its box.
  void makeField(Random& random)
  {
    vtkNew<vtkMeshSDF> distance;
    const bool ofStart = random.chance(0.4);
    const Model ball = icosphere(
      random.integer(0, 2), random.real(0.2, 1.5) * this->Input.radius, this->Input.centre);
    distance->SetInputDataObject(ofStart ? this->Input.data : toPolyData(ball));
    const int samples = random.integer(6, 24);
    distance->SetSampleDimensions(samples, samples, samples);
    distance->SetPadding(random.real(0.05, 1.0));
    const EventLog log(distance); // what it says is for its own judge
    distance->Update();
    vtkNew<vtkImageData> image;
    image->DeepCopy(distance->GetOutput());
    vtkDataArray* values = image->GetPointData()->GetScalars();
    if (!values)
    {
      return;
    }
    this->FieldText = ofStart ? ", distance to itself" : ", distance to a ball";
    this->FieldText += " on " + std::to_string(samples) + "^3";
    if (this->Parameters.isOdd() && random.chance(0.3))
    {
      this->FieldHasNaN = true;
      values->SetComponent(vtkIdType(random.index(std::size_t(values->GetNumberOfTuples()))), 0,
        std::numeric_limits<double>::quiet_NaN());
      this->FieldText += ", with a NaN";
    }
    this->Filter->SetInputDataObject(1, image);
  }

  void drawFlow()
  {
    Random& random = this->Parameters.random();
    Draws& draw = this->Parameters;
    const auto& filter = this->Filter;
    const double timeStep = random.logarithmic(1e-3, 0.3);
    filter->SetTimeStep(draw.number("TimeStep", random.chance(0.4) ? 0.0 : timeStep));
    filter->SetNumberOfSteps(random.chance(0.1) ? random.integer(20, 60) : random.integer(0, 12));
    filter->SetOutputInterval(random.integer(1, 4));
    filter->SetCurvatureSpeed(draw.rate("CurvatureSpeed", 0.9, 1e-3, 1.0));
    filter->SetCurvatureRange(draw.number("CurvatureRange", random.logarithmic(1e-3, 1.0)));
    filter->SetAdvectionSpeed(draw.rate("AdvectionSpeed", 0.9, 0.1, 3.0));
    filter->SetAdvectionBalance(draw.rate("AdvectionBalance", 0.3, 0.1, 1.0));
    filter->SetRelativeUnits(random.chance(0.8));
    filter->SetFieldMode(random.chance(0.2) ? random.integer(1, 2) : 0);
    filter->SetEdgeSharpness(draw.rate("EdgeSharpness", 0.5, 1e-2, 100.0));
    if (filter->GetFieldMode() == vtkSurfaceEvolution::IMAGE && filter->GetEdgeSharpness() == 0.0)
    {
      filter->SetFieldModeToEdgeImage(); // in a distance the automatic one rightly sees no edges
    }
    filter->SetNormalSpeed(
      (random.chance(0.5) ? 1.0 : -1.0) * draw.rate("NormalSpeed", 0.5, 0.1, 3.0));
    filter->SetBoundaryMode(random.integer(0, 2));
    filter->SetSurfaceGuard(draw.number("SurfaceGuard", random.real(1.0, 4.0)));
    filter->SetConvergenceTolerance(draw.rate("ConvergenceTolerance", 0.2, 1e-4, 0.1));
    filter->SetSmoothingSteps(random.chance(0.2) ? random.integer(1, 6) : 0);
    filter->SetSmoothingSpeed(draw.rate("SmoothingSpeed", 0.8, 1e-4, 0.1));
    filter->SetSmoothingDecay(draw.rate("SmoothingDecay", 0.8, 1e-2, 1.0));
    this->drawVolumeFlow();
    filter->SetSolverTolerance(
      draw.number("SolverTolerance", random.chance(0.8) ? 1e-10 : random.logarithmic(1e-15, 1e-2)));
  }

  /// Where nothing else moves the surface; the others are refused.
  void drawVolumeFlow()
  {
    Random& random = this->Parameters.random();
    const bool isFree =
      this->Filter->GetNumberOfInputConnections(1) == 0 && this->Input.topology.isClosed();
    this->Filter->SetFlow(isFree && random.chance(0.25) ? 1 : 0);
    this->Filter->SetVolumePreserving(isFree && random.chance(0.25));
  }

  void drawRedistribution()
  {
    Random& random = this->Parameters.random();
    Draws& draw = this->Parameters;
    const auto& filter = this->Filter;
    filter->SetVolumeRedistribution(draw.rate("VolumeRedistribution", 0.4, 0.1, 100.0));
    filter->SetAngleRedistribution(draw.rate("AngleRedistribution", 0.4, 0.1, 100.0));
    filter->SetLengthRedistribution(draw.rate("LengthRedistribution", 0.3, 0.1, 100.0));
    filter->SetAngleMethod(random.integer(0, 1));
    filter->SetAngleWeighting(random.integer(0, 2));
    filter->SetCurvatureControl(random.integer(0, 3));
    filter->SetCurvatureControlAlpha(draw.rate("CurvatureControlAlpha", 0.8, 1e-2, 1.0));
  }

  void drawElements()
  {
    Random& random = this->Parameters.random();
    this->Filter->SetRemeshing(random.chance(0.4) ? 0 : random.integer(1, 3));
    const double length = this->Input.radius * random.logarithmic(0.05, 0.5);
    this->Filter->SetTargetEdgeLength(
      this->Parameters.number("TargetEdgeLength", random.chance(0.6) ? 0.0 : length));
    this->Filter->SetRemeshingInterval(random.chance(0.7) ? 1 : random.integer(1, 5));
    this->Filter->SetCacheLimit(random.chance(0.9) ? 2048 : 1);
  }

  void drawTime(Random& random)
  {
    const int steps = this->Filter->GetNumberOfSteps() + this->Filter->GetSmoothingSteps();
    this->AsksForTime = random.chance(0.3);
    this->AskedTime = random.real(-0.2, 1.2) * steps * this->publishedStep();
  }

  vtkNew<vtkSurfaceEvolution> Filter;
  bool AsksForTime = false;
  double AskedTime = 0.0;
  std::string FieldText;
  bool FieldHasNaN = false;
};

} // namespace

std::unique_ptr<FilterCase> makeEvolutionCase(const Subject& subject, Random& random)
{
  return std::make_unique<EvolutionCase>(subject, random);
}

} // namespace robustness
