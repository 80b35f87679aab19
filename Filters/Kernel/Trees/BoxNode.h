// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * A node of the binary tree of boxes over triangles.
 */

#ifndef EVOLVING_BOX_NODE_H
#define EVOLVING_BOX_NODE_H

#include "Types.h"

namespace evolving
{

struct BoxNode
{
  /// A root alone is one level.
  static constexpr int MostLevels = 21;

  Box box;
  Index left = NoIndex; ///< NoIndex for leaves
  Index right = NoIndex;
  Index firstTriangle = 0; ///< of a leaf, in the list of all leaves' triangles
  Index triangleCount = 0;

  bool isLeaf() const { return this->left == NoIndex; }
};

} // namespace evolving

#endif
