// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * Random vectors that are the same with every compiler: the arguments of a call are evaluated in no
 * order, so Vec3(draw(), draw(), draw()) is another vector with another compiler.
 */

#ifndef EVOLVING_DRAWS_H
#define EVOLVING_DRAWS_H

#include "Types.h"

namespace evolving::shapes
{

/// The last coordinate is drawn first.
template <class Distribution, class Generator>
Vec3 drawnVector(Distribution& distribution, Generator& generator)
{
  Vec3 vector;
  for (Eigen::Index i = 2; i >= 0; --i)
  {
    vector[i] = distribution(generator);
  }
  return vector;
}

/// The same in the plane z = 0.
template <class Distribution, class Generator>
Vec3 drawnInPlane(Distribution& distribution, Generator& generator)
{
  Vec3 vector = Vec3::Zero();
  vector[1] = distribution(generator);
  vector[0] = distribution(generator);
  return vector;
}

} // namespace evolving::shapes

#endif
