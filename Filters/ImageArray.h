// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * Which array of an image a filter works on. Private to the module.
 */

#ifndef ImageArray_h
#define ImageArray_h

#include "vtkSmartPointer.h"
#include "vtkType.h"

class vtkAlgorithm;
class vtkDataArray;
class vtkDataSetAttributes;
class vtkImageData;
class vtkInformationVector;

/**
 * The array that SetInputArrayToProcess(0, ...) of a filter chooses, of the points or cells of the
 * image on one of its ports; by default the active scalars, of the points or else of the cells, and
 * so with no name.
 */
class ImageArray
{
public:
  /// To be called in the filter's constructor.
  /// @param expected what the array is to be, in words
  ImageArray(vtkAlgorithm* filter, int port, const char* expected = "a distance or an intensity");
  ~ImageArray();

  /**
   * An image whose active point scalars are the array; cells count as samples at their middles.
   * The same object until the image or the choice changes. Null without an image.
   * @throws evolving::InputError when there is no such array, or none of one number per sample
   */
  vtkImageData* Get(vtkAlgorithm* filter, vtkInformationVector** inputVector);

private:
  int Port;
  const char* Expected;
  vtkImageData* LastImage = nullptr;
  vtkMTimeType LastTime = 0;
  vtkDataArray* LastArray = nullptr;
  vtkSmartPointer<vtkImageData> Samples;
};

#endif
