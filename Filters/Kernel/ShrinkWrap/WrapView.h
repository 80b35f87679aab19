// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * A target as the samples of its grid show it.
 */

#ifndef EVOLVING_WRAP_VIEW_H
#define EVOLVING_WRAP_VIEW_H

#include "Execution.h"
#include "Mesh/SurfaceMesh.h"
#include "ShrinkWrap/OuterRegion.h"
#include "ShrinkWrap/ShrinkWrapOptions.h"
#include "ShrinkWrap/WrapReference.h"
#include "ShrinkWrap/WrapTarget.h"
#include "ShrinkWrap/WrapTuning.h"

#include <memory>

namespace evolving
{

class WrapView
{
public:
  /// As describeTarget().
  WrapView(const SurfaceMesh& mesh, const ShrinkWrapOptions& options,
    const WrapResolution& resolution, const WrapTuning& tuning, const Execution& execution);

  const std::shared_ptr<const WrapTarget>& target() const { return this->Target; }
  const std::shared_ptr<const WrapReference>& reference() const { return this->Reference; }
  const OuterRegion& region() const { return this->Region; }
  /// Without TargetFields::start, which the region has taken.
  TargetFields& fields() { return this->Fields; }

private:
  WrapView(DescribedTarget described, const Execution& execution);

  std::shared_ptr<const WrapTarget> Target;
  TargetFields Fields;
  OuterRegion Region;
  std::shared_ptr<const WrapReference> Reference;
};

} // namespace evolving

#endif
