# SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
# SPDX-License-Identifier: BSD-3-Clause
"""Several ranks: what cannot be gathered, or is wrong on one rank only, is said on all of them, and
no rank is left waiting."""

import numpy
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonDataModel import vtkImageData, vtkMultiBlockDataSet, vtkPolyData
from vtkmodules.vtkIOPLY import vtkPLYReader

import evolvingsurfaces as es
import ranks
from ranks import RANK, RANKS, check


def icosphere(radius=1.0):
    source = es.vtkIcosphereSource()
    source.SetLevel(1)
    source.SetRadius(radius)
    source.Update()
    return source.GetOutput()


def image(level):
    """The distance from a plane."""
    data = vtkImageData()
    data.SetDimensions(5, 5, 5)
    scalars = numpy_to_vtk(numpy.tile(numpy.arange(5.0) - level, 25), deep=True)
    scalars.SetName("Field")
    data.GetPointData().SetScalars(scalars)
    return data


def check_error(name, filter_, words):
    messages = ranks.errors_of(filter_)
    filter_.UpdatePiece(RANK, RANKS, 0)
    check(name + ": one sentence", len(messages) == 1 and words in messages[0], str(messages))
    output = filter_.GetOutputDataObject(0)
    check(name + ": no output", output.GetNumberOfPoints() == 0)


def small(filter_):
    if hasattr(filter_, "SetSampleDimensions"):
        filter_.SetSampleDimensions(8, 8, 8)
    return filter_


def check_blocks(make):
    """Every rank holds another block, the first none: it would not even run the filter."""
    blocks = vtkMultiBlockDataSet()
    blocks.SetNumberOfBlocks(RANKS)
    if RANK > 0:
        blocks.SetBlock(RANK, icosphere())
    filter_ = small(make())
    filter_.SetInputData(blocks)
    messages = ranks.errors_of(filter_)
    filter_.UpdatePiece(RANK, RANKS, 0)
    said = len(messages) == 1 and "Merge Blocks" in messages[0]
    check(f"{filter_.GetClassName()}: blocks on different ranks", said, str(messages))


def check_same_blocks():
    blocks = vtkMultiBlockDataSet()
    blocks.SetBlock(0, icosphere())
    blocks.SetBlock(1, icosphere(2.0))
    filter_ = small(es.vtkMeshSDF())
    filter_.SetInputData(blocks)
    messages = ranks.errors_of(filter_)
    filter_.UpdatePiece(RANK, RANKS, 0)
    output = filter_.GetOutputDataObject(0)
    check("the same blocks on all ranks", not messages and all(
        output.GetBlock(i).GetNumberOfPoints() > 0 for i in range(2)), str(messages))


def check_bad_point_on_one_rank(make):
    surface = vtkPolyData()
    if RANK == RANKS - 1:
        surface.DeepCopy(icosphere())
        surface.GetPoints().SetPoint(3, float("nan"), 0.0, 0.0)
    filter_ = small(make())
    filter_.SetInputData(surface)
    messages = ranks.errors_of(filter_)
    filter_.UpdatePiece(RANK, RANKS, 0)
    name = f"{filter_.GetClassName()}: a bad point on one rank"
    if make is es.vtkShrinkWrap:  # does without it, and warns
        wraps = filter_.GetOutput().GetNumberOfPoints() > 0
        check(name, not messages and wraps == (RANK == 0), str(messages))
        return
    speaks = RANK == 0 or make is es.vtkMeshSDF  # the others write no surface, so they read none
    check(name, len(messages) == (1 if speaks else 0), str(messages))


def check_missing_file():
    """The reader of one rank alone fails."""
    name = "/bunny.ply" if RANK == 0 else "/no-such-file.ply"
    reader = vtkPLYReader()
    reader.SetFileName(ranks.DATA + name)
    ranks.errors_of(reader)
    filter_ = small(es.vtkMeshSDF())
    filter_.SetInputConnection(reader.GetOutputPort())
    filter_.UpdatePiece(RANK, RANKS, 0)
    check("a reader that fails on one rank", True)


def check_more_ranks_than_samples():
    """Ranks whose part of the grid is empty take part in the gathering."""
    filter_ = es.vtkMeshSDF()
    filter_.SetInputData(icosphere() if RANK == RANKS - 1 else vtkPolyData())
    filter_.SetSampleDimensions(2, 2, 1)
    filter_.UpdatePiece(RANK, RANKS, 0)
    filter_.UpdatePiece(RANK, RANKS, 1)
    points = ranks.total(filter_.GetOutput().GetNumberOfPoints())
    check("more ranks than samples", points >= 4, str(points))


def check_empty_everywhere(make):
    filter_ = small(make())
    filter_.SetInputData(vtkPolyData())
    messages = ranks.errors_of(filter_)
    filter_.UpdatePiece(RANK, RANKS, 0)
    check(f"{filter_.GetClassName()}: nothing on any rank", not messages, str(messages))


def main():
    ranks.load_plugin(globals())
    filters = (es.vtkMeshSDF, es.vtkSurfaceEvolution, es.vtkTangentialRedistribution,
               es.vtkShrinkWrap, es.vtkDistanceHierarchy)
    for make in filters:
        check_blocks(make)
        check_bad_point_on_one_rank(make)
        check_empty_everywhere(make)
    check_same_blocks()
    evolution = es.vtkSurfaceEvolution()
    evolution.SetInputData(0, icosphere())
    evolution.SetInputData(1, image(RANK))
    check_error("images that differ", evolution, "the whole image on each")
    evolution.SetInputData(1, image(1.0))
    evolution.SetNumberOfSteps(1)
    evolution.UpdatePiece(RANK, RANKS, 0)
    check("the same image", (evolution.GetOutput().GetNumberOfPoints() > 0) == (RANK == 0))
    check_missing_file()
    check_more_ranks_than_samples()
    print(f"rank {RANK}: all passed", flush=True)


main()
