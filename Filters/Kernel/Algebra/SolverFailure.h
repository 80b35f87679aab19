// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * What an iterative solver says when it does not reach its tolerance.
 */

#ifndef EVOLVING_SOLVER_FAILURE_H
#define EVOLVING_SOLVER_FAILURE_H

#include "Errors.h"

#include <sstream>
#include <string>

namespace evolving
{

/// @param system its kind, "linear" say @param residual relative, as the tolerance
/// @throws SolverError
[[noreturn]] inline void throwNotSolved(
  const std::string& system, int iterations, double residual, double tolerance)
{
  std::ostringstream message;
  message << "The " << system << " system has a relative residual of " << residual << " after "
          << iterations << " iterations, expected " << tolerance
          << "; a smaller time step, a larger solver tolerance or a mesh without degenerate faces "
             "helps.";
  throw SolverError(message.str());
}

} // namespace evolving

#endif
