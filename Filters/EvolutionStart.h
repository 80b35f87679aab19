// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * The start of an evolution and its data. Private to the module.
 */

#ifndef EvolutionStart_h
#define EvolutionStart_h

#include "ClosestElements.h"
#include "DataTransfer.h"
#include "KernelBridge.h"

#include <memory>

class vtkPolyData;

/**
 * The start surface of an evolution as the kernel has it, and how the input's point and cell data
 * get onto its states: as they are while these have the start's elements; from where a point of new
 * elements came from on the start otherwise.
 */
class EvolutionStart
{
public:
  /**
   * Welded where it is not closed as it is and, where it is closed, with normals outwards: contour
   * filters turn them to lower values, which is inwards for a signed distance.
   * @param isSplit polygons become triangles
   * @throws evolving::InputError, evolving::Cancelled
   */
  EvolutionStart(vtkPolyData* input, bool isSplit, const evolving::Execution& execution);

  /**
   * Slivers, as contour filters make them, are no part of what is to evolve.
   * @return whether there were any that could be taken out
   */
  bool TakeSliversOut();

  /// What evolves.
  const std::shared_ptr<const evolving::SurfaceMesh>& Mesh() const { return this->Start; }

  /**
   * @param input the one that the start was made of, or one of equal points and cells
   * @param state of a flow from Mesh() that traced it, unless it has the start's elements
   */
  void WriteData(vtkPolyData* input, const evolving::FlowState& state, vtkPolyData* output,
    const evolving::Execution& execution);

private:
  using Points = std::shared_ptr<const std::vector<evolving::Vec3>>;

  /// @param places on the start, of the points of faces
  void FindPlaces(
    const Points& places, const evolving::SurfaceMesh& faces, const evolving::Execution& execution);

  std::shared_ptr<const evolving::SurfaceMesh> Start;
  std::shared_ptr<const evolving::SurfaceMesh> WithSlivers; ///< the start, unless there were some
  DataTransfer::Copies Elements;                            ///< where those of it come from
  std::unique_ptr<const ClosestElements> Closest;
  /// Of the elements that were written last, and where they come from.
  Points Written;
  std::vector<DataTransfer::Mixture> PointPlaces;
  std::vector<vtkIdType> CellPlaces;
};

#endif
