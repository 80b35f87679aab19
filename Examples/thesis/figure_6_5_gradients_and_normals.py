# SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
# SPDX-License-Identifier: BSD-3-Clause
"""Figure 6.5: gradients of the distance (green) and normals (red) at an evolving surface's points.

Both are arrays of the evolution's output. The advection (3.8) is fast where they agree; they part
where the start sphere faces a concavity of the target, here beside the bunny's neck and ears.
"""

import numpy as np

from drawing import arrows, surface
from evolutions import at_steps, evolution_towards, sides
from figures import array, check, model, points
from pictures import Panel, save

STEPS = (10, 80)
GREEN, RED = (0.10, 0.55, 0.20), (0.80, 0.15, 0.12)

bunny = model("bunny.ply")
longest = sides(bunny).max()
states = at_steps(evolution_towards(bunny, level=3), STEPS)


def props(state, length):
    return [surface(state, edges=False), arrows(state, "DistanceGradient", length * longest, GREEN),
            arrows(state, "Normals", length * longest, RED)]


cosines = [np.sum(array(state, "DistanceGradient") * array(state, "Normals"), axis=1)
           for state in states]
panels = [Panel(props(state, 0.12), f"step {step}: gradient times normal\n"
                f"{cosine.mean():.2f} on average, {cosine.min():.2f} at least")
          for step, state, cosine in zip(STEPS, states, cosines)]
neck = tuple(points(states[-1])[cosines[-1].argmin()])
panels.append(Panel(props(states[-1], 0.06), f"step {STEPS[-1]}, where they part most",
                    zoom=3.5, center=neck))
save(panels, height=330)

for state in states:
    lengths = np.linalg.norm(array(state, "DistanceGradient"), axis=1)
    check("largest |1 - gradient|", np.abs(lengths - 1.0).max(), 0.0, 1e-5)
check("smallest gradient times normal, early", cosines[0].min(), 0.75, 0.9)
check("smallest gradient times normal, late", cosines[1].min(), 0.3, 0.6)
