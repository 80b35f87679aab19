// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * Looks at a target, as closely as it needs.
 */

#ifndef EVOLVING_WRAP_LOOKS_H
#define EVOLVING_WRAP_LOOKS_H

#include "Execution.h"
#include "Mesh/SurfaceMesh.h"
#include "ShrinkWrap/ShrinkWrapOptions.h"
#include "ShrinkWrap/WrapTuning.h"
#include "ShrinkWrap/WrapView.h"
#include "Types.h"

#include <memory>
#include <optional>

namespace evolving
{

struct SeenTarget
{
  std::unique_ptr<WrapView> view;
  std::optional<Index> wantedGenus; ///< genusToKeep(); none of a target of points
};

/**
 * Of parts that run through each other, as one surface (outerSurface()): a first look; the same
 * again where it has shown sheets, that are then solids (solidSheets()); another one where it has
 * shown that other elements or finer cells are needed (neededResolution()); and more while the
 * start has not the holes and handles of a clean closed target (finerResolution()). One view is
 * held at a time.
 * @throws as describeTarget()
 */
SeenTarget lookAsNeeded(const SurfaceMesh& mesh, const ShrinkWrapOptions& options,
  const WrapTuning& tuning, const Execution& execution);

} // namespace evolving

#endif
