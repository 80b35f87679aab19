# SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
# SPDX-License-Identifier: BSD-3-Clause
"""Section 3.2: segmentation of nuclei in a noisy image by v_N = b e Laplace F - a (grad e . N) N.

The image is made here: six ellipsoids of intensity 1, blurred, with noise of 0.2. One evolution
moves all surfaces at once, from spheres around centres known to a voxel. Lengths are in voxels.

- K and what is noise are chosen from the image, e = 1 / (1 + K max(0, |grad I|^2 - n^2)): 0.1 on
  edges and 1 off them, where noise is all there is.
- Off edges e is flat and only curvature moves a sphere, so it must start outside: it shrinks at
  2 b / r, with b = 1 from 14 to 9 in the time (14^2 - 9^2) / (4 b) = 29, or 58 steps of 0.5.
- At an edge a |grad e|, a = 4, is far above 2 b e / r and holds it. A start sphere must not reach a
  neighbour's edge, which would hold it as well.

They come out 2 % too small: the image is blurred, which draws the largest slope of a ball of
radius r inwards by sigma^2 / r. What the 0.8 voxels against noise add to that is made good for.
"""

import evolvingsurfaces as es
import numpy as np
from vtkmodules.numpy_interface import dataset_adapter
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkCommonExecutionModel import vtkTrivialProducer
from vtkmodules.vtkFiltersCore import vtkAppendPolyData, vtkContourFilter
from vtkmodules.vtkRenderingCore import vtkColorTransferFunction

from drawing import RED, image_slice, lines, surface
from evolutions import evolution, flipped, icosphere, triangles
from figures import add_array, check, copy_of, points
from pictures import Panel, save

SIZE, SLICE = (120, 88, 48), 24                  # voxels; the slice that is shown
#         centre      half axes          turned about z, degrees
NUCLEI = ((22, 24, 24, 9.0, 9.0, 9.0, 0), (58, 20, 22, 11.0, 8.0, 8.0, 20),
          (96, 24, 26, 8.0, 10.0, 9.0, 40), (24, 64, 22, 8.0, 11.0, 8.0, -30),
          (59, 55, 25, 8.0, 8.0, 8.0, 0), (96, 62, 23, 11.0, 9.0, 8.0, 60))
CYAN = (0.25, 0.75, 0.9)
random = np.random.default_rng(3)


def distance(places, nucleus):
    """From a nucleus' surface, negative inside; exact to first order."""
    center, axes, angle = nucleus[:3], np.array(nucleus[3:6]), np.radians(nucleus[6])
    c, s = np.cos(angle), np.sin(angle)
    turn = np.array([[c, -s, 0.0], [s, c, 0.0], [0.0, 0.0, 1.0]])
    scaled = (places - np.array(center)) @ turn / axes
    level = np.maximum(np.linalg.norm(scaled, axis=-1), 1e-9)
    return (level - 1.0) * level / np.maximum(np.linalg.norm(scaled / axes, axis=-1), 1e-9)


def noisy_image():
    voxels = np.stack(np.meshgrid(*map(np.arange, SIZE[::-1]), indexing="ij")[::-1], axis=-1)
    voxels = voxels.reshape(-1, 3)               # x fastest
    nearest = np.min([distance(voxels, nucleus) for nucleus in NUCLEI], axis=0)
    intensity = 0.5 - 0.5 * np.tanh(1.2 * nearest) + 0.2 * random.normal(size=len(voxels))
    image = vtkImageData()
    image.SetDimensions(SIZE)
    dataset_adapter.WrapDataObject(image).PointData.append(intensity, "Intensity")
    image.GetPointData().SetActiveScalars("Intensity")
    return image


def contour(data):
    """Where a surface meets the slice."""
    add_array(data, "Height", np.asarray(points(data))[:, 2].copy())
    curves = vtkContourFilter()
    curves.SetInputData(data)
    curves.SetInputArrayToProcess(0, 0, 0, 0, "Height")
    curves.SetValue(0, SLICE)
    return copy_of(curves)


image = noisy_image()
scan = vtkTrivialProducer()
scan.SetOutput(image)
spheres = [icosphere(3, 14.0, np.array(nucleus[:3]) + random.uniform(-1.0, 1.0, 3))
           for nucleus in NUCLEI]
start = vtkAppendPolyData()
for sphere in spheres:
    start.AddInputConnection(sphere.GetOutputPort())
flow = evolution(start, scan, TimeStep=0.5, NumberOfSteps=150, RelativeUnits=False,
                 FieldMode=es.vtkSurfaceEvolution.IMAGE, CurvatureSpeed=1.0,
                 AdvectionSpeed=4.0, VolumeRedistribution=0.5)
result = copy_of(flow)

gray = vtkColorTransferFunction()
gray.AddRGBPoint(-0.5, 0.0, 0.0, 0.0)
gray.AddRGBPoint(1.5, 1.0, 1.0, 1.0)
slab = image_slice(image, 2, SLICE, gray)
slab.SetPosition(0.0, 0.0, -2.0 * SIZE[2])        # behind the contours
save([Panel([slab, lines(contour(copy_of(start)), CYAN), lines(contour(result), RED, 3.0)],
            f"slice {SLICE}: image, start (cyan), result (red)",
            direction=(0.0, 0.0, 1.0), zoom=1.45),
      Panel([surface(result)], "all surfaces of the result", direction=(0.0, -0.4, 1.0),
            zoom=1.15)])

corners, places = triangles(result), np.asarray(points(result))
own = np.argmin([np.linalg.norm(corners.mean(axis=1) - n[:3], axis=1) for n in NUCLEI], axis=0)
for number, nucleus in enumerate(NUCLEI):
    a, b, c = np.moveaxis(corners[own == number], 1, 0)
    volume = np.einsum("ij,ij->", a - np.array(nucleus[:3]), np.cross(b - a, c - a)) / 6.0
    check(f"nucleus {number}: volume by the true one",
          volume / (4.0 / 3.0 * np.pi * np.prod(nucleus[3:6])), 0.94, 1.02)
errors = np.min([np.abs(distance(places, nucleus)) for nucleus in NUCLEI], axis=0)
check("mean distance from the true surfaces, voxels", errors.mean(), 0.0, 0.2)
check("largest distance, voxels", errors.max(), 0.0, 0.8)
check("flipped triangles", flipped(result), 0, 0)
