// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * The arrays of an input on the points and cells of an output. Private to the module.
 */

#ifndef DataTransfer_h
#define DataTransfer_h

#include "vtkType.h"

#include <array>
#include <vector>

class vtkDataObject;
class vtkPolyData;

/// Of the arrays that CarriedArrays chooses.
namespace DataTransfer
{

/// Every point and cell of the output is one of the input's.
struct Copies
{
  std::vector<vtkIdType> points; ///< of the input, one for each of the output; all different
  std::vector<vtkIdType> cells;  ///< likewise; parts of one cell follow each other
};

/// A point among three of the input's.
struct Mixture
{
  std::array<vtkIdType, 3> points;
  std::array<double, 3> weights; ///< none negative, their sum 1
};

/// Point and cell data as they are; cells that have several parts lose their ids.
void Copy(vtkPolyData* input, const Copies& copies, vtkPolyData* output);

/**
 * Point data between the input's points: continuous arrays are interpolated, the others have the
 * value of the point with the largest weight.
 */
void InterpolatePoints(vtkPolyData* input, const std::vector<Mixture>& points, vtkPolyData* output);

/// Cell data of cells that look like some of the input's, but are not those.
void CopyCells(vtkPolyData* input, const std::vector<vtkIdType>& cells, vtkPolyData* output);

/// Field data, beside the output's; what this module computed of the input is left out.
void PassFieldData(vtkDataObject* input, vtkDataObject* output);

/// The arrays that Copy() would write, with no tuples; none without an input.
void CopyWithoutTuples(vtkPolyData* input, vtkPolyData* output);

} // namespace DataTransfer

#endif
