// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * Distance grids as users get them, from vtkMeshSDF, and how far two of them differ.
 */

#ifndef BENCHMARK_SAMPLED_DISTANCE_H
#define BENCHMARK_SAMPLED_DISTANCE_H

#include "vtkImageData.h"
#include "vtkMeshSDF.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <vector>

namespace benchmark
{

/// What differs between runs of vtkMeshSDF; its other parameters keep their defaults.
struct Sampling
{
  int size = 128; ///< along each axis of the cube grid
  int method = vtkMeshSDF::CLOSEST_POINT;
  int sign = vtkMeshSDF::AUTOMATIC;
  int threads = 2; ///< of VTK's STDThread backend
  int sweeps = 8;
};

/// Leaves the program when the filter fails.
vtkSmartPointer<vtkImageData> sampleDistance(vtkPolyData* surface, const Sampling& sampling);

std::vector<float> values(vtkImageData* image);
/// The name of the sign method that was used.
const char* signMethod(vtkImageData* image);

/// Of |d|, lengths in cells. Signs are counted apart: one that is wrong is no small error.
struct Difference
{
  double mean = 0.0;
  double largest = 0.0;
  double meanSquare = 0.0; ///< the thesis's error of section 5.3
  long long signs = 0;     ///< that differ farther than 1e-4 cells from the surface
};

Difference difference(
  const std::vector<float>& field, const std::vector<float>& exact, double spacing);

/// The signed distance to the unit sphere at an image's samples.
std::vector<float> distanceToUnitSphere(vtkImageData* image);

} // namespace benchmark

#endif
