// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "DistanceJudge.h"
#include "FilterCase.h"
#include "OutputChecks.h"

#include "vtkImageData.h"
#include "vtkMeshSDF.h"
#include "vtkNew.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>

namespace robustness
{

namespace
{

class MeshSDFCase : public FilterCase
{
public:
  MeshSDFCase(const Subject& subject, Random& random)
    : FilterCase(subject, random)
  {
    this->drawGrid();
    this->drawMethods();
    this->drawPart(random);
    this->Filter->SetInputDataObject(subject.data);
  }

  vtkAlgorithm* filter() override { return this->Filter; }

  void update() override
  {
    if (this->AsksForPart)
    {
      this->Filter->UpdateExtent(this->Part);
    }
    else
    {
      this->Filter->Update();
    }
  }

  std::string describe() override
  {
    std::string text = FilterCase::describe();
    if (this->AsksForPart)
    {
      text += ", part";
      for (const int bound : this->Part)
      {
        text += " " + std::to_string(bound);
      }
    }
    return text;
  }

  std::string whyRefuse() const override
  {
    const std::string why = this->whySurfaceIsRefused();
    if (this->Input.hasFaces && !why.empty())
    {
      return why;
    }
    if (this->Input.model.points.empty())
    {
      return "";
    }
    if (!this->Input.hasFaces)
    {
      return this->whyPointsAreRefused();
    }
    return this->whyParametersAreRefused();
  }

  bool mustAccept() const override
  {
    const bool hasSomething =
      this->Input.isUsable() && (!this->Input.hasFaces || !this->Input.joined.faces.empty());
    const bool fits = this->Filter->GetMethod() != vtkMeshSDF::FAST_SWEEPING || !this->HasBounds;
    return this->Parameters.areSensible() && hasSomething && fits && this->whyRefuse().empty() &&
      !this->IsTooLarge;
  }

  bool mayBeEmpty() const override { return this->Input.model.points.empty() || this->isNothing(); }

  void judge(std::size_t) override
  {
    vtkImageData* image = this->Filter->GetOutput();
    if (image->GetNumberOfPoints() == 0)
    {
      return;
    }
    if (!this->AsksForPart)
    {
      judgeDistances(this->Input, this->Filter, image);
      return;
    }
    vtkNew<vtkImageData> part;
    part->DeepCopy(image);
    vtkNew<vtkMeshSDF> whole;
    this->copyParametersTo(whole);
    whole->SetInputDataObject(this->Input.data);
    whole->Update();
    judgePart(part, whole->GetOutput());
    judgeDistances(this->Input, this->Filter, whole->GetOutput());
  }

private:
  /// Vertex cells without any points.
  bool isNothing() const
  {
    const auto& cells = this->Input.model.vertices;
    return !this->Input.hasFaces && !cells.empty() &&
      std::all_of(cells.begin(), cells.end(), [](const Cell& cell) { return cell.empty(); });
  }

  std::string whyPointsAreRefused() const
  {
    if (!this->Input.isUsable())
    {
      return "a point is not there, or no number";
    }
    const int sign = this->Filter->GetSign();
    return sign == vtkMeshSDF::AUTOMATIC || sign == vtkMeshSDF::UNSIGNED ? ""
                                                                         : "points have no sides";
  }

  std::string whyParametersAreRefused() const
  {
    const double* b = this->Filter->GetModelBounds();
    const bool isAutomatic = !(b[0] <= b[1] && b[2] <= b[3] && b[4] <= b[5]);
    for (const char* name : { "BandWidth", "SmoothingSigma" })
    {
      if (this->Parameters.isNaN(name))
      {
        return std::string(name) + " is NaN";
      }
    }
    return isAutomatic && this->Parameters.isNaN("Padding") ? "Padding is NaN" : "";
  }

