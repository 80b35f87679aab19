// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * The length that a method needs to make as many vertices as another one.
 */

#ifndef BENCHMARK_LENGTH_SEARCH_H
#define BENCHMARK_LENGTH_SEARCH_H

#include <functional>

namespace benchmark
{

/**
 * Tries lengths until the number of vertices is right within 2 %, or ten times. Returns the best
 * one that was tried.
 * @param vertices to aim at
 * @param guess the first length
 * @param vertexCount runs the method with a length
 */
double lengthForVertices(
  double vertices, double guess, const std::function<double(double)>& vertexCount);

} // namespace benchmark

#endif
