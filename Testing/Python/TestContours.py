# SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
# SPDX-License-Identifier: BSD-3-Clause
"""What contour filters hand over, through evolution and redistribution, on shapes that are known."""

import unittest

import evolvingsurfaces as es
import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkFiltersCore import vtkContourFilter, vtkFlyingEdges3D

SHIFT = np.array([0.13, -0.21, 0.37])            # no symmetry with the samples


def sphere(radius):
    return lambda x: np.linalg.norm(x, axis=-1) - radius


def ellipsoid(axes):
    """The distance to first order: nothing of it is lost near the surface."""
    def distance(x):
        k0 = np.linalg.norm(x / axes, axis=-1)
        k1 = np.linalg.norm(x / np.square(axes), axis=-1)
        return k0 * (k0 - 1.0) / np.maximum(k1, 1e-12)
    return distance


def torus(ring, tube):
    return lambda x: np.hypot(np.hypot(x[..., 0], x[..., 1]) - ring, x[..., 2]) - tube


def image_of(function, dimensions, spacing=(1.0, 1.0, 1.0), center=(0.0, 0.0, 0.0)):
    """An image of values at samples around a point."""
    image = vtkImageData()
    image.SetDimensions(dimensions)
    image.SetSpacing(spacing)
    origin = [c - 0.5 * (n - 1) * h for c, n, h in zip(center, dimensions, spacing)]
    image.SetOrigin(origin)
    axes = [o + h * np.arange(n) for o, n, h in zip(origin, dimensions, spacing)]
    z, y, x = np.meshgrid(axes[2], axes[1], axes[0], indexing="ij")
    values = function(np.stack([x, y, z], axis=-1)).astype(np.float32)
    image.GetPointData().SetScalars(numpy_to_vtk(values.ravel(), deep=True))
    return image


def contour_of(image, value, kind=vtkFlyingEdges3D):
    contour = kind()
    contour.SetInputData(image)
    contour.SetValue(0, value)
    return contour


def field_of(surface):
    field = es.vtkMeshSDF()
    field.SetInputConnection(surface.GetOutputPort())
    field.SetSampleDimensions(48, 48, 48)
    return field


def evolution_of(surface, field=None):
    evolution = es.vtkSurfaceEvolution()
    evolution.SetInputConnection(0, surface.GetOutputPort())
    if field:
        evolution.SetInputConnection(1, field.GetOutputPort())
    return evolution


def evened(surface):
    even = es.vtkTangentialRedistribution()
    even.SetInputConnection(surface.GetOutputPort())
    even.Update()
    return even.GetOutput()


def arrays_of(surface):
    points = vtk_to_numpy(surface.GetPoints().GetData()).astype(float)
    return points, vtk_to_numpy(surface.GetPolys().GetConnectivityArray()).reshape(-1, 3)


def smallest_angles(surface):
    """One per triangle, in degrees."""
    points, triangles = arrays_of(surface)
    corners = points[triangles]
    angles = []
    for k in range(3):
        a = corners[:, (k + 1) % 3] - corners[:, k]
        b = corners[:, (k + 2) % 3] - corners[:, k]
        lengths = np.linalg.norm(a, axis=1) * np.linalg.norm(b, axis=1)
        cosine = np.where(lengths > 0.0, np.einsum("ij,ij->i", a, b), 1.0)
        angles.append(np.arccos(np.clip(cosine / np.where(lengths > 0.0, lengths, 1.0), -1, 1)))
    return np.degrees(np.min(angles, axis=0))


def normal_rms(surface, distance):
    """The angle between faces and the exact shape, in degrees, over the area."""
    points, triangles = arrays_of(surface)
    a, b, c = (points[triangles[:, k]] for k in range(3))
    normal = np.cross(b - a, c - a)
    area = np.linalg.norm(normal, axis=1)
    middle = (a + b + c) / 3.0
    gradient = np.stack([distance(middle + h) - distance(middle - h)
                         for h in 1e-5 * np.eye(3)], axis=1)
    gradient /= np.linalg.norm(gradient, axis=1)[:, None]
    cosine = np.abs(np.einsum("ij,ij->i", normal, gradient)) / area
    return np.sqrt(np.average(np.degrees(np.arccos(np.clip(cosine, 0, 1))) ** 2, weights=area))


