// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * The table of filters and outcomes, and the seeds of what is bad.
 */

#ifndef ROBUSTNESS_REPORT_H
#define ROBUSTNESS_REPORT_H

#include "ChildProcess.h"

#include <array>
#include <iosfwd>
#include <map>
#include <string>

namespace robustness
{

class Report
{
public:
  /// @param shown a good outcome that is printed too; empty for none
  explicit Report(const std::string& shown = "")
    : Shown(shown)
  {
  }
  /// Counts a result; a bad one is printed at once, for runs that are not waited for.
  void add(const std::string& filter, const ChildResult& result, std::ostream& out);
  std::uint64_t count() const { return this->Count; }
  bool isGood() const { return this->Bad.empty(); }
  void print(std::ostream& out) const;

private:
  std::string Shown;
  std::map<std::string, std::array<std::uint64_t, OutcomeCount>> Table;
  std::map<std::string, std::vector<std::uint64_t>> Bad; ///< seeds by kind
  std::uint64_t Count = 0;
};

} // namespace robustness

#endif
