// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * Can a surface evolve by this field at all?
 */

#ifndef EVOLVING_FIELD_CHECK_H
#define EVOLVING_FIELD_CHECK_H

#include "Evolution/ScalarImage.h"
#include "Mesh/SurfaceMesh.h"

namespace evolving
{

/**
 * A field must have samples along all three axes, and its box must meet the start's.
 * @throws InputError that says which is not so and what to do
 */
void checkFieldPlace(const ScalarImage& field, const SurfaceMesh& start);

/**
 * A distance has a zero level, or comes closer to zero than a cell if it is unsigned, and changes
 * by about 1 per length there: labels, intensities and implicit functions do not. Far from the
 * level it may be anything, as a narrow band is; in the middle of the samples near it the gradient
 * must be between a half and two, so that noise, smoothing and parts thinner than a cell pass.
 * @throws InputError that says what the field is like and what to do
 */
void checkDistance(const ScalarImage& field);

} // namespace evolving

#endif
