// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include <sstream>

namespace robustness
{

template <typename... Parts>
void require(bool isSo, Fault fault, const Parts&... parts)
{
  if (!isSo)
  {
    std::ostringstream what;
    what.precision(12);
    (what << ... << parts);
    throw WrongAnswer(fault, what.str());
  }
}

} // namespace robustness
