// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * What the kernel says when it refuses an input.
 */

#ifndef EVOLVING_TESTING_REFUSAL_H
#define EVOLVING_TESTING_REFUSAL_H

#include "Errors.h"

#include <string>

namespace evolving::checks
{

/// The sentence of the InputError that a call ends with; empty when it ends without one.
template <typename Call>
std::string refusalOf(const Call& call)
{
  try
  {
    call();
  }
  catch (const InputError& error)
  {
    return error.what();
  }
  return {};
}

} // namespace evolving::checks

#endif
