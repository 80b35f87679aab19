# SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
# SPDX-License-Identifier: BSD-3-Clause
"""Figure 6.6: evolution towards a cube.

From the author's start sphere around the model, on a grid with 40 cells along the cube, without
redistribution: the advection draws points to edges and corners.
"""

import numpy as np

from drawing import BLUE, lines, surface
from evolutions import at_steps, evolution_towards, flipped, smallest_angles
from figures import array, check, column, model
from pictures import Panel, save

STEPS = (0, 15, 30, 60, 160)                     # the last ten of them smooth

cube = model("cube.obj")
flow = evolution_towards(cube, level=3)
states = at_steps(flow, STEPS)
save([Panel([surface(state), lines(cube, BLUE)], f"step {step}: mean distance\n"
            f"{array(state, 'MeanDistance')[0]:.3f} of the side")
      for step, state in zip(STEPS, states)], height=220)
last = states[-1]
distances = np.array(column(flow.GetOutputDataObject(1), "MeanDistance"))
check("largest ratio of successive mean distances, first 100 steps",
      (distances[1:101] / distances[:100]).max(), 0.9, 1.0)
check("mean distance at the end, in sides", array(last, "MeanDistance")[0], 0.0, 0.006)
check("largest distance at the end, in sides", array(last, "MaxDistance")[0], 0.0, 0.012)
check("volume at the end", array(last, "Volume")[0], 0.97, 1.03)
check("smallest angle at the end", smallest_angles(last).min(), 8.0, 20.0)
check("flipped triangles", max(flipped(state) for state in states), 0, 0)
