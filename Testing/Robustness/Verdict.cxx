// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Verdict.h"

namespace robustness
{

bool isGood(Outcome outcome)
{
  return outcome == Outcome::Valid || outcome == Outcome::Shortcoming ||
    outcome == Outcome::Refused;
}

const char* nameOf(Outcome outcome)
{
  static const char* const names[OutcomeCount] = { "valid", "shortcoming", "refused", "wrong",
    "crashed", "timed out", "out of memory" };
  return names[static_cast<int>(outcome)];
}

const char* nameOf(Fault fault)
{
  static const char* const names[] = { "none", "not triangles", "not manifold", "borders",
    "degenerate faces", "self-intersections", "no volume", "", "too far", "not finite",
    "not oriented", "misstated", "wrong distance", "wrong sign", "no sentence", "left over",
    "refused good", "accepted bad", "changed input", "nothing" };
  return names[static_cast<int>(fault)];
}

} // namespace robustness
