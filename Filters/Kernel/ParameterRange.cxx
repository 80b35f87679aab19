// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ParameterRange.h"

#include "Errors.h"

#include <sstream>
#include <string>

namespace evolving
{

namespace
{

std::string rangeInWords(double smallest, double largest)
{
  std::ostringstream words;
  if (smallest == AboveZero)
  {
    words << "a number above 0";
  }
  else
  {
    words << "a number of at least " << smallest;
  }
  if (largest != AnyNumber)
  {
    words << " and at most " << largest;
  }
  return words.str();
}

} // namespace

void checkRange(const char* name, double value, double smallest, double largest, const char* advice)
{
  if (!(value >= smallest && value <= largest))
  {
    std::ostringstream message;
    message << name << " is " << value << ", expected " << rangeInWords(smallest, largest) << "; "
            << advice << ".";
    throw InputError(message.str());
  }
}

void checkRangeOrZero(
  const char* name, double value, double smallest, double largest, const char* advice)
{
  if (value != 0.0 && !(value >= smallest && value <= largest))
  {
    std::ostringstream message;
    message << name << " is " << value << ", expected 0 or " << rangeInWords(smallest, largest)
            << "; " << advice << ".";
    throw InputError(message.str());
  }
}

} // namespace evolving
