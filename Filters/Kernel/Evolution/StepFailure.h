// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * Why a step of an evolution could not be made, and how a user is told.
 */

#ifndef EVOLVING_STEP_FAILURE_H
#define EVOLVING_STEP_FAILURE_H

#include <exception>
#include <string>

namespace evolving
{

struct StepFailure
{
  std::string reason;
  bool mayPassInParts = false; ///< shorter steps may do what this one could not
  bool isOfInput = false;      ///< what the step was given cannot be used: an InputError
  bool isExtinction = false;   ///< nothing is wrong: the surface has shrunk to a point
};

/**
 * Steps fail in many ways, none of which may take away what was reached before.
 * @param exception of a step that was undone
 * @throws the exception when it is Cancelled, or of no known kind
 */
StepFailure failureOf(const std::exception_ptr& exception);

/// Why std::bad_alloc ended a step.
const char* outOfMemory();

/// The sentence that a user reads.
std::string endSentence(int step, const std::string& reason);

} // namespace evolving

#endif
