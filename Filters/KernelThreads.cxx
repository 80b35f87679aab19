// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "KernelThreads.h"

#include "vtkSMPTools.h"

#include <algorithm>
#include <atomic>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <new>
#include <system_error>
#include <thread>
#include <vector>

namespace KernelThreads
{

namespace
{

/// Starting threads costs as much as two or three tasks of the kernel's smallest size.
constexpr std::int64_t FewestParallelTasks = 4;

//------------------------------------------------------------------------------
bool HasBackend(const char* name)
{
  return std::strcmp(vtkSMPTools::GetBackend(), name) == 0;
}

//------------------------------------------------------------------------------
void RunInOrder(std::int64_t count, const std::function<void(std::int64_t)>& task)
{
  for (std::int64_t i = 0; i < count; ++i)
  {
    task(i);
  }
}

//------------------------------------------------------------------------------
/**
 * VTK's STDThread backend in a form that survives a lack of memory: its own ends the process when
 * a thread cannot be started or a task not be queued.
 */
void RunOnStandardThreads(std::int64_t count, const std::function<void(std::int64_t)>& task)
{
  std::atomic<std::int64_t> next{ 0 };
  const auto work = [&]()
  {
    for (std::int64_t i = next++; i < count; i = next++)
    {
      task(i);
    }
  };
  const std::int64_t wanted =
    std::min<std::int64_t>(count, std::max(1, vtkSMPTools::GetEstimatedNumberOfThreads()));
  std::vector<std::thread> others;
  try
  {
    others.reserve(static_cast<std::size_t>(wanted - 1));
    for (std::int64_t i = 1; i < wanted; ++i)
    {
      others.emplace_back(work);
    }
  }
  catch (const std::system_error&)
  {
    // The system gives no more threads; those started so far and this one do the work.
  }
  catch (const std::bad_alloc&)
  {
  }
  work();
  for (std::thread& other : others)
  {
    other.join();
  }
}

} // namespace

//------------------------------------------------------------------------------
void For(std::int64_t count, const std::function<void(std::int64_t)>& task)
{
  if (count < FewestParallelTasks)
  {
    RunInOrder(count, task);
    return;
  }
  if (HasBackend("STDThread") && !vtkSMPTools::IsParallelScope())
  {
    RunOnStandardThreads(count, task);
    return;
  }
  vtkSMPTools::For(0, count, 1,
    [&task](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType i = begin; i < end; ++i)
      {
        task(i);
      }
    });
}

//------------------------------------------------------------------------------
void With(const std::function<void()>& work)
{
  if (!HasBackend("Sequential") || std::getenv("VTK_SMP_BACKEND_IN_USE"))
  {
    work();
    return;
  }
  // A scope that is left by an exception would keep its backend, so none passes through.
  std::exception_ptr failure;
  vtkSMPTools::LocalScope(vtkSMPTools::Config{ 0, "STDThread", false },
    [&]()
    {
      try
      {
        work();
      }
      catch (...)
      {
        failure = std::current_exception();
      }
    });
  if (failure)
  {
    std::rethrow_exception(failure);
  }
}

} // namespace KernelThreads
