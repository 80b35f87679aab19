// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Distance/FloatBox.h"

#include <cmath>

namespace evolving
{

FloatBox roundedOutwards(const Box& box)
{
  FloatBox rounded(box.min().cast<float>(), box.max().cast<float>());
  for (int axis = 0; axis < 3; ++axis)
  {
    float& low = rounded.min()[axis];
    float& high = rounded.max()[axis];
    low = static_cast<double>(low) > box.min()[axis] ? std::nextafter(low, -HUGE_VALF) : low;
    high = static_cast<double>(high) < box.max()[axis] ? std::nextafter(high, HUGE_VALF) : high;
  }
  return rounded;
}

} // namespace evolving
