# SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
# SPDX-License-Identifier: BSD-3-Clause
"""Figure 6.11: the best attempt at the bunny by fixed connectivity, beside vtkShrinkWrap's result.

Volume-based redistribution keeps co-volumes even, the shapes of elements (AngleMethod) keep angles
off zero; but a sphere's triangles still stretch in concavities and do not reach their ground.
vtkShrinkWrap starts from an iso-surface of the distance, as the thesis's last paragraph suggests,
and has no such limit.
"""

import evolvingsurfaces as es
from drawing import colored, scalar_bar, sequential
from evolutions import evolution_towards, flipped, sides, smallest_angles
from figures import array, check, copy_of, dataset_adapter, model
from pictures import Panel, save

bunny = model("bunny.ply")
longest = sides(bunny).max()
evolved = copy_of(evolution_towards(bunny, VolumeRedistribution=1.0, AngleRedistribution=25.0,
                                    AngleMethod=1))
wrap = es.vtkShrinkWrap()
wrap.SetInputData(bunny)
wrapped = copy_of(wrap)

colors = sequential(0.0, 60.0)
panels = []
for name, result in {"sphere, fixed connectivity": evolved, "vtkShrinkWrap": wrapped}.items():
    angles = smallest_angles(result)
    dataset_adapter.WrapDataObject(result).CellData.append(angles, "SmallestAngle")
    panels.append(Panel([colored(result, "SmallestAngle", colors, edges=True, cells=True)],
                        f"{name}, {result.GetNumberOfPoints()} points:\nlargest distance "
                        f"{100 * array(result, 'MaxDistance')[0] / longest:.2f} %, "
                        f"angles from {angles.min():.1f}\u00b0"))
bar = scalar_bar(colors, "smallest angle of a triangle, degrees", form="%.0f")
save(panels, height=320, bar=bar)

check("evolved: smallest angle", smallest_angles(evolved).min(), 7.0, 20.0)
check("evolved: mean smallest angle", smallest_angles(evolved).mean(), 41.0, 48.0)
check("evolved: mean distance", array(evolved, "MeanDistance")[0] / longest, 0.0, 0.0095)
check("evolved: largest distance", array(evolved, "MaxDistance")[0] / longest, 0.0, 0.1)
check("evolved: flipped triangles", flipped(evolved), 0, 2)
check("wrapped: smallest angle", smallest_angles(wrapped).min(), 44.0, 60.0)
check("wrapped: mean smallest angle", smallest_angles(wrapped).mean(), 50.0, 60.0)
# The triangles lie on the bunny; so the vertices stand off a little where it is curved.
check("wrapped: mean distance", array(wrapped, "MeanDistance")[0] / longest, 0.0, 5e-4)
check("wrapped: largest distance", array(wrapped, "MaxDistance")[0] / longest, 0.0, 0.01)
check("wrapped: flipped triangles", flipped(wrapped), 0, 0)
