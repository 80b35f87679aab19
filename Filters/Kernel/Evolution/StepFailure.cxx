// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Evolution/StepFailure.h"

#include "Errors.h"
#include "Evolution/SurfaceGuard.h"

#include <new>

namespace evolving
{

StepFailure failureOf(const std::exception_ptr& exception)
{
  try
  {
    std::rethrow_exception(exception);
  }
  catch (const Cancelled&)
  {
    throw;
  }
  catch (const SurfaceVanished& end)
  {
    return { end.what(), true, false, true };
  }
  catch (const SolverError& error)
  {
    return { error.what(), true, false };
  }
  catch (const InputError& error)
  {
    return { error.what(), false, true };
  }
  catch (const std::bad_alloc&)
  {
    return { outOfMemory(), false, false };
  }
  catch (const std::exception& error)
  {
    return { error.what(), false, false };
  }
}

const char* outOfMemory()
{
  return "the computation ran out of memory, expected room for the next step; use fewer or larger "
         "elements.";
}

std::string endSentence(int step, const std::string& reason)
{
  return "The evolution ended before step " + std::to_string(step) + ": " + reason;
}

} // namespace evolving
