// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * Closed surfaces of one part that cross themselves.
 */

#ifndef SelfCrossingSurfaces_h
#define SelfCrossingSurfaces_h

#include "SampleSurfaces.h"

namespace Sample
{

/// A prism over r = 1/2 + cos(angle): the inner loop, 0 < x < 1/2, is covered twice.
Surface SelfOverlappingPrism();

/// A prism over a bow tie: the part x < 0 faces outwards, the smaller one, 0 < x < 0.6, inwards.
Surface TwistedPrism();

/// A tube of figure-eight section with half a twist: one side, no boundary.
Surface KleinBottle(int around, int across);

} // namespace Sample

#endif
