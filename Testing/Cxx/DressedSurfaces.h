// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * Surfaces with data of every kind, which follow from where a point or cell is, so that a test can
 * tell whether they are where they belong.
 */

#ifndef DressedSurfaces_h
#define DressedSurfaces_h

#include "SampleSurfaces.h"

#include <gtest/gtest.h>

namespace Sample
{

/**
 * A copy of a surface in [-1, 1]^3 with point arrays Height (double, z, the active scalars), Place
 * (float, the point), Color (unsigned char, the point as red, green and blue), Label (int, 5 above
 * z = 0 and 2 below), Name (strings, north and south), Bit (likewise), Number (active global ids),
 * Pedigree (active) and vtkGhostType; cell arrays Middle (double, the middle, active vectors), Side
 * (int, as Label) and CellNumber (active global ids); field array Patient (a string).
 */
Surface Dressed(vtkPolyData* surface);

} // namespace Sample

/// Are all those arrays of the input on the output, value by value, with their roles?
testing::AssertionResult HasSameData(vtkPolyData* input, vtkPolyData* output);

/// Are Height, Place and Color about right for points on the unit sphere in these directions, and
/// Label, Name and Bit of one kind, and right but within an edge of z = 0?
testing::AssertionResult HasDataOfDirections(vtkPolyData* output, double tolerance, double edge);

/// Are Middle and Side about right for cells in these directions?
testing::AssertionResult HasCellDataOfDirections(vtkPolyData* output, double tolerance);

#endif
