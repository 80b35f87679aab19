// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "MemoryCount.h"

#include <atomic>
#include <cstdlib>
#include <new>

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define MEMORY_COUNT_SANITIZED
#elif defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
#define MEMORY_COUNT_SANITIZED
#endif
#endif

#if defined(__GLIBC__) && !defined(MEMORY_COUNT_SANITIZED)
#define MEMORY_COUNT_SUPPORTED
#include <malloc.h>
#endif

namespace evolving
{

namespace
{

std::atomic<std::size_t> bytesHeld{ 0 };
std::atomic<std::size_t> mostBytesHeld{ 0 };
std::atomic<std::size_t> bytesHandedOut{ 0 };

} // namespace

bool MemoryCount::isSupported()
{
#ifdef MEMORY_COUNT_SUPPORTED
  return true;
#else
  return false;
#endif
}

MemoryCount::MemoryCount()
  : HeldAtStart(bytesHeld)
  , TotalAtStart(bytesHandedOut)
{
  mostBytesHeld = this->HeldAtStart;
}

std::size_t MemoryCount::peak() const
{
  return mostBytesHeld - this->HeldAtStart;
}

std::size_t MemoryCount::held() const
{
  return bytesHeld - this->HeldAtStart;
}

std::size_t MemoryCount::total() const
{
  return bytesHandedOut - this->TotalAtStart;
}

} // namespace evolving

#ifdef MEMORY_COUNT_SUPPORTED

// The array and nothrow forms call these.

void* operator new(std::size_t size)
{
  void* pointer = std::malloc(size);
  if (!pointer)
  {
    throw std::bad_alloc();
  }
  using namespace evolving;
  const std::size_t bytes = malloc_usable_size(pointer);
  bytesHandedOut += bytes;
  const std::size_t now = bytesHeld += bytes;
  std::size_t most = mostBytesHeld;
  while (most < now && !mostBytesHeld.compare_exchange_weak(most, now))
  {
  }
  return pointer;
}

void operator delete(void* pointer) noexcept
{
  if (pointer)
  {
    evolving::bytesHeld -= malloc_usable_size(pointer);
    std::free(pointer);
  }
}

void operator delete(void* pointer, std::size_t) noexcept
{
  operator delete(pointer);
}

#endif
