# SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
# SPDX-License-Identifier: BSD-3-Clause
"""Pictures in numbers: whether there is anything in one, how far two are apart."""

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkImagingCore import vtkImageShrink3D
from vtkmodules.vtkIOImage import vtkJPEGReader, vtkPNGReader

PICTURES = {".jpg": vtkJPEGReader, ".png": vtkPNGReader}
# Pixels of a block that is averaged: lines and letters drawn by another version of the graphics
# library lie elsewhere by a part of a pixel, what they show does not.
BLOCK = 8


def read(path):
    reader = PICTURES[path.suffix]()
    reader.SetFileName(str(path))
    reader.Update()
    return reader.GetOutput()


def is_blank(path):
    colors = read(path).GetPointData().GetScalars()
    if colors is None or colors.GetNumberOfTuples() == 0:
        return True
    ranges = [colors.GetRange(i) for i in range(colors.GetNumberOfComponents())]
    return all(low == high for low, high in ranges)


def blocks(path):
    """The colours, averaged over blocks: an array of one row for each, 0 to 255, and its shape."""
    coarse = vtkImageShrink3D()
    coarse.SetInputData(read(path))
    coarse.SetShrinkFactors(BLOCK, BLOCK, 1)
    coarse.AveragingOn()
    coarse.Update()
    image = coarse.GetOutput()
    colors = vtk_to_numpy(image.GetPointData().GetScalars()).astype(float)
    return image.GetDimensions(), colors.reshape(image.GetNumberOfPoints(), -1)[:, :3]


def difference(first, second):
    """The largest difference of a block in two pictures, 0 to 255; 255 for pictures of other sizes."""
    (size, colors), (other_size, other_colors) = blocks(first), blocks(second)
    if size != other_size:
        return 255.0
    return float(np.abs(colors - other_colors).max())
