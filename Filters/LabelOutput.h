// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * The surfaces of labels as VTK data. Private to the module.
 */

#ifndef LabelOutput_h
#define LabelOutput_h

#include "KernelBridge.h"

#include "vtkSmartPointer.h"
#include "vtkType.h"

#include <vector>

class vtkDataArray;
class vtkPolyData;

/// Labels are written as what the image has, or as doubles where that cannot hold the background's.
class LabelOutput
{
public:
  /// @param type of the labels, as VTK_UNSIGNED_CHAR
  LabelOutput(int type, double background, std::vector<double> values);

  /// The closed surfaces, with `Label`, `NeighborLabel` and the field arrays.
  void WriteSurfaces(const evolving::LabelSurfaces& result, vtkPolyData* output) const;
  /// The interfaces, with `BoundaryLabels`.
  void WriteInterfaces(const evolving::LabelSurfaces& result, vtkPolyData* output) const;

private:
  double ValueOf(evolving::Material material) const;
  vtkSmartPointer<vtkDataArray> MakeArray(const char* name, int components, vtkIdType count) const;
  void AddLabels(vtkPolyData* output, const char* name,
    const std::vector<evolving::Material>& materials, bool isActive) const;
  void AddField(vtkPolyData* output, const char* name, const std::vector<double>& values) const;

  int Type;
  double Background;
  std::vector<double> Values;
};

#endif
