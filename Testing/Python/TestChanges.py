# SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
# SPDX-License-Identifier: BSD-3-Clause
"""An update after any change gives, bit for bit, what a fresh filter gives.

Filters keep what they have computed, the next update may ask for it again; here every parameter
and everything of an input is changed in between.
"""

import unittest

import cases
import evolvingsurfaces as es
from observing import Messages, differences, results
from vtkmodules.vtkCommonCore import vtkFloatArray, vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData

# They say how, not what, or what to take of inputs with time steps: the results stay the same.
WITHOUT_EFFECT = {"CacheLimit", "SurfaceGuard", "InputTime", "InputTimeIndex"}


def fresh_results(name, settings, change=lambda made: None):
    made = cases.make(name, settings)
    change(made)
    return results(made, Messages(made))


class Parameters(unittest.TestCase):
    def test_the_table_has_every_setter(self):
        for name in cases.CLASSES:
            with self.subTest(name):
                connections = {key for key in cases.own_setters(name)
                               if key.endswith("Connection")}
                self.assertEqual(cases.own_setters(name) - connections,
                                 set(cases.OTHER_VALUES[name]))

    def test_another_value_gives_what_a_fresh_filter_gives(self):
        for name, table in cases.OTHER_VALUES.items():
            for parameter, (value, beside) in table.items():
                with self.subTest(f"{name}.{parameter}"):
                    self.check_value(name, parameter, value, beside)

    def check_value(self, name, parameter, value, beside):
        made = cases.make(name, beside)
        messages = Messages(made)
        usual = getattr(made, "Get" + parameter)()
        before = results(made, messages)
        cases.assign(made, {parameter: value})
        after = results(made, messages)
        fresh = fresh_results(name, {**beside, parameter: value})
        self.assertEqual(differences(after, fresh), [])
        if parameter not in WITHOUT_EFFECT:
            self.assertNotEqual(differences(after, before), [], "it was to change something")
        cases.assign(made, {parameter: usual})
        self.assertEqual(differences(results(made, messages), before), [])


def moved(surface):
    surface.GetPoints().SetPoint(3, 0.1, 0.2, 1.5)
    surface.GetPoints().Modified()


def rounded(surface):
    points = surface.GetPoints()
    for i in range(points.GetNumberOfPoints()):
        points.SetPoint(i, [round(x * 1024) / 1024 for x in points.GetPoint(i)])


def single(surface):
    points = vtkPoints()
    points.SetDataTypeToFloat()
    points.DeepCopy(surface.GetPoints())
    surface.SetPoints(points)


def cells(*polygons):
    made = vtkCellArray()
    for polygon in polygons:
        made.InsertNextCell(len(polygon), polygon)
    return made


def polygons_of(surface):
    return [[surface.GetCell(i).GetPointId(k) for k in range(3)]
            for i in range(surface.GetNumberOfPolys())]


def without_a_polygon(surface):
    surface.SetPolys(cells(*polygons_of(surface)[1:]))


def turned(surface):
    surface.SetPolys(cells(*[polygon[::-1] for polygon in polygons_of(surface)]))


def with_a_strip(surface):
    polygons = polygons_of(surface)
    surface.SetPolys(cells(*polygons[1:]))
    surface.SetStrips(cells(polygons[0]))


SURFACE_CHANGES = {
    "points": moved, "point type": single, "polygons": without_a_polygon, "orientation": turned,
    "strips": with_a_strip,
    "vertices": lambda surface: surface.SetVerts(cells([0], [5])),
    "lines": lambda surface: surface.SetLines(cells([0, 5])),
    "all cells": lambda surface: surface.SetPolys(vtkCellArray()),
    "unused point": lambda surface: surface.GetPoints().InsertNextPoint(0.0, 0.0, 9.0),
}


def with_floats(image):
    scalars = image.GetPointData().GetScalars()
    values = vtkFloatArray()
    values.SetName(scalars.GetName())
    for i in range(scalars.GetNumberOfTuples()):
        values.InsertNextValue(round(8.0 * scalars.GetTuple1(i)) / 8.0)
    image.GetPointData().SetScalars(values)


def with_components(image):
    scalars = image.GetPointData().GetScalars()
    values = vtkFloatArray()
    values.SetNumberOfComponents(2)
    for i in range(scalars.GetNumberOfTuples()):
        values.InsertNextTuple2(0.7 * scalars.GetTuple1(i), 5.0)
    image.GetPointData().SetScalars(values)


