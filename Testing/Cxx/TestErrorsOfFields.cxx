// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

// Bad images on the second input of vtkSurfaceEvolution, and bad numbers in parameters.

#include "DataChecks.h"
#include "EventLog.h"
#include "FilterRuns.h"
#include "SampleSurfaces.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkIntArray.h"
#include "vtkMath.h"
#include "vtkMeshSDF.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkShrinkWrap.h"
#include "vtkSurfaceEvolution.h"
#include "vtkTangentialRedistribution.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <string>

namespace
{

using Image = vtkSmartPointer<vtkImageData>;

//------------------------------------------------------------------------------
/// An evolution onto the image, what it said, and what it gave.
class OntoImage
{
public:
  explicit OntoImage(vtkImageData* image, double startRadius = 1.5)
    : Log(this->Filter)
  {
    this->Filter->SetInputData(0, Sample::Icosphere(2, startRadius));
    this->Filter->SetInputData(1, image);
    this->Filter->SetTimeStep(0.1);
    this->Filter->SetNumberOfSteps(20);
    this->Filter->SetCurvatureSpeed(0.01);
    this->Filter->SetRemeshingToOff();
    this->Filter->Update();
  }

  void ExpectRefusal() const { ::ExpectRefusal(this->Filter, this->Log); }

  void ExpectResult() const
  {
    ASSERT_TRUE(this->Log.Errors.empty()) << this->Log.Errors.front();
    EXPECT_EQ(this->Filter->GetOutput()->GetNumberOfPoints(), 162);
    EXPECT_TRUE(IsFinite(this->Filter->GetOutputDataObject(0)));
    EXPECT_TRUE(IsFinite(this->Filter->GetOutputDataObject(1)));
  }

  vtkNew<vtkSurfaceEvolution> Filter;
  EventLog Log;
};

//------------------------------------------------------------------------------
/// The image of a unit sphere, changed.
Image Changed(const std::function<void(vtkImageData*)>& change)
{
  const Image image = Sample::SphereImage(17, 2.0, 1.0);
  change(image);
  return image;
}

//------------------------------------------------------------------------------
TEST(FieldErrors, ImagesThatCannotBeUsedAreRefused)
{
  const auto withValue = [](double value)
  {
    return [value](vtkImageData* image)
    { image->GetPointData()->GetScalars()->SetComponent(100, 0, value); };
  };
  const std::function<void(vtkImageData*)> changes[] = {
    withValue(vtkMath::Nan()),
    withValue(vtkMath::Inf()),
    [](vtkImageData* image) { image->GetPointData()->Initialize(); },
    [](vtkImageData* image) { image->SetDirectionMatrix(1, 0.1, 0, 0, 1, 0, 0, 0, 1); },
    [](vtkImageData* image) { image->SetDirectionMatrix(1, 0, 0, 0, 1, 0, 0, 0, 0); },
    [](vtkImageData* image) { image->SetDirectionMatrix(2, 0, 0, 0, 2, 0, 0, 0, 2); },
    [](vtkImageData* image) { image->SetDirectionMatrix(1, 0, vtkMath::Nan(), 0, 1, 0, 0, 0, 1); },
    [](vtkImageData* image) { image->SetSpacing(0.0, 0.1, 0.1); },
    [](vtkImageData* image) { image->SetSpacing(-0.1, 0.1, 0.1); },
    [](vtkImageData* image) { image->SetOrigin(vtkMath::Nan(), 0.0, 0.0); },
    [](vtkImageData* image) { image->GetPointData()->GetScalars()->SetNumberOfTuples(9); },
  };
  for (const auto& change : changes)
  {
    SCOPED_TRACE(&change - changes);
    OntoImage(Changed(change)).ExpectRefusal();
  }
}

//------------------------------------------------------------------------------
TEST(FieldErrors, AnEmptyImageIsRefused)
{
  OntoImage(vtkNew<vtkImageData>()).ExpectRefusal();
}

//------------------------------------------------------------------------------
TEST(FieldErrors, ScalarsOfAnyTypeAreRead)
{
  // Whole numbers, in an image of a larger sphere.
  const Image image = Sample::SphereImage(17, 200.0, 100.0);
  vtkNew<vtkIntArray> whole;
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    whole->InsertNextTuple1(std::round(image->GetPointData()->GetScalars()->GetTuple1(i)));
  }
  image->GetPointData()->SetScalars(whole);
  OntoImage run(image, 150.0);
  run.ExpectResult();
  EXPECT_NEAR(DistanceFromOrigin(run.Filter->GetOutput()).Largest, 100.0, 12.0);
}

