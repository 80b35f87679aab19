// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "FilterCase.h"
#include "OutputChecks.h"
#include "RedistributionJudge.h"

#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkTangentialRedistribution.h"

namespace robustness
{

namespace
{

class RedistributionCase : public FilterCase
{
public:
  RedistributionCase(const Subject& subject, Random& random)
    : FilterCase(subject, random)
  {
    this->draw(random);
    this->Filter->SetInputDataObject(subject.data);
  }

  vtkAlgorithm* filter() override { return this->Filter; }

  std::string whyRefuse() const override
  {
    if (this->Input.model.points.empty())
    {
      return "";
    }
    const std::string why = this->whySurfaceIsRefused();
    const Topology& topology = this->Input.topology;
    if (why.empty() && !(topology.isManifold() && topology.isOriented()))
    {
      return "the input is not an oriented manifold";
    }
    return why.empty() && this->Parameters.isNaN("TimeStep") ? "TimeStep is NaN" : why;
  }

  bool mustAccept() const override
  {
    return this->Parameters.areSensible() && this->Input.model.isClean && this->Input.isSolid();
  }

  /// Points that no face uses stay as they are, which may be NaN: the judge looks at the others.
  void requireNumbers() override
  {
    vtkNew<vtkPolyData> arrays;
    arrays->DeepCopy(this->Filter->GetOutput());
    arrays->SetPoints(nullptr);
    requireFinite(arrays);
  }

  void judge(std::size_t) override
  {
    judgeRedistribution(this->Input,
      { this->Filter->GetPreserveShape(),
        this->Filter->GetBoundaryMode() == vtkTangentialRedistribution::FIXED },
      this->Filter->GetOutput());
  }

private:
  void draw(Random& random)
  {
    Draws& draws = this->Parameters;
    const auto& filter = this->Filter;
    filter->SetNumberOfSteps(random.integer(0, 20));
    filter->SetTimeStep(draws.number("TimeStep", random.logarithmic(1e-3, 1.0)));
    filter->SetVolumeRedistribution(draws.rate("VolumeRedistribution", 0.5, 0.1, 100.0));
    filter->SetAngleRedistribution(draws.rate("AngleRedistribution", 0.7, 0.1, 100.0));
    filter->SetLengthRedistribution(draws.rate("LengthRedistribution", 0.4, 0.1, 100.0));
    filter->SetAngleMethod(random.integer(0, 1));
    filter->SetAngleWeighting(random.integer(0, 1));
    filter->SetCurvatureControl(random.integer(0, 3));
    filter->SetCurvatureControlAlpha(draws.rate("CurvatureControlAlpha", 0.8, 1e-2, 1.0));
    filter->SetPreserveShape(random.chance(0.8));
    filter->SetBoundaryMode(random.integer(0, 2));
    filter->SetFeatureAngle(
      draws.number("FeatureAngle", random.chance(0.6) ? 45.0 : random.real(0.0, 180.0)));
  }

  vtkNew<vtkTangentialRedistribution> Filter;
};

} // namespace

std::unique_ptr<FilterCase> makeRedistributionCase(const Subject& subject, Random& random)
{
  return std::make_unique<RedistributionCase>(subject, random);
}

} // namespace robustness
