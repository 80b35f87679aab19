# SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
# SPDX-License-Identifier: BSD-3-Clause
"""Images as scanners make them, segmented with the defaults of Surface Evolution."""

import unittest

import evolvingsurfaces as es
import numpy as np
from vtkmodules.numpy_interface import dataset_adapter
from vtkmodules.vtkCommonDataModel import vtkImageData

from observing import Messages

E = es.vtkSurfaceEvolution
CENTER = np.array((20.3, -7.2, 4.9))              # millimetres
RADIUS = 9.0


def scan(spacing=(1.0, 1.0, 1.0), noise=0.1, inside=60.0, outside=-1000.0, half=15.0):
    """A ball of tissue in air."""
    counts = [int(2.0 * half / step) + 1 for step in spacing]
    image = vtkImageData()
    image.SetDimensions(counts)
    image.SetSpacing(spacing)
    image.SetOrigin(CENTER - half)
    axes = [CENTER[a] - half + spacing[a] * np.arange(counts[a]) for a in range(3)]
    z, y, x = np.meshgrid(*axes[::-1], indexing="ij")
    distance = np.sqrt((x - CENTER[0])**2 + (y - CENTER[1])**2 + (z - CENTER[2])**2) - RADIUS
    part = np.clip(0.5 - distance / min(spacing), 0.0, 1.0)
    part += noise * np.random.default_rng(2).normal(size=part.shape)
    values = outside + (inside - outside) * part
    dataset_adapter.WrapDataObject(image).PointData.append(values.ravel(), "Intensity")
    image.GetPointData().SetActiveScalars("Intensity")
    return image


def evolved(image, radius, **settings):
    start = es.vtkIcosphereSource()
    start.SetLevel(3)
    start.SetRadius(radius)
    start.SetCenter(*CENTER)
    made = E()
    made.SetInputConnection(start.GetOutputPort())
    made.SetInputData(1, image)
    for name, value in {"FieldMode": E.IMAGE, **settings}.items():
        getattr(made, "Set" + name)(value)
    messages = Messages(made)
    made.Update()
    return made, messages


def errors(made):
    points = dataset_adapter.WrapDataObject(made.GetOutput()).Points
    return np.linalg.norm(np.asarray(points) - CENTER, axis=1) - RADIUS


def field_value(made, name):
    return made.GetOutput().GetFieldData().GetArray(name).GetValue(0)


class Segmentation(unittest.TestCase):
    def check(self, made, messages, largest=0.5):
        self.assertEqual(messages.errors + messages.warnings, [])
        self.assertLess(abs(errors(made).mean()), 0.25)
        self.assertLess(np.abs(errors(made)).max(), largest)

    def test_a_ball_from_outside_and_from_a_seed(self):
        for intensities in ((60.0, -1000.0), (0.1, 0.3), (65535.0, 0.0)):
            image = scan(inside=intensities[0], outside=intensities[1])
            with self.subTest(intensities):
                self.check(*evolved(image, 13.0))
                self.check(*evolved(image, 3.0, NormalSpeed=1.0))

    def test_slices_may_be_apart(self):
        for radius, speed in ((13.0, 0.0), (3.0, 1.0)):
            made, messages = evolved(scan((0.7, 0.7, 2.0)), radius, NormalSpeed=speed)
            self.check(made, messages, largest=1.0)       # half a voxel's longest side

    def test_the_sharpness_used_is_told_and_can_be_set(self):
        image = scan()
        relative, _ = evolved(image, 13.0)
        absolute, _ = evolved(image, 13.0, RelativeUnits=False, CurvatureSpeed=50.0,
                              AdvectionSpeed=500.0)
        length = np.sqrt(3.0) * 13.0
        ratio = field_value(absolute, "EdgeSharpness") / field_value(relative, "EdgeSharpness")
        self.assertAlmostEqual(ratio / length**2, 1.0, places=1)
        given, _ = evolved(image, 13.0, EdgeSharpness=2.0e-6, NumberOfSteps=1)
        self.assertAlmostEqual(field_value(given, "EdgeSharpness"), 2.0e-6)
        edges, _ = evolved(image, 13.0, FieldMode=E.EDGE_IMAGE, NumberOfSteps=1)
        self.assertIsNone(edges.GetOutput().GetFieldData().GetArray("EdgeSharpness"))

    def test_an_image_without_edges_is_refused(self):
        for image in (scan(inside=7.0, outside=7.0), scan(noise=0.1, half=4.0)):
            made, messages = evolved(image, 3.0)
            self.assertEqual(len(messages.errors), 1)
            self.assertIn("EdgeSharpness", messages.errors[0])
            self.assertEqual(made.GetOutput().GetNumberOfPoints(), 0)


if __name__ == "__main__":
    unittest.main()
