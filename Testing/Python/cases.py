# SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
# SPDX-License-Identifier: BSD-3-Clause
"""Each class ready to run on something small, and for each of its parameters another value.

A parameter counts only beside certain others (an alpha beside the exponential control): these are
in its row of the table, so that the value given there changes the output.
"""

import math
import re

import evolvingsurfaces as es
from vtkmodules.vtkCommonCore import vtkDoubleArray
from vtkmodules.vtkCommonDataModel import vtkImageData, vtkPolyData

CLASSES = tuple(name for name in dir(es)
                if name.startswith("vtk") and isinstance(getattr(es, name), type))

E, S = es.vtkSurfaceEvolution, es.vtkMeshSDF

# What every case has, beside its inputs.
COMMON = {
    "vtkMeshSDF": {"SampleDimensions": (10, 10, 10)},
    "vtkDistanceHierarchy": {"SampleDimensions": (10, 10, 10)},
    "vtkIcosphereSource": {"Level": 1, "Resolution": 3},
    "vtkLabelSurfaces": {},
    "vtkTangentialRedistribution": {"NumberOfSteps": 2},
    "vtkShrinkWrap": {"SampleDimensions": (24, 24, 24), "TargetEdgeLength": 0.3},
    # The start has less than a quarter of the points, so that AUTOMATIC makes new elements at once.
    "vtkSurfaceEvolution": {"NumberOfSteps": 3, "TimeStep": 0.1, "CurvatureSpeed": 0.05,
                            "TargetEdgeLength": 0.15},
}

EXPONENTIAL = {"VolumeRedistribution": 1.0, "CurvatureControl": E.EXPONENTIAL}
OCTREE = {"Structure": es.vtkDistanceHierarchy.OCTREE}
REMESHED = {"Remeshing": E.UNIFORM, "TargetEdgeLength": 0.2}
SWEPT = {"Method": S.FAST_SWEEPING}
SMOOTHED = {"SmoothingSteps": 2}
FREE = {"InputData": (1, None)}                   # of a field
BOX = (-1.5, 1.5, -1.5, 1.5, -1.5, 1.5)


def closed():
    """A box, whose edges every flow rounds off."""
    source = es.vtkIcosphereSource()
    source.SetShape(es.vtkIcosphereSource.BOX)
    source.SetResolution(4)
    source.Update()
    return source.GetOutput()


def ball_image(n=13, size=2.0, radius=1.0):
    """Intensities of a ball, a little blurred."""
    image = vtkImageData()
    image.SetDimensions(n, n, n)
    image.SetOrigin(3 * (-size,))
    image.SetSpacing(3 * (2.0 * size / (n - 1),))
    array = vtkDoubleArray()
    array.SetName("Intensity")
    for i in range(image.GetNumberOfPoints()):
        array.InsertNextValue(math.tanh(5.0 * (radius - math.hypot(*image.GetPoint(i)))))
    image.GetPointData().SetScalars(array)
    return image


