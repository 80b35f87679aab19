// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Report.h"

#include <iomanip>
#include <ostream>

namespace robustness
{

namespace
{

std::string kindOf(const std::string& filter, const Verdict& verdict)
{
  std::string kind = filter + " " + nameOf(verdict.outcome);
  if (verdict.outcome == Outcome::Wrong)
  {
    kind += std::string(", ") + nameOf(verdict.fault) + " (" +
      std::to_string(static_cast<int>(verdict.fault)) + ")";
  }
  return kind;
}

} // namespace

void Report::add(const std::string& filter, const ChildResult& result, std::ostream& out)
{
  ++this->Count;
  ++this->Table[filter][static_cast<std::size_t>(result.verdict.outcome)];
  const bool isBad = !robustness::isGood(result.verdict.outcome);
  const std::string kind = kindOf(filter, result.verdict);
  if (isBad)
  {
    this->Bad[kind].push_back(result.seed);
  }
  if (isBad || this->Shown == nameOf(result.verdict.outcome))
  {
    out << "seed " << result.seed << ": " << kind << ": " << result.verdict.what << "\n  "
        << result.description << std::endl;
  }
}

void Report::print(std::ostream& out) const
{
  constexpr int NameWidth = 26;
  constexpr int Width = 15;
  out << "\n" << std::left << std::setw(NameWidth) << "filter" << std::right;
  for (int o = 0; o < OutcomeCount; ++o)
  {
    out << std::setw(Width) << nameOf(static_cast<Outcome>(o));
  }
  for (const auto& [filter, counts] : this->Table)
  {
    out << "\n" << std::left << std::setw(NameWidth) << filter << std::right;
    for (const std::uint64_t count : counts)
    {
      out << std::setw(Width) << count;
    }
  }
  out << "\n" << this->Count << " inputs\n";
  for (const auto& [kind, seeds] : this->Bad)
  {
    out << kind << ": seeds";
    for (const std::uint64_t seed : seeds)
    {
      out << " " << seed;
    }
    out << "\n";
  }
  out.flush();
}

} // namespace robustness
