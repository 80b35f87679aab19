// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

// How answers are classed, with a filter that says and does what it is told to.

#include "BaseShapes.h"
#include "Generator.h"
#include "Trial.h"

#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkPolyDataAlgorithm.h"

#include <gtest/gtest.h>

#include <limits>

namespace
{

using namespace robustness;

//------------------------------------------------------------------------------
/// Says its errors and warnings, and hands out the triangle or nothing.
class Puppet : public vtkPolyDataAlgorithm
{
public:
  static Puppet* New();
  vtkTypeMacro(Puppet, vtkPolyDataAlgorithm);

  std::vector<std::string> Errors;
  std::vector<std::string> Warnings;
  vtkSmartPointer<vtkPolyData> Result;

protected:
  Puppet() { this->SetNumberOfInputPorts(0); }

  int RequestData(
    vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector) override
  {
    for (const std::string& error : this->Errors)
    {
      vtkErrorMacro(<< error);
    }
    for (const std::string& warning : this->Warnings)
    {
      vtkWarningMacro(<< warning);
    }
    if (this->Result)
    {
      vtkPolyData::GetData(outputVector)->DeepCopy(this->Result);
    }
    return this->Errors.empty() ? 1 : 0;
  }
};
vtkStandardNewMacro(Puppet);

class PuppetCase : public FilterCase
{
public:
  PuppetCase(const Subject& subject, Random& random)
    : FilterCase(subject, random)
  {
  }
  vtkAlgorithm* filter() override { return this->Filter; }
  std::string whyRefuse() const override { return this->Why; }
  bool mustAccept() const override { return this->MustAccept; }
  bool mayBeEmpty() const override { return false; }
  void judge(std::size_t) override
  {
    require(this->JudgeIsPleased, Fault::TooFar, "the judge is not pleased");
  }

  vtkNew<Puppet> Filter;
  std::string Why;
  bool MustAccept = false;
  bool JudgeIsPleased = true;
};

class Answers : public testing::Test
{
protected:
  void giveResult() { this->Case.Filter->Result = this->Input.data; }
  Verdict verdict() { return judgeAnswer(this->Case); }
  void expect(Outcome outcome, Fault fault = Fault::None)
  {
    const Verdict found = this->verdict();
    EXPECT_EQ(found.outcome, outcome) << found.what;
    EXPECT_EQ(found.fault, fault) << found.what;
  }

  const Subject Input{ icosphere(0, 1.0, Vec3::Zero()) };
  Random Numbers{ 2, Random::ForParameters };
  PuppetCase Case{ this->Input, this->Numbers };
};

const std::string Sentence = "The edge length is -1, expected a positive one; choose another.";

TEST_F(Answers, AreValidWithoutAWord)
{
  this->giveResult();
  this->expect(Outcome::Valid);
}

TEST_F(Answers, HaveShortcomingsWhenThereIsAWarning)
{
  this->giveResult();
  this->Case.Filter->Warnings = { "A part is thinner than a triangle." };
  this->expect(Outcome::Shortcoming);
}

TEST_F(Answers, AreRefusalsWithOneSentence)
{
  this->Case.Filter->Errors = { Sentence };
  this->expect(Outcome::Refused);
}

TEST_F(Answers, AreWrongWithTwoErrors)
{
  this->Case.Filter->Errors = { Sentence, Sentence };
  this->expect(Outcome::Wrong, Fault::NoSentence);
}

TEST_F(Answers, AreWrongWithoutASentence)
{
  this->Case.Filter->Errors = { "vector::_M_range_check" };
  this->expect(Outcome::Wrong, Fault::NoSentence);
}

TEST_F(Answers, AreWrongWithOutputsLeftOver)
{
  this->giveResult();
  this->Case.Filter->Errors = { Sentence };
  this->expect(Outcome::Wrong, Fault::LeftOver);
}

TEST_F(Answers, MayStopWithWhatWasReached)
{
  this->giveResult();
  vtkNew<vtkDoubleArray> stopped;
  stopped->SetName("Stopped");
  stopped->InsertNextValue(2.0);
  this->Case.Filter->Result->GetFieldData()->AddArray(stopped);
  this->expect(Outcome::Wrong, Fault::NoSentence);
  this->Case.Filter->Modified();
  this->Case.Filter->Errors = { Sentence };
  this->expect(Outcome::Shortcoming);
}

TEST_F(Answers, AreWrongWhenAGoodInputIsRefused)
{
  this->Case.MustAccept = true;
  this->Case.Filter->Errors = { Sentence };
  this->expect(Outcome::Wrong, Fault::RefusedGood);
}

TEST_F(Answers, AreWrongWhenABadInputIsNot)
{
  this->giveResult();
  this->Case.Why = "a point is NaN";
  this->expect(Outcome::Wrong, Fault::AcceptedBad);
}

TEST_F(Answers, AreWrongWhenThereIsNothing)
{
  this->expect(Outcome::Wrong, Fault::Nothing);
}

TEST_F(Answers, AreWrongWithNumbersThatAreNone)
{
  this->giveResult();
  vtkNew<vtkDoubleArray> array;
  array->SetName("Values");
  array->SetNumberOfTuples(this->Input.data->GetNumberOfPoints());
  array->FillValue(0.0);
  array->SetValue(3, std::numeric_limits<double>::infinity());
  this->Case.Filter->Result->GetPointData()->AddArray(array);
  this->expect(Outcome::Wrong, Fault::NotFinite);
}

TEST_F(Answers, AreWrongWhenTheJudgeSaysSo)
{
  this->giveResult();
  this->Case.JudgeIsPleased = false;
  this->expect(Outcome::Wrong, Fault::TooFar);
}

TEST_F(Answers, KnowWhenMemoryRanOut)
{
  this->Case.Filter->Errors = { "The computation ran out of memory; use fewer samples." };
  this->expect(Outcome::OutOfMemory);
}

TEST(Trials, AreTheSameForTheSameSeed)
{
  const auto describe = [](std::uint64_t seed)
  {
    std::string text;
    const Verdict verdict = runTrial(
      seed, filterKind("DistanceHierarchy"), [&](const std::string& said) { text = said; });
    return text + verdict.what;
  };
  EXPECT_EQ(describe(4), describe(4));
  EXPECT_NE(describe(4), describe(5));
}

} // namespace
