// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * What the generator starts from: good surfaces of about unit size, closed and open.
 */

#ifndef ROBUSTNESS_BASE_SHAPES_H
#define ROBUSTNESS_BASE_SHAPES_H

#include "ShapeParts.h"

#include <vector>

namespace robustness
{

struct BaseShape
{
  const char* name;
  Model (*make)(Random&);
};

const std::vector<BaseShape>& baseShapes();

} // namespace robustness

#endif
