// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * Where moving vertices no longer helps the worst elements, other elements take their place.
 */

#ifndef EVOLVING_ELEMENT_REPAIR_H
#define EVOLVING_ELEMENT_REPAIR_H

#include "Execution.h"
#include "Remeshing/EditableSurface.h"
#include "Remeshing/ReferenceSurface.h"

namespace evolving
{

/**
 * For every triangle with an angle below `degrees`, the worst first: tries to flip and to collapse
 * each of its edges and to split the longest one, improves the stars around after each, and keeps
 * what raises the smallest angle around most.
 * @return the number of places that got better
 */
Index repairElements(EditableSurface& surface, const ReferenceSurface& reference, double degrees,
  const Execution& execution = {});

} // namespace evolving

#endif
