# SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
# SPDX-License-Identifier: BSD-3-Clause
"""Figure 6.8: convex meshes after 150 steps with tau = 0.03 and 10 of smoothing, by co-volume.

Upper row: without redistribution, as in the thesis: points gather on edges and corners, which draws
them well, but at the apex of the cone triangles lose their angles. Lower row: volume-based with
omega = 1: co-volumes spread by 2 % and no triangle is turned, at the price of chipped edges.
"""

import numpy as np
from vtkmodules.vtkFiltersSources import vtkConeSource, vtkCylinderSource, vtkPlatonicSolidSource

from drawing import colored, scalar_bar, sequential
from evolutions import area_spread, evolution_towards, flipped, sides, smallest_angles
from figures import add_array, array, check, copy_of
from pictures import Panel, save


def solid(number):
    source = vtkPlatonicSolidSource()
    source.SetSolidType(number)
    return copy_of(source)


def around(source, resolution, height):
    source.SetResolution(resolution)
    source.SetHeight(height)
    return copy_of(source)


MODELS = {"tetrahedron": solid(0), "cube": solid(1), "octahedron": solid(2),
          "icosahedron": solid(3), "dodecahedron": solid(4),
          "cone": around(vtkConeSource(), 48, 1.5),
          "cylinder": around(vtkCylinderSource(), 48, 1.0),
          "prism": around(vtkCylinderSource(), 6, 0.8)}
RATES = (0.0, 1.0)

colors = sequential(0.0, 2.0)
panels, results = [], {}
for rate in RATES:
    for name, mesh in MODELS.items():
        result = copy_of(evolution_towards(mesh, level=3, VolumeRedistribution=rate))
        areas = np.asarray(array(result, "CoVolume"))
        add_array(result, "RelativeCoVolume", areas / areas.mean())
        results[rate, name] = result
        panels.append(Panel([colored(result, "RelativeCoVolume", colors, edges=True)],
                            f"{name},\nspread {100 * area_spread(result):.0f} %", zoom=0.85))
save(panels, columns=len(MODELS), height=150,
     bar=scalar_bar(colors, "co-volume, relative to the mean"))

for (rate, name), result in results.items():
    mean, farthest = (array(result, measure)[0] / sides(MODELS[name]).max()
                      for measure in ("MeanDistance", "MaxDistance"))
    spread = (0.0, 0.025) if rate else (0.3, 0.8)
    what = f"{name}, omega = {rate:g}:"
    check(f"{what} mean distance by longest side", mean, 0.0, 0.006)
    check(f"{what} largest distance by longest side", farthest, 0.0, 0.01)
    check(f"{what} spread of co-volumes", area_spread(result), *spread)
    if rate:
        check(f"{what} smallest angle", smallest_angles(result).min(), 15.0, 60.0)
        check(f"{what} flipped triangles", flipped(result), 0, 0)
