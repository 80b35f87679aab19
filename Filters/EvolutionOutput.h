// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * A solved evolution behind a filter: how its states and its history become VTK data. Private to
 * the module.
 */

#ifndef EvolutionOutput_h
#define EvolutionOutput_h

#include "KernelBridge.h"

#include "vtkSmartPointer.h"

#include <functional>
#include <memory>
#include <vector>

class vtkCellArray;
class vtkPolyData;
class vtkTable;

/**
 * A flow's series as VTK data: each state with its own polygons, which remeshing may change. All
 * states have points of one type: the wanted one, or double when floats cannot hold the elements of
 * a state (Mesh/FloatPoints.h). The numbers of a state are those of the points that are written.
 */
class EvolutionOutput
{
public:
  /// Solves the flow; the last parameters are StateSeries'. @param pointType the wanted one
  EvolutionOutput(int pointType, bool hasField, evolving::StateSeries::MakeFlow makeFlow,
    const std::vector<int>& published, std::size_t memoryLimit,
    const evolving::Execution& execution, std::size_t flowBytes = 0);

  /// Writes what is carried over from the input to a state.
  using WriteData = std::function<void(const evolving::FlowState& state)>;

  /**
   * Points, polygons, point arrays and field arrays of the state published as number i. States
   * with equal polygons that are written one after the other share them.
   * @param writeData called before there are arrays of the state's own; may be empty
   */
  void WriteState(std::size_t i, vtkPolyData* output, const evolving::Execution& execution,
    const WriteData& writeData = {});

  /// The last state reached, as the kernel has it.
  std::shared_ptr<const evolving::FlowState> LastState(const evolving::Execution& execution);
  /// The state published as number i, as the kernel has it.
  evolving::SurfaceMesh Mesh(std::size_t i, const evolving::Execution& execution);

  /// VTK_FLOAT or VTK_DOUBLE.
  int PointType() const { return this->Type; }
  /// For who finds that floats do not keep a promise.
  void UseDoubles() { this->Type = VTK_DOUBLE; }

  /// One row for every computed step.
  void WriteHistory(vtkTable* output) const;

  const evolving::StateSeries& Flow() const { return this->Series; }

private:
  vtkCellArray* PolygonsOf(const std::shared_ptr<const evolving::SurfaceMesh>& origin);
  void Measure(const evolving::SurfaceFlow& flow);

  std::shared_ptr<const evolving::SurfaceMesh> WrittenOrigin;
  vtkSmartPointer<vtkCellArray> Polygons; ///< of the origin written last
  int Type;
  bool HasField;
  std::vector<evolving::FlowRecord> RoundedRecords; ///< by iteration, of the points as floats
  evolving::StateSeries Series;
};

namespace EvolutionArrays
{
/// The arrays that a surface has without a field: normals, curvature, co-volume, velocities, psi.
void WriteShapeArrays(const evolving::StateArrays& arrays, vtkPolyData* output);
/// The arrays of a surface that no rank but the first has: the same names, no tuples.
/// @param writeData those of the input
void WriteEmpty(vtkPolyData* output, bool hasField, const std::function<void()>& writeData);
/// The columns of the history without a row.
void WriteEmptyHistory(vtkTable* output);
}

#endif
