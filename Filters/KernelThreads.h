// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * The threads that the filters lend the kernel: VTK's, in the number and of the backend that the
 * user chose. Private to the module.
 */

#ifndef KernelThreads_h
#define KernelThreads_h

#include <cstdint>
#include <functional>

namespace KernelThreads
{

/**
 * Runs task(0), ..., task(count - 1), which must not throw, and waits for all. Where the system has
 * no thread left to give, those that there are do the work.
 */
void For(std::int64_t count, const std::function<void(std::int64_t)>& task);

/**
 * Runs work so that For() has several threads also where VTK's default backend is the sequential
 * one: then, unless the user has asked for that, the backend is STDThread.
 */
void With(const std::function<void()>& work);

} // namespace KernelThreads

#endif
