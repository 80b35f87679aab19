// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * Inputs that are special as a whole: next to nothing, flat, thin, or no surface at all.
 */

#ifndef ROBUSTNESS_SPECIAL_MODELS_H
#define ROBUSTNESS_SPECIAL_MODELS_H

#include "BaseShapes.h"

namespace robustness
{

const std::vector<BaseShape>& specialModels();

} // namespace robustness

#endif