IMAGE_CHANGES = {
    "origin": lambda image: image.SetOrigin(-1.9, -2.0, -2.0),
    "spacing": lambda image: image.SetSpacing(0.5, 0.5, 0.45),
    "extent": lambda image: image.SetExtent(1, 9, 0, 8, 0, 8),
    "direction": lambda image: image.SetDirectionMatrix(0, -1, 0, 1, 0, 0, 0, 0, 1),
    "scalars": lambda image: image.GetPointData().GetScalars().SetTuple1(400, 0.01),
    "active array": lambda image: image.GetPointData().SetActiveScalars("Half"),
    "no scalars": lambda image: image.GetPointData().Initialize(),
    "type": with_floats, "components": with_components,
}


def takes_surfaces(name):
    made = cases.make(name)
    return (made.GetNumberOfInputPorts() > 0 and
            isinstance(made.GetInputDataObject(0, 0), vtkPolyData))


class Inputs(unittest.TestCase):
    def test_another_surface_gives_what_a_fresh_filter_gives(self):
        for name in cases.CLASSES:
            for label, change in SURFACE_CHANGES.items():
                if takes_surfaces(name):
                    with self.subTest(f"{name}, {label}"):
                        self.check_input(name, 0, cases.cap, change)

    def test_another_image_gives_what_a_fresh_filter_gives(self):
        for settings in ({}, {"FieldMode": es.vtkSurfaceEvolution.EDGE_IMAGE}):
            for label, change in IMAGE_CHANGES.items():
                with self.subTest(label, **settings):
                    self.check_input("vtkSurfaceEvolution", 1, cases.sphere_image, change,
                                     settings)

    def test_another_image_of_labels_gives_what_a_fresh_filter_gives(self):
        changes = {key: IMAGE_CHANGES[key] for key in ("origin", "spacing", "direction",
                                                       "no scalars", "type", "components")}
        changes["a voxel"] = lambda image: image.GetPointData().GetScalars().SetTuple1(171, 2)
        for label, change in changes.items():
            with self.subTest(label):
                self.check_input("vtkLabelSurfaces", 0, cases.label_image, change)

    def check_input(self, name, port, make_input, change, settings=None):
        """Another object in its place, and the same object changed."""
        changed = make_input()
        change(changed)
        changed.Modified()
        expected = fresh_results(name, settings, lambda made: made.SetInputData(port, changed))
        for in_place in (False, True):
            made = cases.make(name, settings)
            made.SetInputData(port, make_input())
            messages = Messages(made)
            before = results(made, messages)
            if in_place:
                change(made.GetInputDataObject(port, 0))
                made.GetInputDataObject(port, 0).Modified()
            else:
                made.SetInputData(port, changed)
            self.assertEqual(differences(results(made, messages), expected), [])
            made.SetInputData(port, make_input())
            self.assertEqual(differences(results(made, messages), before), [])

    def test_a_point_type_alone_counts(self):
        # Coordinates that single precision holds: only the type tells the surfaces apart.
        for name in ("vtkSurfaceEvolution", "vtkShrinkWrap", "vtkTangentialRedistribution"):
            with self.subTest(name):
                def make_rounded():
                    surface = cases.cap()
                    rounded(surface)
                    return surface

                self.check_input(name, 0, make_rounded, single)
                made = cases.make(name)
                surface = make_rounded()
                single(surface)
                made.SetInputData(surface)
                made.Update()
                self.assertEqual(made.GetOutput().GetPoints().GetData().GetDataTypeAsString(),
                                 "float")

    def test_a_field_comes_and_goes(self):
        made = cases.make("vtkSurfaceEvolution")
        messages = Messages(made)
        with_field = results(made, messages)
        made.SetInputData(1, None)
        expected = fresh_results("vtkSurfaceEvolution", {},
                                 lambda fresh: fresh.SetInputData(1, None))
        self.assertEqual(differences(results(made, messages), expected), [])
        made.SetInputData(1, cases.sphere_image())
        self.assertEqual(differences(results(made, messages), with_field), [])

    def test_points_alone_are_told_apart_by_their_vertices(self):
        for name in ("vtkMeshSDF", "vtkShrinkWrap"):
            with self.subTest(name):
                def points():
                    surface = vtkPolyData()
                    surface.SetPoints(cases.cap().GetPoints())
                    return surface

                def with_vertices(surface):
                    surface.SetVerts(cells(*[[i] for i in range(0, 160, 2)]))

                self.check_input(name, 0, points, with_vertices)


if __name__ == "__main__":
    unittest.main()
