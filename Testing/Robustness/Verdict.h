// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * What became of an input: the classes of the table, and what can be wrong with an output.
 */

#ifndef ROBUSTNESS_VERDICT_H
#define ROBUSTNESS_VERDICT_H

#include <stdexcept>
#include <string>

namespace robustness
{

enum class Outcome
{
  Valid,
  Shortcoming, ///< valid, and what could not be reached is named
  Refused,     ///< one sentence, and outputs without anything
  Wrong,
  Crashed,
  TimedOut,
  OutOfMemory
};

/// Outcomes of a program that keeps its promises.
bool isGood(Outcome outcome);
const char* nameOf(Outcome outcome);
constexpr int OutcomeCount = 7;

/// The first seven have the numbers of CGAL's benchmark for Alpha Wrap; its 7 does not apply.
enum class Fault
{
  None = 0,
  NotTriangles = 1,
  NotManifold = 2,
  Borders = 3,
  DegenerateFaces = 4,
  SelfIntersections = 5,
  NoVolume = 6,
  TooFar = 8,       ///< from the input, without a word
  NotFinite = 9,    ///< NaN or infinite
  NotOriented = 10, ///< or not outwards
  Misstated = 11,   ///< field data, or arrays, that do not belong to the output
  WrongDistance = 12,
  WrongSign = 13,
  NoSentence = 14,   ///< errors that are not one sentence, or no error where there must be one
  LeftOver = 15,     ///< outputs in spite of an error
  RefusedGood = 16,  ///< a good input with sensible parameters
  AcceptedBad = 17,  ///< what must be refused
  ChangedInput = 18, ///< cells, ids or data that must stay
  Nothing = 19       ///< an output without anything and without a word
};

const char* nameOf(Fault fault);

struct Verdict
{
  Outcome outcome = Outcome::Valid;
  Fault fault = Fault::None;
  std::string what; ///< one line, for people
};

/// Thrown by judges at the first thing that is wrong.
class WrongAnswer : public std::runtime_error
{
public:
  WrongAnswer(Fault fault, const std::string& what)
    : std::runtime_error(what)
    , Kind(fault)
  {
  }
  Fault fault() const { return this->Kind; }

private:
  Fault Kind;
};

/// @throws WrongAnswer unless something is so
template <typename... Parts>
void require(bool isSo, Fault fault, const Parts&... parts);

} // namespace robustness

#include "Verdict.hxx"

#endif
