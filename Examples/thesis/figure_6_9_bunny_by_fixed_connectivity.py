# SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
# SPDX-License-Identifier: BSD-3-Clause
"""Figure 6.9: evolution towards the bunny without redistribution: the method's limit.

An icosphere of 10242 points and fixed connectivity. The start knows nothing of the concavities
between ears, neck and back: the triangles that are drawn into them are stretched until they have no
angles left. Figure 6.11 shows what redistribution saves, and what remeshing does.
"""

from drawing import colored, scalar_bar, sequential, surface
from evolutions import evolution_towards, flipped, sides, smallest_angles
from figures import array, check, copy_of, dataset_adapter, model
from pictures import Panel, save

BEHIND_EAR = (0.4, 6.8, 0.5)

bunny = model("bunny.ply")
result = copy_of(evolution_towards(bunny, level=5))
angles = smallest_angles(result)
dataset_adapter.WrapDataObject(result).CellData.append(angles, "SmallestAngle")

colors = sequential(0.0, 60.0)
stretched = colored(result, "SmallestAngle", colors, cells=True)
close_up = colored(result, "SmallestAngle", colors, edges=True, cells=True)
save([Panel([surface(result, edges=False)], "result: 10242 points"),
      Panel([stretched], f"{100 * (angles < 10.0).mean():.0f} % of the triangles: below 10\u00b0"),
      Panel([close_up], "behind the ear", zoom=4.0, center=BEHIND_EAR)],
     bar=scalar_bar(colors, "smallest angle of a triangle, degrees", form="%.0f"))

longest = sides(bunny).max()
check("mean distance by longest side", array(result, "MeanDistance")[0] / longest, 0.005, 0.012)
check("largest distance by longest side", array(result, "MaxDistance")[0] / longest, 0.05, 0.12)
check("mean smallest angle", angles.mean(), 30.0, 36.0)
check("smallest angle: as good as none", angles.min(), 0.0, 0.05)
check("part of the triangles with angles below 10 degrees", (angles < 10.0).mean(), 0.08, 0.15)
check("part of flipped triangles", flipped(result) / len(angles), 0.0, 0.001)
