// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * Exceptions by cause. Every message is one sentence for the user: what was wrong, what was
 * found, what was expected, what to do.
 */

#ifndef EVOLVING_ERRORS_H
#define EVOLVING_ERRORS_H

#include <stdexcept>

namespace evolving
{

/// The mesh, the image or an option cannot be used.
class InputError : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

/// A linear system was not solved, or a step could not be made acceptable.
class SolverError : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

/// The host asked to stop; nothing is wrong.
class Cancelled : public std::runtime_error
{
public:
  Cancelled()
    : std::runtime_error("The computation was cancelled.")
  {
  }
};

} // namespace evolving

#endif
