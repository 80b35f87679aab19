// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * Runs code in a process of its own that gets no more than so much memory.
 */

#ifndef MemoryLimit_h
#define MemoryLimit_h

#include <cstddef>
#include <functional>

namespace MemoryLimit
{

/// Needs Linux and glibc; under a sanitizer, which maps terabytes, there is no limit to set.
bool IsSupported();

/**
 * Calls `prepare`, then `run` with so many more bytes of address space than were in use before it,
 * then `judge` without that limit; all in a child of this process. Threads have small stacks
 * there, so that they can start under small limits too.
 * @return what `judge` returned, 0 to 99, or 100 and more when the child crashed
 */
int Run(std::size_t bytes, const std::function<void()>& prepare, const std::function<void()>& run,
  const std::function<int()>& judge);

} // namespace MemoryLimit

#endif
