# SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
# SPDX-License-Identifier: BSD-3-Clause
"""Figure 5.8: the sign of the distance inside the bunny, and iso-contours around it.

    figure_5_8_sign_and_contours.py [PICTURE.png]
"""
import evolvingsurfaces as es
import numpy
from drawing import BLUE, diverging, image_slice, scalar_bar, sequential, surface, volume
from figures import array, check, copy_of, model, points
from pictures import Panel, save
from vtkmodules.vtkCommonDataModel import vtkPlane
from vtkmodules.vtkFiltersCore import (vtkClipPolyData, vtkFeatureEdges,
                                       vtkImplicitPolyDataDistance, vtkMarchingCubes,
                                       vtkMassProperties)

SAMPLES, LEVELS = 100, (0.3, 0.8, 1.4, 2.1)
bunny = model("bunny.ply")


def signed_distance():
    distance = es.vtkMeshSDF()
    distance.SetInputData(bunny)
    distance.SetSampleDimensions(SAMPLES, SAMPLES, SAMPLES)
    distance.SetPadding(0.3)
    distance.SetSignToFloodFill()                # section 5.4
    return copy_of(distance)


def contour(image, level):
    cubes = vtkMarchingCubes()
    cubes.SetInputData(image)
    cubes.SetValue(0, level)
    return copy_of(cubes)


def behind(source, depth):
    """What lies behind a plane across z."""
    plane = vtkPlane()
    plane.SetOrigin(0.0, 0.0, depth)
    plane.SetNormal(0.0, 0.0, -1.0)
    clip = vtkClipPolyData()
    clip.SetInputData(source)
    clip.SetClipFunction(plane)
    return clip


def open_edges(source):
    edges = vtkFeatureEdges()
    edges.SetInputData(source)
    edges.FeatureEdgesOff()
    return copy_of(edges).GetNumberOfCells()


def volume_of(source):
    mass = vtkMassProperties()
    mass.SetInputData(source)
    return mass.GetVolume()


def mean_error(source, level):
    """How far the points of a contour are from its level, by VTK's own distance."""
    distance = vtkImplicitPolyDataDistance()
    distance.SetInput(bunny)
    sample = points(source)[::50]
    return numpy.mean([abs(distance.EvaluateFunction(point) - level) for point in sample])


image = signed_distance()
d, cell = array(image, "SignedDistance"), image.GetSpacing()[0]
contours = [contour(image, level) for level in LEVELS]
colors, around = diverging(5.0), sequential(0.0, 2.4)
sign = volume(image, diverging(cell), ((-5.0, 0.4), (-0.5 * cell, 0.3), (0.0, 0.0)))
save([Panel([sign, surface(bunny, edges=False, opacity=0.15)], "negative inside", zoom=1.7),
      Panel([surface(bunny, BLUE, edges=False)] +
            [surface(behind(shell, 0.0), around.GetColor(level), edges=False, smooth=True)
             for level, shell in zip(LEVELS, contours)],
            "outer iso-contours, cut open", bar=scalar_bar(around, "distance")),
      Panel([image_slice(image, 2, SAMPLES // 2, colors)], "middle slice",
            direction=(0.0, 0.0, 1.0), bar=scalar_bar(colors, "signed distance"))],
     width=1000, height=320)

inside = numpy.count_nonzero(d < 0.0) * cell ** 3
check("volume of the samples inside over the bunny's", inside / volume_of(bunny), 0.99, 1.01)
for level, shell in zip(LEVELS, contours):
    check(f"open edges of contour {level}", open_edges(shell), 0, 0)
    check(f"mean error of contour {level}, in cells", mean_error(shell, level) / cell, 0.0, 0.02)
volumes = [volume_of(shell) for shell in [bunny] + contours]
check("least growth of the volume from contour to contour", min(numpy.diff(volumes)), 50.0, 1000.0)
