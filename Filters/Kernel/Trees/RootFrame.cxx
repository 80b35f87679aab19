// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Trees/RootFrame.h"

#include <cmath>

namespace evolving
{

RootFrame::RootFrame(const Box& root)
{
  if (root.isEmpty() || !root.center().allFinite())
  {
    return;
  }
  this->Middle = root.center();
  const double halfSize = 0.5 * root.sizes().maxCoeff();
  if (std::isnormal(halfSize) && std::isnormal(1.0 / halfSize))
  {
    this->HalfSize = halfSize;
    this->InverseHalfSize = 1.0 / halfSize;
  }
}

} // namespace evolving
