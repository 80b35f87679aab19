# SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
# SPDX-License-Identifier: BSD-3-Clause
"""A real image, segmented with the defaults: the brain in an MR scan, from a sphere around it.

    brain_mr.py [FOLDER [PICTURE.png]]

The scan is the one of MRIcron, in Debian's package mricron-data (BSD-3-Clause): ch2bet.nii.gz, a
head of 1 mm voxels without its skull, and aal.nii.gz, an atlas of the regions of that same brain,
which the surface knows nothing of. FOLDER is where they are.

Nothing is set but that the field is an image: the edge detector is chosen from the image, the time
step from the start, and elements are renewed on the way.
"""

import sys
from pathlib import Path

import evolvingsurfaces as es
import numpy as np
from vtkmodules.numpy_interface import dataset_adapter
from vtkmodules.vtkFiltersCore import vtkContourFilter
from vtkmodules.vtkIOImage import vtkNIFTIImageReader
from vtkmodules.vtkRenderingCore import vtkColorTransferFunction

sys.path.insert(0, str(Path(__file__).resolve().parent / "thesis"))

from drawing import RED, image_slice, lines, surface  # noqa: E402
from figures import add_array, array, check, copy_of, points  # noqa: E402
from pictures import Panel, save  # noqa: E402

SKIPPED = 77                                     # what tests take for "cannot be tried here"
SLICES = ((0, 75), (1, 115), (2, 80))            # axis and voxel
folder = Path(sys.argv[1] if len(sys.argv) > 1 else "/usr/share/mricron/templates")


def read(name):
    if not (folder / name).is_file():
        print(f"There is no {name} in {folder}, expected the images of MRIcron: install Debian's "
              "package mricron-data, or give the folder they are in.", file=sys.stderr)
        sys.exit(SKIPPED)
    reader = vtkNIFTIImageReader()
    reader.SetFileName(str(folder / name))
    return copy_of(reader)


def voxels(image):
    """The values as a flat array, x fastest."""
    return np.asarray(dataset_adapter.WrapDataObject(image).PointData[0])


def inside(mesh, image):
    """Which voxels have their middles within a closed surface."""
    distance = es.vtkMeshSDF()                   # at the image's own samples
    distance.SetInputData(mesh)
    distance.SetSampleDimensions(image.GetDimensions())
    distance.SetModelBounds(image.GetBounds())
    return voxels(copy_of(distance)) < 0.0


def section(mesh, axis, place):
    """Where a surface meets a slice."""
    add_array(mesh, "Place", np.asarray(points(mesh))[:, axis].copy())
    curves = vtkContourFilter()
    curves.SetInputData(mesh)
    curves.SetInputArrayToProcess(0, 0, 0, 0, "Place")
    curves.SetValue(0, place)
    return copy_of(curves)


scan, atlas = read("ch2bet.nii.gz"), read("aal.nii.gz")
start = es.vtkIcosphereSource()
start.SetLevel(4)
start.SetRadius(110.0)                           # millimetres
start.SetCenter(90.0, 108.0, 75.0)

flow = es.vtkSurfaceEvolution()
flow.SetInputConnection(0, start.GetOutputPort())
flow.SetInputData(1, scan)
flow.SetFieldModeToImage()
result = copy_of(flow)

gray = vtkColorTransferFunction()
gray.AddRGBPoint(0.0, 0.0, 0.0, 0.0)
gray.AddRGBPoint(130.0, 1.0, 1.0, 1.0)
looks = {0: ((1.0, 0.0, 0.0), (0.0, 0.0, 1.0)), 1: ((0.0, -1.0, 0.0), (0.0, 0.0, 1.0)),
         2: ((0.0, 0.0, 1.0), (0.0, 1.0, 0.0))}
panels = []
for axis, index in SLICES:
    towards, up = looks[axis]
    slab = image_slice(scan, axis, index, gray)
    slab.SetPosition([-300.0 * d for d in towards])         # behind the contour
    panels.append(Panel([slab, lines(section(result, axis, index), RED, 3.0)],
                        f"{'xyz'[axis]} = {index} mm", direction=towards, up=up, zoom=1.3))
panels.append(Panel([surface(result)], "the result", direction=(-0.7, 0.6, 0.4), up=(0.0, 0.0, 1.0),
                    zoom=1.1))
save(panels, sys.argv[2] if len(sys.argv) > 2 else "brain_mr.png", height=280)

brain, found, regions = voxels(scan) > 0, inside(result, scan), voxels(atlas) > 0
both = np.count_nonzero(brain & found)
check("volume of the surface by that of the brain's voxels",
      array(result, "Volume")[0] / np.count_nonzero(brain), 0.97, 1.03)
check("overlap with the brain's voxels (Dice)",
      2.0 * both / (np.count_nonzero(brain) + np.count_nonzero(found)), 0.95, 1.0)
regions &= brain                                 # those that the scan shows
check("part of the atlas's regions that is inside",
      np.count_nonzero(regions & found) / np.count_nonzero(regions), 0.97, 1.0)
check("smallest angle, in degrees", array(result, "MinAngle")[0], 20.0, 60.0)
