// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

// Looks for inputs that the filters do not survive, or answer wrongly; see --help.

#include "Arguments.h"
#include "Generator.h"
#include "Report.h"
#include "Subject.h"
#include "Trial.h"

#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkXMLPolyDataWriter.h"

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <iostream>
#include <thread>

namespace
{

using namespace robustness;

volatile std::sig_atomic_t isInterrupted = 0;

void interrupt(int)
{
  isInterrupted = 1;
}

const FilterKind& filterOf(std::uint64_t seed, const Arguments& arguments)
{
  return arguments.only.empty() ? drawFilter(seed) : filterKind(arguments.only);
}

void saveInput(std::uint64_t seed, const std::string& file)
{
  vtkNew<vtkXMLPolyDataWriter> writer;
  writer->SetInputDataObject(Subject(makeModel(seed)).data);
  writer->SetFileName(file.c_str());
  writer->SetDataModeToBinary(); // ParaView 5.11 reads its appended data back empty
  writer->Write();
}

int repeat(std::uint64_t seed, const Arguments& arguments)
{
  const FilterKind& kind = filterOf(seed, arguments);
  if (!arguments.save.empty())
  {
    saveInput(seed, arguments.save);
  }
  const Verdict verdict =
    runTrial(seed, kind, [](const std::string& text) { std::cout << text << std::endl; });
  std::cout << nameOf(verdict.outcome);
  if (verdict.fault != Fault::None)
  {
    std::cout << ", " << nameOf(verdict.fault);
  }
  std::cout << ": " << verdict.what << "\n";
  return isGood(verdict.outcome) ? EXIT_SUCCESS : EXIT_FAILURE;
}

/// In the child: one trial on one or two threads, so that both are tried.
void work(std::uint64_t seed, const Arguments& arguments, const Messenger& parent)
{
  setenv("VTK_SMP_MAX_THREADS", seed % 4 == 0 ? "2" : "1", 1);
  const Verdict verdict = runTrial(
    seed, filterOf(seed, arguments), [&](const std::string& text) { parent.describe(text); });
  parent.conclude(verdict);
}

int runAll(const Arguments& arguments)
{
  constexpr std::uint64_t TableEvery = 1000;
  const auto start = std::chrono::steady_clock::now();
  const auto isTimeUp = [&]()
  {
    const auto limit = std::chrono::seconds(arguments.seconds);
    return isInterrupted || (limit.count() > 0 && std::chrono::steady_clock::now() - start > limit);
  };
  const std::size_t jobs = arguments.jobs > 0
    ? static_cast<std::size_t>(arguments.jobs)
    : std::max<std::size_t>(1, std::thread::hardware_concurrency());
  ChildLimits limits;
  constexpr int SlowDown = IsSanitized ? 8 : 1;
  limits.cpuSeconds = SlowDown * arguments.timeLimit;
  limits.wallSeconds = 15 * limits.cpuSeconds;
  ChildPool pool(
    limits, [&](std::uint64_t seed, const Messenger& parent) { work(seed, arguments, parent); });
  Report report(arguments.show);
  std::uint64_t next = arguments.seed;
  const auto hasNext = [&]()
  { return !isTimeUp() && (arguments.count == 0 || next < arguments.seed + arguments.count); };
  while (hasNext() || pool.size() > 0)
  {
    while (hasNext() && pool.size() < jobs)
    {
      pool.start(next++);
    }
    const ChildResult result = pool.wait();
    report.add(filterOf(result.seed, arguments).name, result, std::cout);
    if (report.count() % TableEvery == 0)
    {
      report.print(std::cout);
    }
  }
  report.print(std::cout);
  std::cout << "the next seed is " << next << "\n";
  return report.isGood() ? EXIT_SUCCESS : EXIT_FAILURE;
}

} // namespace

int main(int argc, char** argv)
{
  const Arguments arguments = readArguments(argc, argv);
  if (arguments.repeat)
  {
    return repeat(*arguments.repeat, arguments);
  }
  std::signal(SIGINT, interrupt);
  std::signal(SIGTERM, interrupt);
  return runAll(arguments);
}
