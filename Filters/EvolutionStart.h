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
   * Welded and, where it is closed, with normals outwards: contour filters turn them to lower
   * values, which is inwards for a signed distance.
   * @param isSplit polygons become triangles
   * @throws evolving::InputError, evolving::Cancelled
   */
  EvolutionStart(vtkPolyData* input, bool isSplit, const evolving::Execution& execution);

  const std::shared_ptr<const evolving::SurfaceMesh>& Mesh() const { return this->Start; }

  /**
   * @param input the one that the start was made of, or one of equal points and cells
   * @param state of a flow that traced the start, unless it has the start's elements
   */
  void WriteData(vtkPolyData* input, const evolving::FlowState& state, vtkPolyData* output,
    const evolving::Execution& execution);

private:
  void FindPlaces(const evolving::FlowState& state, const evolving::Execution& execution);

  std::shared_ptr<const evolving::SurfaceMesh> Start;
  DataTransfer::Copies Elements; ///< where the start's come from
  std::unique_ptr<const ClosestElements> Closest;
  /// Of the elements that were written last, and where they come from.
  std::shared_ptr<const std::vector<evolving::Vec3>> Written;
  std::vector<DataTransfer::Mixture> PointPlaces;
  std::vector<vtkIdType> CellPlaces;
};

#endif
