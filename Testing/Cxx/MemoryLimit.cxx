// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "MemoryLimit.h"

#include <cstdlib>

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define MEMORY_LIMIT_SANITIZED
#elif defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
#define MEMORY_LIMIT_SANITIZED
#endif
#endif

#if defined(__GLIBC__) && !defined(MEMORY_LIMIT_SANITIZED)
#define MEMORY_LIMIT_SUPPORTED
#include <fstream>
#include <pthread.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>
#endif

namespace MemoryLimit
{

#ifdef MEMORY_LIMIT_SUPPORTED

namespace
{

constexpr std::size_t StackBytes = 256 << 10;
constexpr int Crashed = 100;

//------------------------------------------------------------------------------
std::size_t AddressSpace()
{
  std::size_t pages = 0;
  std::ifstream("/proc/self/statm") >> pages;
  return pages * static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
}

//------------------------------------------------------------------------------
void SetLimit(rlim_t bytes)
{
  rlimit limit;
  getrlimit(RLIMIT_AS, &limit);
  limit.rlim_cur = bytes < limit.rlim_max ? bytes : limit.rlim_max;
  setrlimit(RLIMIT_AS, &limit);
}

//------------------------------------------------------------------------------
void ShrinkStacks()
{
  pthread_attr_t attributes;
  pthread_attr_init(&attributes);
  pthread_attr_setstacksize(&attributes, StackBytes);
  pthread_setattr_default_np(&attributes);
  pthread_attr_destroy(&attributes);
}

} // namespace

//------------------------------------------------------------------------------
bool IsSupported()
{
  return true;
}

//------------------------------------------------------------------------------
int Run(std::size_t bytes, const std::function<void()>& prepare, const std::function<void()>& run,
  const std::function<int()>& judge)
{
  const pid_t child = fork();
  if (child == 0)
  {
    ShrinkStacks();
    prepare();
    SetLimit(AddressSpace() + bytes);
    run();
    SetLimit(RLIM_INFINITY);
    _exit(judge());
  }
  int status = 0;
  const bool ended = child > 0 && waitpid(child, &status, 0) == child && WIFEXITED(status);
  return ended ? WEXITSTATUS(status) : Crashed + (WIFSIGNALED(status) ? WTERMSIG(status) : 0);
}

#else

//------------------------------------------------------------------------------
bool IsSupported()
{
  return false;
}

//------------------------------------------------------------------------------
int Run(std::size_t, const std::function<void()>&, const std::function<void()>&,
  const std::function<int()>&)
{
  return 0;
}

#endif

} // namespace MemoryLimit