# Another value, and what must be beside it to count.
OTHER_VALUES = {
    "vtkMeshSDF": {
        "SampleDimensions": ((10, 8, 10), {}), "Padding": (0.3, {}), "ModelBounds": (BOX, {}),
        "Method": (S.FAST_SWEEPING, {}), "Sign": (S.UNSIGNED, {}), "BandWidth": (1.5, {}),
        "SmoothingSigma": (1.0, {}), "NumberOfSweeps": (1, SWEPT),
        "ComputeClosestPoint": (True, {}), "ComputeClosestCellId": (True, {}),
        "ComputeGradient": (True, {})},
    "vtkDistanceHierarchy": {
        "Structure": (es.vtkDistanceHierarchy.OCTREE, {}), "Level": (2, {}),
        "SampleDimensions": ((20, 20, 20), OCTREE), "Padding": (0.3, OCTREE),
        "ModelBounds": (BOX, OCTREE)},
    "vtkIcosphereSource": {
        "Shape": (es.vtkIcosphereSource.BOX, {}), "Level": (2, {}),
        "Resolution": (4, {"Shape": es.vtkIcosphereSource.CUBE_SPHERE}), "Radius": (2.0, {}),
        "Center": ((1.0, 2.0, 3.0), {}), "OutputPointsPrecision": (1, {})},
    "vtkLabelSurfaces": {"BackgroundLabel": (2.0, {}), "SmoothingLength": (1.0, {})},
    "vtkTangentialRedistribution": {
        "NumberOfSteps": (3, {}), "TimeStep": (0.05, {}), "VolumeRedistribution": (1.0, {}),
        "AngleRedistribution": (4.0, {}), "LengthRedistribution": (1.0, {}),
        "AngleMethod": (E.WEIGHTED_EDGES, {}),
        "AngleWeighting": (E.INVERSE_AREA, {"AngleMethod": E.WEIGHTED_EDGES}),
        "CurvatureControl": (E.EXPONENTIAL, {"VolumeRedistribution": 1.0}),
        "CurvatureControlAlpha": (0.5, EXPONENTIAL), "PreserveShape": (False, {}),
        "BoundaryMode": (E.FIXED, {"LengthRedistribution": 1.0}), "FeatureAngle": (0.0, {})},
    "vtkShrinkWrap": {
        "OutputSteps": (True, {}), "Start": (es.vtkShrinkWrap.ICOSPHERE, {}),
        "SampleDimensions": ((32, 32, 32), {}), "TargetEdgeLength": (0.4, {}),
        "TargetNumberOfPoints": (300, {"TargetEdgeLength": 0.0, "TargetNumberOfPoints": 500}),
        "GapSize": (1.0, {}), "AdaptToCurvature": (True, {}),
        "PreserveFeatures": (es.vtkShrinkWrap.ON, {"FeatureAngle": 10.0}),
        "FeatureAngle": (10.0, {"PreserveFeatures": es.vtkShrinkWrap.ON}), "NumberOfSteps": (5, {}),
        "OffsetDistance": (0.2, {}), "InputTime": (es.vtkShrinkWrap.FIRST_STEP, {}),
        "InputTimeIndex": (1, {"InputTime": es.vtkShrinkWrap.STEP_INDEX}),
        "PassPointData": (False, {}), "PassCellData": (False, {})},
    "vtkSurfaceEvolution": {
        "TimeStep": (0.05, {}), "NumberOfSteps": (2, {}), "OutputInterval": (2, {}),
        "Flow": (E.SURFACE_DIFFUSION, {**FREE, "InputDataObject": (0, closed())}),
        "VolumePreserving": (True, FREE), "CurvatureSpeed": (0.1, {}), "CurvatureRange": (0.5, {}),
        "AdvectionSpeed": (0.5, {}),
        "AdvectionBalance": (0.5, {}), "RelativeUnits": (False, {}),
        "FieldMode": (E.EDGE_IMAGE, {}),
        "EdgeSharpness": (1.0, {"FieldMode": E.IMAGE, "InputDataObject": (1, ball_image())}),
        "NormalSpeed": (0.5, {"FieldMode": E.EDGE_IMAGE}),
        "VolumeRedistribution": (1.0, {}), "AngleRedistribution": (1.0, {}),
        "LengthRedistribution": (1.0, {}),
        "AngleMethod": (E.SHAPE, {"AngleRedistribution": 1.0}),
        "AngleWeighting": (E.DISTANCE, {"AngleRedistribution": 1.0}),
        "CurvatureControl": (E.CUBE_ROOT, {"VolumeRedistribution": 1.0}),
        "CurvatureControlAlpha": (0.5, EXPONENTIAL),
        "SmoothingSteps": (1, {}), "SmoothingSpeed": (0.01, SMOOTHED),
        "SmoothingDecay": (1.0, SMOOTHED), "BoundaryMode": (E.FREE, {}),
        "SurfaceGuard": (1.0, {}), "ConvergenceTolerance": (100.0, {}),
        "Remeshing": (E.UNIFORM, {}), "TargetEdgeLength": (0.3, REMESHED),
        "RemeshingInterval": (2, REMESHED), "SolverTolerance": (1e-2, {}), "CacheLimit": (1, {}),
        "InputTime": (E.FIRST_STEP, {}), "InputTimeIndex": (1, {"InputTime": E.STEP_INDEX})},
}


