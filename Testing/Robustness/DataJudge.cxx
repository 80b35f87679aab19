// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "DataJudge.h"

#include "DistanceReference.h"
#include "OutputChecks.h"
#include "Verdict.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkPolyData.h"

#include <cmath>

namespace robustness
{

namespace
{

/// Rounding to floats, of coordinates and of the result's points.
constexpr double Rounding = 1e-5;
constexpr std::size_t MostEvaluations = 1000000;

void judgePlaces(const Subject& target, vtkPolyData* result)
{
  const DistanceReference reference(target.data, true);
  vtkDataArray* places = pointArray(result, PlaceArray, 3);
  const auto count = static_cast<std::size_t>(result->GetNumberOfPoints());
  const std::size_t step = 1 + count * reference.size() / MostEvaluations;
  for (std::size_t i = 0; i < count && !reference.isEmpty(); i += step)
  {
    Vec3 point;
    Vec3 place;
    result->GetPoint(static_cast<vtkIdType>(i), point.data());
    places->GetTuple(static_cast<vtkIdType>(i), place.data());
    const DistanceBounds bounds = reference(point);
    const double tolerance = Rounding * (target.radius + point.norm());
    const double distance = (place - point).norm();
    require(distance >= bounds.lower - tolerance && distance <= bounds.upper + tolerance,
      Fault::Misstated, "point ", i, " has data of a place at ", distance, ", the closest is at ",
      bounds.lower, " to ", bounds.upper);
  }
}

void judgeNumbers(const Subject& target, vtkPolyData* result)
{
  vtkDataArray* numbers = result->GetCellData()->GetArray(NumberArray);
  const vtkIdType cells = target.data->GetNumberOfCells();
  require((numbers != nullptr) == (cells > 0), Fault::Misstated, "cell data are ",
    numbers ? "of no cells" : "missing");
  for (vtkIdType i = 0; numbers && i < numbers->GetNumberOfTuples(); ++i)
  {
    const double number = numbers->GetComponent(i, 0);
    require(number >= 0.0 && number < static_cast<double>(cells) && std::floor(number) == number,
      Fault::Misstated, "cell ", i, " has the data of cell ", number, " of ", cells);
  }
}

} // namespace

void judgeWrappedData(const Subject& target, vtkPolyData* result)
{
  judgePlaces(target, result);
  judgeNumbers(target, result);
}

} // namespace robustness
