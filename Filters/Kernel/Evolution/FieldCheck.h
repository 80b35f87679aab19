// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * Can a surface evolve by this field at all?
 */

#ifndef EVOLVING_FIELD_CHECK_H
#define EVOLVING_FIELD_CHECK_H

#include "Evolution/FlowOptions.h"
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
 * level it may be anything, as a narrow band is. Of the samples near it at least a tenth must have
 * a gradient of a half, as parts thinner than a cell, where differences cancel, still do, and half
 * of them none above two, as noise of half a cell still does.
 * @throws InputError that says what the field is like and what to do
 */
void checkDistance(const ScalarImage& field);

/// Both, the second where the image is to be a distance. @throws InputError
void checkField(const ScalarImage& field, const SurfaceMesh& start, FieldMode mode);

} // namespace evolving

#endif
