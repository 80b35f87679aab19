// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * Images of labels for the tests of vtkLabelSurfaces, and the surfaces made of them.
 */

#ifndef EVOLVING_TESTING_LABEL_IMAGES_H
#define EVOLVING_TESTING_LABEL_IMAGES_H

#include "vtkSmartPointer.h"

#include <functional>

class vtkDataArray;
class vtkImageData;
class vtkLabelSurfaces;
class vtkPolyData;

using Image = vtkSmartPointer<vtkImageData>;

/// An image of a function of place, relative to the middle, in units of x.
Image LabelImage(vtkDataArray* array, const std::function<double(double, double, double)>& label);

/// A ball of two halves, 5 and 9, in -1.
Image Halves();

/// A ball, 1, in 0.
Image Ball();

vtkSmartPointer<vtkLabelSurfaces> FilterOf(vtkImageData* image, double background = 0.0);

/// The triangles of a label, with all points.
vtkSmartPointer<vtkPolyData> SurfaceOf(vtkLabelSurfaces* filter, double label);

#endif
