// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * Boxes in half the memory.
 */

#ifndef EVOLVING_FLOAT_BOX_H
#define EVOLVING_FLOAT_BOX_H

#include "Types.h"

namespace evolving
{

using FloatBox = Eigen::AlignedBox3f;

/// The smallest box of floats around a box of doubles.
FloatBox roundedOutwards(const Box& box);

} // namespace evolving

#endif
