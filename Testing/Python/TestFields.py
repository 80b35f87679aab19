# SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
# SPDX-License-Identifier: BSD-3-Clause
"""Any start around a model, with a field and the defaults: it is reached, or what is left is said."""

import re
import sys
import unittest
from pathlib import Path

import evolvingsurfaces as es
import numpy as np
from vtkmodules.vtkFiltersCore import vtkTriangleFilter
from vtkmodules.vtkFiltersSources import vtkCubeSource, vtkPlaneSource, vtkSphereSource

from observing import Messages, is_finite

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "Examples" / "thesis"))

from figures import array, model  # noqa: E402

E = es.vtkSurfaceEvolution


def box_of(data):
    return np.reshape(data.GetBounds(), (3, 2))


def icosphere(box, larger=1.1):
    source = es.vtkIcosphereSource()
    source.SetCenter(box.mean(axis=1))
    source.SetRadius(0.5 * larger * np.linalg.norm(box[:, 1] - box[:, 0]))
    return source


def eight_corners(box):
    source = vtkCubeSource()
    source.SetBounds(*np.ravel(box + 0.1 * np.ptp(box) * np.array((-1.0, 1.0))))
    return source


def coarse_sphere(box):
    source = vtkSphereSource()
    source.SetCenter(box.mean(axis=1))
    source.SetRadius(0.6 * np.linalg.norm(box[:, 1] - box[:, 0]))
    return source


def distance_to(data, samples=80):
    distance = es.vtkMeshSDF()
    distance.SetInputData(data)
    distance.SetSampleDimensions(samples, samples, samples)
    distance.Update()
    return distance


def evolved(start, distance, **settings):
    made = E()
    made.SetInputConnection(0, start.GetOutputPort())
    made.SetInputConnection(1, distance.GetOutputPort())
    for name, value in settings.items():
        getattr(made, "Set" + name)(value)
    messages = Messages(made)
    made.Update()
    return made, messages


def value(made, name):
    return array(made.GetOutput(), name)[0]


def shortcomings(made):
    found = made.GetOutput().GetFieldData().GetAbstractArray("Shortcomings")
    return [found.GetValue(i) for i in range(found.GetNumberOfValues())] if found else []


class Fields(unittest.TestCase):
    def check_reached(self, made, messages, cell):
        """But for folds that are told, if elements do not get into them."""
        self.assertEqual(messages.errors, [])
        self.assertEqual(messages.warnings, shortcomings(made))
        for sentence in messages.warnings:
            part = re.search(r"field: (\S+) % of the level's area is not reached, in", sentence)
            self.assertLess(float(part.group(1)), 0.2)
        self.assertTrue(is_finite(made.GetOutput()))
        self.assertGreater(value(made, "MinAngle"), 20.0)
        self.assertLess(value(made, "MaxDistance"), cell)
        self.assertLess(value(made, "MeanDistance"), 0.1 * cell)

    def test_a_model_without_holes_is_reached(self):
        for name, start in (("bunny.ply", icosphere), ("bunny.ply", eight_corners),
                            ("bunny.ply", coarse_sphere), ("arc.vtk", eight_corners),
                            ("cube.obj", icosphere), ("cube.obj", eight_corners)):
            data = model(name)
            distance = distance_to(data)
            with self.subTest(f"{start.__name__} around {name}"):
                made, messages = evolved(start(box_of(data)), distance)
                self.check_reached(made, messages, distance.GetOutput().GetSpacing()[0])
                self.assertGreater(made.GetOutput().GetNumberOfPoints(), 600)

    def test_a_membrane_is_said(self):
        torus = model("torus.ply")                # radii 1 and 0.4: a hole 1.2 wide
        for start in (icosphere, eight_corners):
            made, messages = evolved(start(box_of(torus)), distance_to(torus))
            self.assertEqual(messages.errors, [])
            self.assertEqual(messages.warnings, shortcomings(made))
            self.assertEqual(len(messages.warnings), 1)
            said = re.search(r"membranes? spans?.*?, ([\d.]+) wide at \((\S+) (\S+) (\S+)\)",
                             messages.warnings[0])
            width, *place = map(float, said.groups())
            self.assertAlmostEqual(width, 1.2, delta=0.12)
            self.assertAlmostEqual(width, 2.0 * value(made, "MaxDistance"), delta=0.01)
            self.assertLess(np.linalg.norm(place[:2]), 0.3)
            self.assertIn("vtkShrinkWrap", messages.warnings[0])
            self.assertGreater(value(made, "MinAngle"), 20.0)

    def test_a_start_with_the_hole_leaves_none(self):
        torus = model("torus.ply")
        made, messages = evolved(self.wrapped(torus), distance_to(torus))
        self.assertEqual(messages.errors + messages.warnings, [])

    @staticmethod
    def wrapped(data):
        wrap = es.vtkShrinkWrap()
        wrap.SetInputData(data)
        return wrap

    def test_nothing_is_said_on_the_way(self):
        torus = model("torus.ply")
        made, messages = evolved(icosphere(box_of(torus)), distance_to(torus), TimeStep=0.01,
                                 NumberOfSteps=10)
        self.assertEqual(messages.errors + messages.warnings + shortcomings(made), [])

    def test_uniform_elements_suit_the_target_whatever_the_start(self):
        bunny = model("bunny.ply")
        distance = distance_to(bunny)
        cell = distance.GetOutput().GetSpacing()[0]
        counts = []
        for larger in (1.1, 10.0):
            made, messages = evolved(icosphere(box_of(bunny), larger), distance,
                                     Remeshing=E.UNIFORM)
            self.check_reached(made, messages, cell)
            counts.append(made.GetOutput().GetNumberOfPoints())
        self.assertLess(max(counts), 1.1 * min(counts))
        self.assertGreater(min(counts), 2000)

    def test_uniform_elements_of_an_open_surface_are_as_large_as_they_were(self):
        bunny = model("bunny.ply")
        (x0, y0, z0), (x1, y1, z1) = box_of(bunny).T
        sheet = vtkPlaneSource()
        sheet.SetOrigin(x0, y0, 0.5 * (z0 + z1))
        sheet.SetPoint1(x1, y0, 0.5 * (z0 + z1))
        sheet.SetPoint2(x0, y1, 0.5 * (z0 + z1))
        sheet.SetResolution(10, 10)
        triangles = vtkTriangleFilter()
        triangles.SetInputConnection(sheet.GetOutputPort())
        made, messages = evolved(triangles, distance_to(bunny), Remeshing=E.UNIFORM,
                                 TimeStep=1e-6, NumberOfSteps=1)
        self.assertEqual(messages.errors, [])
        self.assertLess(made.GetOutput().GetNumberOfPoints(), 200)     # of 121


if __name__ == "__main__":
    unittest.main()
