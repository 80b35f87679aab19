// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * How far lengths of edges may be from their sizes, and sizes from the one that all could have.
 */

#ifndef EVOLVING_EDGE_LENGTH_LIMITS_H
#define EVOLVING_EDGE_LENGTH_LIMITS_H

namespace evolving
{

///@{
/// Edges between these ratios to their size stay: half of a longer one is nearer to the size than
/// the whole, and so are the edges that become of a shorter one's neighbours (Botsch, Kobbelt, *A
/// Remeshing Approach to Multiresolution Modeling*, 2004).
constexpr double LongestPerSize = 4.0 / 3.0;
constexpr double ShortestPerSize = 4.0 / 5.0;
///@}

///@{
/// Between steps of a flow edges are good that are a little longer or shorter than that, a
/// twentieth, so that elements that are new do not have to be renewed after the next step.
constexpr double LongestGoodPerSize = 1.4;
constexpr double ShortestGoodPerSize = 0.75;
///@}

///@{
/// Sizes that follow the curvature, relative to the one that as many elements would have without.
/// Measured by Testing/Benchmarks/WrapConstants --adapt: smaller ones cost angles and time (columns
/// p1, CPU s), a largest one of 1.25 costs distance (hausdorff), and what others change scatters
/// from model to model.
constexpr double SmallestAdaptiveSize = 0.4;
constexpr double LargestAdaptiveSize = 1.5;
///@}

} // namespace evolving

#endif
