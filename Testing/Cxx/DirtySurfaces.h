// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * Inputs as users' files have them, and what each filter makes of them.
 */

#ifndef DirtySurfaces_h
#define DirtySurfaces_h

#include "SampleSurfaces.h"

#include <vector>

/// What a filter does with an input.
enum class Answer
{
  Result, ///< an output with points, no error
  Empty,  ///< an empty output, no error
  Error,  ///< one sentence, initialised outputs
};

/// An input, and the answers of the filters to it.
struct DirtySurface
{
  const char* Name;
  Sample::Surface (*Make)();
  Answer Distance;
  Answer Evolution;
  Answer Redistribution;
  Answer Wrap;
  Answer Hierarchy;
};

/// All of them.
const std::vector<DirtySurface>& DirtySurfaces();

#endif
