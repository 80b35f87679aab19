// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

// Arrays of the input that have the names of results, and normals of a surface that moves.

#include "DataChecks.h"
#include "DressedSurfaces.h"
#include "EventLog.h"
#include "FilterRuns.h"
#include "FlowSetups.h"
#include "SampleSurfaces.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkInformation.h"
#include "vtkInformationIterator.h"
#include "vtkInformationKey.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkShrinkWrap.h"
#include "vtkSurfaceEvolution.h"
#include "vtkTangentialRedistribution.h"
#include "vtkXMLPolyDataReader.h"
#include "vtkXMLPolyDataWriter.h"

#include <gtest/gtest.h>

#include <functional>
#include <string>

namespace
{

using Surface = Sample::Surface;

//------------------------------------------------------------------------------
vtkSmartPointer<vtkFloatArray> Sevens(const char* name, vtkIdType count, int components = 1)
{
  auto array = vtkSmartPointer<vtkFloatArray>::New();
  array->SetName(name);
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(count);
  array->Fill(7.0);
  return array;
}

//------------------------------------------------------------------------------
Surface Evolved(vtkPolyData* surface, int remeshing = vtkSurfaceEvolution::OFF)
{
  vtkNew<vtkSurfaceEvolution> filter;
  SetUpCurvatureFlow(filter, surface, 0.01, 5);
  filter->SetRemeshing(remeshing);
  filter->Update();
  return filter->GetOutput();
}

//------------------------------------------------------------------------------
Surface Wrapped(vtkPolyData* surface)
{
  vtkNew<vtkShrinkWrap> filter;
  SetUpCoarsely(filter, surface);
  filter->SetNumberOfSteps(2);
  filter->Update();
  return filter->GetOutput();
}

//------------------------------------------------------------------------------
const std::function<Surface(vtkPolyData*)> Runs[] = {
  [](vtkPolyData* surface) { return Evolved(surface); },
  [](vtkPolyData* surface) { return Evolved(surface, vtkSurfaceEvolution::UNIFORM); },
  [](vtkPolyData* surface) { return Redistributed(surface); },
  Wrapped,
};

//------------------------------------------------------------------------------
double LargestOf(vtkFieldData* data, const char* name)
{
  double range[2];
  data->GetArray(name)->GetRange(range, 0);
  return range[1];
}

//------------------------------------------------------------------------------
TEST(ResultArrays, AUsersArrayOfTheSameNameIsKeptUnderAnother)
{
  const Surface surface = Sample::Icosphere(2);
  surface->GetPointData()->SetScalars(Sevens("CoVolume", 162));
  surface->GetPointData()->AddArray(Sevens("CoVolume_input", 162));
  for (const auto& run : Runs)
  {
    SCOPED_TRACE(&run - Runs);
    vtkPointData* data = nullptr;
    const Surface output = run(surface);
    data = output->GetPointData();
    EXPECT_LT(LargestOf(data, "CoVolume"), 1.0);
    EXPECT_EQ(LargestOf(data, "CoVolume_input"), 7.0);
    EXPECT_EQ(LargestOf(data, "CoVolume_input_input"), 7.0);
    ASSERT_TRUE(data->GetScalars());
    EXPECT_STREQ(data->GetScalars()->GetName(), "CoVolume_input_input");
  }
  EXPECT_STREQ(surface->GetPointData()->GetScalars()->GetName(), "CoVolume");
  EXPECT_EQ(LargestOf(surface->GetPointData(), "CoVolume"), 7.0);
}

//------------------------------------------------------------------------------
TEST(ResultArrays, FieldArraysLikewise)
{
  const Surface surface = Sample::Icosphere(2);
  surface->GetFieldData()->AddArray(Sevens("Area", 2));
  for (const Surface& output : { Evolved(surface), Wrapped(surface) })
  {
    EXPECT_NE(FieldValue(output, "Area"), 7.0);
    EXPECT_EQ(output->GetFieldData()->GetArray("Area_input")->GetNumberOfTuples(), 2);
  }
}

//------------------------------------------------------------------------------
TEST(ResultArrays, ResultsOfAnEarlierFilterGiveWay)
{
  const Surface first = Evolved(Sample::Icosphere(2));
  for (const auto& run : Runs)
  {
    SCOPED_TRACE(&run - Runs);
    for (const std::string& name : ArrayNames(run(first)->GetPointData()))
    {
      EXPECT_EQ(name.find("_input"), std::string::npos) << name;
    }
  }
  EXPECT_FALSE(Evolved(first)->GetFieldData()->HasArray("Area_input"));
  // What it does not compute itself, redistribution keeps: all data of its input.
  const Surface even = Redistributed(first);
  EXPECT_TRUE(SameBits(even->GetPointData()->GetArray("NormalVelocity"),
    first->GetPointData()->GetArray("NormalVelocity")));
  EXPECT_NEAR(LargestOf(even->GetPointData(), "CoVolume"),
    LargestOf(first->GetPointData(), "CoVolume"), 0.01);
}

//------------------------------------------------------------------------------
/// A reader warns of every other key where this module is not loaded.
TEST(ResultArrays, HaveKeysOfVTKAlone)
{
  for (const auto& run : Runs)
  {
    const Surface output = run(Sample::Icosphere(2));
    int count = 0;
    for (vtkFieldData* data : { static_cast<vtkFieldData*>(output->GetPointData()),
           static_cast<vtkFieldData*>(output->GetCellData()), output->GetFieldData() })
    {
      for (int i = 0; i < data->GetNumberOfArrays(); ++i)
      {
        vtkNew<vtkInformationIterator> keys;
        keys->SetInformation(data->GetAbstractArray(i)->GetInformation());
        for (keys->InitTraversal(); !keys->IsDoneWithTraversal(); keys->GoToNextItem(), ++count)
        {
          EXPECT_EQ(std::string(keys->GetCurrentKey()->GetLocation()).rfind("vtk", 0), 0U)
            << keys->GetCurrentKey()->GetLocation();
        }
      }
    }
    EXPECT_GT(count, 0);
  }
}

//------------------------------------------------------------------------------
TEST(ResultArrays, OfAFileGiveWayToo)
{
  vtkNew<vtkXMLPolyDataWriter> writer;
  writer->SetInputData(Evolved(Sample::Icosphere(2)));
  writer->WriteToOutputStringOn();
  writer->Write();
  vtkNew<vtkXMLPolyDataReader> reader;
  reader->ReadFromInputStringOn();
  reader->SetInputString(writer->GetOutputString());
  reader->Update();
  for (const auto& run : Runs)
  {
    const Surface output = run(reader->GetOutput());
    EXPECT_FALSE(output->GetPointData()->HasArray("Normals_input"));
    EXPECT_FALSE(output->GetPointData()->HasArray("MeanCurvature_input"));
    EXPECT_FALSE(output->GetFieldData()->HasArray("Area_input"));
  }
}

//------------------------------------------------------------------------------
TEST(ResultArrays, AStopOfAnEarlierFlowIsNotOneOfThis)
{
  const Surface surface = Evolved(Sample::Icosphere(2));
  vtkNew<vtkSurfaceEvolution> vanishing;
  SetUpCurvatureFlow(vanishing, surface, 0.01, 40);
  vanishing->UpdateTimeStep(0.01);
  ASSERT_TRUE(vanishing->GetOutput()->GetFieldData()->HasArray("ExtinctionTime"));
  EXPECT_FALSE(Evolved(vanishing->GetOutput())->GetFieldData()->HasArray("ExtinctionTime"));
}

//------------------------------------------------------------------------------
TEST(ResultArrays, NormalsOfASurfaceThatMovesAreNew)
{
  const Surface surface = Sample::Icosphere(2);
  surface->GetPointData()->SetNormals(Sevens("Pointing", 162, 3));
  surface->GetPointData()->SetTangents(Sevens("Along", 162, 3));
  surface->GetCellData()->SetNormals(Sevens("Normals", 320, 3));
  for (const auto& run : Runs)
  {
    SCOPED_TRACE(&run - Runs);
    const Surface output = run(surface);
    EXPECT_FALSE(output->GetPointData()->HasArray("Pointing"));
    EXPECT_FALSE(output->GetPointData()->HasArray("Along"));
    EXPECT_FALSE(output->GetCellData()->HasArray("Normals"));
    vtkDataArray* active = output->GetPointData()->GetNormals();
    if (&run != &Runs[3]) // a wrap is another surface, with creases of its own
    {
      ASSERT_TRUE(active);
      EXPECT_STREQ(active->GetName(), "Normals");
      EXPECT_NEAR(LargestOf(output->GetPointData(), "Normals"), 1.0, 0.05);
    }
    else
    {
      EXPECT_FALSE(active);
    }
  }
  EXPECT_STREQ(surface->GetPointData()->GetNormals()->GetName(), "Pointing");
  EXPECT_FALSE(Evolved(Sample::Icosphere(2))->GetPointData()->GetNormals());
}

//------------------------------------------------------------------------------
TEST(ResultArrays, ArraysThatAreTooShortAreLeftOutWithAWarning)
{
  const Surface surface = Sample::Dressed(Sample::Icosphere(2));
  surface->GetPointData()->AddArray(Sevens("Short", 100));
  surface->GetPointData()->AddArray(Sevens("Empty", 0));
  surface->GetCellData()->AddArray(Sevens("Few", 3));
  vtkNew<vtkSurfaceEvolution> filter;
  const EventLog log(filter);
  SetUpCurvatureFlow(filter, surface, 0.01, 5);
  for (const int step : { 5, 2, 0 })
  {
    filter->UpdateTimeStep(0.01 * step);
  }
  ASSERT_EQ(log.Warnings.size(), 1u);
  EXPECT_TRUE(IsOneSentence(log.Warnings.front()));
  for (const char* name : { "Short", "Empty", "Few" })
  {
    EXPECT_NE(log.Warnings.front().find(name), std::string::npos) << log.Warnings.front();
    EXPECT_FALSE(filter->GetOutput()->GetPointData()->HasArray(name));
  }
  EXPECT_TRUE(filter->GetOutput()->GetPointData()->HasArray("Height"));
  vtkNew<vtkShrinkWrap> wrap;
  const EventLog logOfWrap(wrap);
  SetUpCoarsely(wrap, surface);
  wrap->SetNumberOfSteps(2);
  wrap->Update();
  ASSERT_EQ(logOfWrap.Warnings.size(), 1u);
  EXPECT_TRUE(IsOneSentence(logOfWrap.Warnings.front()));
}

//------------------------------------------------------------------------------
TEST(ResultArrays, ArraysWithoutANameAreCarriedToo)
{
  const Surface surface = Sample::Icosphere(2);
  for (int i = 0; i < 2; ++i)
  {
    const auto nameless = Sevens("x", 162);
    nameless->SetName(nullptr);
    surface->GetPointData()->AddArray(nameless);
  }
  for (const auto& run : Runs)
  {
    const Surface output = run(surface);
    int nameless = 0;
    for (int i = 0; i < output->GetPointData()->GetNumberOfArrays(); ++i)
    {
      nameless += output->GetPointData()->GetArrayName(i) ? 0 : 1;
    }
    EXPECT_EQ(nameless, 2) << &run - Runs;
  }
}

} // namespace
