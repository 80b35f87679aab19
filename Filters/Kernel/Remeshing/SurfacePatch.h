// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * A place of a surface as it was, to take local changes back.
 */

#ifndef EVOLVING_SURFACE_PATCH_H
#define EVOLVING_SURFACE_PATCH_H

#include "Remeshing/EditableSurface.h"
#include "Types.h"

#include <array>
#include <vector>

namespace evolving
{

/**
 * Some vertices and all faces at them. Takes time and memory of the patch, not of the surface.
 */
class SurfacePatch
{
public:
  SurfacePatch(const EditableSurface& surface, const std::vector<Index>& vertices);

  /**
   * Undoes all changes since: of the patch's vertices, of the connectivity within its faces (edges
   * with both ends in the patch), and elements that were added. Elements outside must not have
   * changed, nor must compact() have been called.
   */
  void restore(EditableSurface& surface) const;

private:
  struct VertexState
  {
    Index number;
    Vec3 point;
    Index outgoing;
    double size;
    Index guess;
    unsigned char holds;
  };
  struct FaceState
  {
    Index number;
    std::array<Index, 3> vertices;
    std::array<Index, 3> opposites;
    std::array<Index, 3> curves;
    Index label;
  };

  static void resize(EditableSurface& surface, Index vertices, Index faces);

  Index VertexSlots;
  Index FaceSlots;
  std::vector<VertexState> Vertices;
  std::vector<FaceState> Faces;
};

} // namespace evolving

#endif
