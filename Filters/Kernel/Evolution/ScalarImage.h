// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * A sampled scalar field (a distance image, an image to segment) evaluated between its samples.
 */

#ifndef EVOLVING_SCALAR_IMAGE_H
#define EVOLVING_SCALAR_IMAGE_H

#include "Distance/DistanceGrid.h"
#include "Evolution/ImageAxes.h"
#include "Types.h"

#include <vector>

namespace evolving
{

/**
 * Trilinear interpolation of values, and of central differences at the samples. Outside the
 * grid: the value at the closest point of the grid plus the distance to it, with the gradient
 * turned outwards: the field is continued, never clamped to zero speed. Along an axis of one
 * sample the field is constant. The grid may be turned: points, gradients and box() are the
 * world's, the grid's own numbers are along the image's axes.
 */
class ScalarImage
{
public:
  struct Sample
  {
    double value = 0.0;
    Vec3 gradient = Vec3::Zero(); ///< not normalized
  };

  /// @param values one per sample of the grid, x fastest; copied in. @throws InputError
  ScalarImage(const DistanceGrid& grid, std::vector<float> values, const ImageAxes& axes = {});

  Sample at(const Vec3& point) const;
  /// At a point given along the image's axes; so is the gradient.
  Sample atOwnPoint(const Vec3& point) const;
  /// Central differences at a sample, one-sided at the border, zero along an axis of one sample.
  Vec3 gradientAtSample(int i, int j, int k) const;
  const DistanceGrid& grid() const { return this->Grid; }
  const ImageAxes& axes() const { return this->Axes; }
  const std::vector<float>& values() const { return this->Values; }
  /// From the first to the last sample; the world's box around that when the image is turned.
  Box box() const;
  /**
   * The box of the samples with a value of at most zero: empty when there is none. Along the
   * image's own axes, so that its size does not depend on how the image is turned.
   */
  Box insideBox() const;

private:
  DistanceGrid Grid;
  ImageAxes Axes;
  std::vector<float> Values;
};

} // namespace evolving

#endif
