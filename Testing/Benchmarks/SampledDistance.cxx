// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "SampledDistance.h"

#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iostream>

namespace benchmark
{

vtkSmartPointer<vtkImageData> sampleDistance(vtkPolyData* surface, const Sampling& sampling)
{
  vtkNew<vtkMeshSDF> filter;
  filter->SetInputData(surface);
  filter->SetSampleDimensions(sampling.size, sampling.size, sampling.size);
  filter->SetMethod(sampling.method);
  filter->SetSign(sampling.sign);
  filter->SetNumberOfSweeps(sampling.sweeps);
  // The filter keeps a backend that is not the sequential one.
  vtkSMPTools::LocalScope(
    vtkSMPTools::Config{ sampling.threads, "STDThread", false }, [&]() { filter->Update(); });
  vtkSmartPointer<vtkImageData> image = filter->GetOutput();
  if (!image->GetPointData()->GetScalars())
  {
    std::cerr << "vtkMeshSDF made no image, see its message above.\n";
    std::exit(1);
  }
  return image;
}

std::vector<float> values(vtkImageData* image)
{
  auto* scalars = vtkFloatArray::SafeDownCast(image->GetPointData()->GetScalars());
  const float* first = scalars->GetPointer(0);
  return { first, first + scalars->GetNumberOfTuples() };
}

const char* signMethod(vtkImageData* image)
{
  const auto method =
    static_cast<int>(image->GetFieldData()->GetArray("SignMethod")->GetComponent(0, 0));
  switch (method)
  {
    case vtkMeshSDF::FLOOD_FILL:
      return "FloodFill";
    case vtkMeshSDF::WINDING_NUMBER:
      return "WindingNumber";
    case vtkMeshSDF::PSEUDONORMAL:
      return "Pseudonormal";
    default:
      return "Unsigned";
  }
}

Difference difference(
  const std::vector<float>& field, const std::vector<float>& exact, double spacing)
{
  constexpr double SurfaceCells = 1e-4;
  Difference result;
  for (std::size_t s = 0; s < field.size(); ++s)
  {
    const double expected = static_cast<double>(exact[s]) / spacing;
    const double error =
      std::abs(std::abs(static_cast<double>(field[s]) / spacing) - std::abs(expected));
    result.mean += error;
    result.meanSquare += error * error;
    result.largest = std::max(result.largest, error);
    const bool differs = (field[s] < 0.0F) != (exact[s] < 0.0F);
    result.signs += differs && std::abs(expected) > SurfaceCells ? 1 : 0;
  }
  result.mean /= static_cast<double>(field.size());
  result.meanSquare /= static_cast<double>(field.size());
  return result;
}

std::vector<float> distanceToUnitSphere(vtkImageData* image)
{
  std::vector<float> distance(static_cast<std::size_t>(image->GetNumberOfPoints()));
  for (std::size_t s = 0; s < distance.size(); ++s)
  {
    double p[3];
    image->GetPoint(static_cast<vtkIdType>(s), p);
    distance[s] = static_cast<float>(std::sqrt(p[0] * p[0] + p[1] * p[1] + p[2] * p[2]) - 1.0);
  }
  return distance;
}

} // namespace benchmark
