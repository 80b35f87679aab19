# SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
# SPDX-License-Identifier: BSD-3-Clause
"""Figure 6.1: mean curvature flow of an irregular shape, without and with redistribution.

The points of the upper row accumulate where curvature is high; in the lower row
volume-based redistribution makes co-volumes equal. tau is the author's; his omega of 200 belongs to
another scaling, 5 per time does the same here (tau omega must stay below 1).
"""

import numpy as np

from drawing import surface
from evolutions import area_spread, at_steps, evolution, flipped, icosphere, moved, smallest_angles
from figures import array, check
from pictures import Panel, save

STEPS = (0, 10, 20, 30, 40)
#         direction of a lump  height  width
LUMPS = (((1.0, 0.2, 0.1), 2.2, 0.25), ((-0.6, 0.8, 0.2), 1.6, 0.20), ((-0.5, -0.7, 0.5), 2.0, 0.2),
         ((0.2, 0.3, -1.0), 1.3, 0.30), ((0.1, 0.6, 0.9), 1.2, 0.15))


def with_lumps(sphere):
    radius = np.full(len(sphere), 2.0)
    for direction, height, width in LUMPS:
        away = sphere - np.array(direction) / np.linalg.norm(direction)
        radius += height * np.exp(-(away ** 2).sum(axis=1) / width)
    return radius[:, None] * sphere


start = moved(icosphere(3), with_lumps)
rows = {}
for rate in (0.0, 5.0):
    flow = evolution(start, NumberOfSteps=STEPS[-1], RelativeUnits=False, CurvatureSpeed=1.0,
                     VolumeRedistribution=rate)
    rows[rate] = at_steps(flow, STEPS)

panels = []
for rate, states in rows.items():
    name = f"omega = {rate:g}" if rate else "without"
    for step, state in zip(STEPS, states):
        panels.append(Panel([surface(state)], f"{name}, step {step}:\nco-volumes spread "
                            f"{100 * area_spread(state):.0f} %", zoom=1.25))
save(panels, columns=len(STEPS), height=200, same_scale=True)

plain, even = rows[0.0], rows[5.0]
check("spread of co-volumes at the end, without", area_spread(plain[-1]), 0.3, 0.6)
check("spread of co-volumes at the end, with", area_spread(even[-1]), 0.0, 0.03)
check("mean smallest angle at the end, without", smallest_angles(plain[-1]).mean(), 35.0, 44.0)
check("mean smallest angle at the end, with", smallest_angles(even[-1]).mean(), 50.0, 60.0)
for states in rows.values():
    areas = np.array([array(state, "Area")[0] for state in states])
    check("largest ratio of areas of successive states", (areas[1:] / areas[:-1]).max(), 0.0, 0.9)
    check("flipped triangles", max(flipped(state) for state in states), 0, 0)
