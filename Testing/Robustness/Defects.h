// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * What goes wrong with models on their way to us. A defect that leaves the solid as it is keeps
 * what is known of it; all others forget it.
 */

#ifndef ROBUSTNESS_DEFECTS_H
#define ROBUSTNESS_DEFECTS_H

#include "Model.h"

#include <vector>

namespace robustness
{

struct Defect
{
  const char* name;
  void (*make)(Model&, Random&);
};

/// Faces that are missing, turned, double, thin or of a strange kind.
const std::vector<Defect>& faceDefects();
/// Sheets, fins, walls, stray parts: faces that do not belong there.
const std::vector<Defect>& partDefects();
/// Points that are noisy, unused, not numbers, or numbers of points that are not there.
const std::vector<Defect>& pointDefects();

/// Scale, place and precision, which come last.
void transform(Model& model, Random& random);

} // namespace robustness

#endif
