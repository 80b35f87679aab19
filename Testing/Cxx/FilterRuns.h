// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * Runs of the filters that several tests begin with, and what every end of one must be like.
 */

#ifndef FilterRuns_h
#define FilterRuns_h

#include "vtkSmartPointer.h"

#include <gtest/gtest.h>

#include <functional>
#include <string>

class EventLog;
class vtkAlgorithm;
class vtkImageData;
class vtkInformation;
class vtkMeshSDF;
class vtkPolyData;
class vtkShrinkWrap;
class vtkTangentialRedistribution;

/// Runs vtkMeshSDF with n^3 samples, the rest as it is by default or set up.
vtkSmartPointer<vtkImageData> Distance(
  vtkPolyData* surface, int n, const std::function<void(vtkMeshSDF*)>& setUp = {});

/// What the filter says of its output before it runs.
vtkInformation* InformationOf(vtkMeshSDF* filter);

/// The names of vtkMeshSDF's methods, for tests over all of them.
std::string NameOfMethod(const testing::TestParamInfo<int>& info);

/// Runs vtkTangentialRedistribution.
vtkSmartPointer<vtkPolyData> Redistributed(
  vtkPolyData* surface, const std::function<void(vtkTangentialRedistribution*)>& setUp = {});

/// Coarse enough for a test: a tenth of a second or so.
void SetUpCoarsely(vtkShrinkWrap* filter, vtkPolyData* input);

/// Is it what its field data say, and is that a closed oriented 2-manifold of this genus?
void ExpectClosed(vtkPolyData* surface, int genus);

/// Did the filter say one sentence, with these words in it, and leave its outputs as new?
void ExpectRefusal(vtkAlgorithm* filter, const EventLog& log, const std::string& words = {});

/// Runs the filter; the same.
void ExpectRefusalOf(vtkAlgorithm* filter, const std::string& words = {});

#endif
