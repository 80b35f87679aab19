// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Draws.h"

#include "vtkAlgorithm.h"
#include "vtkIndent.h"
#include "vtkSmartPointer.h"

#include <cmath>
#include <limits>
#include <sstream>
#include <vector>

namespace robustness
{

namespace
{

constexpr double OddTrials = 0.125;
constexpr double OddNumbers = 0.3;

const std::vector<double>& oddNumbers()
{
  using Double = std::numeric_limits<double>;
  static const std::vector<double> numbers{ Double::quiet_NaN(), Double::infinity(),
    -Double::infinity(), Double::max(), Double::lowest(), Double::min(), Double::denorm_min(), 0.0,
    -1.0, 1e300, 1e-300, 1e100, 1e-100, 1e30, 1e-30, 1e9, 1e-9 };
  return numbers;
}

std::vector<std::string> linesOf(vtkAlgorithm* filter)
{
  std::ostringstream text;
  text.precision(17);
  filter->PrintSelf(text, vtkIndent());
  std::istringstream stream(text.str());
  std::vector<std::string> lines;
  for (std::string line; std::getline(stream, line);)
  {
    lines.push_back(line);
  }
  return lines;
}

/// Lines about objects and times, which differ from one filter to the next.
bool isOfSuperclass(const std::string& line)
{
  return line.find("0x") != std::string::npos || line.find("Time: ") == 0 ||
    line.find("Modified Time") != std::string::npos || line.find("Count: ") != std::string::npos ||
    line.find("NumberOfSolves") == 0;
}

} // namespace

Draws::Draws(Random& random)
  : Source(random)
  , Odd(random.chance(OddTrials))
{
}

double Draws::number(const std::string& name, double sensible)
{
  if (!this->Odd || !this->Source.chance(OddNumbers))
  {
    return sensible;
  }
  this->Sensible = false;
  const double odd = this->Source.pick(oddNumbers());
  if (std::isnan(odd))
  {
    this->NaNs.insert(name);
  }
  return odd;
}

double Draws::rate(const std::string& name, double probability, double lowest, double highest)
{
  const bool isOn = this->Source.chance(probability);
  const double value = this->Source.logarithmic(lowest, highest);
  return this->number(name, isOn ? value : 0.0);
}

std::string parametersOf(vtkAlgorithm* filter)
{
  const auto other = vtkSmartPointer<vtkAlgorithm>::Take(filter->NewInstance());
  const std::vector<std::string> defaults = linesOf(other);
  std::string text;
  for (const std::string& line : linesOf(filter))
  {
    const std::size_t first = line.find_first_not_of(' ');
    const std::string own = first == std::string::npos ? "" : line.substr(first);
    if (std::find(defaults.begin(), defaults.end(), line) == defaults.end() && !isOfSuperclass(own))
    {
      text += (text.empty() ? "" : ", ") + own;
    }
  }
  return text.empty() ? "defaults" : text;
}

} // namespace robustness
