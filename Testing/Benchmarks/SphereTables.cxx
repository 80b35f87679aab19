// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * Tables 6.1 to 6.3 of the thesis, the shrinking sphere, beside the kernel's figures; the same of
 * spheres made of quads; and tables 6.2 and 6.3 as they were computed in 2020.
 */

#include "Arguments.h"
#include "Report.h"
#include "ShrinkingSphere.h"

#include "StartSurface/PrimitiveSurfaces.h"

#include <algorithm>
#include <cmath>

using namespace benchmark;

namespace
{

/// Of the kernel's solver: the errors are small differences of radii.
constexpr double Tolerance = 1e-10;

/// A row's printed figures.
struct Printed
{
  double error;
  double seconds;
};

/// A table of the thesis, from 42 vertices to 2562, and what a right scheme computes instead.
struct ThesisTable
{
  const char* title;
  double omega;
  Printed printed[4];
  double expected[4]; ///< by an implementation independent of the kernel
  double allowed;     ///< relative deviation from these
};

const ThesisTable Tables[] = {
  { "Table 6.1: no redistribution", 0.0,
    { { 0.00306693, 0.015400 }, { 0.000867587, 0.109411 }, { 0.000210629, 2.879498 },
      { 0.0000511243, 66.822671 } },
    { 0.00306683, 0.000867625, 0.000210625, 0.0000511173 }, 1e-3 },
  { "Table 6.2: volume-based, omega = 1", 1.0,
    { { 0.00284543, 0.054055 }, { 0.000859596, 0.147276 }, { 0.000209863, 3.467786 },
      { 0.0000507569, 113.075791 } },
    { 0.00306683, 0.000872717, 0.000211283, 0.0000511856 }, 5e-3 },
  { "Table 6.3: volume-based, omega = 100", 100.0,
    { { 0.00491455, 0.062172 }, { 0.00106504, 0.182325 }, { 0.000238864, 3.122358 },
      { 0.0000571001, 146.78901 } },
    { 0.00306683, 0.00100435, 0.000226696, 0.0000536707 }, 5e-3 },
};

/// A table of the thesis computed as in 2020.
struct TableOf2020
{
  const char* title;
  const ThesisTable& thesis;
  TangentialForm form;
  double omega;
  const char* remark;
};

const TableOf2020 TablesOf2020[] = {
  { "Table 6.2 as in 2020: v_T neither divided by mu nor projected nor less psi h", Tables[1],
    FormOfTable62, 1.0, "" },
  { "Table 6.3 as in 2020: the same, co-volumes driven apart, omega = 10", Tables[2], FormOfTable63,
    10.0,
    "2562 vertices: what else that run had is not known; it is neither the tolerance of the solver"
    " nor a limit of its iterations" },
};
constexpr double AllowedOf2020 = 5e-4;

int vertexCount(int row)
{
  return 10 * (4 << (2 * row)) + 2;
}

bool isAsked(const Arguments& arguments, int row)
{
  return std::find(arguments.sizes.begin(), arguments.sizes.end(), vertexCount(row)) !=
    arguments.sizes.end();
}

std::string percent(double value, double reference)
{
  return fixed(100.0 * (value / reference - 1.0), 4) + " %";
}

std::string verdict(double value, double reference, double allowed)
{
  return std::abs(value / reference - 1.0) <= allowed ? "pass" : "FAIL";
}

/// Experimental order of convergence from row to row; empty for the first.
class Order
{
public:
  std::string next(double error)
  {
    const double last = this->Last;
    this->Last = error;
    return last > 0.0 ? fixed(std::log2(last / error), 3) : "";
  }

private:
  double Last = 0.0;
};

std::vector<std::string> scheduleCells(std::size_t vertices, const SphereSchedule& schedule)
{
  return { std::to_string(vertices), general(schedule.tau, 6), std::to_string(schedule.steps) };
}

void append(std::vector<std::string>& row, const std::vector<std::string>& more)
{
  row.insert(row.end(), more.begin(), more.end());
}

void printTable(const ThesisTable& thesis, const Arguments& arguments)
{
  Table table(thesis.title,
    { "vertices", "tau", "steps", "thesis: error", "EOC", "CPU s", "ours: error", "EOC", "CPU s",
      "expected", "deviation", "" });
  Order printedOrder;
  Order order;
  for (int r = 0; r < 4; ++r)
  {
    if (!isAsked(arguments, r))
    {
      continue;
    }
    const evolving::SurfaceMesh start = evolving::icosphere(r + 1);
    const SphereSchedule schedule = sphereSchedule(r);
    const SphereRun run = shrinkByKernel(start, schedule, thesis.omega, Tolerance, 1);
    const Printed& printed = thesis.printed[r];
    const double expected = thesis.expected[r];
    std::vector<std::string> row = scheduleCells(start.points.size(), schedule);
    append(row,
      { general(printed.error, 6), printedOrder.next(printed.error), fixed(printed.seconds, 3),
        general(run.error, 6), order.next(run.error), fixed(run.time.cpu, 3), general(expected, 6),
        percent(run.error, expected), verdict(run.error, expected, thesis.allowed) });
    table.add(row);
  }
  table.note("pass: within " + general(100.0 * thesis.allowed) + " % of the expected error" +
    (thesis.omega > 0.0 ? "; the thesis's own is of another velocity, see below" : ""));
  table.print();
}

/// Where the thesis prints no figures.
void printQuads(const Arguments& arguments)
{
  const double expected[] = { 0.0027455, 0.00067973, 0.00016542 };
  Table table("The same schedule on cube-spheres of quads, no redistribution",
    { "vertices", "tau", "steps", "error", "EOC", "CPU s", "expected", "deviation", "" });
  Order order;
  for (int r = 0; r < 3; ++r)
  {
    if (!isAsked(arguments, r))
    {
      continue;
    }
    const evolving::SurfaceMesh start = evolving::cubeSphere(3 << r);
    const SphereSchedule schedule = sphereSchedule(r);
    const SphereRun run = shrinkByKernel(start, schedule, 0.0, Tolerance, 1);
    std::vector<std::string> row = scheduleCells(start.points.size(), schedule);
    append(row,
      { general(run.error, 6), order.next(run.error), fixed(run.time.cpu, 3),
        general(expected[r], 6), percent(run.error, expected[r]),
        verdict(run.error, expected[r], 5e-3) });
    table.add(row);
  }
  table.note("pass: within 0.5 % of the expected error");
  table.print();
}

void printAsIn2020(const TableOf2020& mode, const Arguments& arguments)
{
  Table table(mode.title,
    { "vertices", "tau", "steps", "thesis: error", "EOC", "CPU s", "computed", "EOC", "CPU s",
      "deviation", "" });
  Order printedOrder;
  Order order;
  for (int r = 0; r < 4; ++r)
  {
    if (!isAsked(arguments, r))
    {
      continue;
    }
    const evolving::SurfaceMesh start = evolving::icosphere(r + 1);
    const SphereSchedule schedule = sphereSchedule(r);
    const SphereRun run = shrinkByThesis(start, schedule, mode.form, mode.omega, {});
    const Printed& printed = mode.thesis.printed[r];
    std::vector<std::string> row = scheduleCells(start.points.size(), schedule);
    append(row,
      { general(printed.error, 6), printedOrder.next(printed.error), fixed(printed.seconds, 3),
        general(run.error, 6), order.next(run.error), fixed(run.time.cpu, 3),
        percent(run.error, printed.error), verdict(run.error, printed.error, AllowedOf2020) });
    table.add(row);
  }
  table.note("pass: within " + general(100.0 * AllowedOf2020) + " % of the error in the thesis");
  if (*mode.remark != 0 && isAsked(arguments, 3))
  {
    table.note(mode.remark);
  }
  table.print();
}

} // namespace

int main(int argc, char** argv)
{
  Arguments defaults;
  defaults.sizes = { 42, 162, 642, 2562 };
  defaults.threads = 1;
  defaults.runs = 1;
  const Arguments arguments = readArguments(argc, argv, defaults,
    "The shrinking sphere of the thesis's tables 6.1 to 6.3 on icospheres of --sizes vertices (42,"
    " 162, 642, 2562), and on cube-spheres.");
  printHeader("SphereTables", arguments);
  for (const ThesisTable& table : Tables)
  {
    printTable(table, arguments);
  }
  printQuads(arguments);
  for (const TableOf2020& table : TablesOf2020)
  {
    printAsIn2020(table, arguments);
  }
  return 0;
}
