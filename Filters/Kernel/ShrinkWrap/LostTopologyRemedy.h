// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * Which parameters of a wrap have cost a target its topology, and what to set them to.
 */

#ifndef EVOLVING_LOST_TOPOLOGY_REMEDY_H
#define EVOLVING_LOST_TOPOLOGY_REMEDY_H

#include "LostTopology/LostTopology.h"
#include "ShrinkWrap/ShrinkWrapOptions.h"
#include "ShrinkWrap/WrapTarget.h"

namespace evolving
{

/**
 * A start without holes, too few samples and too large elements, each by itself, close what is
 * narrow: all that were too coarse for the narrowest lost place.
 * @param target of the wrap that has lost it
 */
LostTopologyRemedy remedyFor(
  const LostTopology& lost, const WrapTarget& target, const ShrinkWrapOptions& options);

} // namespace evolving

#endif
