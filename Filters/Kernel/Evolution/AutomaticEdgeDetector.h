// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * An edge detector for who knows nothing of the image's intensities.
 */

#ifndef EVOLVING_AUTOMATIC_EDGE_DETECTOR_H
#define EVOLVING_AUTOMATIC_EDGE_DETECTOR_H

#include "Evolution/EdgeDetector.h"

namespace evolving
{

/**
 * e = 1 / (1 + K max(0, |grad (G * I)|^2 - n^2)), with numbers from the image:
 *
 * - G is a Gaussian of 0.8 samples, for noise; with the differences that follow it blurs by about
 *   one sample, which moves the edge of a ball of radius r inwards by 1 / r samples:
 * onBlurredEdges() makes that good.
 * - n, the largest gradient that noise may have: e is flat where there is no edge, so that noise
 *   neither holds a surface nor drives it. 10 % of the gradients of Gaussian noise are below 0.76
 *   of a component's standard deviation, 1 in 100,000 is above 5 of them; n is these 5 deviations
 *   when the least tenth of the image's gradients, where it is not constant, is noise: edges are
 *   elsewhere.
 * - K, with which e is 0.1 at a typical edge: the median of the gradients that are largest across
 *   an edge and above n. An edge of a third of that still halves e.
 *
 * No unit and no scale of intensities or lengths changes e.
 * @throws InputError when no edge stands out from the noise, or there are none. @throws Cancelled
 */
EdgeDetector automaticEdgeDetector(const ScalarImage& image, const Execution& execution = {});

} // namespace evolving

#endif
