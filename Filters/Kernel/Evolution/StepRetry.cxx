// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Evolution/StepRetry.h"

namespace evolving
{

namespace
{

constexpr int MostHalvings = 4;

} // namespace

std::optional<StepFailure> tryInMoreParts(
  int parts, const std::function<std::optional<StepFailure>(int parts, bool isFirst)>& tryStep)
{
  std::optional<StepFailure> failure;
  for (int halvings = 0; halvings <= MostHalvings; ++halvings)
  {
    failure = tryStep(parts << halvings, halvings == 0);
    if (!failure || !failure->mayPassInParts)
    {
      break;
    }
  }
  return failure;
}

} // namespace evolving
