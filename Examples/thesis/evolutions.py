# SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
# SPDX-License-Identifier: BSD-3-Clause
"""Evolutions as the figures need them: as the author set them up, minimal surfaces; and measures.

Settings are properties by their names: evolution(start, TimeStep=0.03) calls SetTimeStep(0.03).
"""

import evolvingsurfaces as es
import numpy as np
from vtkmodules.numpy_interface import dataset_adapter
from vtkmodules.vtkFiltersCore import vtkTriangleFilter

from drawing import connect
from figures import array, at_time, copy_of, points

CELLS = 40                                       # of the author's grids, along the longest side
STEP = 0.03                                      # the author's tau


def icosphere(level=4, radius=1.0, center=(0.0, 0.0, 0.0)):
    sphere = es.vtkIcosphereSource()
    sphere.SetLevel(level)
    sphere.SetRadius(radius)
    sphere.SetCenter(center)
    return sphere


def moved(source, place):
    """A copy of what a source puts out, with its points (an array of n rows) put elsewhere."""
    data = copy_of(source)
    copy = data.NewInstance()
    copy.DeepCopy(data)
    coordinates = np.array(points(copy), dtype=float)
    dataset_adapter.WrapDataObject(copy).SetPoints(place(coordinates))
    return copy


def evolution(start, field=None, **settings):
    """A surface evolution from a source, towards a distance field where there is one."""
    flow = es.vtkSurfaceEvolution()
    flow.SetRemeshingToOff()            # elements stay, and all steps are made, as in the thesis
    flow.SetConvergenceTolerance(0.0)
    connect(flow, start)
    if field is not None:
        flow.SetDistanceFieldConnection(field.GetOutputPort())
    flow.SetTimeStep(STEP)
    for name, value in settings.items():
        getattr(flow, "Set" + name)(value)
    return flow


def relaxation(surface, step, steps):
    """Mean curvature flow with a fixed boundary, towards the minimal surface in it."""
    return evolution(surface, RelativeUnits=False, CurvatureSpeed=1.0, TimeStep=step,
                     NumberOfSteps=steps, BoundaryMode=es.vtkSurfaceEvolution.FIXED)


def sides(mesh):
    low_and_high = np.reshape(mesh.GetBounds(), (3, 2))
    return low_and_high[:, 1] - low_and_high[:, 0]


def distance_to(mesh, cells=CELLS):
    """The signed distance in the author's box: the mesh's, its longest side wider on every side."""
    extent = sides(mesh) + 2.0 * sides(mesh).max()
    distance = es.vtkMeshSDF()
    distance.SetInputData(mesh)
    distance.SetPadding(1.0)
    distance.SetSampleDimensions(*(int(n) for n in np.rint(cells * extent / sides(mesh).max())))
    return distance


def start_sphere(mesh, level=4):
    """The author's: in the middle of that box, with 0.4 of its shortest side as radius."""
    shortest = (sides(mesh) + 2.0 * sides(mesh).max()).min()
    return icosphere(level, 0.4 * shortest, np.reshape(mesh.GetBounds(), (3, 2)).mean(axis=1))


def evolution_towards(mesh, level=4, **settings):
    """From that sphere to a model; unless settings say otherwise 150 steps and 10 of smoothing."""
    return evolution(start_sphere(mesh, level), distance_to(mesh),
                     **{"NumberOfSteps": 150, "SmoothingSteps": 10, **settings})


def at_steps(flow, steps):
    """The surface after each of these steps."""
    return [at_time(flow, step * flow.GetTimeStep()) for step in steps]


def corner_ids(data):
    """The points of all triangles, polygons cut into such: n x 3."""
    cut = vtkTriangleFilter()
    connect(cut, data)
    cut.Update()
    return np.reshape(dataset_adapter.WrapDataObject(cut.GetOutput()).Polygons, (-1, 4))[:, 1:]


def triangles(data):
    """The corners of all triangles: n x 3 x 3."""
    return np.asarray(points(data), dtype=float)[corner_ids(data)]


def smallest_angles(data):
    """The smallest angle of every triangle, in degrees."""
    corners = triangles(data)
    cosines = []
    for k in range(3):
        a = corners[:, (k + 1) % 3] - corners[:, k]
        b = corners[:, (k + 2) % 3] - corners[:, k]
        lengths = np.linalg.norm(a, axis=1) * np.linalg.norm(b, axis=1)
        cosines.append((a * b).sum(axis=1) / np.maximum(lengths, 1e-300))
    return np.degrees(np.arccos(np.clip(np.max(cosines, axis=0), -1.0, 1.0)))


def area_spread(data):
    """Standard deviation of the co-volumes, as a part of their mean."""
    areas = np.asarray(array(data, "CoVolume"))
    return areas.std() / areas.mean()


def flipped(data):
    """How many triangles are turned against the normals at their corners."""
    a, b, c = np.moveaxis(triangles(data), 1, 0)
    normals = np.asarray(array(data, "Normals"))[corner_ids(data)].sum(axis=1)
    return int((np.einsum("ij,ij->i", np.cross(b - a, c - a), normals) < 0.0).sum())
