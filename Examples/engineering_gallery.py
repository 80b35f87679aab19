# SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
# SPDX-License-Identifier: BSD-3-Clause
"""Shapes that engineers bring, and beside each what vtkShrinkWrap makes of it.

    engineering_gallery.py [PICTURE.jpg]
"""

import sys
from pathlib import Path

import evolvingsurfaces as es

sys.path.insert(0, str(Path(__file__).resolve().parent / "thesis"))

from drawing import surface  # noqa: E402
from figures import array, check, copy_of, model  # noqa: E402
from pictures import Panel, save  # noqa: E402

# The file, about how many points, from where to look and how near.
SHAPES = {"clamp.obj": (3000, (0.7, 0.4, 0.5), 1.0),
          "perforated_sheet.obj": (5000, (0.4, -0.8, 0.9), 1.0),
          "bracket.vtk": (3000, (0.7, 0.9, 0.5), 1.0),
          "rib_cooler.obj": (6000, (0.5, -1.0, 0.7), 1.0),
          "bowl.ply": (3000, (0.6, -1.0, 0.9), 1.0),
          "bar_heap.ply": (4000, (0.4, -1.0, 0.8), 1.25)}

panels, results = [], {}
for name, (number, direction, zoom) in SHAPES.items():
    shape = model(name)
    wrap = es.vtkShrinkWrap()
    wrap.SetInputData(shape)
    wrap.SetTargetNumberOfPoints(number)
    results[name] = result = copy_of(wrap)
    title = Path(name).stem.replace("_", " ")
    for data, what in ((shape, title), (result, "wrapped")):
        caption = f"{what}, {data.GetNumberOfPoints()} points"
        panels.append(Panel([surface(data)], caption, direction=direction, up=(0.0, 0.0, 1.0),
                            zoom=zoom))
path = sys.argv[1] if len(sys.argv) > 1 else "engineering_gallery.jpg"
save(panels, path, columns=4, height=260)

for name, result in results.items():
    check(f"{name}: is closed", array(result, "IsClosed")[0], 1, 1)
    check(f"{name}: intersections", array(result, "SelfIntersections")[0], 0, 0)
    check(f"{name}: smallest angle", array(result, "MinAngle")[0], 20.0, 60.0)
