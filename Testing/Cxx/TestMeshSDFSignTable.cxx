// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

// vtkMeshSDF: every cell of the table in the help page Inputs.html, with every method.

#include "DataChecks.h"
#include "EventLog.h"
#include "FilterRuns.h"
#include "SignTable.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkMeshSDF.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <fstream>
#include <string>

namespace
{

//------------------------------------------------------------------------------
vtkSmartPointer<vtkMeshSDF> Filter(const SignRow& row, int method, int sign)
{
  const auto filter = vtkSmartPointer<vtkMeshSDF>::New();
  filter->SetInputData(row.Make());
  filter->SetSampleDimensions(33, 33, 33);
  filter->SetPadding(0.25);
  filter->SetMethod(method);
  filter->SetSign(sign);
  return filter;
}

//------------------------------------------------------------------------------
/// The signs at the samples next to the places.
std::string SignsAt(vtkImageData* image, const std::vector<Sample::Point>& places)
{
  std::string signs;
  for (Sample::Point place : places)
  {
    const vtkIdType sample = image->FindPoint(place.data());
    signs += image->GetPointData()->GetScalars()->GetTuple1(sample) < 0.0 ? '-' : '+';
  }
  return signs;
}

//------------------------------------------------------------------------------
class MeshSDFSignTable : public testing::TestWithParam<SignRow>
{
protected:
  static constexpr int Methods[] = { vtkMeshSDF::CLOSEST_POINT, vtkMeshSDF::FAST_SWEEPING,
    vtkMeshSDF::BRUTE_FORCE };

  /// The signs are the cell's, and the distance is that of Unsigned.
  static void ExpectCell(const SignCell& cell, int sign)
  {
    for (const int method : Methods)
    {
      SCOPED_TRACE("method " + std::to_string(method) + ", sign " + std::to_string(sign));
      if (std::string(cell.Signs) == "!")
      {
        ExpectRefusalOf(Filter(GetParam(), method, sign));
        continue;
      }
      const auto filter = Filter(GetParam(), method, sign);
      filter->Update();
      const auto reference = Filter(GetParam(), method, vtkMeshSDF::UNSIGNED);
      reference->Update();
      vtkDataArray* signedDistance = filter->GetOutput()->GetPointData()->GetScalars();
      vtkDataArray* distance = reference->GetOutput()->GetPointData()->GetScalars();
      for (vtkIdType i = 0; i < distance->GetNumberOfTuples(); ++i)
      {
        ASSERT_GE(distance->GetTuple1(i), 0.0);
        ASSERT_EQ(std::abs(signedDistance->GetTuple1(i)), distance->GetTuple1(i));
      }
      if (std::string(cell.Signs) == "?")
      {
        EXPECT_LT(signedDistance->GetRange()[0], 0.0);
        EXPECT_GT(signedDistance->GetRange()[1], 0.0);
        continue;
      }
      EXPECT_EQ(SignsAt(filter->GetOutput(), GetParam().Places), cell.Signs);
    }
  }
};

TEST_P(MeshSDFSignTable, FloodFill)
{
  ExpectCell(GetParam().FloodFill, vtkMeshSDF::FLOOD_FILL);
}

TEST_P(MeshSDFSignTable, Pseudonormal)
{
  ExpectCell(GetParam().Pseudonormal, vtkMeshSDF::PSEUDONORMAL);
}

TEST_P(MeshSDFSignTable, WindingNumber)
{
  ExpectCell(GetParam().WindingNumber, vtkMeshSDF::WINDING_NUMBER);
}

TEST_P(MeshSDFSignTable, AutomaticIsTheMethodItNames)
{
  const auto automatic = Filter(GetParam(), vtkMeshSDF::CLOSEST_POINT, vtkMeshSDF::AUTOMATIC);
  automatic->Update();
  EXPECT_EQ(FieldValue(automatic->GetOutput(), "SignMethod"), GetParam().Automatic);
  EXPECT_TRUE(IsOneSentence(FieldText(automatic->GetOutput(), "SignReason")));
  const auto named = Filter(GetParam(), vtkMeshSDF::CLOSEST_POINT, GetParam().Automatic);
  named->Update();
  EXPECT_TRUE(SameImage(automatic->GetOutput(), named->GetOutput()));
}

INSTANTIATE_TEST_SUITE_P(Rows, MeshSDFSignTable, testing::ValuesIn(SignTable()),
  [](const testing::TestParamInfo<SignRow>& info) { return std::string(info.param.Name); });

//------------------------------------------------------------------------------
TEST(MeshSDFSignTablePage, HasTheRowsThatAreTested)
{
  std::ifstream file(EVOLVINGSURFACES_HELP_DIR "/Inputs.html");
  std::string page;
  for (std::string line; std::getline(file, line);)
  {
    page += line; // the page's lines are broken between tags
  }
  page = page.substr(0, page.find("<h2>"));
  std::size_t rows = 0;
  for (std::size_t at = page.find("<tr><td>"); at != std::string::npos;
       at = page.find("<tr><td>", at + 1))
  {
    ++rows;
  }
  EXPECT_EQ(rows, SignTable().size());
  for (const SignRow& row : SignTable())
  {
    EXPECT_NE(page.find(HtmlOf(row)), std::string::npos) << HtmlOf(row);
  }
}

} // namespace
