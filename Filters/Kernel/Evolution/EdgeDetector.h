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

#include <memory>

namespace evolving
{

/// What was made of an image I.
struct EdgeDetector
{
  std::shared_ptr<const ScalarImage> e;
  double sharpness = 0.0; ///< K, length^2 / intensity^2
  double noise = 0.0;     ///< n, intensity / length, see automaticEdgeDetector()
  double blur = 0.0;      ///< variance by which its edges are blurred, an area; see BlurredEdges.h
};

/**
 * e = 1 / (1 + K |grad I|^2) at the samples of the image I: 1 where I is constant, near 0 at
 * edges.
 * @param sharpness K in length^2 / intensity^2
 * @throws Cancelled
 */
ScalarImage edgeDetector(
  const ScalarImage& image, double sharpness, const Execution& execution = {});

struct EdgeSample : ScalarImage::Sample
{
  bool isOutside = false; ///< of the image
};

/**
 * e and its gradient at a point. Outside the image there are no edges to see: e of the closest
 * point of the image, and no gradient.
 */
EdgeSample sampleEdgeDetector(const ScalarImage& e, const Vec3& point);

} // namespace evolving

#endif
