// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * How a step that fails is tried again.
 */

#ifndef EVOLVING_STEP_RETRY_H
#define EVOLVING_STEP_RETRY_H

#include "Evolution/StepFailure.h"

#include <functional>
#include <optional>

namespace evolving
{

/**
 * A step in `parts` parts, and where it fails again in 2, 4, 8 and 16 times as many, as long as
 * that may help.
 * @param tryStep makes the step in so many parts, and undoes what it did where it fails; the flag
 * says whether that is the first try
 * @return why the last try failed; nothing when one did not
 */
std::optional<StepFailure> tryInMoreParts(
  int parts, const std::function<std::optional<StepFailure>(int parts, bool isFirst)>& tryStep);

} // namespace evolving

#endif
