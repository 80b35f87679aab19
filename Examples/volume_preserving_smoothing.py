# SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
# SPDX-License-Identifier: BSD-3-Clause
"""A noisy scan, smoothed by mean curvature flow and by the flow that keeps the volume.

    volume_preserving_smoothing.py [PICTURE.png]

Both are given the same time, a quarter of a squared edge: noise from point to point is gone by then. Mean curvature
flow also moves the whole inwards; VolumePreserving gives back as much.
"""

import sys
from pathlib import Path

import evolvingsurfaces as es
import numpy as np
from vtkmodules.vtkFiltersCore import vtkImplicitPolyDataDistance

sys.path.insert(0, str(Path(__file__).resolve().parent / "thesis"))

from drawing import colored, diverging, scalar_bar, surface  # noqa: E402
from evolutions import moved, triangles  # noqa: E402
from figures import add_array, array, check, column, copy_of, model, points  # noqa: E402
from pictures import Panel, save  # noqa: E402

STEPS = 10

scan = model("bunny.ply")
normals = es.vtkTangentialRedistribution()       # for its array of normals
normals.SetInputData(scan)
normals.SetNumberOfSteps(0)
normals.Update()
corners = triangles(scan)
edge = np.linalg.norm(corners[:, 1] - corners[:, 0], axis=1).mean()
random = np.random.default_rng(1)
heights = 0.2 * edge * random.normal(size=(scan.GetNumberOfPoints(), 1))
noisy = moved(normals, lambda xyz: xyz + heights * array(normals.GetOutput(), "Normals"))


def smoothed(keeps_volume):
    flow = es.vtkSurfaceEvolution()
    flow.SetInputData(noisy)
    flow.SetVolumePreserving(keeps_volume)
    flow.RelativeUnitsOff()
    flow.SetCurvatureSpeed(1.0)                  # length^2/time
    flow.SetTimeStep(0.25 * edge ** 2 / STEPS)
    flow.SetNumberOfSteps(STEPS)
    return flow


def with_distance(flow):
    """The result, with the signed distance of its points from the scan without noise."""
    result = copy_of(flow)
    distance = vtkImplicitPolyDataDistance()
    distance.SetInput(scan)
    values = np.array([distance.EvaluateFunction(p) for p in points(result)])
    add_array(result, "Distance", values / edge)
    return result, values / edge


def panel(props, caption):
    return Panel(props, caption, direction=(0.25, 0.2, 1.0))


flows = [smoothed(False), smoothed(True)]
results = [with_distance(flow) for flow in flows]
volumes = [column(flow.GetOutputDataObject(1), "Volume") for flow in flows]
changes = [volume[-1] / volume[0] - 1.0 for volume in volumes]
colors = diverging(1.0)
save([panel([surface(noisy, edges=False)], "a noisy scan"),
      panel([colored(results[0][0], "Distance", colors)],
            f"mean curvature flow: volume {100 * changes[0]:+.1f} %"),
      panel([colored(results[1][0], "Distance", colors)],
            f"volume-preserving: {100 * abs(changes[1]):+.1f} %")],
     width=900, height=300, same_scale=True,
     bar=scalar_bar(colors, "distance from the scan without noise, in edges", 3))

check("mean curvature flow: change of volume", changes[0], -0.2, -0.005)
check("volume-preserving: change of volume", abs(changes[1]), 0.0, 1e-10)
kept, lost = (abs(np.mean(values)) for _, values in (results[1], results[0]))
check("volume-preserving: mean distance, in edges", kept, 0.0, 0.1)
check("mean curvature flow: mean distance, in edges", lost, 3.0 * kept, 3.0)
area = column(flows[1].GetOutputDataObject(1), "Area")
check("largest growth of the area in a step", max(np.diff(area)), -1e300, 0.0)
