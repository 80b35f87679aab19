// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * What a benchmark prints: where it ran, and tables with aligned columns.
 */

#ifndef BENCHMARK_REPORT_H
#define BENCHMARK_REPORT_H

#include "Arguments.h"

#include <string>
#include <vector>

namespace benchmark
{

/// The program, the machine's threads and load, and the arguments that change figures.
void printHeader(const std::string& program, const Arguments& arguments);

/// Columns as wide as they need to be; texts to the left, the figures after them to the right.
class Table
{
public:
  /// @param texts how many of the columns are no figures
  Table(std::string title, std::vector<std::string> columns, std::size_t texts = 1);

  /**
   * A row may be shorter than the header; the rest is left empty.
   * @param remark stands in place of the rest and widens no column
   */
  void add(std::vector<std::string> row, const std::string& remark = {});
  /// A line below the table.
  void note(const std::string& line);
  void print() const;

private:
  struct Row
  {
    std::vector<std::string> cells;
    std::string remark;
  };

  std::vector<std::size_t> widths() const;

  std::string Title;
  std::size_t Texts;
  std::vector<Row> Rows; ///< the first is the header
  std::vector<std::string> Notes;
};

///@{
/// A number with so many digits after the point, or with so many significant ones.
std::string fixed(double value, int digits);
std::string general(double value, int digits = 3);
///@}

/// A cube grid's size, as in 128^3.
std::string cube(int size);

} // namespace benchmark

#endif
