// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * What children tell their parent, in lines through a pipe.
 */

#ifndef ROBUSTNESS_CHILD_MESSAGES_H
#define ROBUSTNESS_CHILD_MESSAGES_H

#include "Verdict.h"

#include <cstdint>
#include <string>

namespace robustness
{

/// Hands what the work is, and its verdict, from the child to the parent.
class Messenger
{
public:
  explicit Messenger(int pipe)
    : Pipe(pipe)
  {
  }
  void describe(const std::string& text) const;
  void conclude(const Verdict& verdict) const;

private:
  void send(std::string line) const;
  int Pipe;
};

struct ChildResult
{
  std::uint64_t seed = 0;
  std::string description;
  Verdict verdict;
};

/// Reads what a child has told; false without a verdict.
bool readTold(const std::string& told, ChildResult& result);

} // namespace robustness

#endif
