// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * What the tests measure of an output, without the code under test.
 */

#ifndef DataChecks_h
#define DataChecks_h

#include <gtest/gtest.h>

#include <functional>
#include <string>
#include <vector>

class vtkDataArray;
class vtkDataObject;
class vtkDataSet;
class vtkFieldData;
class vtkImageData;
class vtkPolyData;
class vtkTable;

/// Are all coordinates and all values of all arrays finite numbers?
testing::AssertionResult IsFinite(vtkDataObject* data);

/// Has it neither points, cells, rows nor arrays: is it as Initialize() leaves it?
testing::AssertionResult IsInitialized(vtkDataObject* data);

/// Is the text one sentence for a user: not empty, one line, with a full stop at its end?
testing::AssertionResult IsOneSentence(const std::string& text);

/// Have two arrays the same type, shape and bits?
testing::AssertionResult SameBits(vtkDataArray* a, vtkDataArray* b);

/// Have two images the same extent, place and bits in their active scalars?
testing::AssertionResult SameImage(vtkImageData* a, vtkImageData* b);

/// Does every point array of a agree with b's of the same name, relative to its largest value?
testing::AssertionResult SamePointArrays(vtkPolyData* a, vtkPolyData* b, double tolerance);

/// The one value of a field array; NaN without that array.
double FieldValue(vtkDataObject* data, const char* name);
std::string FieldText(vtkDataObject* data, const char* name);

///@{
/// Names in alphabetical order: the order of arrays means nothing.
std::vector<std::string> Sorted(std::vector<std::string> names);
std::vector<std::string> ArrayNames(vtkFieldData* arrays);
std::vector<std::string> ColumnNames(vtkTable* table);
///@}

/// The smallest and largest value of a function over all points.
struct Range
{
  double Smallest;
  double Largest;
};
Range RangeOverPoints(vtkDataSet* data, const std::function<double(const double point[3])>& value);
Range DistanceFromOrigin(vtkDataSet* data);

#endif
