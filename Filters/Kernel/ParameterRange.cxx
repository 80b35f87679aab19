// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ParameterRange.h"

#include "Errors.h"

#include <sstream>

namespace evolving
{

void checkRange(const char* name, double value, double smallest, double largest)
{
  if (!(value >= smallest && value <= largest))
  {
    std::ostringstream message;
    message << name << " is " << value << ", expected a number "
            << (smallest == AboveZero ? "above 0" : "of at least ");
    if (smallest != AboveZero)
    {
      message << smallest;
    }
    if (largest != AnyNumber)
    {
      message << " and at most " << largest;
    }
    message << ".";
    throw InputError(message.str());
  }
}

} // namespace evolving