class Contours(unittest.TestCase):
    def expect_good(self, surface, distance, smallest=35.0):
        angles = smallest_angles(surface)
        self.assertGreaterEqual(angles.min(), smallest)
        self.assertGreaterEqual(np.percentile(angles, 1), 42.0)
        self.assertLess(np.abs(distance(arrays_of(surface)[0])).mean(), 0.1)  # cells are 1

    def test_of_a_distance_with_defaults(self):
        exact = torus(12.0, 5.0)
        image = image_of(exact, (40, 40, 20), center=SHIFT)
        contour = contour_of(image, 1.0)
        evolution = evolution_of(contour)
        evolution.SetInputDataObject(1, image)
        result = evened(evolution)
        self.assertLess(smallest_angles(contour.GetOutput()).min(), 1.0)
        self.expect_good(result, exact)
        self.assertLess(normal_rms(result, exact), 3.0)

    def test_of_a_noisy_image_with_cells_that_are_no_cubes(self):
        exact = ellipsoid(np.array([16.0, 12.0, 10.0]))
        random = np.random.default_rng(1)

        def intensities(x):
            blurred = -1000.0 + 1050.0 / (1.0 + np.exp(exact(x) / 0.8))
            return blurred + 20.0 * random.standard_normal(blurred.shape)

        contour = contour_of(image_of(intensities, (56, 46, 18), (0.7, 0.7, 1.5), SHIFT), -475.0)
        result = evened(evolution_of(contour, field_of(contour)))
        self.assertLess(smallest_angles(contour.GetOutput()).min(), 1.0)
        self.expect_good(result, exact)

    def test_of_labels_have_no_steps(self):
        for exact in (sphere(10.0), ellipsoid(np.array([16.0, 12.0, 10.0])), torus(11.0, 5.0)):
            labels = image_of(lambda x: exact(x) < 0.0, (40, 36, 30), center=SHIFT)
            contour = contour_of(labels, 0.5)
            evolution = evolution_of(contour)
            evolution.SetFlowToSurfaceDiffusion()
            evolution.SetRemeshingToUniform()
            evolution.RelativeUnitsOff()
            evolution.SetCurvatureSpeed(1.0)
            evolution.SetTimeStep(1.0)
            evolution.SetNumberOfSteps(10)
            result = evened(evolution)
            self.assertGreater(normal_rms(contour.GetOutput(), exact), 20.0)
            self.assertLess(normal_rms(result, exact), 3.0)
            self.expect_good(result, exact)

    def test_that_ends_at_the_border_of_the_image(self):
        for height in (4.0, 8.0, 11.0):          # of the border over the centre
            exact = ellipsoid(np.array([16.0, 12.0, 14.0]))
            image = image_of(exact, (40, 32, 18), center=(*SHIFT[:2], height + 8.5 - 18.0))
            contour = contour_of(image, 0.0)
            evolution = evolution_of(contour)
            evolution.SetInputDataObject(1, image)
            result = evened(evolution)
            self.assertLess(smallest_angles(contour.GetOutput()).min(), 4.0)
            self.expect_good(result, exact, 30.0)
            points = arrays_of(result)[0]
            top = points[:, 2] > height + 17.0 - 18.0 - 1e-5
            self.assertGreater(np.count_nonzero(top), 30)   # it still ends there
            self.assertLess(np.abs(exact(points[top])).max(), 0.05)

    def test_through_samples_does_not_stop_a_flow_that_keeps_its_elements(self):
        image = image_of(lambda x: np.square(x).sum(axis=-1) - 100.0, (25, 25, 25))
        for kind in (vtkFlyingEdges3D, vtkContourFilter):
            evolution = evolution_of(contour_of(image, 0.0, kind))
            evolution.SetRemeshingToOff()
            evolution.SetNumberOfSteps(10)
            messages = []
            evolution.AddObserver("ErrorEvent", lambda *_: messages.append("error"))
            evolution.Update()
            self.assertEqual(messages, [])
            self.assertGreater(evolution.GetOutput().GetNumberOfPolys(), 1000)
            self.assertIsNone(evolution.GetOutput().GetFieldData().GetArray("Stopped"))

    def test_keep_their_data(self):
        image = image_of(sphere(8.0), (24, 24, 24), center=SHIFT)
        height = image_of(lambda x: x[..., 2], (24, 24, 24), center=SHIFT)
        height.GetPointData().GetScalars().SetName("Height")
        image.GetPointData().AddArray(height.GetPointData().GetScalars())
        contour = vtkContourFilter()             # interpolates every array, to the points' height
        contour.SetInputData(image)
        contour.SetValue(0, 0.0)
        contour.Update()
        evolution = evolution_of(contour)
        evolution.SetInputDataObject(1, image)
        for time in (0.0, 5.0, 150.0):
            evolution.UpdateTimeStep(time)
            result = evolution.GetOutput()
            kept = vtk_to_numpy(result.GetPointData().GetArray("Height"))
            self.assertLess(np.abs(kept - arrays_of(result)[0][:, 2]).max(), 0.3)
            if time > 0.0:
                self.assertGreater(smallest_angles(result).min(), 20.0)
        evolution.UpdateTimeStep(0.0)
        before, after = (np.count_nonzero(smallest_angles(source.GetOutput()) < 10.0)
                         for source in (contour, evolution))
        self.assertLess(after, 0.1 * before)   # what is left goes with the first step

    def test_that_are_good_already_do_not_become_worse(self):
        exact = ellipsoid(np.array([9.0, 7.0, 6.0]))
        image = image_of(exact, (24, 20, 18), center=SHIFT)
        first = evolution_of(contour_of(image, 0.5))
        first.SetInputDataObject(1, image)
        second = evolution_of(first)
        second.SetInputDataObject(1, image)
        second.Update()
        for source in (first, second):
            before = smallest_angles(source.GetOutput())
            after = smallest_angles(evened(source))
            self.assertGreaterEqual(after.min(), min(before.min(), 40.0) - 1e-3)
            self.assertGreaterEqual(np.percentile(after, 1), np.percentile(before, 1) - 0.1)
        start, end = (smallest_angles(source.GetOutput()) for source in (first, second))
        self.assertGreaterEqual(end.min(), start.min() - 1.0)


if __name__ == "__main__":
    unittest.main()
