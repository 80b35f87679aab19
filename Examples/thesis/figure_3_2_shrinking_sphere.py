# SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
# SPDX-License-Identifier: BSD-3-Clause
"""Figure 3.2: a sphere that shrinks under mean curvature flow, beside the exact radius.

    figure_3_2_shrinking_sphere.py [PICTURE.png]
"""
from math import sqrt

import evolvingsurfaces as es
import numpy
from drawing import BLUE, IVORY, surface
from figures import array, at_time, check, points
from pictures import Panel, save
from vtkmodules.vtkCommonDataModel import vtkPlane
from vtkmodules.vtkFiltersCore import vtkClipPolyData

TIMES = (0.0, 0.05, 0.1, 0.15, 0.2)


def half(sphere):
    """What is left of a sphere when the half towards the eye is cut away."""
    plane = vtkPlane()
    plane.SetNormal(0.35, 0.3, -1.0)
    clip = vtkClipPolyData()
    clip.SetInputData(sphere)
    clip.SetClipFunction(plane)
    return clip


def exact_radius(time):
    return sqrt(1.0 - 4.0 * time)                # (3.5) for a surface, m = 2


start = es.vtkIcosphereSource()
start.SetLevel(4)
flow = es.vtkSurfaceEvolution()                  # no distance field: mean curvature flow
flow.SetInputConnection(start.GetOutputPort())
flow.SetRelativeUnits(False)
flow.SetRemeshingToOff()
flow.SetConvergenceTolerance(0.0)
flow.SetCurvatureSpeed(1.0)
flow.SetTimeStep(0.0005)
flow.SetNumberOfSteps(400)
flow.SetOutputInterval(100)
spheres = [at_time(flow, time) for time in TIMES]
radii = [numpy.linalg.norm(points(sphere), axis=1) for sphere in spheres]

shades = [tuple(numpy.array(IVORY) * (1 - i / 4) + numpy.array(BLUE) * i / 4) for i in range(5)]
panels = [Panel([surface(sphere, color)], f"t = {time:g}\nr = {numpy.mean(r):.4f}",
                direction=(0.0, 0.0, 1.0))
          for sphere, color, time, r in zip(spheres, shades, TIMES, radii)]
panels.append(Panel([surface(half(sphere), color, edges=False, smooth=True)
                     for sphere, color in zip(spheres, shades)], "one in the other"))
save(panels, same_scale=True, height=220)

for time, sphere, r in zip(TIMES, spheres, radii):
    check(f"time of t = {time:g}", array(sphere, "Time")[0], time - 1e-9, time + 1e-9)
    check(f"radius at t = {time:g} against sqrt(1 - 4t)", numpy.mean(r) / exact_radius(time),
          0.99, 1.01)
    check(f"spread of radii at t = {time:g}", numpy.ptp(r), 0.0, 0.002)
