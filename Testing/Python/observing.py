# SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
# SPDX-License-Identifier: BSD-3-Clause
"""What a filter says and what it hands out, to be compared and looked at."""

import hashlib
import re

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkDataObject
from vtkmodules.vtkCommonExecutionModel import vtkStreamingDemandDrivenPipeline


class Messages:
    """A filter's errors and warnings as sentences; VTK's trailer is kept off the terminal."""

    def __init__(self, made):
        self.errors = []
        self.warnings = []
        self.listen(made, "ErrorEvent", self.errors)
        self.listen(made, "WarningEvent", self.warnings)
        made.GetExecutive().AddObserver("ErrorEvent", lambda *_: None)

    @staticmethod
    def listen(made, event, sentences):
        def remember(_, __, message):
            sentences.append(re.sub(r"^.*?\(0x[0-9a-f]+\): ", "", message, flags=re.S).strip())

        remember.CallDataType = "string0"
        made.AddObserver(event, remember)

    def clear(self):
        self.errors.clear()
        self.warnings.clear()


def arrays_of(data):
    """Every array of a data object with where it is: name to array."""
    found = {}
    for kind in range(vtkDataObject.NUMBER_OF_ATTRIBUTE_TYPES):
        arrays = data.GetAttributesAsFieldData(kind)
        for i in range(arrays.GetNumberOfArrays() if arrays else 0):
            array = arrays.GetAbstractArray(i)
            found[kind, array.GetName()] = array
    if data.IsA("vtkPointSet") and data.GetPoints():
        found["Points"] = data.GetPoints().GetData()
    if data.IsA("vtkPolyData"):
        for cells in ("Verts", "Lines", "Polys", "Strips"):
            made = getattr(data, "Get" + cells)()
            found[cells, "Offsets"] = made.GetOffsetsArray()
            found[cells, "Connectivity"] = made.GetConnectivityArray()
    return found


def bits(array):
    """Type, shape and a fingerprint of the bits of an array."""
    if array.IsA("vtkStringArray"):
        return [array.GetValue(i) for i in range(array.GetNumberOfValues())]
    values = vtk_to_numpy(array)
    return values.dtype.str, values.shape, hashlib.sha1(values.tobytes()).hexdigest()


def description(data):
    """All of a data object but the seconds that its computation took."""
    described = {key: bits(array) for key, array in arrays_of(data).items()
                 if "Seconds" not in key}
    if data.IsA("vtkImageData"):
        axes = data.GetDirectionMatrix()
        described["Layout"] = (data.GetExtent(), data.GetOrigin(), data.GetSpacing(),
                               [axes.GetElement(i, j) for i in range(3) for j in range(3)])
    if data.IsA("vtkDataSet"):
        scalars = data.GetPointData().GetScalars()
        described["Active"] = scalars.GetName() if scalars else None
    key = vtkDataObject.DATA_TIME_STEP()
    if data.GetInformation().Has(key):
        described["Time"] = data.GetInformation().Get(key)
    return described


def outputs_of(made):
    return [made.GetOutputDataObject(port) for port in range(made.GetNumberOfOutputPorts())]


def results(made, messages, times=(0.0, 0.1, 1e9)):
    """What updates give and say: at several times where there are some."""
    messages.clear()
    made.UpdateInformation()
    steps = vtkStreamingDemandDrivenPipeline.TIME_STEPS()
    published = made.GetOutputInformation(0).Get(steps)
    found = {"published": published}
    for time in times if published else (None,):
        made.Update() if time is None else made.UpdateTimeStep(time)
        for port, output in enumerate(outputs_of(made)):
            for key, value in description(output).items():
                found[time, port, key] = value
    return {**found, "errors": sorted(messages.errors), "warnings": sorted(messages.warnings)}


def differences(a, b):
    """The keys of two results that differ, in short."""
    return [key for key in {**a, **b} if a.get(key) != b.get(key)][:5]


def is_finite(data):
    """Are all numbers of a data object finite?"""
    return all(np.isfinite(vtk_to_numpy(array)).all() for array in arrays_of(data).values()
               if not array.IsA("vtkStringArray"))
