// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "LongRuns.h"

#include "ChangedSurfaces.h"
#include "DataChecks.h"
#include "SurfaceMeasures.h"

#include "vtkDistanceHierarchy.h"
#include "vtkImageData.h"
#include "vtkMeshSDF.h"
#include "vtkPolyData.h"
#include "vtkShrinkWrap.h"
#include "vtkSurfaceEvolution.h"
#include "vtkTangentialRedistribution.h"

namespace
{

using Filter = vtkSmartPointer<vtkAlgorithm>;

//------------------------------------------------------------------------------
Filter MakeDistance(int method)
{
  auto filter = vtkSmartPointer<vtkMeshSDF>::New();
  filter->SetInputData(Sample::Read("bunny.ply"));
  filter->SetSampleDimensions(48, 48, 48);
  filter->SetMethod(method);
  return filter;
}

//------------------------------------------------------------------------------
Filter MakeRedistribution()
{
  auto filter = vtkSmartPointer<vtkTangentialRedistribution>::New();
  filter->SetInputData(Sample::Mapped(Sample::Icosphere(3), Sample::TowardsThePole));
  filter->SetNumberOfSteps(20);
  filter->SetVolumeRedistribution(0.1); // the slowest term
  return filter;
}

//------------------------------------------------------------------------------
Filter MakeWrap()
{
  auto filter = vtkSmartPointer<vtkShrinkWrap>::New();
  filter->SetInputData(Sample::Icosphere(2));
  filter->SetSampleDimensions(24, 24, 24);
  filter->SetTargetEdgeLength(0.2);
  filter->SetNumberOfSteps(20);
  return filter;
}

//------------------------------------------------------------------------------
Filter MakeHierarchy()
{
  auto filter = vtkSmartPointer<vtkDistanceHierarchy>::New();
  filter->SetInputData(Sample::Read("bunny.ply"));
  filter->SetStructureToOctree();
  return filter;
}

} // namespace

//------------------------------------------------------------------------------
vtkSmartPointer<vtkAlgorithm> MakeLongEvolution()
{
  auto filter = vtkSmartPointer<vtkSurfaceEvolution>::New();
  filter->SetInputData(0, Sample::Icosphere(3, 1.5));
  filter->SetInputData(1, Sample::SphereImage(17, 2.0, 1.0));
  filter->SetTimeStep(0.01);
  filter->SetNumberOfSteps(50);
  filter->SetVolumeRedistribution(1.0);
  filter->SetAngleRedistribution(1.0);
  return filter;
}

//------------------------------------------------------------------------------
std::vector<LongRunCase> LongRunCases()
{
  return { { "ClosestPoint", []() { return MakeDistance(vtkMeshSDF::CLOSEST_POINT); } },
    { "FastSweeping", []() { return MakeDistance(vtkMeshSDF::FAST_SWEEPING); } },
    { "BruteForce", []() { return MakeDistance(vtkMeshSDF::BRUTE_FORCE); } },
    { "Evolution", MakeLongEvolution }, { "Redistribution", MakeRedistribution },
    { "Wrap", MakeWrap }, { "Hierarchy", MakeHierarchy } };
}

//------------------------------------------------------------------------------
std::string NameOf(const testing::TestParamInfo<LongRunCase>& info)
{
  return info.param.Name;
}

//------------------------------------------------------------------------------
testing::AssertionResult SameOutputs(vtkAlgorithm* a, vtkAlgorithm* b)
{
  if (auto* image = vtkImageData::SafeDownCast(a->GetOutputDataObject(0)))
  {
    return SameImage(image, vtkImageData::SafeDownCast(b->GetOutputDataObject(0)));
  }
  auto* surface = vtkPolyData::SafeDownCast(a->GetOutputDataObject(0));
  auto* other = vtkPolyData::SafeDownCast(b->GetOutputDataObject(0));
  if (surface->GetNumberOfPoints() == 0)
  {
    return testing::AssertionFailure() << "the output is empty";
  }
  const testing::AssertionResult sameSurface = SameSurface(surface, other, 0.0);
  return sameSurface ? SamePointArrays(surface, other, 0.0) : sameSurface;
}
