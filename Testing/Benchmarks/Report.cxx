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

Table::Table(std::string title, std::vector<std::string> columns, std::size_t texts)
  : Title(std::move(title))
  , Texts(texts)
  , Rows{ { std::move(columns), {} } }
{
}

void Table::add(std::vector<std::string> row, const std::string& remark)
{
  this->Rows.push_back({ std::move(row), remark });
}

void Table::note(const std::string& line)
{
  this->Notes.push_back(line);
}

std::vector<std::size_t> Table::widths() const
{
  std::vector<std::size_t> widths(this->Rows.front().cells.size(), 0);
  for (const Row& row : this->Rows)
  {
    widths.resize(std::max(widths.size(), row.cells.size()), 0);
    for (std::size_t c = 0; c < row.cells.size(); ++c)
    {
      widths[c] = std::max(widths[c], row.cells[c].size());
    }
  }
  return widths;
}

void Table::print() const
{
  const std::vector<std::size_t> widths = this->widths();
  std::cout << "== " << this->Title << "\n";
  for (const Row& row : this->Rows)
  {
    for (std::size_t c = 0; c < row.cells.size(); ++c)
    {
      std::cout << (c > 0 ? "  " : "") << (c < this->Texts ? std::left : std::right)
                << std::setw(static_cast<int>(widths[c])) << row.cells[c];
    }
    std::cout << (row.remark.empty() ? "" : "  " + row.remark) << "\n";
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
