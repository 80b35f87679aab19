// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * The triangles of any surface, wherever they are kept.
 */

#ifndef EVOLVING_TRIANGLE_VIEW_H
#define EVOLVING_TRIANGLE_VIEW_H

#include "Mesh/SurfaceMesh.h"
#include "Types.h"

#include <array>
#include <vector>

namespace evolving
{

/// The vertex numbers of a triangle.
using TriangleVertices = std::array<Index, 3>;

/// Looks at points, and at three numbers of them for each triangle; both must outlive it.
class TriangleView
{
public:
  TriangleView(const std::vector<Vec3>& points, const std::vector<Index>& corners)
    : Points(&points)
    , Corners(&corners)
  {
  }

  const std::vector<Vec3>& points() const { return *this->Points; }
  Index count() const { return static_cast<Index>(this->Corners->size() / 3); }
  TriangleVertices vertices(Index triangle) const
  {
    const auto first = at(3 * triangle);
    return { (*this->Corners)[first], (*this->Corners)[first + 1], (*this->Corners)[first + 2] };
  }

private:
  const std::vector<Vec3>* Points;
  const std::vector<Index>* Corners;
};

/// @throws InputError when a face is not a triangle or the mesh does not pass validate()
TriangleView triangleView(const SurfaceMesh& mesh);

} // namespace evolving

#endif
