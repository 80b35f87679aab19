# SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
# SPDX-License-Identifier: BSD-3-Clause
"""A bar of metal in the heat: surface diffusion makes a ball of it, of the same volume.

    surface_diffusion.py [PICTURE.png]

Atoms wander along the surface from where it is curved to where it is not: d_t F = Laplace_S H N. The
area falls as fast as it can while nothing is lost.
"""

import sys
from math import pi
from pathlib import Path

import evolvingsurfaces as es
import numpy as np
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkFiltersGeometry import vtkGeometryFilter

sys.path.insert(0, str(Path(__file__).resolve().parent / "thesis"))

from drawing import colored, scalar_bar, sequential  # noqa: E402
from figures import array, at_time, check, column, points  # noqa: E402
from pictures import Panel, save  # noqa: E402

N = 14                                           # edges per unit of length
box = vtkImageData()                             # 4 x 1 x 1
box.SetDimensions(4 * N + 1, N + 1, N + 1)
box.SetSpacing(1.0 / N, 1.0 / N, 1.0 / N)
box.SetOrigin(-2.0, -0.5, -0.5)
bar = vtkGeometryFilter()                        # its surface: quads
bar.SetInputData(box)

diffusion = es.vtkSurfaceEvolution()
diffusion.SetInputConnection(bar.GetOutputPort())
diffusion.SetFlowToSurfaceDiffusion()            # until it rests: the time step is automatic
diffusion.SetNumberOfSteps(100)

states = [at_time(diffusion, step) for step in (0, 2, 12, 30, 100)]
colors = sequential(0.0, 5.0)
save([Panel([colored(state, "MeanCurvature", colors, edges=True)],
            f"t = {array(state, 'Time')[0]:.3f}\narea {array(state, 'Area')[0]:.2f}",
            direction=(0.5, -1.0, 0.5), up=(0.0, 0.0, 1.0), zoom=1.1) for state in states],
     width=1200, height=190, same_scale=True,
     bar=scalar_bar(colors, "mean curvature", 3))

history = diffusion.GetOutputDataObject(1)
volume, area = column(history, "Volume"), column(history, "Area")
check("largest change of the volume", max(abs(np.divide(volume, 4.0) - 1.0)), 0.0, 1e-10)
check("largest growth of the area in a step", max(np.diff(area)), -1e300, 0.0)
radius = (3.0 / pi) ** (1.0 / 3.0)               # of the ball of volume 4
radii = np.linalg.norm(points(states[-1]), axis=1)
check("smallest radius against the ball's", radii.min() / radius, 0.99, 1.01)
check("largest radius against the ball's", radii.max() / radius, 0.99, 1.01)
check("smallest angle, degrees", array(states[-1], "MinAngle")[0], 20.0, 60.0)
