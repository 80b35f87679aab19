# SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
# SPDX-License-Identifier: BSD-3-Clause
"""Several ranks: an input that is spread over them gives what the whole input gives."""

import numpy
import paraview.simple as pv
from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPlane, vtkPolyData
from vtkmodules.vtkFiltersCore import vtkClipPolyData

import evolvingsurfaces as es
import ranks
from ranks import RANK, RANKS, check

SIZE = [24, 24, 24]
# Global ids of the cells start here, so that they are no numbers of cells.
FIRST_ID = 7000


def cells_of(surface, first, last, spare=0):
    """The triangles of a range with global ids, and spare ones as ghosts."""
    corners = vtk_to_numpy(surface.GetPolys().GetConnectivityArray()).reshape(-1, 3)
    end = min(last + spare, len(corners))
    cells = vtkCellArray()
    cells.SetData(3, numpy_to_vtkIdTypeArray(corners[first:end].ravel().copy(), deep=True))
    part = vtkPolyData()
    part.SetPoints(surface.GetPoints())
    part.SetPolys(cells)
    numbers = numpy_to_vtkIdTypeArray(FIRST_ID + numpy.arange(first, end), deep=True)
    numbers.SetName("Number")
    part.GetCellData().SetGlobalIds(numbers)
    ghosts = numpy_to_vtk((numpy.arange(first, end) >= last).astype(numpy.uint8), deep=True)
    ghosts.SetName("vtkGhostType")
    if spare:
        part.GetCellData().AddArray(ghosts)
    return part


