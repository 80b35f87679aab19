# SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
# SPDX-License-Identifier: BSD-3-Clause
"""Figure 3.7: the redistribution potential on a closed surface that evolves by mean curvature.

The tangential velocity is its gradient. At first it differs much from place to place; as areas
become even it levels out.

    figure_3_7_redistribution_potential.py [PICTURE.png]
"""
import evolvingsurfaces as es
import numpy
from drawing import colored, diverging, scalar_bar
from figures import add_array, array, at_time, check, points
from pictures import Panel, save
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.util.numpy_support import numpy_to_vtk

TIME_STEP, RATE = 0.0005, 200.0                  # the thesis's rate
SHOWN = (0, 4, 10, 20, 100)                      # steps


def distorted_sphere():
    """An icosphere with three lobes, its points drawn towards the top: areas differ."""
    sphere = es.vtkIcosphereSource()
    sphere.Update()
    data = sphere.GetOutput()
    x, y, z = numpy.array(points(data), dtype=float).T
    angle, height = numpy.arctan2(y, x), z + 0.48 * (1.0 - z * z)
    radius = numpy.sqrt(numpy.clip(1.0 - height ** 2, 0.0, 1.0))
    size = 1.0 + 0.35 * numpy.cos(3.0 * angle) * radius ** 3
    lobes = [size * radius * numpy.cos(angle), size * radius * numpy.sin(angle), size * height]
    moved = vtkPoints()
    moved.SetData(numpy_to_vtk(numpy.stack(lobes, axis=1), deep=True))
    data.SetPoints(moved)
    return data


def center_potential(surface):
    """psi is determined up to a constant: here its mean over the surface is zero."""
    psi, area = array(surface, "RedistributionPotential"), array(surface, "CoVolume")
    centered = psi - numpy.average(psi, weights=area)
    add_array(surface, "Potential", centered)
    return centered


def spread_of_areas(surface):
    area = array(surface, "CoVolume")
    return numpy.std(area) / numpy.mean(area)


flow = es.vtkSurfaceEvolution()
flow.SetInputData(distorted_sphere())
flow.SetRelativeUnits(False)
flow.SetRemeshingToOff()
flow.SetConvergenceTolerance(0.0)
flow.SetCurvatureSpeed(1.0)
flow.SetTimeStep(TIME_STEP)
flow.SetNumberOfSteps(SHOWN[-1])
flow.SetVolumeRedistribution(RATE)
surfaces = [at_time(flow, TIME_STEP * step) for step in SHOWN]
potentials = [center_potential(surface) for surface in surfaces]

colors = diverging(100.0)
save([Panel([colored(surface, "Potential", colors, edges=True)], f"t = {TIME_STEP * step:g}",
            direction=(0.4, -1.0, 0.8), up=(0.0, 0.0, 1.0))
      for surface, step in zip(surfaces, SHOWN)], height=230, same_scale=True,
     bar=scalar_bar(colors, "redistribution potential"))

for step, surface, psi in zip(SHOWN, surfaces, potentials):
    print(f"step {step}: potential {psi.min():.3g} to {psi.max():.3g}, "
          f"spread of areas {spread_of_areas(surface):.3g}, area {array(surface, 'Area')[0]:.4g}")
for last, now, psi, following in zip(SHOWN, SHOWN[1:], potentials, potentials[1:]):
    check(f"range of the potential, step {now} over step {last}",
          numpy.ptp(following) / numpy.ptp(psi), 0.0, 0.8)
check("range of the potential, end over start",
      numpy.ptp(potentials[-1]) / numpy.ptp(potentials[0]), 0.0, 0.02)
check("spread of areas at the start", spread_of_areas(surfaces[0]), 0.5, 1.0)
check("spread of areas at the end", spread_of_areas(surfaces[-1]), 0.0, 0.05)
