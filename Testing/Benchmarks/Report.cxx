// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Report.h"

#include "vtkVersion.h"

#include <algorithm>
#include <cstdlib>
#include <iomanip>
#include <iostream>
#include <sstream>
#include <thread>

namespace benchmark
{

void printHeader(const std::string& program, const Arguments& arguments)
{
  double load = 0.0;
  const bool hasLoad = getloadavg(&load, 1) == 1;
  std::cout << "# " << program << ": machine with " << std::thread::hardware_concurrency()
            << " threads";
  if (hasLoad)
  {
    std::cout << " (load " << fixed(load, 2) << " at the start)";
  }
  std::cout << ", up to " << arguments.threads << " used; VTK " << vtkVersion::GetVTKVersion()
            << "; "
            << (arguments.runs == 1 ? "one run"
                                    : "median of " + std::to_string(arguments.runs) +
                     " runs (of fewer when they last)")
            << "\n"
            << std::endl;
}

Table::Table(std::string title, std::vector<std::string> columns)
  : Title(std::move(title))
  , Rows{ std::move(columns) }
{
}

void Table::add(std::vector<std::string> row)
{
  this->Rows.push_back(std::move(row));
}

void Table::note(const std::string& line)
{
  this->Notes.push_back(line);
}

void Table::print() const
{
  std::vector<std::size_t> widths;
  for (const auto& row : this->Rows)
  {
    widths.resize(std::max(widths.size(), row.size()), 0);
    for (std::size_t c = 0; c < row.size(); ++c)
    {
      widths[c] = std::max(widths[c], row[c].size());
    }
  }
  std::cout << "== " << this->Title << "\n";
  for (const auto& row : this->Rows)
  {
    for (std::size_t c = 0; c < row.size(); ++c)
    {
      std::cout << (c == 0 ? std::left : std::right) << std::setw(static_cast<int>(widths[c]))
                << row[c] << (c + 1 < row.size() ? "  " : "");
    }
    std::cout << "\n";
  }
  for (const std::string& line : this->Notes)
  {
    std::cout << "   " << line << "\n";
  }
  std::cout << std::endl; // at once: the next table may take minutes
}

std::string fixed(double value, int digits)
{
  std::ostringstream text;
  text << std::fixed << std::setprecision(digits) << value;
  return text.str();
}

std::string general(double value, int digits)
{
  std::ostringstream text;
  text << std::setprecision(digits) << value;
  return text.str();
}

std::string cube(int size)
{
  return std::to_string(size) + "^3";
}

} // namespace benchmark
