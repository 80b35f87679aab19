// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

// The bits of every output are the same for VTK's sequential backend and any number of threads.

#include "LongRuns.h"

#include "vtkAlgorithm.h"
#include "vtkSMPTools.h"

#include <gtest/gtest.h>

#include <cstdlib>

namespace
{

//------------------------------------------------------------------------------
/// Says that the user has chosen a backend: otherwise the filters take threads where VTK's default
/// is the sequential one.
class ChosenBackend
{
public:
  explicit ChosenBackend(const char* name) { setenv(Variable, name, 1); }
  ~ChosenBackend() { unsetenv(Variable); }

private:
  static constexpr const char* Variable = "VTK_SMP_BACKEND_IN_USE";
};

//------------------------------------------------------------------------------
class Threads : public testing::TestWithParam<LongRunCase>
{
protected:
  static vtkSmartPointer<vtkAlgorithm> Run(const char* backend, int threads)
  {
    const ChosenBackend chosen(backend);
    const auto filter = GetParam().Make();
    vtkSMPTools::LocalScope(
      vtkSMPTools::Config{ threads, backend, false }, [&]() { filter->Update(); });
    return filter;
  }
};

TEST_P(Threads, ChangeNothing)
{
  const auto serial = Run("Sequential", 1);
  for (const int threads : { 1, 2, 8, 64 })
  {
    EXPECT_TRUE(SameOutputs(serial, Run("STDThread", threads))) << threads << " threads";
  }
}

TEST_P(Threads, ChangeNothingWhenNobodyChose)
{
  const auto filter = GetParam().Make();
  filter->Update();
  EXPECT_TRUE(SameOutputs(Run("Sequential", 1), filter));
}

INSTANTIATE_TEST_SUITE_P(Filters, Threads, testing::ValuesIn(LongRunCases()), NameOf);

} // namespace
