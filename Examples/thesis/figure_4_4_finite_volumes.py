# SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
# SPDX-License-Identifier: BSD-3-Clause
"""Figure 4.4: the finite volume network and the angle-weighted pseudonormals of the bunny.

The co-volume of a vertex reaches to the midpoints of its edges and the centroids of its triangles.

    figure_4_4_finite_volumes.py [PICTURE.png]
"""
import evolvingsurfaces as es
import numpy
from drawing import BLUE, RED, arrows, lines, surface
from figures import array, at_time, check, model, points
from numpy.linalg import norm
from pictures import Panel, save
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData


def arrays_of_start(data):
    """The arrays that an evolution has at its vertices: of the start, if it makes no step."""
    evolution = es.vtkSurfaceEvolution()
    evolution.SetInputData(data)
    evolution.SetNumberOfSteps(0)
    return at_time(evolution, 0.0)


def co_volume_network(corners):
    """In each triangle, a line from its centroid to the middle of every edge."""
    network, ends, cells = vtkPolyData(), vtkPoints(), vtkCellArray()
    middles = 0.5 * (corners + numpy.roll(corners, -1, axis=1))
    centroids = numpy.repeat(corners.mean(axis=1), 3, axis=0)
    ends.SetData(numpy_to_vtk(numpy.concatenate([centroids, middles.reshape(-1, 3)]), deep=True))
    for i in range(len(centroids)):
        cells.InsertNextCell(2, (i, i + len(centroids)))
    network.SetPoints(ends)
    network.SetLines(cells)
    return network


def at_corners(corners):
    """For k = 0, 1, 2: the two edge vectors that leave corner k of every triangle."""
    for k in range(3):
        yield [numpy.roll(corners, -j, axis=1)[:, k] - corners[:, k] for j in (1, 2)]


def co_volumes(triangles, corners, count):
    """The areas enclosed by the network: vertex, middle of an edge, centroid, middle of an edge."""
    areas = numpy.zeros(count)
    for k, (u, v) in enumerate(at_corners(corners)):
        for edge in (u, v):
            part = 0.5 * norm(numpy.cross(0.5 * edge, (u + v) / 3.0), axis=1)
            numpy.add.at(areas, triangles[:, k], part)
    return areas


def pseudonormals(triangles, corners, count):
    """Algorithm 2: the normals of the triangles at a vertex, weighted by their angles there."""
    normals = numpy.zeros((count, 3))
    for k, (u, v) in enumerate(at_corners(corners)):
        across = numpy.cross(u, v)
        angle = numpy.arctan2(norm(across, axis=1), numpy.sum(u * v, axis=1))
        numpy.add.at(normals, triangles[:, k], (angle / norm(across, axis=1))[:, None] * across)
    return normals / norm(normals, axis=1)[:, None]


bunny = arrays_of_start(model("bunny.ply"))
count = bunny.GetNumberOfPoints()
triangles = vtk_to_numpy(bunny.GetPolys().GetConnectivityArray()).reshape(-1, 3)
corners = numpy.array(points(bunny), dtype=float)[triangles]
network = co_volume_network(corners)
save([Panel([surface(bunny, edges=False), lines(network, RED, 2.0)], "finite volume network",
            zoom=1.9, center=(-2.2, 7.2, 0.0)),
      Panel([surface(bunny), lines(network, RED, 3.5), arrows(bunny, "Normals", 0.35, BLUE)],
            "co-volumes and pseudonormals, close", zoom=6.0, center=(-2.6, 6.4, 2.5))],
     width=840, height=320)

check("points of the bunny", count, 1839, 1839)
error = array(bunny, "CoVolume") - co_volumes(triangles, corners, count)
check("largest error of CoVolume", abs(error).max(), 0.0, 1e-12)
check("sum of CoVolume over Area", array(bunny, "CoVolume").sum() / array(bunny, "Area")[0],
      1.0 - 1e-12, 1.0 + 1e-12)
error = array(bunny, "Normals") - pseudonormals(triangles, corners, count)
check("largest error of Normals", abs(error).max(), 0.0, 1e-12)
