// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * Small pieces of a label that lie apart from the rest of it.
 */

#ifndef EVOLVING_LABEL_ISLANDS_H
#define EVOLVING_LABEL_ISLANDS_H

#include "Remeshing/EditableSurface.h"

namespace evolving
{

/**
 * A label of the target is in one piece, so on the surface, too. Where a patch is narrower than
 * elements, as at the end of a blade, a few faces may lie nearest to it amidst those of others.
 * Pieces without an inner vertex, but for the largest one of each label, get the label that is
 * beside most of their border.
 */
void joinIslands(EditableSurface& surface);

} // namespace evolving

#endif
