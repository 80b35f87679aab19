// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * What every judge asks of an output: numbers, and field data that belong to it.
 */

#ifndef ROBUSTNESS_OUTPUT_CHECKS_H
#define ROBUSTNESS_OUTPUT_CHECKS_H

#include "Surface.h"

#include <string>

class vtkDataArray;
class vtkDataObject;
class vtkDataSet;
class vtkPolyData;
class vtkTable;

namespace robustness
{

/// The one value of a field array. @throws WrongAnswer when it is not there
double fieldNumber(vtkDataObject* data, const char* name);
/// A point array of a size. @throws WrongAnswer when it is not there
vtkDataArray* pointArray(vtkDataSet* data, const char* name, int components);

///@{
/// @throws WrongAnswer
void requireFinite(vtkDataObject* data);
/// A number said of the output against the one measured on it, in parts of a scale.
void requireStated(const std::string& name, double stated, double measured, double tolerance);
/// Point numbers that are there, three corners or more.
void requireUsableFaces(const Surface& surface);
/// Closed, manifold and oriented.
void requireClosed(const Topology& topology);
/// Every component of a closed surface, but cavities, is outwards around a volume.
void requireOutward(const Surface& surface);
///@}

} // namespace robustness

#endif
