# SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
# SPDX-License-Identifier: BSD-3-Clause
"""Surface Evolution with a surface from NumPy and nothing else, at any scale."""

import unittest

import evolvingsurfaces as es
import numpy as np
from vtkmodules.numpy_interface import dataset_adapter
from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
from vtkmodules.vtkCommonExecutionModel import vtkStreamingDemandDrivenPipeline

from observing import Messages, is_finite

SCALES = (1e-3, 1.0, 1e3)


def sphere(level=3):
    source = es.vtkIcosphereSource()
    source.SetLevel(level)
    source.Update()
    data = dataset_adapter.WrapDataObject(source.GetOutput())
    return np.array(data.Points, dtype=float), np.array(data.Polygons).reshape(-1, 4)[:, 1:]


def dumbbell():
    """Two bulbs and a neck of slivers between them."""
    points, triangles = sphere()
    width = 0.35 + 0.65 * np.minimum(1.0, 1.5 * np.abs(points[:, 2])) ** 2
    return points * np.column_stack((width, width, np.full_like(width, 2.5))), triangles


def polydata(points, triangles):
    made = vtkPolyData()
    made.SetPoints(vtkPoints())
    made.GetPoints().SetData(numpy_to_vtk(points, deep=True))
    cells = vtkCellArray()
    ids = np.ascontiguousarray(triangles, dtype=np.int64)
    cells.SetData(3, numpy_to_vtkIdTypeArray(ids.ravel(), deep=True))
    made.SetPolys(cells)
    return made


def value(filter_, name):
    array = filter_.GetOutput().GetFieldData().GetArray(name)
    return array.GetValue(0) if array else None


def column(filter_, name):
    return vtk_to_numpy(filter_.GetOutputDataObject(1).GetColumnByName(name))


def times(filter_):
    filter_.UpdateInformation()
    return filter_.GetOutputInformation(0).Get(vtkStreamingDemandDrivenPipeline.TIME_STEPS())


class Defaults(unittest.TestCase):
    def evolved(self, points, triangles, **settings):
        made = es.vtkSurfaceEvolution()
        made.SetInputData(polydata(points, triangles))
        for name, setting in settings.items():
            getattr(made, "Set" + name)(setting)
        messages = Messages(made)
        made.Update()
        self.assertEqual(messages.errors + messages.warnings, [])
        self.assertTrue(is_finite(made.GetOutput()))
        return made

    def test_any_scale_gives_the_same(self):
        points, triangles = sphere()
        reference = self.evolved(points, triangles)
        for scale in SCALES:
            made = self.evolved(scale * points, triangles)
            self.assertAlmostEqual(value(made, "Area") / scale**2, value(reference, "Area"), 6)
            self.assertAlmostEqual(
                value(made, "TimeStep"), value(reference, "TimeStep"), 9)
            self.assertEqual(len(column(made, "Time")), made.GetNumberOfSteps() + 1)

    def test_in_absolute_units_the_step_grows_with_the_area(self):
        points, triangles = sphere()
        for scale in SCALES:
            made = self.evolved(scale * points, triangles, RelativeUnits=False, CurvatureSpeed=1.0)
            whole = made.GetNumberOfSteps() * value(made, "TimeStep")
            self.assertAlmostEqual(whole / scale**2, 0.125, 2)

    def test_a_neck_pinches_off_and_both_sides_go_on(self):
        for scale in SCALES:
            points, triangles = dumbbell()
            made = self.evolved(scale * points, triangles)
            self.assertTrue(np.all(np.diff(column(made, "Area")) < 0.0))
            self.assertGreater(column(made, "MinAngle")[1:].min(), 14.0)
            self.assertLess(value(made, "Area"), 0.6 * column(made, "Area")[0])

    def test_a_point_is_an_end(self):
        points, triangles = sphere()
        made = self.evolved(points, triangles, RelativeUnits=False, CurvatureSpeed=1.0,
                            TimeStep=0.001, NumberOfSteps=400)
        self.assertAlmostEqual(value(made, "ExtinctionTime"), 0.25, 2)
        self.assertEqual(times(made)[-1], value(made, "Time"))
        self.assertIsNone(value(made, "Stopped"))


if __name__ == "__main__":
    unittest.main()
