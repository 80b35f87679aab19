# SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
# SPDX-License-Identifier: BSD-3-Clause
"""What the figures share beside their drawing: models, time steps, numbers that must hold."""

import sys
from pathlib import Path

from vtkmodules.numpy_interface import dataset_adapter
from vtkmodules.vtkIOGeometry import vtkOBJReader
from vtkmodules.vtkIOLegacy import vtkPolyDataReader
from vtkmodules.vtkIOPLY import vtkPLYReader

READERS = {".ply": vtkPLYReader, ".obj": vtkOBJReader, ".vtk": vtkPolyDataReader}


def model(name):
    """A sample of Data/ as data, for example model("bunny.ply")."""
    path = Path(__file__).resolve().parents[2] / "Data" / name
    reader = READERS[path.suffix]()
    reader.SetFileName(str(path))
    return copy_of(reader)


def at_time(algorithm, time):
    """What a filter puts out at a time, as data of its own: the next request does not change it."""
    algorithm.UpdateTimeStep(time)
    return copy_of(algorithm)


def copy_of(algorithm):
    """What a filter puts out, as data of its own."""
    algorithm.Update()
    output = algorithm.GetOutputDataObject(0)
    copy = output.NewInstance()
    copy.ShallowCopy(output)
    return copy


def points(data):
    """The coordinates as an array of n rows."""
    return dataset_adapter.WrapDataObject(data).Points


def array(data, name):
    """A point array, cell array or field array by its name, as an array of n values or rows."""
    wrapped = dataset_adapter.WrapDataObject(data)
    for attributes in (wrapped.PointData, wrapped.CellData, wrapped.FieldData):
        if name in attributes.keys():
            return attributes[name]
    sys.exit(f"there is no array {name}")


def add_array(data, name, values):
    """Puts values of your own beside the points of data."""
    dataset_adapter.WrapDataObject(data).PointData.append(values, name)


def column(table, name):
    """A column of a History as a list."""
    return [table.GetValueByName(row, name).ToDouble() for row in range(table.GetNumberOfRows())]


def check(name, value, low, high):
    """Prints a number; the script ends with an error when it is not between low and high.

    Save the picture first: it is what shows why."""
    print(f"{name}: {value:.6g} (expected {low:.6g} to {high:.6g})")
    if not low <= value <= high:                 # and so for a NaN
        sys.exit(f"{name} is {value:.6g}, expected {low:.6g} to {high:.6g}")
