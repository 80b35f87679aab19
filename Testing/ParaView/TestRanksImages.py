# SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
# SPDX-License-Identifier: BSD-3-Clause
"""Several ranks: images come in parts that equal the whole, and are contoured once."""

import numpy
import paraview.simple as pv
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkFiltersCore import vtkFlyingEdges3D

import ranks

SIZE = [24, 24, 24]
# The same bit for bit where the whole grid is computed, or every sample by itself; otherwise
# another triangle may be found that is about as near.
EXACT = 0.0
CLOSE = 0.25
CASES = (("Closest Point", "Automatic", CLOSE), ("Closest Point", "Winding Number", CLOSE),
         ("Closest Point", "Flood Fill", EXACT), ("Fast Sweeping", "Automatic", EXACT),
         ("Fast Sweeping", "Flood Fill", EXACT), ("Brute Force", "Pseudonormal", EXACT),
         ("Brute Force", "Winding Number", EXACT), ("Brute Force", "Unsigned", EXACT))


def check_image_parts(bunny, method, sign, bound):
    image = ranks.part(MeshSDF(Input=ranks.bunny_reader(), SampleDimensions=SIZE, Method=method,
                               Sign=sign))
    whole = ranks.whole_distance(bunny, method, sign).GetOutput()
    name = f"Mesh SDF, {method}, {sign}"
    ranks.check(name + ": a part", 0 < image.GetNumberOfPoints() < whole.GetNumberOfPoints(),
                str(image.GetExtent()))
    ranks.check(name + ": its place", image.GetOrigin() == whole.GetOrigin()
                and image.GetSpacing() == whole.GetSpacing())
    expected = ranks.in_part(whole, image, "SignedDistance")
    found = ranks.values(image, "SignedDistance")
    error = abs(found - expected).max()
    ranks.check(name + ": its values", error <= bound * whole.GetSpacing()[0],
                f"largest difference {error:.3g}")
    far = abs(expected) > bound * whole.GetSpacing()[0]
    ranks.check(name + ": its signs", (numpy.sign(found) == numpy.sign(expected))[far].all())
    ranks.check(name + ": all parts", ranks.total(image.GetNumberOfCells())
                == whole.GetNumberOfCells())


def area(surface):
    """The area of a surface's triangles that are this rank's own, not ghosts."""
    points = vtk_to_numpy(surface.GetPoints().GetData()).astype(float)
    corners = points[vtk_to_numpy(surface.GetPolys().GetConnectivityArray()).reshape(-1, 3)]
    ghosts = surface.GetCellData().GetArray("vtkGhostType")
    if ghosts:
        corners = corners[vtk_to_numpy(ghosts) == 0]
    sides = corners[:, 1:] - corners[:, :1]
    return numpy.linalg.norm(numpy.cross(sides[:, 0], sides[:, 1]), axis=1).sum() / 2


def check_contour_once(bunny, method):
    distance = MeshSDF(Input=ranks.bunny_reader(), SampleDimensions=SIZE, Method=method)
    contour = ranks.part(pv.Contour(Input=distance, ContourBy=["POINTS", "SignedDistance"],
                                    Isosurfaces=[0.5]))
    whole = vtkFlyingEdges3D()
    whole.SetInputData(ranks.whole_distance(bunny, method).GetOutput())
    whole.SetValue(0, 0.5)
    whole.Update()
    ratio = ranks.total(area(contour)) / area(whole.GetOutput())
    ranks.check(f"Contour of Mesh SDF, {method}: once", abs(ratio - 1) < 0.01, f"ratio {ratio:.4f}")


def main():
    ranks.load_plugin(globals())
    bunny = ranks.read_bunny()
    for method, sign, bound in CASES:
        check_image_parts(bunny, method, sign, bound)
    for method in ("Closest Point", "Fast Sweeping"):
        check_contour_once(bunny, method)
    print(f"rank {ranks.RANK}: all passed", flush=True)


main()
