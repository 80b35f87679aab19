# SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
# SPDX-License-Identifier: BSD-3-Clause
"""Figure 6.4: the gradient field of the signed distance to the bunny, with trajectories.

Left: the gradient in a slice of the grid, on the distance itself. Right: trajectories against it,
from points around. Each leads straight to the bunny, so it is as long as its start is far away.
"""

import numpy as np
from vtkmodules.vtkFiltersCore import vtkClipPolyData
from vtkmodules.vtkFiltersFlowPaths import vtkStreamTracer
from vtkmodules.vtkImagingCore import vtkExtractVOI

import evolvingsurfaces as es
from drawing import BLUE, SLATE, arrows, diverging, image_slice, lines, scalar_bar, surface
from evolutions import icosphere, sides
from figures import array, check, copy_of, model, points
from pictures import Panel, save

bunny = model("bunny.ply")
longest = sides(bunny).max()
distance = es.vtkMeshSDF()
distance.SetInputData(bunny)
distance.SetSampleDimensions(80, 80, 80)
distance.SetPadding(0.4)
distance.ComputeGradientOn()
field = copy_of(distance)
field.GetPointData().SetActiveVectors("Gradient")
across, up, deep = field.GetDimensions()
sparse = vtkExtractVOI()
sparse.SetInputData(field)
sparse.SetVOI(0, across - 1, 0, up - 1, deep // 2, deep // 2)
sparse.SetSampleRate(4, 4, 1)

middle = np.reshape(bunny.GetBounds(), (3, 2)).mean(axis=1)
around = icosphere(2, 0.8 * longest, middle)
trajectories = vtkStreamTracer()
trajectories.SetInputData(field)
trajectories.SetSourceConnection(around.GetOutputPort())
trajectories.SetIntegrationDirectionToBackward()
trajectories.SetIntegratorTypeToRungeKutta45()
trajectories.SetMaximumPropagation(longest)
trajectories.SetMaximumNumberOfSteps(2000)
paths = copy_of(trajectories)
outside = vtkClipPolyData()                      # what follows inside leads to the medial axis
outside.SetInputData(paths)
outside.SetInputArrayToProcess(0, 0, 0, 0, "SignedDistance")

colors = diverging(0.6 * longest)
slab = image_slice(field, 2, deep // 2, colors)
slab.SetPosition(0.0, 0.0, -longest)              # behind the arrows
save([Panel([slab, arrows(sparse, "Gradient", 0.05 * longest, SLATE)],
            "gradient of the signed distance", scalar_bar(colors, "signed distance"),
            (0.0, 0.0, 1.0)),
      Panel([surface(bunny, edges=False), lines(outside, BLUE, 1.2)],
            "trajectories against it", zoom=1.25)])


def length_outside(line):
    """Of a trajectory down to the surface, and the distance where it starts."""
    ids = [line.GetPointId(i) for i in range(line.GetNumberOfPoints())]
    distances = np.asarray(array(paths, "SignedDistance"))[ids]
    outer = distances > 0.0
    drawn = np.asarray(points(paths))[ids][outer]
    return np.linalg.norm(np.diff(drawn, axis=0), axis=1).sum() + distances[outer][-1], distances[0]


lengths, distances = np.transpose([length_outside(paths.GetCell(i))
                                   for i in range(paths.GetNumberOfCells())])
check("trajectories", len(lengths), 162, 162)
check("largest |1 - gradient|",
      np.abs(np.linalg.norm(array(field, "Gradient"), axis=1) - 1.0).max(), 0.0, 1e-5)
check("largest |length - distance| of a trajectory, in cells",
      np.abs(lengths - distances).max() / field.GetSpacing()[0], 0.0, 1.0)
