// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * How small elements, and the cells of the grid that they start from, have to be for a target.
 */

#ifndef EVOLVING_WRAP_RESOLUTION_H
#define EVOLVING_WRAP_RESOLUTION_H

#include "Execution.h"
#include "ShrinkWrap/ShrinkWrapOptions.h"
#include "ShrinkWrap/WrapTarget.h"
#include "ShrinkWrap/WrapView.h"
#include "Types.h"

#include <optional>

namespace evolving
{

/// For a first look at a target, of which nothing is known yet: 128 samples where none are asked
/// for.
WrapResolution firstResolution(const ShrinkWrapOptions& options);

/// Do the options leave it to the target how small elements beside creases are?
bool mayVarySizes(const ShrinkWrapOptions& options);

/// Of the grid of any look: as many as are asked for, or 32 million where that is automatic.
GridIndex mostSamples(const ShrinkWrapOptions& options);

/**
 * What the first look has shown to be needed. Where no edge length is asked for, elements
 * - of as many points as are asked for, or else of 9000, or as many more as it takes: up to 60,000;
 * - without parts of the target that cannot be seen from outside;
 * - smaller ones beside the creases to preserve, down to an eighth, CreaseSizes;
 * and in any case cells small enough to find holes and gaps of their size, 32 million of them at
 * most.
 * @param view by firstResolution()
 * @param isClean is the target closed, and does nothing of it run through anything? Then what the
 *   first look cannot see is behind holes and gaps too narrow for it, and not inside another part.
 * @return nothing where the first look was fine enough
 * @throws Cancelled
 */
std::optional<WrapResolution> neededResolution(const ShrinkWrapOptions& options,
  const WrapView& view, const Execution& execution = {}, bool isClean = false);

/// The same of a target of points: only a number of them that is asked for needs a second look.
std::optional<WrapResolution> neededForPoints(
  const ShrinkWrapOptions& options, const WrapView& view);

/**
 * The next resolution to try where a view has not the holes and handles of its target: with finer
 * cells.
 * @param tried for this view
 * @return nothing where no finer ones are allowed, or where the elements are what closes the holes
 */
std::optional<WrapResolution> finerResolution(
  const ShrinkWrapOptions& options, const WrapResolution& tried, const WrapView& view);

} // namespace evolving

#endif
