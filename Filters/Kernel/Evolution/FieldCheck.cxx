// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Evolution/FieldCheck.h"

#include "Errors.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <sstream>
#include <string>
#include <vector>

namespace evolving
{

namespace
{

/// The gradients near the zero level: most are no larger, and some no smaller.
constexpr double LargestGradient = 2.0;
constexpr double SmallestGradient = 0.5;
/// Parts of the samples there: differences cancel at all others where parts are thinner than cells.
constexpr double Most = 0.5;
constexpr double AllButSome = 0.9;
/// In cells: where the gradient of an unsigned distance is looked at, beside its kink.
constexpr double Nearest = 1.0;
constexpr double Farthest = 3.0;

const char* const WhatToDo =
  "take the distance of its contour by vtkMeshSDF, or another FieldMode for an image to segment";

const char* const WhatToDoWithLabels =
  "take smooth surfaces of labels by vtkLabelSurfaces, or, to get there from another surface, the "
  "distance of their contour by vtkMeshSDF";

template <class... Parts>
[[noreturn]] void refuse(const Parts&... parts)
{
  std::ostringstream message;
  (message << ... << parts);
  throw InputError(message.str());
}

std::string inWords(const Box& box)
{
  std::ostringstream words;
  for (int axis = 0; axis < 3; ++axis)
  {
    words << (axis > 0 ? " x " : "") << "[" << box.min()[axis] << ", " << box.max()[axis] << "]";
  }
  return words.str();
}

/// Calls visit(value, i, j, k, hasOtherSign) for every sample; the last is true where a neighbour
/// of the sample is on the other side of zero.
template <class Visit>
void forEachSample(const ScalarImage& field, Visit visit)
{
  const DistanceGrid& grid = field.grid();
  const auto value = [&](int i, int j, int k)
  { return field.values()[static_cast<std::size_t>(grid.index(i, j, k))]; };
  const Extent& e = grid.extent;
  for (int k = e[4]; k <= e[5]; ++k)
  {
    for (int j = e[2]; j <= e[3]; ++j)
    {
      for (int i = e[0]; i <= e[1]; ++i)
      {
        const bool isInside = value(i, j, k) < 0.0F;
        const auto differs = [&](int a, int b, int c)
        { return a <= e[1] && b <= e[3] && c <= e[5] && (value(a, b, c) < 0.0F) != isInside; };
        visit(value(i, j, k), i, j, k,
          differs(i + 1, j, k) || differs(i, j + 1, k) || differs(i, j, k + 1));
      }
    }
  }
}

struct Values
{
  float least = 0.0F;
  float largest = 0.0F;
  bool areTwo = true; ///< no other than these
  bool areWhole = true;
};

Values summarize(const std::vector<float>& values)
{
  const auto [least, largest] = std::minmax_element(values.begin(), values.end());
  const bool areTwo = std::all_of(values.begin(), values.end(),
    [low = *least, high = *largest](float value) { return value == low || value == high; });
  const bool areWhole = std::all_of(
    values.begin(), values.end(), [](float value) { return value == std::floor(value); });
  return { *least, *largest, areTwo, areWhole };
}

/// Of the samples near the zero level.
std::vector<double> gradientsNearZero(const ScalarImage& field, bool isSigned)
{
  const double cell = field.grid().spacing.maxCoeff();
  std::vector<double> gradients;
  forEachSample(field,
    [&](float value, int i, int j, int k, bool isAtChange)
    {
      const bool isNear =
        isSigned ? isAtChange : value > Nearest * cell && value <= Farthest * cell;
      if (isNear)
      {
        gradients.push_back(field.gradientAtSample(i, j, k).norm());
      }
    });
  return gradients;
}

/// The value that a part of all are below; zero when there are none.
double quantile(std::vector<double>& values, double part)
{
  if (values.empty())
  {
    return 0.0;
  }
  const auto place =
    values.begin() + static_cast<std::ptrdiff_t>(part * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), place, values.end());
  return *place;
}

} // namespace

void checkFieldPlace(const ScalarImage& field, const SurfaceMesh& start)
{
  const std::array<int, 3> n = { field.grid().dimension(0), field.grid().dimension(1),
    field.grid().dimension(2) };
  if (std::min({ n[0], n[1], n[2] }) < 2)
  {
    refuse("The field has ", n[0], " x ", n[1], " x ", n[2],
      " samples, expected at least two along every axis: a slice attracts no surface, give the "
      "whole volume.");
  }
  const Box fieldBox = field.box();
  const Box startBox = boundingBox(start);
  if (!fieldBox.intersects(startBox))
  {
    refuse("The start surface, in ", inWords(startBox), ", lies outside of the field, in ",
      inWords(fieldBox),
      ", expected them to meet: begin with a surface around or inside of what the field "
      "describes.");
  }
}

void checkDistance(const ScalarImage& field)
{
  const Values values = summarize(field.values());
  if (values.least == values.largest)
  {
    refuse("The field is ", values.least,
      " everywhere, expected a signed distance; take that of a "
      "surface by vtkMeshSDF.");
  }
  if (values.areTwo)
  {
    refuse("The field has no values but ", values.least, " and ", values.largest,
      ", expected a signed distance; ", WhatToDoWithLabels, ".");
  }
  if (values.areWhole && values.least >= 0.0F)
  {
    refuse("The field has whole numbers from ", values.least, " to ", values.largest,
      ", as labels are, expected a signed distance; ", WhatToDoWithLabels, ".");
  }
  const double cell = field.grid().spacing.maxCoeff();
  const bool isSigned = values.least < 0.0F && values.largest >= 0.0F;
  if (!isSigned && std::min(std::abs(values.least), std::abs(values.largest)) > cell)
  {
    refuse("The values of the field go from ", values.least, " to ", values.largest,
      ", expected a signed distance, which is zero somewhere; subtract the value at the target, "
      "or ",
      WhatToDo, ".");
  }
  std::vector<double> gradients = gradientsNearZero(field, isSigned);
  const double middle = quantile(gradients, Most);
  if (middle > LargestGradient || quantile(gradients, AllButSome) < SmallestGradient)
  {
    refuse("The field changes by ", middle,
      " per length near its zero level, expected a signed distance, which changes by 1; ", WhatToDo,
      ".");
  }
}

void checkField(const ScalarImage& field, const SurfaceMesh& start, FieldMode mode)
{
  checkFieldPlace(field, start);
  if (mode == FieldMode::DistanceField)
  {
    checkDistance(field);
  }
}

} // namespace evolving
