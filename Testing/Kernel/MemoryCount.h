// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * What operator new has handed out in this process.
 */

#ifndef EVOLVING_MEMORY_COUNT_H
#define EVOLVING_MEMORY_COUNT_H

#include <cstddef>

namespace evolving
{

/// Counts from its making on, one at a time.
class MemoryCount
{
public:
  /// Not under sanitizers, which have an operator new of their own.
  static bool isSupported();

  MemoryCount();

  /// The most bytes held at one time, beyond those held at the beginning.
  std::size_t peak() const;
  /// The bytes held now, beyond those.
  std::size_t held() const;
  /// The bytes of all allocations together.
  std::size_t total() const;

private:
  std::size_t HeldAtStart;
  std::size_t TotalAtStart;
};

} // namespace evolving

#endif
