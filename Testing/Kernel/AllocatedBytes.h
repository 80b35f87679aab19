// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * What is allocated, as the allocator counts it.
 */

#ifndef EVOLVING_ALLOCATED_BYTES_H
#define EVOLVING_ALLOCATED_BYTES_H

#include <vector>

#if defined(__GLIBC__) && (__GLIBC__ > 2 || __GLIBC_MINOR__ >= 33)
#include <malloc.h>
#endif

namespace evolving
{

constexpr double MiB = 1024.0 * 1024.0;

/// Bytes that are allocated now; 0 where nobody counts them.
inline double bytesInUse()
{
#if defined(__GLIBC__) && (__GLIBC__ > 2 || __GLIBC_MINOR__ >= 33)
  const struct mallinfo2 counts = mallinfo2();
  return static_cast<double>(counts.uordblks + counts.hblkhd);
#else
  return 0.0;
#endif
}

/// Sanitizers bring an allocator of their own, which is not counted.
inline bool allocatorCounts()
{
  const double before = bytesInUse();
  const std::vector<char> block(1 << 20, 'x');
  return bytesInUse() - before >= MiB && block.back() == 'x';
}

} // namespace evolving

#endif
