// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ShrinkWrap/WrapView.h"

#include <utility>

namespace evolving
{

WrapView::WrapView(const SurfaceMesh& mesh, const ShrinkWrapOptions& options,
  const WrapResolution& resolution, const WrapTuning& tuning, const Execution& execution)
  : WrapView(describeTarget(mesh, options, resolution, execution.phase(0.0, 0.7), tuning),
      execution.phase(0.7, 1.0))
{
}

WrapView::WrapView(DescribedTarget described, const Execution& execution)
  : Target(std::make_shared<const WrapTarget>(std::move(described.target)))
  , Fields(std::move(described.fields))
  , Region(this->Target->grid, std::move(this->Fields.start), this->Target->startLevel,
      execution.phase(0.0, 0.5))
  , Reference(
      std::make_shared<const WrapReference>(*this->Target, this->Region, execution.phase(0.5, 1.0)))
{
}

} // namespace evolving
