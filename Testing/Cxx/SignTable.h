// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * The table of the help page Inputs.html, row by row: kinds of input, and what each sign method
 * of vtkMeshSDF makes of them.
 */

#ifndef SignTable_h
#define SignTable_h

#include "SampleSurfaces.h"

#include <string>
#include <vector>

/**
 * One cell: what the page says, and the signs at the row's places that show it. `-` is inside, `+`
 * outside; `?` alone means that both signs occur without a reason, `!` that the method is refused.
 */
struct SignCell
{
  const char* Says;
  const char* Signs;
};

struct SignRow
{
  const char* Name; ///< of the test
  const char* Input;
  Sample::Surface (*Make)();
  std::vector<Sample::Point> Places;
  SignCell FloodFill;
  SignCell Pseudonormal;
  SignCell WindingNumber;
  int Automatic; ///< the method that it takes
};

/// All rows, in the page's order.
const std::vector<SignRow>& SignTable();

/// The row as the page has it.
std::string HtmlOf(const SignRow& row);

#endif
