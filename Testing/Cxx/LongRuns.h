// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * Every filter with an input and parameters that give it something to do.
 */

#ifndef LongRuns_h
#define LongRuns_h

#include "vtkSmartPointer.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

class vtkAlgorithm;

/// A filter ready for Update().
struct LongRunCase
{
  const char* Name;
  vtkSmartPointer<vtkAlgorithm> (*Make)();
};

/// vtkMeshSDF with each method, vtkSurfaceEvolution, ....
std::vector<LongRunCase> LongRunCases();
std::string NameOf(const testing::TestParamInfo<LongRunCase>& info);

vtkSmartPointer<vtkAlgorithm> MakeLongEvolution();

/// Have the first outputs of two filters the same bits?
testing::AssertionResult SameOutputs(vtkAlgorithm* a, vtkAlgorithm* b);

#endif
