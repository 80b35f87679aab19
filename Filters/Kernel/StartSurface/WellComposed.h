// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * Well-composed sets of samples (Latecki, Eckhardt, Rosenfeld 1995; Latecki 1997): sets whose
 * boundary is a 2-manifold.
 */

#ifndef EVOLVING_WELL_COMPOSED_H
#define EVOLVING_WELL_COMPOSED_H

#include "Execution.h"
#include "StartSurface/InsideSamples.h"
#include "Types.h"

namespace evolving
{

/**
 * Is a cell one through which the surface may pass more than once? So it is when on one of its
 * faces just two opposite corners are inside, or when of the whole cell just two opposite corners
 * are inside, or just two opposite corners outside.
 * @param corners as InsideSamples::cornersOfCell() has them
 */
bool isAmbiguousCell(unsigned corners);

/**
 * Turns outside samples inside until no cell is ambiguous; of the samples that settle a cell,
 * the one with the smallest value. Samples only ever turn inside, so this ends, and the outer
 * layer stays outside. On a field that is smooth at the size of a cell few samples turn.
 * @return the number of samples turned
 * @throws Cancelled
 */
GridIndex makeWellComposed(InsideSamples& samples, const Execution& execution = {});

} // namespace evolving

#endif
