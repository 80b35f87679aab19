// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * Local changes that build on each other, on several threads.
 */

#ifndef EVOLVING_ORDERED_TASKS_H
#define EVOLVING_ORDERED_TASKS_H

#include "Execution.h"
#include "Types.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

namespace evolving
{

/// The places of the surface, edges or faces, that a task reads or changes.
using PlacesOfTask = std::function<std::vector<Index>(std::size_t task)>;

/**
 * Runs tasks 0 to count - 1 with the outcome of one after the other. Those that have no place in
 * common may run side by side: then each waits only for those before it at its own places.
 * @param placeCount places are numbers below it
 * @param grain how many tasks are worth a thread
 */
void runInOrder(std::size_t count, const PlacesOfTask& placesOf, Index placeCount,
  std::int64_t grain, const std::function<void(std::size_t task)>& run,
  const Execution& execution = {});

} // namespace evolving

#endif
