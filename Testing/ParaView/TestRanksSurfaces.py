# SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
# SPDX-License-Identifier: BSD-3-Clause
"""Several ranks: a surface exists once, on the first rank, and is the serial one bit for bit."""

import paraview.simple as pv
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkFiltersSources import vtkSphereSource

import evolvingsurfaces as es
import ranks

SIZE = [24, 24, 24]


def check_surface_once(name, proxy, reference):
    surface = ranks.part(proxy)
    reference.Update()
    expected = reference.GetOutput()
    points = expected.GetNumberOfPoints()
    ranks.check(name + ": once", ranks.total(surface.GetNumberOfPoints()) == points,
                f"{surface.GetNumberOfPoints()} of {points} points")
    is_here = surface.GetNumberOfPoints() > 0
    ranks.check(name + ": on the first rank", is_here == (ranks.RANK == 0))
    if ranks.RANK == 0:
        same = (vtk_to_numpy(surface.GetPoints().GetData())
                == vtk_to_numpy(expected.GetPoints().GetData())).all()
    ranks.check(name + ": as in a serial run", ranks.RANK > 0 or same)
    ranks.check(name + ": the same arrays", ranks.array_names(surface.GetPointData())
                == ranks.array_names(expected.GetPointData()))


def check_history_once(name, proxy, reference):
    rows = ranks.part(proxy, 1).GetNumberOfRows()
    expected = reference.GetOutputDataObject(1).GetNumberOfRows()
    ranks.check(name + ": one history", ranks.total(rows) == expected,
                f"{rows} of {expected} rows")


def check_evolution(name, source, surface):
    """The source as a proxy, and its whole as data."""
    reference = es.vtkSurfaceEvolution()
    reference.SetInputData(surface)
    reference.SetNumberOfSteps(3)
    evolution = SurfaceEvolution(Input=source, NumberOfSteps=3)
    check_surface_once(name, evolution, reference)
    check_history_once(name, evolution, reference)
    return reference


def check_shrink_wrap(source, surface):
    reference = es.vtkShrinkWrap()
    reference.SetInputData(surface)
    reference.SetSampleDimensions(*SIZE)
    reference.SetTargetEdgeLength(0.2)
    wrap = ShrinkWrap(Input=source, SampleDimensions=SIZE, TargetEdgeLength=0.2)
    check_surface_once("Shrink Wrap", wrap, reference)
    check_history_once("Shrink Wrap", wrap, reference)


def check_boxes(structure):
    reference = es.vtkDistanceHierarchy()
    reference.SetInputData(ranks.read_bunny())
    reference.SetSampleDimensions(*SIZE)
    ranks.set_enum(reference, "Structure", structure)
    boxes = DistanceHierarchy(Input=ranks.bunny_reader(), SampleDimensions=SIZE,
                              Structure=structure)
    check_surface_once(f"Distance Hierarchy, {structure}", boxes, reference)


def sphere_source():
    """VTK's sphere, which makes pieces: with seams, where a whole has none."""
    source = vtkSphereSource()
    source.SetThetaResolution(24)
    source.SetPhiResolution(16)
    source.Update()
    return source.GetOutput()


def check_reader_once_after(bunny):
    """A filter behind a reader does not make it read the file on every rank, to be drawn there."""
    reader = ranks.bunny_reader()
    ranks.part(MeshSDF(Input=reader, SampleDimensions=SIZE))
    points = ranks.total(ranks.part(reader).GetNumberOfPoints())
    ranks.check("A reader: once after Mesh SDF", points == bunny.GetNumberOfPoints(), str(points))


def main():
    ranks.load_plugin(globals())
    source = es.vtkIcosphereSource()
    source.SetLevel(3)
    source.Update()
    sphere = Icosphere(Level=3)
    ranks.check("Icosphere: once", ranks.total(ranks.part(sphere).GetNumberOfPoints()) == 642)
    check_evolution("Surface Evolution", sphere, source.GetOutput())
    check_evolution("Surface Evolution of pieces", pv.Sphere(ThetaResolution=24, PhiResolution=16),
                    sphere_source())
    check_shrink_wrap(sphere, source.GetOutput())
    for structure in ("AABB Tree", "Octree"):
        check_boxes(structure)
    bunny = ranks.read_bunny()
    reference = es.vtkTangentialRedistribution()
    reference.SetInputData(bunny)
    reference.SetNumberOfSteps(1)
    check_surface_once("Tangential Redistribution",
                       TangentialRedistribution(Input=ranks.bunny_reader(), NumberOfSteps=1),
                       reference)
    check_reader_once_after(bunny)
    print(f"rank {ranks.RANK}: all passed", flush=True)


main()
