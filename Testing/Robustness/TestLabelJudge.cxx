// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

// The judge of label surfaces: passes what is right, finds what was spoilt.

#include "BaseShapes.h"
#include "FilterCase.h"

#include "vtkAlgorithm.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkPolyData.h"

#include <gtest/gtest.h>

namespace
{

using namespace robustness;

class LabelJudge : public testing::Test
{
protected:
  /// The first case of one seed after another that has a result.
  LabelJudge()
  {
    for (std::uint64_t seed = 1; !this->Output || this->Output->GetNumberOfCells() < 100; ++seed)
    {
      Random random(seed, Random::ForParameters);
      this->Case = makeLabelCase(this->Input, random);
      if (this->Case->mustAccept())
      {
        this->Case->update();
        this->Output = vtkPolyData::SafeDownCast(this->Case->filter()->GetOutputDataObject(0));
      }
    }
  }

  void expect(Fault fault)
  {
    try
    {
      this->Case->judge(0);
      ADD_FAILURE() << "the judge is pleased";
    }
    catch (const WrongAnswer& answer)
    {
      EXPECT_EQ(answer.fault(), fault) << answer.what();
    }
  }

  const Subject Input{ icosphere(0, 1.0, Vec3::Zero()) };
  std::unique_ptr<FilterCase> Case;
  vtkPolyData* Output = nullptr;
};

TEST_F(LabelJudge, PassesWhatTheFilterMakes)
{
  EXPECT_NO_THROW(this->Case->judge(0));
}

TEST_F(LabelJudge, FindsAnotherLabel)
{
  vtkDataArray* labels = this->Output->GetCellData()->GetArray("Label");
  labels->SetTuple1(0, labels->GetTuple1(0) + 1.0);
  this->expect(Fault::Borders);
}

TEST_F(LabelJudge, FindsALabelThatIsItsOwnNeighbor)
{
  vtkDataArray* labels = this->Output->GetCellData()->GetArray("Label");
  this->Output->GetCellData()->GetArray("NeighborLabel")->SetTuple1(0, labels->GetTuple1(0));
  this->expect(Fault::Misstated);
}

TEST_F(LabelJudge, FindsAWrongVolume)
{
  vtkDataArray* volumes = this->Output->GetFieldData()->GetArray("Volume");
  volumes->SetComponent(0, 0, 1.01 * volumes->GetComponent(0, 0));
  this->expect(Fault::Misstated);
}

TEST_F(LabelJudge, FindsALabelTooMany)
{
  vtkDataArray* values = this->Output->GetFieldData()->GetArray("LabelValue");
  values->InsertNextTuple1(77.0);
  this->expect(Fault::Misstated);
}

TEST_F(LabelJudge, FindsASurfaceThatHasShrunk)
{
  const Vec3 middle(this->Output->GetCenter());
  for (vtkIdType i = 0; i < this->Output->GetNumberOfPoints(); ++i)
  {
    const Vec3 point = 0.97 * (Vec3(this->Output->GetPoint(i)) - middle) + middle;
    this->Output->GetPoints()->SetPoint(i, point.data());
  }
  vtkDataArray* volumes = this->Output->GetFieldData()->GetArray("Volume");
  for (vtkIdType i = 0; i < volumes->GetNumberOfTuples(); ++i)
  {
    volumes->SetComponent(i, 0, 0.97 * 0.97 * 0.97 * volumes->GetComponent(i, 0));
  }
  this->expect(Fault::NoVolume);
}

} // namespace
