# SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
# SPDX-License-Identifier: BSD-3-Clause
"""Figure 3.3: minimal surfaces over closed curves.

The thesis draws harmonic graphs over a circle (Poisson's integral formula). Such a graph is near a
minimal surface only where it is flat, so here it is the start: mean curvature flow with a fixed
boundary takes it to the minimal surface through the same curve.

    figure_3_3_minimal_surfaces.py [PICTURE.png]
"""
import numpy
from drawing import boundary, colored, diverging, scalar_bar
from evolutions import relaxation
from figures import add_array, array, at_time, check, column, model, points
from pictures import Panel, save
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.util.numpy_support import numpy_to_vtk

HEIGHT, TIME_STEP, STEPS = 0.5, 0.01, 100
# Heights over the circle: sums of a cos nt.
CURVES = ({2: 1.0}, {3: 1.0}, {4: 1.0}, {2: 0.7, 3: 0.5})


def harmonic_graph(curve):
    """The disc lifted to z = sum of a r^n cos nt, which is harmonic in x and y."""
    disc = model("disc.vtk")
    xyz = numpy.array(points(disc), dtype=float)
    z = xyz[:, 0] + 1j * xyz[:, 1]
    xyz[:, 2] = HEIGHT * sum(a * (z ** n).real for n, a in curve.items())
    lifted = vtkPoints()
    lifted.SetData(numpy_to_vtk(xyz, deep=True))
    disc.SetPoints(lifted)
    return disc


def is_rim(surface):
    return numpy.linalg.norm(points(surface)[:, :2], axis=1) > 0.999


def extend_curvature(surface):
    """Gives rim points, which do not flow, the mean curvature of the nearest inner point."""
    rim, xyz, curvature = is_rim(surface), points(surface), array(surface, "MeanCurvature")
    inner = numpy.flatnonzero(~rim)
    extended = numpy.array(curvature)
    for i in numpy.flatnonzero(rim):
        extended[i] = curvature[inner[numpy.argmin(numpy.sum((xyz[inner] - xyz[i]) ** 2, axis=1))]]
    add_array(surface, "Curvature", extended)


def formula(curve):
    return " + ".join(f"{'' if a == 1 else f'{a:.1g} '}cos {n}t" for n, a in curve.items())


colors = diverging(1.0)
flows = [relaxation(harmonic_graph(curve), TIME_STEP, STEPS) for curve in CURVES]
starts = [at_time(flow, 0.0) for flow in flows]
ends = [at_time(flow, TIME_STEP * STEPS) for flow in flows]
for data in starts + ends:
    extend_curvature(data)
save([Panel([colored(data, "Curvature", colors, edges=True), boundary(data)], caption,
            direction=(0.2, -1.0, 0.75), up=(0.0, 0.0, 1.0))
     for surfaces, name in ((starts, "harmonic"), (ends, "minimal"))
     for data, caption in zip(surfaces, [f"{name}\n{formula(curve)}" for curve in CURVES])],
     columns=len(CURVES), width=840, height=160, same_scale=True,
     bar=scalar_bar(colors, "mean curvature"))

for curve, flow, start, end in zip(CURVES, flows, starts, ends):
    name = formula(curve)
    before, after = (abs(array(data, "Curvature")).max() for data in (start, end))
    area = column(flow.GetOutputDataObject(1), "Area")
    check(f"{name}: largest mean curvature of the harmonic graph", before, 0.2, 2.0)
    check(f"{name}: largest mean curvature left", after, 0.0, 0.01)
    check(f"{name}: area lost", area[0] - area[-1], 1e-3, 0.2)
    check(f"{name}: largest growth of the area in a step", max(numpy.diff(area)), -1.0, 1e-9)
    moved = numpy.linalg.norm(points(end) - points(start), axis=1)
    check(f"{name}: motion of the rim", moved[is_rim(start)].max(), 0.0, 1e-12)
