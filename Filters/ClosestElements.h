// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * Which points and cells of an input are closest to others. Private to the module.
 */

#ifndef ClosestElements_h
#define ClosestElements_h

#include "DataTransfer.h"
#include "KernelBridge.h"

#include <vector>

/// The triangles of an input, or its points where it has no faces, in a tree.
class ClosestElements
{
public:
  /**
   * @param mesh triangles, or points alone
   * @param pointOfVertex the input's number of every vertex
   * @param cellOfFace the input's cell of every face, of every vertex where there are no faces
   * @throws evolving::Cancelled
   */
  ClosestElements(const evolving::SurfaceMesh& mesh, std::vector<vtkIdType> pointOfVertex,
    std::vector<vtkIdType> cellOfFace, const evolving::Execution& execution);

  /// Where on the input's closest cells the points closest to these lie. @throws
  /// evolving::Cancelled
  std::vector<DataTransfer::Mixture> MixturesAt(
    const std::vector<evolving::Vec3>& points, const evolving::Execution& execution) const;

  /// The input's cells closest to points. @throws evolving::Cancelled
  std::vector<vtkIdType> CellsAt(
    const std::vector<evolving::Vec3>& points, const evolving::Execution& execution) const;

private:
  evolving::SurfaceMesh Mesh;
  std::vector<vtkIdType> PointOfVertex;
  std::vector<vtkIdType> CellOfFace;
  evolving::AABBTree Tree;
};

/// The middles of a mesh's faces, with its vertices where `points` are.
std::vector<evolving::Vec3> FaceCenters(
  const evolving::SurfaceMesh& mesh, const std::vector<evolving::Vec3>& points);

#endif
