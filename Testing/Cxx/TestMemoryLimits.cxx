// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

// Out of memory, wherever that happens and on whichever thread: one sentence, outputs as new, and
// a filter that works again when there is more.

#include "DataChecks.h"
#include "EventLog.h"
#include "MemoryLimit.h"
#include "SampleSurfaces.h"

#include "vtkDataSet.h"
#include "vtkDistanceHierarchy.h"
#include "vtkFieldData.h"
#include "vtkIcosphereSource.h"
#include "vtkImageData.h"
#include "vtkMeshSDF.h"
#include "vtkPolyData.h"
#include "vtkSMPTools.h"
#include "vtkShrinkWrap.h"
#include "vtkSurfaceEvolution.h"
#include "vtkTangentialRedistribution.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <memory>
#include <string>
#include <tuple>

namespace
{

using Filter = vtkSmartPointer<vtkAlgorithm>;

//------------------------------------------------------------------------------
Filter MakeDistance(int sign)
{
  auto filter = vtkSmartPointer<vtkMeshSDF>::New();
  filter->SetInputData(Sample::Icosphere(5));
  filter->SetSampleDimensions(60, 60, 60);
  filter->SetSign(sign);
  filter->ComputeGradientOn();
  filter->ComputeClosestPointOn();
  return filter;
}

//------------------------------------------------------------------------------
Filter MakeWinding()
{
  return MakeDistance(vtkMeshSDF::WINDING_NUMBER);
}

//------------------------------------------------------------------------------
Filter MakeFlood()
{
  return MakeDistance(vtkMeshSDF::FLOOD_FILL);
}

//------------------------------------------------------------------------------
Filter MakeEvolution()
{
  auto filter = vtkSmartPointer<vtkSurfaceEvolution>::New();
  filter->SetInputData(0, Sample::Icosphere(4, 1.5));
  filter->SetInputData(1, Sample::SphereImage(33, 2.0, 1.0));
  filter->SetNumberOfSteps(2);
  filter->SetTimeStep(0.01);
  filter->SetVolumeRedistribution(1.0);
  filter->SetAngleRedistribution(1.0);
  filter->SetRemeshingToUniform();
  return filter;
}

//------------------------------------------------------------------------------
Filter MakeRedistribution()
{
  auto filter = vtkSmartPointer<vtkTangentialRedistribution>::New();
  filter->SetInputData(Sample::Icosphere(5));
  filter->SetNumberOfSteps(2);
  return filter;
}

//------------------------------------------------------------------------------
Filter MakeWrap()
{
  auto filter = vtkSmartPointer<vtkShrinkWrap>::New();
  filter->SetInputData(Sample::Icosphere(3));
  filter->SetSampleDimensions(60, 60, 60);
  filter->SetTargetEdgeLength(0.1);
  return filter;
}

//------------------------------------------------------------------------------
Filter MakeHierarchy()
{
  auto filter = vtkSmartPointer<vtkDistanceHierarchy>::New();
  filter->SetInputData(Sample::Icosphere(5));
  filter->SetStructureToOctree();
  filter->SetSampleDimensions(60, 60, 60);
  return filter;
}

//------------------------------------------------------------------------------
Filter MakeSphere()
{
  auto filter = vtkSmartPointer<vtkIcosphereSource>::New();
  filter->SetLevel(6);
  return filter;
}

//------------------------------------------------------------------------------
struct FilterCase
{
  const char* Name;
  Filter (*Make)();
};

//------------------------------------------------------------------------------
/// What a child process found; anything else is a crash.
enum Verdict
{
  Finished,
  Refused,
  Stopped, ///< with what a flow had reached, and one sentence
  SaidMoreThanOneSentence,
  LeftOutputs,
  FailsForever
};

//------------------------------------------------------------------------------
bool AreInitialized(vtkAlgorithm* filter)
{
  for (int port = 0; port < filter->GetNumberOfOutputPorts(); ++port)
  {
    if (!IsInitialized(filter->GetOutputDataObject(port)))
    {
      return false;
    }
  }
  return true;
}

//------------------------------------------------------------------------------
bool HasPoints(vtkAlgorithm* filter)
{
  return vtkDataSet::SafeDownCast(filter->GetOutputDataObject(0))->GetNumberOfPoints() > 0;
}

//------------------------------------------------------------------------------
/// Did a flow end on its way, with a good state?
bool HasStopped(vtkAlgorithm* filter)
{
  return HasPoints(filter) && filter->GetOutputDataObject(0)->GetFieldData()->HasArray("Stopped");
}

//------------------------------------------------------------------------------
Verdict Judge(vtkAlgorithm* filter, EventLog& log)
{
  if (log.Errors.empty())
  {
    return HasPoints(filter) ? Finished : FailsForever;
  }
  if (log.Errors.size() > 1 || !IsOneSentence(log.Errors.front()))
  {
    return SaidMoreThanOneSentence;
  }
  if (!AreInitialized(filter))
  {
    return HasStopped(filter) ? Stopped : LeftOutputs;
  }
  log.Clear();
  filter->Modified();
  filter->Update();
  return log.Errors.empty() && HasPoints(filter) ? Refused : FailsForever;
}

//------------------------------------------------------------------------------
int UpdateLimited(const FilterCase& filterCase, int threads, std::size_t bytes)
{
  Filter filter;
  std::unique_ptr<EventLog> log;
  return MemoryLimit::Run(
    bytes,
    [&]()
    {
      setenv("VTK_SMP_BACKEND_IN_USE", "STDThread", 1); // the user's choice
      // From 9.3 on VTK starts its threads when first asked, and ends the process where it gets
      // none.
      vtkSMPTools::LocalScope(vtkSMPTools::Config{ threads, "STDThread", false },
        []() { vtkSMPTools::IsParallelScope(); });
      filter = filterCase.Make();
      log = std::make_unique<EventLog>(filter);
    },
    [&]()
    {
      vtkSMPTools::LocalScope(
        vtkSMPTools::Config{ threads, "STDThread", false }, [&]() { filter->Update(); });
    },
    [&]() { return static_cast<int>(Judge(filter, *log)); });
}

//------------------------------------------------------------------------------
class Memory : public testing::TestWithParam<std::tuple<FilterCase, int>>
{
};

TEST_P(Memory, MayEndAnywhere)
{
  if (!MemoryLimit::IsSupported())
  {
    GTEST_SKIP() << "no memory limits here";
  }
  const auto& [filterCase, threads] = GetParam();
  constexpr double Least = 1 << 20;
  constexpr double Most = 1 << 30;
  constexpr double Growth = 1.6;
  int refused = 0;
  int verdict = Refused;
  for (double bytes = Least; verdict != Finished && bytes < Most; bytes *= Growth)
  {
    verdict = UpdateLimited(filterCase, threads, static_cast<std::size_t>(bytes));
    refused += verdict == Refused ? 1 : 0;
    ASSERT_TRUE(verdict == Refused || verdict == Stopped || verdict == Finished)
      << "verdict " << verdict << " with " << bytes << " bytes";
  }
  EXPECT_EQ(verdict, Finished);
  EXPECT_GE(refused, 2);
}

INSTANTIATE_TEST_SUITE_P(Filters, Memory,
  testing::Combine(
    testing::Values(FilterCase{ "Winding", MakeWinding }, FilterCase{ "Flood", MakeFlood },
      FilterCase{ "Evolution", MakeEvolution }, FilterCase{ "Redistribution", MakeRedistribution },
      FilterCase{ "Wrap", MakeWrap }, FilterCase{ "Hierarchy", MakeHierarchy },
      FilterCase{ "Sphere", MakeSphere }),
    testing::Values(1, 2, 8)),
  [](const testing::TestParamInfo<std::tuple<FilterCase, int>>& info)
  {
    return std::string(std::get<0>(info.param).Name) + "On" +
      std::to_string(std::get<1>(info.param));
  });

} // namespace
