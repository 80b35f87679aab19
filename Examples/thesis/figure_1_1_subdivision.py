# SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
# SPDX-License-Identifier: BSD-3-Clause
"""Figure 1.1: four steps of subdivision of an icosahedron, a cube and a cube-sphere.

    figure_1_1_subdivision.py [PICTURE.png]
"""
from math import log2, pi

import evolvingsurfaces as es
from drawing import surface
from figures import check
from pictures import Panel, save
from vtkmodules.vtkFiltersCore import vtkMassProperties, vtkTriangleFilter

STEPS = range(5)                                 # the primitive and four subdivisions of it
Icosphere, Box, CubeSphere = (es.vtkIcosphereSource.ICOSPHERE, es.vtkIcosphereSource.BOX,
                              es.vtkIcosphereSource.CUBE_SPHERE)


def primitive(shape, step):
    source = es.vtkIcosphereSource()
    source.SetShape(shape)
    source.SetLevel(step)
    source.SetResolution(2 ** step)              # of the two that are made of quads
    source.SetRadius(0.75 if shape == Box else 1.0)
    source.Update()
    return source


def count(source):
    return source.GetOutput().GetNumberOfPoints()


def missing_volume(source):
    """What the polyhedron lacks of the unit ball."""
    triangles = vtkTriangleFilter()
    triangles.SetInputConnection(source.GetOutputPort())
    mass = vtkMassProperties()
    mass.SetInputConnection(triangles.GetOutputPort())
    return 4.0 / 3.0 * pi - mass.GetVolume()


rows = {shape: [primitive(shape, step) for step in STEPS] for shape in (Icosphere, Box, CubeSphere)}
save([Panel([surface(source)], f"{count(source)} points")
      for row in rows.values() for source in row], columns=len(STEPS), width=900, height=160,
     same_scale=True)

for step in STEPS:
    check(f"points of icosphere {step}", count(rows[Icosphere][step]), *[10 * 4 ** step + 2] * 2)
    check(f"points of cube {step}", count(rows[Box][step]), *[6 * 4 ** step + 2] * 2)
    check(f"points of cube-sphere {step}", count(rows[CubeSphere][step]), *[6 * 4 ** step + 2] * 2)
for shape, name in ((Icosphere, "icosphere"), (CubeSphere, "cube-sphere")):
    last, finest = map(missing_volume, rows[shape][-2:])
    check(f"order in which the {name} approaches the ball", log2(last / finest), 1.9, 2.1)
