// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * The edge detector of an image, the function that stops a segmentation at edges (section 3.2).
 */

#ifndef EVOLVING_EDGE_DETECTOR_H
#define EVOLVING_EDGE_DETECTOR_H

#include "Evolution/ScalarImage.h"
#include "Execution.h"

namespace evolving
{

/**
 * e = 1 / (1 + K |grad I|^2) at the samples of the image I: 1 where I is constant, near 0 at
 * edges.
 * @param sharpness K in length^2 / intensity^2
 * @throws Cancelled
 */
ScalarImage edgeDetector(
  const ScalarImage& image, double sharpness, const Execution& execution = {});

/**
 * e and its gradient at a point. Outside the image there are no edges to see: e of the closest
 * point of the image, and no gradient.
 */
ScalarImage::Sample sampleEdgeDetector(const ScalarImage& e, const Vec3& point);

} // namespace evolving

#endif
