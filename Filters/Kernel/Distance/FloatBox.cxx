// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Distance/FloatBox.h"

#include <cmath>
#include <limits>

namespace evolving
{

namespace
{

/// One place of a float and a bit lower: as safe as std::nextafter(), and faster.
float roundedDown(double value)
{
  constexpr float Place = 1.2e-7F;
  const auto rounded = static_cast<float>(value);
  if (std::isinf(rounded))
  {
    return value < 0.0 ? rounded : std::numeric_limits<float>::max();
  }
  return rounded - (Place * std::abs(rounded) + std::numeric_limits<float>::denorm_min());
}

} // namespace

FloatBox roundedOutwards(const Box& box)
{
  return { box.min().unaryExpr(&roundedDown), -((-box.max()).unaryExpr(&roundedDown)) };
}

} // namespace evolving
