# SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
# SPDX-License-Identifier: BSD-3-Clause
"""Figure 6.2: mean curvature flow of a sphere whose points are unevenly distributed.

Angle-based (omega = 3, as in the thesis) and volume-based redistribution together: the spread of
co-volumes falls from above 50 % to below 5 % of their mean within the 25 steps of the figure, and
bad angles grow. tau is the author's; tau omega of the volume-based velocity is 0.9.
"""

import numpy as np

from drawing import surface
from evolutions import area_spread, at_steps, evolution, flipped, icosphere, moved, smallest_angles
from figures import check
from pictures import Panel, save

STEPS = (0, 5, 10, 15, 20, 25)
RADIUS = 3.0
PLACES = 30                                      # that points are drawn to


def unevenly(sphere):
    """Draws points towards places here and there; the sphere gets slightly bumpy, too."""
    random = np.random.default_rng(1)
    for place in random.normal(size=(PLACES, 3)):
        to_place = place / np.linalg.norm(place) - sphere
        sphere = sphere + 0.7 * np.exp(-(to_place ** 2).sum(axis=1) / 0.15)[:, None] * to_place
        sphere /= np.linalg.norm(sphere, axis=1)[:, None]
    bumps = 0.02 * np.sin(5.0 * sphere[:, :1]) * np.cos(4.0 * sphere[:, 1:2])
    return RADIUS * (1.0 + bumps) * sphere


flow = evolution(moved(icosphere(3), unevenly), NumberOfSteps=STEPS[-1], RelativeUnits=False,
                 CurvatureSpeed=1.0, AngleRedistribution=3.0, VolumeRedistribution=30.0)
states = at_steps(flow, STEPS)
save([Panel([surface(state)], f"step {step}:\nspread {100 * area_spread(state):.1f} %"
            f"\nangles from {smallest_angles(state).min():.0f}\u00b0")
      for step, state in zip(STEPS, states)], columns=6, height=200, same_scale=True)

check("spread of co-volumes at the start", area_spread(states[0]), 0.5, 1.0)
check("spread of co-volumes at the end", area_spread(states[-1]), 0.0, 0.05)
check("smallest angle at the start", smallest_angles(states[0]).min(), 0.0, 10.0)
check("smallest angle at the end", smallest_angles(states[-1]).min(), 45.0, 60.0)
check("flipped triangles", max(flipped(state) for state in states), 0, 0)
