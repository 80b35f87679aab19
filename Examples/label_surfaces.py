# SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
# SPDX-License-Identifier: BSD-3-Clause
"""Smooth surfaces of all labels of a segmented image at once, that neither overlap nor leave gaps.

    label_surfaces.py [OUT.vtp]

A body of two halves with a kernel in it and a ring around, in voxels that are twice as high as
wide. Where labels touch they share their points; each keeps the volume of its voxels. Writes the
surfaces, one after another in one file, each label's by itself as STL, and a picture.
"""
import sys
from pathlib import Path

import evolvingsurfaces as es
import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkDataObject, vtkImageData
from vtkmodules.vtkFiltersCore import vtkThreshold
from vtkmodules.vtkFiltersGeometry import vtkGeometryFilter
from vtkmodules.vtkIOGeometry import vtkSTLWriter
from vtkmodules.vtkIOXML import vtkXMLPolyDataWriter

SPACING = np.array([0.5, 0.5, 1.0])
SIZE = np.array([96, 96, 48])
NORMAL = np.array([0.8, 0.36, 0.48])             # of the plane between the halves


def body(p):
    return np.linalg.norm(p, axis=-1) - 15.0


def plane(p):
    return p @ NORMAL - 1.0


def kernel(p):
    return np.linalg.norm(p - [2.0, -3.0, 1.0], axis=-1) - 6.0


def ring(p):
    u, w = 0.8 * p[..., 1] - 0.6 * p[..., 2], 0.6 * p[..., 1] + 0.8 * p[..., 2]
    return np.hypot(np.hypot(p[..., 0], u) - 18.0, w) - 4.0


voxels = np.stack(np.meshgrid(*(np.arange(n) for n in SIZE), indexing="ij"), axis=-1)
places = (voxels - 0.5 * SIZE + 0.3) * SPACING
labels = np.select([kernel(places) < 0, (body(places) < 0) & (plane(places) < 0),
                    body(places) < 0, ring(places) < 0], [3, 1, 2, 4], 0).astype(np.uint8)
image = vtkImageData()
image.SetDimensions(*(int(n) for n in SIZE))
image.SetSpacing(*SPACING)
image.SetOrigin(*places[0, 0, 0])
image.GetPointData().SetScalars(numpy_to_vtk(labels.ravel(order="F"), deep=True))

surfaces = es.vtkLabelSurfaces()
surfaces.SetInputData(image)
surfaces.Update()


def one(label, source=surfaces):
    """The closed surface of a label: a threshold of its cells."""
    cells = vtkThreshold()
    cells.SetInputConnection(source.GetOutputPort())
    cells.SetInputArrayToProcess(0, 0, 0, vtkDataObject.FIELD_ASSOCIATION_CELLS, "Label")
    cells.SetLowerThreshold(label)
    cells.SetUpperThreshold(label)
    surface = vtkGeometryFilter()
    surface.SetInputConnection(cells.GetOutputPort())
    return surface


out = Path(sys.argv[1] if len(sys.argv) > 1 else "label_surfaces.vtp")
writer = vtkXMLPolyDataWriter()
writer.SetFileName(str(out))
writer.SetDataModeToBinary()
writer.SetInputConnection(surfaces.GetOutputPort())
if not writer.Write():
    sys.exit(f"cannot write {out}")
for label in (1, 2, 3, 4):
    single = one(label)
    stl = vtkSTLWriter()
    stl.SetFileName(str(out.with_name(f"{out.stem}_{label}.stl")))
    stl.SetInputConnection(single.GetOutputPort())
    stl.Write()

# What it is worth, in numbers and in a picture.
sys.path.insert(0, str(Path(__file__).resolve().parent / "thesis"))

from drawing import surface  # noqa: E402
from evolutions import smallest_angles, triangles  # noqa: E402
from figures import check  # noqa: E402
from pictures import Panel, save  # noqa: E402

COLORS = {1: (0.86, 0.58, 0.42), 2: (0.53, 0.68, 0.82), 3: (0.93, 0.85, 0.55),
          4: (0.62, 0.76, 0.56)}


def off(source, label, neighbor, shape):
    """How far the triangles between two labels are turned from a shape, in degrees (rms), and how
    far they are from it, in voxels (mean)."""
    data = source.GetOutput().GetCellData()
    chosen = ((vtk_to_numpy(data.GetArray("Label")) == label) &
              (vtk_to_numpy(data.GetArray("NeighborLabel")) == neighbor))
    a, b, c = triangles(source.GetOutput())[chosen].astype(float).transpose(1, 0, 2)
    normal = np.cross(b - a, c - a)
    middle = (a + b + c) / 3.0
    gradient = np.stack([shape(middle + h) - shape(middle - h) for h in 1e-4 * np.eye(3)], axis=1)
    area = np.linalg.norm(normal, axis=1)
    cosine = np.einsum("ij,ij->i", normal, gradient) / area / np.linalg.norm(gradient, axis=1)
    angle = np.degrees(np.arccos(np.clip(np.abs(cosine), 0.0, 1.0)))
    return (np.sqrt(np.average(angle ** 2, weights=area)),
            np.average(np.abs(shape(middle)), weights=area) / SPACING.max())


stairs = es.vtkLabelSurfaces()
stairs.SetInputData(image)
stairs.SetSmoothingLength(0.0)
stairs.Update()


def view(source, label):
    return surface(one(label, source), color=COLORS[label], edges=False)


turned = {name: off(source, 4, 0, ring)[0] for name, source in (("voxels", stairs),
                                                                 ("surfaces", surfaces))}
save([Panel([view(stairs, label) for label in COLORS],
            f"faces of the voxels\nnormals of the ring off by {turned['voxels']:.2g}\u00b0"),
      Panel([view(surfaces, label) for label in COLORS],
            f"label surfaces\nnormals of the ring off by {turned['surfaces']:.2g}\u00b0"),
      Panel([view(surfaces, label) for label in (1, 3, 4)],
            "without one half: the kernel\nin the interface that both share")],
     out.with_suffix(".png"), same_scale=True)

field = surfaces.GetOutput().GetFieldData()
volume, wanted = (vtk_to_numpy(field.GetArray(name)) for name in ("Volume", "VoxelVolume"))
check("largest error of a volume, relative", np.abs(volume / wanted - 1.0).max(), 0.0, 1e-5)
for name, pair, shape in (("ring", (4, 0), ring), ("kernel in the first half", (3, 1), kernel),
                          ("kernel in the other", (3, 2), kernel), ("between halves", (1, 2), plane),
                          ("first half", (1, 0), body), ("other half", (2, 0), body)):
    normals, distance = off(surfaces, *pair, shape)
    check(f"{name}: normals off, in degrees", normals, 0.0, 7.0)
    check(f"{name}: mean distance, in voxels", distance, 0.0, 0.1)
angles = smallest_angles(surfaces.GetOutput())
check("first percentile of the smallest angles", np.percentile(angles, 1), 23.0, 60.0)
