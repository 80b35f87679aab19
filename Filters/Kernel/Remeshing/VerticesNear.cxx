// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Remeshing/VerticesNear.h"

#include "Trees/AABBTree.h"

namespace evolving
{

std::vector<char> verticesNear(
  const EditableSurface& surface, const SurfaceMesh& faces, double sizes)
{
  const AABBTree tree(faces);
  std::vector<char> isNear(at(surface.vertexSlots()), 0);
  for (Index v = 0; v < surface.vertexSlots(); ++v)
  {
    if (surface.hasVertex(v))
    {
      const double reach = sizes * surface.size(v);
      isNear[at(v)] = tree.closest(surface.point(v), reach * reach).triangle != NoIndex;
    }
  }
  return isNear;
}

} // namespace evolving
