# SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
# SPDX-License-Identifier: BSD-3-Clause
"""A smooth surface of a label map, without its steps and no smaller than what it labels.

    label_map.py [OUT.vtp]

The contour of labels has the steps of the voxels. Surface diffusion takes them away within ten
voxels' fourth power of time: it holds the volume, and what is curved much less than a voxel stays
where it is. Mean curvature flow would do it, too, but shrinks all. Here the labels are those of a
shape that is known, so that the result can be compared. Writes the result and a picture.
"""
import sys
from pathlib import Path

import evolvingsurfaces as es
import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkFiltersCore import vtkFlyingEdges3D
from vtkmodules.vtkIOXML import vtkXMLPolyDataWriter

VOXEL = 0.8


def torus(x, y, z):
    """The distance from a torus that is turned a little."""
    u, w = 0.8 * y - 0.6 * z, 0.6 * y + 0.8 * z
    return np.hypot(np.hypot(x, u) - 14.0, w) - 6.0


axis = VOXEL * (np.arange(58) - 28.5)
z, y, x = np.meshgrid(axis, axis, axis, indexing="ij")
labels = vtkImageData()                          # 1 inside, 0 outside
labels.SetDimensions(58, 58, 58)
labels.SetSpacing(VOXEL, VOXEL, VOXEL)
labels.SetOrigin(axis[0], axis[0], axis[0])
labels.GetPointData().SetScalars(
    numpy_to_vtk((torus(x, y, z) < 0.0).astype(np.uint8).ravel(), deep=True))

contour = vtkFlyingEdges3D()
contour.SetInputData(labels)
contour.SetValue(0, 0.5)

evolution = es.vtkSurfaceEvolution()
evolution.SetInputConnection(contour.GetOutputPort())
evolution.SetFlowToSurfaceDiffusion()
evolution.SetRemeshingToUniform()
evolution.RelativeUnitsOff()
evolution.SetCurvatureSpeed(VOXEL ** 4)          # time in voxels' fourth power
evolution.SetTimeStep(1.0)
evolution.SetNumberOfSteps(10)

even = es.vtkTangentialRedistribution()
even.SetInputConnection(evolution.GetOutputPort())

out = Path(sys.argv[1] if len(sys.argv) > 1 else "label_map.vtp")
writer = vtkXMLPolyDataWriter()
writer.SetFileName(str(out))
writer.SetDataModeToBinary()
writer.SetInputConnection(even.GetOutputPort())
if not writer.Write():
    sys.exit(f"cannot write {out}")

# What it is worth, in numbers and in a picture.
sys.path.insert(0, str(Path(__file__).resolve().parent / "thesis"))

from drawing import surface  # noqa: E402
from evolutions import triangles  # noqa: E402
from figures import check, points  # noqa: E402
from pictures import Panel, save  # noqa: E402


def off(source):
    """How far faces are turned from the shape, in degrees (root mean square)."""
    a, b, c = triangles(source.GetOutput()).transpose(1, 0, 2)
    normal = np.cross(b - a, c - a)
    middle = (a + b + c) / 3.0
    gradient = np.stack([torus(*(middle + h).T) - torus(*(middle - h).T)
                         for h in 1e-4 * np.eye(3)], axis=1)
    gradient /= np.linalg.norm(gradient, axis=1)[:, None]
    area = np.linalg.norm(normal, axis=1)
    cosine = np.clip(np.abs(np.einsum("ij,ij->i", normal, gradient)) / area, 0.0, 1.0)
    return np.sqrt(np.average(np.degrees(np.arccos(cosine)) ** 2, weights=area))


turned = {"contour": off(contour), "evolution": off(evolution), "redistribution": off(even)}
save([Panel([surface(source)], f"{name}\nnormals off by {turned[name]:.2g}\u00b0", zoom=1.25)
      for name, source in (("contour", contour), ("evolution", evolution),
                           ("redistribution", even))], out.with_suffix(".png"))
distance = np.abs(torus(*points(even.GetOutput()).T)).mean() / VOXEL
check("mean distance from the shape, in voxels", distance, 0.0, 0.1)
check("normals of the result, in degrees", turned["redistribution"], 0.0, 3.0)
