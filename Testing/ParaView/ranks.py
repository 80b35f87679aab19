# SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
# SPDX-License-Identifier: BSD-3-Clause
"""What the tests on several ranks share. Every rank runs the same script:

    mpirun -np N pvbatch --sym TEST.py N PLUGIN_FILE DATA_FOLDER

A check fails on all ranks when it fails on one, so that none waits for another that has stopped.
"""

import sys

import numpy
import paraview.simple as pv
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkDoubleArray
from vtkmodules.vtkIOPLY import vtkPLYReader
from vtkmodules.vtkParallelCore import vtkCommunicator, vtkMultiProcessController

# Before the plugin, or Python takes its classes for abstract ones.
import evolvingsurfaces as es

WANTED, PLUGIN, DATA = int(sys.argv[1]), sys.argv[2], sys.argv[3]
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


def load_plugin(names):
    """The plugin's proxies into `names`; and as many ranks as the test is about."""
    pv.LoadPlugin(PLUGIN, ns=names)
    check("ranks", RANKS == WANTED, str(RANKS))


def part(proxy, port=0):
    """What this rank has of a proxy's output."""
    pv.UpdatePipeline(proxy=proxy)
    return proxy.GetClientSideObject().GetOutputDataObject(port)


def bunny_reader():
    return pv.PLYReader(FileNames=[DATA + "/bunny.ply"])


def read_bunny():
    """The whole, read by this rank alone."""
    reader = vtkPLYReader()
    reader.SetFileName(DATA + "/bunny.ply")
    reader.Update()
    return reader.GetOutput()


def redistributed(source):
    """A surface in parts: redistribution makes it an unstructured grid."""
    return pv.ExtractSurface(Input=pv.RedistributeDataSet(Input=source))


def set_enum(filter_, name, value):
    getattr(filter_, f"Set{name}To{value.replace(' ', '')}")()


def whole_distance(surface, method="Closest Point", sign="Automatic", samples=24):
    """The filter that computes the whole grid on this rank."""
    reference = es.vtkMeshSDF()
    reference.SetInputData(surface)
    reference.SetSampleDimensions(samples, samples, samples)
    set_enum(reference, "Method", method)
    set_enum(reference, "Sign", sign)
    reference.ComputeClosestCellIdOn()
    reference.Update()
    return reference


def in_part(whole, part_, name):
    """The whole's values at the samples of the part."""
    n = whole.GetDimensions()
    x0, x1, y0, y1, z0, z1 = part_.GetExtent()
    values = vtk_to_numpy(whole.GetPointData().GetArray(name)).reshape(n[2], n[1], n[0])
    return values[z0:z1 + 1, y0:y1 + 1, x0:x1 + 1].ravel()


def values(data, name):
    return vtk_to_numpy(data.GetPointData().GetArray(name))


def array_names(attributes):
    return [attributes.GetArrayName(i) for i in range(attributes.GetNumberOfArrays())]


def errors_of(filter_):
    """The list that the filter's error messages will be in."""
    messages = []

    def note(_, __, message):
        messages.append(message)
    note.CallDataType = "string0"
    filter_.AddObserver("ErrorEvent", note)
    return messages