def own_part(surface, holders, spare=0):
    """This rank's cells of a surface that only the holders have something of."""
    if RANK not in holders:
        return vtkPolyData()
    cells = surface.GetNumberOfCells()
    i = holders.index(RANK)
    return cells_of(surface, i * cells // len(holders), (i + 1) * cells // len(holders), spare)


def distance_of(part, method="Brute Force"):
    filter_ = es.vtkMeshSDF()
    filter_.SetInputData(part)
    filter_.SetSampleDimensions(*SIZE)
    filter_.ComputeClosestCellIdOn()
    ranks.set_enum(filter_, "Method", method)
    filter_.UpdatePiece(RANK, RANKS, 0)
    return filter_.GetOutput()


def check_redistributed(whole, method):
    source = ranks.redistributed(ranks.bunny_reader())
    cells = ranks.part(source).GetNumberOfCells()
    check("redistributed: parts", 0 < cells < whole.GetInput().GetNumberOfCells(), f"{cells} cells")
    image = ranks.part(MeshSDF(Input=source, SampleDimensions=SIZE, Method=method))
    found = ranks.values(image, "SignedDistance")
    expected = ranks.in_part(whole.GetOutput(), image, "SignedDistance")
    error = abs(found - expected).max()
    check(f"redistributed, {method}: distances", error == 0.0, f"largest difference {error:.3g}")
    check("redistributed: sign method", image.GetFieldData().GetArray("SignMethod").GetValue(0)
          == whole.GetOutput().GetFieldData().GetArray("SignMethod").GetValue(0))


def check_split_by_hand(name, whole, holders, spare=0):
    image = distance_of(own_part(whole.GetInput(), holders, spare))
    for array, first in (("SignedDistance", 0), ("ClosestCellId", FIRST_ID)):
        expected = first + ranks.in_part(whole.GetOutput(), image, array)
        check(f"{name}: {array}", (ranks.values(image, array) == expected).all())


def check_numbering(whole):
    """Without global ids cells are counted rank after rank."""
    part = own_part(whole.GetInput(), list(range(RANKS)))
    part.GetCellData().Initialize()
    image = distance_of(part)
    expected = ranks.in_part(whole.GetOutput(), image, "ClosestCellId")
    check("cells without ids: rank after rank",
          (ranks.values(image, "ClosestCellId") == expected).all())


def check_points(whole):
    """A point set of which every rank has some points and no cells."""
    points = vtk_to_numpy(whole.GetInput().GetPoints().GetData())

    def cloud(some):
        data = vtkPolyData()
        data.SetPoints(vtkPoints())
        data.GetPoints().SetData(numpy_to_vtk(some, deep=True))
        return data
    image = distance_of(cloud(points[RANK::RANKS]))
    reference = ranks.whole_distance(cloud(points), "Brute Force").GetOutput()
    expected = ranks.in_part(reference, image, "SignedDistance")
    check("points: distances", (ranks.values(image, "SignedDistance") == expected).all())


def check_kept_data(bunny):
    """Tangential Redistribution: the gathered data on the first rank, the arrays on all."""
    filter_ = es.vtkTangentialRedistribution()
    filter_.SetInputData(own_part(bunny, list(range(1, RANKS)), spare=100))
    filter_.SetNumberOfSteps(1)
    filter_.UpdatePiece(RANK, RANKS, 0)
    output = filter_.GetOutput()
    numbers = output.GetCellData().GetArray("Number")
    check("kept data: the array", numbers is not None)
    expected = FIRST_ID + numpy.arange(bunny.GetNumberOfCells() if RANK == 0 else 0)
    check("kept data: its values", numpy.array_equal(vtk_to_numpy(numbers), expected))
    check("kept data: new arrays", "CoVolume" in ranks.array_names(output.GetPointData()))
    check("kept data: on the first rank", (output.GetNumberOfCells() > 0) == (RANK == 0))


def check_surface(name, proxy):
    surface = ranks.part(proxy)
    check(name + " of parts: on the first rank", (surface.GetNumberOfPoints() > 0) == (RANK == 0),
          f"{surface.GetNumberOfPoints()} points")
    return surface


def check_extent(name, proxy, radius):
    """A result as large as the sphere on all sides; that of a part would end at a seam."""
    surface = check_surface(name, proxy)
    off = max(abs(abs(bound) - radius) for bound in surface.GetBounds())
    check(name + " of parts: all of it", RANK > 0 or off < 0.05, str(surface.GetBounds()))


def check_surface_filters():
    """Each of them works on the whole."""
    source = es.vtkIcosphereSource()
    source.SetLevel(3)
    source.Update()
    evolved = es.vtkSurfaceEvolution()
    evolved.SetInputData(source.GetOutput())
    evolved.SetNumberOfSteps(3)
    evolved.Update()
    sphere = ranks.redistributed(Icosphere(Level=3))
    check_extent("Surface Evolution", SurfaceEvolution(Input=sphere, NumberOfSteps=3),
                 evolved.GetOutput().GetBounds()[1])
    check_extent("Shrink Wrap", ShrinkWrap(Input=sphere, SampleDimensions=SIZE,
                                           TargetEdgeLength=0.2), 1.0)
    tree = es.vtkDistanceHierarchy()
    tree.SetInputData(source.GetOutput())
    tree.Update()
    expected = tree.GetOutput().GetNumberOfCells() if RANK == 0 else 0
    boxes = check_surface("Distance Hierarchy", DistanceHierarchy(Input=sphere))
    # The tree depends a little on the order of the triangles.
    found = boxes.GetNumberOfCells()
    check("Distance Hierarchy of parts: all boxes", abs(found - expected) <= 0.1 * expected,
          f"{found} of {expected}")


def check_executing_alone(bunny):
    """A rank that executes again, for a larger part of its grid, waits for nobody."""
    filter_ = es.vtkMeshSDF()
    filter_.SetInputData(own_part(bunny, list(range(RANKS))))
    filter_.SetSampleDimensions(*SIZE)
    filter_.UpdatePiece(RANK, RANKS, 0)
    if RANK == 0:
        filter_.UpdateWholeExtent()
    samples = 24 ** 3
    check("executing alone", (filter_.GetOutput().GetNumberOfPoints() == samples) == (RANK == 0))


def check_change_on_one_rank(bunny):
    """Producers run again on all ranks; only one makes something else."""
    part = own_part(bunny, list(range(RANKS)))
    filter_ = es.vtkMeshSDF()
    filter_.SetInputData(part)
    filter_.SetSampleDimensions(*SIZE)
    filter_.SetModelBounds(bunny.GetBounds())
    filter_.UpdatePiece(RANK, RANKS, 0)
    before = ranks.values(filter_.GetOutput(), "SignedDistance").copy()
    if RANK == RANKS - 1:
        part.Initialize()
    part.Modified()
    filter_.UpdatePiece(RANK, RANKS, 0)
    after = ranks.values(filter_.GetOutput(), "SignedDistance")
    check("a part that changes", not numpy.array_equal(before, after))


def check_another_port(bunny):
    """A producer with two outputs: the parts of the other one are gathered too."""
    halves = vtkClipPolyData()
    halves.SetInputData(own_part(bunny, list(range(RANKS))))
    plane = vtkPlane()
    plane.SetOrigin(bunny.GetCenter())
    halves.SetClipFunction(plane)
    halves.GenerateClippedOutputOn()

    def update(filter_, port):
        filter_.SetInputConnection(halves.GetOutputPort(port))
        filter_.SetSampleDimensions(*SIZE)
        filter_.SetModelBounds(bunny.GetBounds())
        filter_.UpdatePiece(RANK, RANKS, 0)
        return ranks.values(filter_.GetOutput(), "SignedDistance").copy()

    kept = es.vtkMeshSDF()
    for port in (0, 1, 0):
        same = numpy.array_equal(update(kept, port), update(es.vtkMeshSDF(), port))
        check(f"port {port} of a producer", same)


def main():
    ranks.load_plugin(globals())
    bunny = ranks.read_bunny()
    everyone = list(range(RANKS))
    for method in ("Brute Force", "Closest Point", "Fast Sweeping"):
        check_redistributed(ranks.whole_distance(bunny, method), method)
    whole = ranks.whole_distance(bunny, "Brute Force")
    check_split_by_hand("split", whole, everyone)
    check_split_by_hand("split with ghosts", whole, everyone, spare=100)
    check_split_by_hand("nothing on the last rank", whole, everyone[:-1])
    check_split_by_hand("nothing on the first rank", whole, everyone[1:])
    check_numbering(whole)
    check_points(whole)
    check_kept_data(bunny)
    check_surface_filters()
    check_executing_alone(bunny)
    check_change_on_one_rank(bunny)
    check_another_port(bunny)
    print(f"rank {RANK}: all passed", flush=True)


main()