  void drawGrid()
  {
    Random& random = this->Parameters.random();
    std::array<int, 3> samples{};
    const bool isCube = random.chance(0.5);
    for (int& n : samples)
    {
      n = random.chance(0.05) ? random.integer(1, 3) : random.integer(4, 24);
      n = isCube ? std::max(samples[0], n > 3 ? 0 : n) : n;
      n = std::max(n, 1);
    }
    if (this->Parameters.isOdd() && random.chance(0.1))
    {
      samples.fill(65536);
      this->IsTooLarge = true;
    }
    this->Filter->SetSampleDimensions(samples.data());
    this->Filter->SetPadding(
      this->Parameters.number("Padding", random.chance(0.6) ? 0.1 : random.real(0.0, 1.0)));
    if (random.chance(0.25))
    {
      this->drawBounds(random);
    }
  }

  void drawBounds(Random& random)
  {
    this->HasBounds = true;
    const double size = this->Input.radius * random.logarithmic(0.05, 5.0);
    const Vec3 place =
      this->Input.centre + random.real(0.0, 2.0) * this->Input.radius * random.direction();
    double bounds[6];
    for (int axis = 0; axis < 3; ++axis)
    {
      const double half = size * (random.chance(0.5) ? 1.0 : random.real(0.3, 1.0));
      bounds[2 * axis] = this->Parameters.number("ModelBounds", place[axis] - half);
      bounds[2 * axis + 1] = this->Parameters.number("ModelBounds", place[axis] + half);
      // Far from the origin, or around a point, the box may have no extent any more.
      this->IsTooLarge = this->IsTooLarge || !(bounds[2 * axis] < bounds[2 * axis + 1]);
    }
    this->Filter->SetModelBounds(bounds);
  }

  void drawMethods()
  {
    Random& random = this->Parameters.random();
    this->Filter->SetMethod(random.chance(0.5) ? 0 : random.integer(0, 2));
    this->Filter->SetSign(random.chance(0.4) ? 0 : random.integer(0, 4));
    this->Filter->SetBandWidth(this->Parameters.rate("BandWidth", 0.25, 0.3, 10.0));
    this->Filter->SetSmoothingSigma(this->Parameters.rate("SmoothingSigma", 0.2, 0.1, 3.0));
    this->Filter->SetNumberOfSweeps(random.chance(0.7) ? 8 : random.integer(1, 20));
    this->Filter->SetComputeClosestPoint(random.chance(0.25));
    this->Filter->SetComputeClosestCellId(random.chance(0.25));
    this->Filter->SetComputeGradient(random.chance(0.25));
  }

  void drawPart(Random& random)
  {
    this->AsksForPart = random.chance(0.15) && !this->IsTooLarge;
    const int* samples = this->Filter->GetSampleDimensions();
    for (int axis = 0; axis < 3; ++axis)
    {
      this->Part[2 * axis] = random.integer(0, samples[axis] - 1);
      this->Part[2 * axis + 1] = random.integer(this->Part[2 * axis], samples[axis] - 1);
    }
  }

  void copyParametersTo(vtkMeshSDF* other) const
  {
    other->SetSampleDimensions(this->Filter->GetSampleDimensions());
    other->SetPadding(this->Filter->GetPadding());
    other->SetModelBounds(this->Filter->GetModelBounds());
    other->SetMethod(this->Filter->GetMethod());
    other->SetSign(this->Filter->GetSign());
    other->SetBandWidth(this->Filter->GetBandWidth());
    other->SetSmoothingSigma(this->Filter->GetSmoothingSigma());
    other->SetNumberOfSweeps(this->Filter->GetNumberOfSweeps());
    other->SetComputeClosestPoint(this->Filter->GetComputeClosestPoint());
    other->SetComputeClosestCellId(this->Filter->GetComputeClosestCellId());
    other->SetComputeGradient(this->Filter->GetComputeGradient());
  }

  vtkNew<vtkMeshSDF> Filter;
  bool HasBounds = false;
  bool IsTooLarge = false; ///< or has no extent: may be refused
  bool AsksForPart = false;
  int Part[6] = { 0, 0, 0, 0, 0, 0 };
};

} // namespace

std::unique_ptr<FilterCase> makeMeshSDFCase(const Subject& subject, Random& random)
{
  return std::make_unique<MeshSDFCase>(subject, random);
}

} // namespace robustness
