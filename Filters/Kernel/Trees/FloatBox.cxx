// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Trees/FloatBox.h"

#include <cstdint>
#include <cstring>
#include <limits>

namespace evolving
{

namespace
{

/// The largest float that is not above; std::nextafter() would be a call.
float roundedDown(double value)
{
  const auto rounded = static_cast<float>(value);
  if (static_cast<double>(rounded) <= value)
  {
    return rounded;
  }
  if (rounded == 0.0F)
  {
    return -std::numeric_limits<float>::denorm_min();
  }
  // Floats of one sign are in the order of their bits.
  std::int32_t bits = 0;
  std::memcpy(&bits, &rounded, sizeof bits);
  bits += rounded > 0.0F ? -1 : 1;
  float lower = 0.0F;
  std::memcpy(&lower, &bits, sizeof lower);
  return lower;
}

} // namespace

FloatBox roundedOutwards(const Box& box)
{
  return { box.min().unaryExpr(&roundedDown), -((-box.max()).unaryExpr(&roundedDown)) };
}

} // namespace evolving
