# SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
# SPDX-License-Identifier: BSD-3-Clause
"""Figure 6.3: mean curvature flow of an ellipsoid without and with redistributions.

Without redistribution points accumulate at the tips, where curvature is high. The volume-based
velocity keeps co-volumes equal, the angle-based one angles; their sum has something of both.
"""

import numpy as np

from drawing import surface
from evolutions import area_spread, at_steps, evolution, flipped, icosphere, moved, smallest_angles
from figures import check
from pictures import Panel, save

STEPS = (0, 20, 40)
ANGLE, VOLUME = {"AngleRedistribution": 3.0}, {"VolumeRedistribution": 5.0}
COLUMNS = {"without": {}, "volume-based": VOLUME, "angle-based": ANGLE, "sum": {**VOLUME, **ANGLE}}

ellipsoid = moved(icosphere(3), lambda sphere: sphere * np.array([5.0, 2.5, 2.5]))
columns = {}
for name, rates in COLUMNS.items():
    flow = evolution(ellipsoid, NumberOfSteps=STEPS[-1], RelativeUnits=False, CurvatureSpeed=1.0,
                     **rates)
    columns[name] = at_steps(flow, STEPS)

panels = [Panel([surface(states[row])], f"{name}, step {step}:\n"
                f"spread {100 * area_spread(states[row]):.0f} %, "
                f"mean angle {smallest_angles(states[row]).mean():.0f}\u00b0",
                zoom=1.7, direction=(0.0, 0.3, 1.0))
          for row, step in enumerate(STEPS) for name, states in columns.items()]
save(panels, columns=len(COLUMNS), height=160, same_scale=True)

last = {name: states[-1] for name, states in columns.items()}
for name, spread, angle in (("without", (0.45, 0.65), (30.0, 36.0)),
                            ("volume-based", (0.0, 0.03), (44.0, 50.0)),
                            ("angle-based", (0.3, 0.48), (36.5, 42.0)),
                            ("sum", (0.03, 0.1), (47.0, 52.0))):
    check(f"{name}: spread of co-volumes at the end", area_spread(last[name]), *spread)
    check(f"{name}: mean smallest angle", smallest_angles(last[name]).mean(), *angle)
    check(f"{name}: flipped triangles", flipped(last[name]), 0, 0)
