# SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
# SPDX-License-Identifier: BSD-3-Clause
"""Figure 6.10: evolution towards the arc with angle-based redistribution, omega = 3, and without.

As in the thesis it betters the angles even of this simple model, but accumulation around irregular
points and the stretched triangles in the concavity stay. The third surface took the other method
of AngleRedistribution, which looks at the shapes of elements: no triangle ends thin as a needle.
"""

from drawing import colored, scalar_bar, sequential
from evolutions import area_spread, evolution_towards, flipped, smallest_angles
from figures import check, copy_of, dataset_adapter, model
from pictures import Panel, save

arc = model("arc.vtk")
colors = sequential(0.0, 60.0)
panels, results = [], []
for name, settings in {
        "without": {},
        "omega = 3": {"AngleRedistribution": 3.0},
        "shapes, omega = 25": {"AngleRedistribution": 25.0, "AngleMethod": 1}}.items():
    result = copy_of(evolution_towards(arc, **settings))
    angles = smallest_angles(result)
    dataset_adapter.WrapDataObject(result).CellData.append(angles, "SmallestAngle")
    results.append(result)
    panels.append(Panel([colored(result, "SmallestAngle", colors, edges=True, cells=True)],
                        f"{name}: smallest angles\n"
                        f"{angles.mean():.1f}\u00b0 in the mean, from {angles.min():.2f}\u00b0",
                        direction=(0.5, -1.0, -0.55), up=(0.0, 0.0, 1.0), zoom=0.82))
save(panels, bar=scalar_bar(colors, "smallest angle of a triangle, degrees", form="%.0f"))

without, angled, shaped = results
check("mean smallest angle without", smallest_angles(without).mean(), 28.0, 31.0)
check("mean smallest angle with", smallest_angles(angled).mean(), 33.5, 36.0)
check("smallest angle without", smallest_angles(without).min(), 0.0, 0.01)
check("smallest angle with", smallest_angles(angled).min(), 0.05, 1.0)
check("mean smallest angle by shapes", smallest_angles(shaped).mean(), 35.0, 37.5)
check("smallest angle by shapes", smallest_angles(shaped).min(), 4.0, 10.0)
check("spread of co-volumes without", area_spread(without), 0.45, 0.6)
check("spread of co-volumes with", area_spread(angled), 0.25, 0.4)
for result in results:
    check("flipped triangles", flipped(result), 0, 0)
