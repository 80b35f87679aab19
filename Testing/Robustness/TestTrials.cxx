// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

// How answers are classed, with a filter that says and does what it is told to; and children that
// crash, hang and eat memory.

#include "BaseShapes.h"
#include "ChildProcess.h"
#include "Generator.h"
#include "Report.h"
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

#include <csignal>
#include <cstdlib>
#include <limits>
#include <sstream>

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

//------------------------------------------------------------------------------
/// What becomes of work in a child.
ChildResult resultOf(const ChildPool::Work& work, const ChildLimits& limits = {})
{
  ChildPool pool(limits, work);
  pool.start(7);
  return pool.wait();
}

TEST(Children, HandTheirVerdictOn)
{
  const ChildResult result = resultOf(
    [](std::uint64_t seed, const Messenger& parent)
    {
      parent.describe("seed " + std::to_string(seed));
      parent.conclude({ Outcome::Wrong, Fault::Borders, "three\nedges" });
    });
  EXPECT_EQ(result.seed, 7u);
  EXPECT_EQ(result.description, "seed 7");
  EXPECT_EQ(result.verdict.outcome, Outcome::Wrong);
  EXPECT_EQ(result.verdict.fault, Fault::Borders);
  EXPECT_EQ(result.verdict.what, "three edges");
}

TEST(Children, MayCrash)
{
  const ChildResult result = resultOf(
    [](std::uint64_t, const Messenger& parent)
    {
      parent.describe("a crash");
      std::signal(SIGSEGV, SIG_DFL);
      std::raise(SIGSEGV);
    });
  EXPECT_EQ(result.verdict.outcome, Outcome::Crashed);
  EXPECT_EQ(result.description, "a crash");
}

TEST(Children, CrashWhenTheyEndWithoutAVerdict)
{
  EXPECT_EQ(resultOf([](std::uint64_t, const Messenger&) {}).verdict.outcome, Outcome::Crashed);
  const auto leave = [](std::uint64_t, const Messenger& parent)
  {
    parent.conclude({});
    std::_Exit(3);
  };
  EXPECT_EQ(resultOf(leave).verdict.outcome, Outcome::Crashed);
}

TEST(Children, MayTakeTooLong)
{
  ChildLimits limits;
  limits.cpuSeconds = 1;
  const auto spin = [](std::uint64_t, const Messenger&)
  {
    for (volatile bool forever = true; forever;)
    {
    }
  };
  EXPECT_EQ(resultOf(spin, limits).verdict.outcome, Outcome::TimedOut);
  limits.wallSeconds = 1;
  const auto sleep = [](std::uint64_t, const Messenger&) { std::raise(SIGSTOP); };
  EXPECT_EQ(resultOf(sleep, limits).verdict.outcome, Outcome::TimedOut);
}

TEST(Children, MayEatMemory)
{
  if (IsSanitized)
  {
    GTEST_SKIP() << "memory is not limited under sanitizers";
  }
  const auto eat = [](std::uint64_t, const Messenger& parent)
  {
    std::vector<std::vector<char>> all;
    for (;;)
    {
      all.emplace_back(std::size_t(1) << 26, 'x');
      parent.describe(std::to_string(all.size()));
    }
  };
  ChildLimits limits;
  limits.bytes = std::size_t(1) << 30;
  EXPECT_EQ(resultOf(eat, limits).verdict.outcome, Outcome::OutOfMemory);
}

//------------------------------------------------------------------------------
TEST(Reports, AreGoodUntilSomethingIsBad)
{
  Report report;
  std::ostringstream out;
  report.add("MeshSDF", { 1, "a ball", { Outcome::Refused, Fault::None, "no" } }, out);
  EXPECT_TRUE(report.isGood());
  EXPECT_TRUE(out.str().empty());
  report.add("MeshSDF", { 2, "a torus", { Outcome::Wrong, Fault::WrongSign, "no" } }, out);
  EXPECT_FALSE(report.isGood());
  EXPECT_NE(out.str().find("seed 2"), std::string::npos);
  report.print(out);
  EXPECT_NE(out.str().find("wrong sign (13): seeds 2"), std::string::npos);
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
