# SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
# SPDX-License-Identifier: BSD-3-Clause
"""Figure 6.7: results after 150 steps with tau = 0.03 and 10 steps of smoothing, by co-volume.

Without redistribution points gather along edges, and the triangles of the arc are stretched in the
concavity, which the start sphere knew nothing of. The grid has 40 cells along the model: 120 x 88 x
100 samples for this arc (the author's arc: 120 x 115 x 96), 120^3 for the cube.
"""

import numpy as np

from drawing import colored, scalar_bar, sequential
from evolutions import area_spread, evolution_towards, flipped, sides
from figures import add_array, array, check, copy_of, model
from pictures import Panel, save

#                direction, zoom
VIEWS = {"arc": ((0.5, -1.0, -0.55), 1.2), "cube": ((0.5, -1.0, 0.55), 0.85)}
MODELS = {"arc": model("arc.vtk"), "cube": model("cube.obj")}
#                largest mean, largest distance, least and largest spread
LIMITS = {"arc": (0.006, 0.03, 0.45, 0.6), "cube": (0.006, 0.01, 0.35, 0.5)}


def relative(result, name, measure):
    """A distance, as a part of the model's longest side."""
    return array(result, measure)[0] / sides(MODELS[name]).max()


colors = sequential(0.0, 2.5)
panels, results = [], {}
for name, (direction, zoom) in VIEWS.items():
    result = results[name] = copy_of(evolution_towards(MODELS[name]))
    areas = np.asarray(array(result, "CoVolume"))
    add_array(result, "RelativeCoVolume", areas / areas.mean())
    panels.append(Panel([colored(result, "RelativeCoVolume", colors, edges=True)],
                        f"{name}: mean distance "
                        f"{100 * relative(result, name, 'MeanDistance'):.2f} % of the longest side",
                        direction=direction, up=(0.0, 0.0, 1.0), zoom=zoom))
save(panels, bar=scalar_bar(colors, "co-volume, relative to the mean"))

for name, result in results.items():
    mean, farthest, least, most = LIMITS[name]
    check(f"{name}: mean distance", relative(result, name, "MeanDistance"), 0.0, mean)
    check(f"{name}: largest distance", relative(result, name, "MaxDistance"), 0.0, farthest)
    check(f"{name}: spread of co-volumes", area_spread(result), least, most)
    check(f"{name}: flipped triangles", flipped(result), 0, 0)
