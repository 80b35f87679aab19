# SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
# SPDX-License-Identifier: BSD-3-Clause
"""A catenoid: the minimal surface between two rings, relaxed from a cylinder.

The exact one is r = c cosh(z / c); the rings of radius 1 are at z = -H and H.

    figure_catenoid.py [PICTURE.png]
"""
from math import cosh, log2, pi

import numpy
from drawing import IVORY, boundary, colored, scalar_bar, sequential, surface
from evolutions import relaxation
from figures import add_array, at_time, check, column, points
from pictures import Panel, save
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData

H, TIME_STEP, STEPS = 0.5, 0.05, 120             # the rings are one radius apart


def waist():
    """The c with c cosh(H / c) = 1: of the two, the stable one, by Newton's method."""
    c = 1.0
    for _ in range(30):
        ratio = H / c
        slope = cosh(ratio) - ratio * (cosh(ratio) ** 2 - 1.0) ** 0.5
        c -= (c * cosh(ratio) - 1.0) / slope
    return c


def cylinder(around, along):
    """Triangles in a grid of `around` x `along` quads, every second diagonal turned."""
    data, grid, cells = vtkPolyData(), vtkPoints(), vtkCellArray()
    for k in range(along + 1):
        for i in range(around):
            angle = 2.0 * pi * i / around
            grid.InsertNextPoint(numpy.cos(angle), numpy.sin(angle), H * (2.0 * k / along - 1.0))
    for k in range(along):
        for i in range(around):
            a, b = k * around + i, k * around + (i + 1) % around
            c, d = b + around, a + around
            for corners in ((a, b, c), (a, c, d)) if (i + k) % 2 else ((a, b, d), (b, c, d)):
                cells.InsertNextCell(3, corners)
    data.SetPoints(grid)
    data.SetPolys(cells)
    return data


def mark_error(surface, c):
    """Adds the distance from the exact catenoid, to first order, and gives the largest."""
    xyz = points(surface)
    steepness = numpy.cosh(xyz[:, 2] / c)
    error = abs(numpy.hypot(xyz[:, 0], xyz[:, 1]) - c * steepness) / steepness
    add_array(surface, "Error", error)
    return error.max()


c = waist()
flows = [relaxation(cylinder(*grid), TIME_STEP, STEPS) for grid in ((36, 12), (72, 24))]
coarse, fine = (at_time(flow, TIME_STEP * STEPS) for flow in flows)
errors = [mark_error(surface, c) for surface in (coarse, fine)]
start, soon = (at_time(flows[0], time) for time in (0.0, TIME_STEP))
colors = sequential(0.0, 0.0014)
save([Panel(props, caption, direction=(0.3, -1.0, 0.5), up=(0.0, 0.0, 1.0)) for props, caption in (
     ([surface(start, IVORY), boundary(start)], "start: a cylinder"),
     ([surface(soon, IVORY), boundary(soon)], f"t = {TIME_STEP}"),
     ([colored(coarse, "Error", colors, edges=True), boundary(coarse)], "relaxed, 36 x 12"),
     ([colored(fine, "Error", colors, edges=True), boundary(fine)], "relaxed, 72 x 24"))],
     width=900, height=200, same_scale=True,
     bar=scalar_bar(colors, "distance from the exact catenoid", 3))

check("exact radius of the waist", c, 0.8483, 0.8484)
check("error of 36 x 12 points", errors[0], 1e-4, 3e-3)
check("error of 72 x 24 points", errors[1], 1e-5, 1e-3)
check("order of the error", log2(errors[0] / errors[1]), 1.8, 2.2)
area = column(flows[1].GetOutputDataObject(1), "Area")
exact = pi * c * (2.0 * H + c * numpy.sinh(2.0 * H / c))
check("area against the exact one", area[-1] / exact, 0.998, 1.002)
check("largest growth of the area in a step", max(numpy.diff(area)), -1.0, 1e-12)