//------------------------------------------------------------------------------
TEST(FieldErrors, AFlatImageIsAnswered)
{
  const Image image = Changed(
    [](vtkImageData* changed)
    {
      changed->SetDimensions(17, 17, 1);
      changed->GetPointData()->GetScalars()->Resize(289);
    });
  OntoImage run(image);
  EXPECT_LE(run.Log.Errors.size(), 1u);
  EXPECT_TRUE(IsFinite(run.Filter->GetOutput()));
}

//------------------------------------------------------------------------------
TEST(FieldErrors, FieldsWithoutATargetAreRefused)
{
  OntoImage(Changed([](vtkImageData* image) { image->GetPointData()->GetScalars()->Fill(1.0); }))
    .ExpectRefusal();
  OntoImage(Sample::SphereImage(17, 2.0, 10.0)).ExpectRefusal(); // all inside of a larger sphere
}

//------------------------------------------------------------------------------
TEST(FieldErrors, AFieldFarAwayIsRefused)
{
  OntoImage(Changed([](vtkImageData* image) { image->SetOrigin(10.0, 0.0, 0.0); })).ExpectRefusal();
}

//------------------------------------------------------------------------------
TEST(FieldErrors, StartsAnywhereAreUsable)
{
  const Image image = Changed([](vtkImageData*) {});
  // On the target, inside it, and outside the whole image.
  for (const double radius : { 1.0, 0.3, 5.0 })
  {
    OntoImage run(image, radius);
    run.ExpectResult();
    EXPECT_LE(FieldValue(run.Filter->GetOutput(), "MaxDistance"), std::abs(radius - 1.0) + 0.05);
  }
}

//------------------------------------------------------------------------------
/// Does a filter with a parameter that is not a number refuse it, or leave it out?
template <typename Class>
void ExpectNoNonsense(const std::function<void(Class*, double)>& set)
{
  for (const double value : { vtkMath::Nan(), vtkMath::Inf() })
  {
    vtkNew<Class> filter;
    EventLog log(filter);
    filter->SetInputData(Sample::Icosphere(1));
    set(filter, value);
    filter->Update();
    EXPECT_LE(log.Errors.size(), 1u);
    for (const std::string& sentence : log.Errors)
    {
      EXPECT_TRUE(IsOneSentence(sentence));
    }
    EXPECT_TRUE(IsFinite(filter->GetOutputDataObject(0)));
  }
}

//------------------------------------------------------------------------------
TEST(ParameterErrors, NotANumberIsNotPassedOn)
{
  using E = vtkSurfaceEvolution;
  const auto evolution = [](void (E::*set)(double))
  {
    ExpectNoNonsense<E>(
      [set](E* filter, double value)
      {
        filter->SetNumberOfSteps(2);
        filter->SetCurvatureControlToExponential();
        filter->SetVolumeRedistribution(1.0);
        filter->SetSmoothingSteps(1);
        (filter->*set)(value);
      });
  };
  for (const auto set : { &E::SetTimeStep, &E::SetCurvatureSpeed, &E::SetCurvatureRange,
         &E::SetAdvectionSpeed, &E::SetAdvectionBalance, &E::SetEdgeSharpness,
         &E::SetVolumeRedistribution, &E::SetAngleRedistribution, &E::SetLengthRedistribution,
         &E::SetCurvatureControlAlpha, &E::SetSmoothingSpeed, &E::SetSmoothingDecay,
         &E::SetSurfaceGuard, &E::SetConvergenceTolerance, &E::SetSolverTolerance })
  {
    evolution(set);
  }
}

//------------------------------------------------------------------------------
TEST(ParameterErrors, NotANumberIsNotPassedOnByTheOthers)
{
  using T = vtkTangentialRedistribution;
  for (const auto set : { &T::SetTimeStep, &T::SetVolumeRedistribution, &T::SetAngleRedistribution,
         &T::SetLengthRedistribution, &T::SetCurvatureControlAlpha, &T::SetFeatureAngle })
  {
    ExpectNoNonsense<T>([set](T* filter, double value) { (filter->*set)(value); });
  }
  using D = vtkMeshSDF;
  for (const auto set : { &D::SetPadding, &D::SetBandWidth, &D::SetSmoothingSigma })
  {
    ExpectNoNonsense<D>(
      [set](D* filter, double value)
      {
        filter->SetSampleDimensions(8, 8, 8);
        (filter->*set)(value);
      });
  }
  using W = vtkShrinkWrap;
  for (const auto set : { &W::SetTargetEdgeLength, &W::SetGapSize, &W::SetOffsetDistance })
  {
    ExpectNoNonsense<W>(
      [set](W* filter, double value)
      {
        filter->SetSampleDimensions(8, 8, 8);
        filter->SetTargetEdgeLength(0.5);
        filter->SetNumberOfSteps(2);
        (filter->*set)(value);
      });
  }
}

} // namespace
