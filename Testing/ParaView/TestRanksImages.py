# SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
# SPDX-License-Identifier: BSD-3-Clause
"""Several ranks: images come in parts that equal the whole, and are contoured once."""

import numpy
import paraview.simple as pv
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkFiltersCore import vtkFlyingEdges3D

import ranks

SIZE = [24, 24, 24]
CASES = (("Closest Point", "Automatic"), ("Closest Point", "Winding Number"),
         ("Closest Point", "Flood Fill"), ("Fast Sweeping", "Automatic"),
         ("Fast Sweeping", "Flood Fill"), ("Brute Force", "Pseudonormal"),
         ("Brute Force", "Winding Number"), ("Brute Force", "Unsigned"))


def check_image_parts(bunny, method, sign):
    """A part has the bits of the whole."""
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
    ranks.check(name + ": its values", error == 0.0, f"largest difference {error:.3g}")
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
    for method, sign in CASES:
        check_image_parts(bunny, method, sign)
    for method in ("Closest Point", "Fast Sweeping"):
        check_contour_once(bunny, method)
    print(f"rank {ranks.RANK}: all passed", flush=True)


main()
