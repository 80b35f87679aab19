// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "PeakMemory.h"

#include <fstream>
#include <sstream>
#include <string>

namespace benchmark
{

namespace
{

/// A line such as "VmHWM:   1234 kB" of /proc/self/status in bytes; 0 when there is none.
double status(const std::string& key)
{
  std::ifstream file("/proc/self/status");
  for (std::string line; std::getline(file, line);)
  {
    if (line.rfind(key + ":", 0) == 0)
    {
      double kilobytes = 0.0;
      std::istringstream(line.substr(key.size() + 1)) >> kilobytes;
      return 1024.0 * kilobytes;
    }
  }
  return 0.0;
}

} // namespace

bool PeakMemory::start()
{
  std::ofstream refs("/proc/self/clear_refs");
  refs << 5; // resets VmHWM
  refs.close();
  this->AtStart = status("VmRSS");
  return !refs.fail() && this->AtStart > 0.0;
}

double PeakMemory::bytes() const
{
  return status("VmHWM") - this->AtStart;
}

} // namespace benchmark