def own_setters(name):
    """The parameters of a class and its connections: all SetX but those that name a value."""
    own = {key[3:] for key in vars(getattr(es, name)) if key.startswith("Set")}
    named = {key for key in own
             if any(parts.group(1) in own for parts in re.finditer(r"(?=(^\w+?)To[A-Z])", key))}
    return own - named


def assign(made, settings):
    for parameter, value in settings.items():
        setter = getattr(made, "Set" + parameter)
        setter(*value) if isinstance(value, tuple) else setter(value)


def cap(level=2, radius=1.4, lowest=-0.7):
    """A sphere without what is below a height: a surface with a boundary, in doubles, with a point
    and a cell array."""
    source = es.vtkIcosphereSource()
    source.SetLevel(level)
    source.SetRadius(radius)
    source.SetOutputPointsPrecision(1)
    source.Update()
    whole = source.GetOutput()
    surface = vtkPolyData()
    surface.SetPoints(whole.GetPoints())
    surface.AllocateExact(whole.GetNumberOfPolys(), 3)
    for i in range(whole.GetNumberOfPolys()):
        ids = whole.GetCell(i).GetPointIds()
        corners = [ids.GetId(k) for k in range(3)]
        if min(whole.GetPoint(corner)[2] for corner in corners) > lowest:
            surface.InsertNextCell(5, 3, corners)
    for data, count in ((surface.GetPointData(), surface.GetNumberOfPoints()),
                        (surface.GetCellData(), surface.GetNumberOfCells())):
        data.AddArray(numbers("Number", count))
    return surface


def numbers(name, count):
    array = vtkDoubleArray()
    array.SetName(name)
    for i in range(count):
        array.InsertNextValue(i)
    return array


def sphere_image(n=9, size=2.0, radius=1.0):
    """The distance to a sphere; another array beside it, of half that."""
    image = vtkImageData()
    image.SetDimensions(n, n, n)
    image.SetOrigin(3 * (-size,))
    image.SetSpacing(3 * (2.0 * size / (n - 1),))
    for name, factor in (("Distance", 1.0), ("Half", 0.5)):
        array = vtkDoubleArray()
        array.SetName(name)
        for i in range(image.GetNumberOfPoints()):
            array.InsertNextValue(factor * (math.hypot(*image.GetPoint(i)) - radius))
        image.GetPointData().AddArray(array)
    image.GetPointData().SetActiveScalars("Distance")
    return image


def label_image(n=7):
    """Two labels that touch."""
    image = vtkImageData()
    image.SetDimensions(n, n, n)
    array = vtkDoubleArray()
    array.SetName("Labels")
    for i in range(image.GetNumberOfPoints()):
        place = [x - 0.5 * (n - 1) for x in image.GetPoint(i)]
        array.InsertNextValue(0 if math.hypot(*place) > 2.5 else 1 if place[0] < 0.3 else 2)
    image.GetPointData().SetScalars(array)
    return image


def make(name, settings=None):
    """A filter of a class with its inputs, the common settings and others."""
    made = getattr(es, name)()
    if made.GetNumberOfInputPorts() > 0:
        made.SetInputData(0, label_image() if name == "vtkLabelSurfaces" else cap())
    if made.GetNumberOfInputPorts() > 1:
        made.SetInputData(1, sphere_image())
    assign(made, COMMON[name])
    assign(made, settings or {})
    return made
