# SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
# SPDX-License-Identifier: BSD-3-Clause
"""Two ranks: images come in parts that equal the whole, surfaces exist once.

    mpirun -np 2 pvbatch --sym TestRanks.py PLUGIN_FILE DATA_FOLDER

Every rank runs the script on its own part; the references are computed by each rank alone.
"""

import sys

import numpy
import paraview.simple as pv
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkDoubleArray
from vtkmodules.vtkFiltersCore import vtkFlyingEdges3D
from vtkmodules.vtkIOPLY import vtkPLYReader
from vtkmodules.vtkParallelCore import vtkCommunicator, vtkMultiProcessController

import evolvingsurfaces as es

DATA = sys.argv[2]
pv.LoadPlugin(sys.argv[1], ns=globals())
CONTROLLER = vtkMultiProcessController.GetGlobalController()
RANK = CONTROLLER.GetLocalProcessId()
RANKS = CONTROLLER.GetNumberOfProcesses()


def total(value):
    """The sum over all ranks."""
    mine = numpy_to_vtk(numpy.array([float(value)]), deep=True)
    everyone = vtkDoubleArray()
    everyone.SetNumberOfTuples(1)
    CONTROLLER.AllReduce(mine, everyone, vtkCommunicator.SUM_OP)
    return everyone.GetValue(0)


def check(name, holds, detail=""):
    """All ranks must agree, or all stop."""
    passed = total(1 if holds else 0) == RANKS
    print(f"rank {RANK}: {name}: {'passed' if holds else 'FAILED'} {detail}", flush=True)
    if not passed:
        CONTROLLER.Barrier()
        sys.exit(1)


def part(proxy, port=0):
    pv.UpdatePipeline(proxy=proxy)
    return proxy.GetClientSideObject().GetOutputDataObject(port)


def alone(filter_, input_):
    filter_.SetInputData(input_)
    return filter_


def check_image_parts(bunny, method, sign):
    proxy = MeshSDF(Input=bunny_reader(), SampleDimensions=[24, 24, 24], Method=method, Sign=sign)
    image = part(proxy)
    reference = alone(es.vtkMeshSDF(), bunny)
    reference.SetSampleDimensions(24, 24, 24)
    getattr(reference, "SetMethodTo" + method.replace(" ", ""))()
    getattr(reference, "SetSignTo" + sign.replace(" ", ""))()
    reference.Update()
    whole = reference.GetOutput()
    name = f"Mesh SDF, {method}, {sign}"
    x0, x1, y0, y1, z0, z1 = image.GetExtent()
    check(name + ": a part", 0 < image.GetNumberOfPoints() < whole.GetNumberOfPoints(),
          str(image.GetExtent()))
    check(name + ": its place", image.GetOrigin() == whole.GetOrigin()
          and image.GetSpacing() == whole.GetSpacing())
    shape = (24, 24, 24)
    expected = vtk_to_numpy(whole.GetPointData().GetScalars()).reshape(shape)
    expected = expected[z0:z1 + 1, y0:y1 + 1, x0:x1 + 1].ravel()
    found = vtk_to_numpy(image.GetPointData().GetArray("SignedDistance"))
    error = abs(found - expected).max()
    # Brute force is the same bit for bit; the others may find another triangle as near.
    bound = 0.0 if method == "Brute Force" else 0.25 * whole.GetSpacing()[0]
    check(name + ": its values", error <= bound, f"largest difference {error:.3g}")


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
    distance = MeshSDF(Input=bunny_reader(), SampleDimensions=[24, 24, 24], Method=method)
    contour = part(pv.Contour(Input=distance, ContourBy=["POINTS", "SignedDistance"],
                              Isosurfaces=[0.5]))
    reference = alone(es.vtkMeshSDF(), bunny)
    reference.SetSampleDimensions(24, 24, 24)
    getattr(reference, "SetMethodTo" + method.replace(" ", ""))()
    whole = vtkFlyingEdges3D()
    whole.SetInputConnection(reference.GetOutputPort())
    whole.SetValue(0, 0.5)
    whole.Update()
    ratio = total(area(contour)) / area(whole.GetOutput())
    check(f"Contour of Mesh SDF, {method}: once", abs(ratio - 1) < 0.01, f"ratio {ratio:.4f}")


def check_surface_once(name, proxy, reference):
    surface = part(proxy)
    reference.Update()
    expected = reference.GetOutput().GetNumberOfPoints()
    check(name + ": once", total(surface.GetNumberOfPoints()) == expected,
          f"{surface.GetNumberOfPoints()} of {expected} points")
    check(name + ": on the first rank", (surface.GetNumberOfPoints() > 0) == (RANK == 0))
    rows = part(proxy, 1).GetNumberOfRows()
    expected = reference.GetOutputDataObject(1).GetNumberOfRows()
    check(name + ": one history", total(rows) == expected, f"{rows} of {expected} rows")
    names = {surface.GetPointData().GetArrayName(i)
             for i in range(surface.GetPointData().GetNumberOfArrays())}
    check(name + ": the same arrays", {"Normals", "MeanCurvature", "CoVolume"} <= names)


def bunny_reader():
    return PLYReader(FileNames=[DATA + "/bunny.ply"])


def read_bunny():
    reader = vtkPLYReader()
    reader.SetFileName(DATA + "/bunny.ply")
    reader.Update()
    return reader.GetOutput()


def main():
    check("ranks", RANKS == 2, str(RANKS))
    bunny = read_bunny()
    for method, sign in (("Closest Point", "Automatic"), ("Brute Force", "Pseudonormal"),
                         ("Closest Point", "Winding Number"), ("Fast Sweeping", "Flood Fill")):
        check_image_parts(bunny, method, sign)
    for method in ("Closest Point", "Fast Sweeping"):
        check_contour_once(bunny, method)

    sphere = Icosphere(Level=3)
    check("Icosphere: once", total(part(sphere).GetNumberOfPoints()) == 642)
    evolution = SurfaceEvolution(Input=sphere, NumberOfSteps=3)
    source = es.vtkIcosphereSource()
    reference = es.vtkSurfaceEvolution()
    reference.SetInputConnection(source.GetOutputPort())
    reference.SetNumberOfSteps(3)
    check_surface_once("Surface Evolution", evolution, reference)

    wrap = ShrinkWrap(Input=sphere, SampleDimensions=[24, 24, 24], TargetEdgeLength=0.2)
    reference = es.vtkShrinkWrap()
    reference.SetInputConnection(source.GetOutputPort())
    reference.SetSampleDimensions(24, 24, 24)
    reference.SetTargetEdgeLength(0.2)
    check_surface_once("Shrink Wrap", wrap, reference)

    even = TangentialRedistribution(Input=bunny_reader(), NumberOfSteps=1)
    points = total(part(even).GetNumberOfPoints())
    check("Tangential Redistribution: once", points == bunny.GetNumberOfPoints(), str(points))
    print(f"rank {RANK}: all passed", flush=True)


main()
