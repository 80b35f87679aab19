# SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
# SPDX-License-Identifier: BSD-3-Clause
"""The filters as scripts use them: in pipelines, with NumPy, step by step."""

import math
import unittest

import evolvingsurfaces as es
import numpy as np
from vtkmodules.numpy_interface import dataset_adapter
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import VTK_QUAD, vtkImageData, vtkPolyData
from vtkmodules.vtkCommonExecutionModel import vtkAlgorithm, vtkStreamingDemandDrivenPipeline
from vtkmodules.vtkFiltersCore import vtkFlyingEdges3D


def icosphere(level=3, radius=1.0, precision=vtkAlgorithm.SINGLE_PRECISION):
    source = es.vtkIcosphereSource()
    source.SetOutputPointsPrecision(precision)
    source.SetLevel(level)
    source.SetRadius(radius)
    source.Update()
    return source.GetOutput()


def box_surface(corners):
    """The faces of a box with corners in the order of their coordinates."""
    surface = vtkPolyData()
    points = vtkPoints()
    points.SetData(numpy_to_vtk(corners, deep=True))
    surface.SetPoints(points)
    surface.AllocateEstimate(6, 4)
    for face in ((0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4),
                 (1, 5, 7, 3)):
        surface.InsertNextCell(VTK_QUAD, 4, face)
    return surface


def radii(surface):
    return np.linalg.norm(vtk_to_numpy(surface.GetPoints().GetData()), axis=1)


def field_value(data, name):
    return data.GetFieldData().GetArray(name).GetValue(0)


def sphere_field(n=33, size=2.0):
    """An image made with NumPy: the distance to the unit sphere."""
    axis = np.linspace(-size, size, n)
    z, y, x = np.meshgrid(axis, axis, axis, indexing="ij")
    distance = np.sqrt(x * x + y * y + z * z) - 1.0
    image = vtkImageData()
    image.SetDimensions(n, n, n)
    image.SetOrigin(-size, -size, -size)
    image.SetSpacing(3 * (axis[1] - axis[0],))
    image.GetPointData().SetScalars(numpy_to_vtk(distance.ravel(), deep=True))
    return image


class NumPy(unittest.TestCase):
    def test_the_distance_is_an_array_of_the_grids_shape(self):
        sdf = es.vtkMeshSDF()
        sdf.SetInputData(icosphere(4))
        sdf.SetSampleDimensions(20, 24, 28)
        sdf.Update()
        image = sdf.GetOutput()
        distance = vtk_to_numpy(image.GetPointData().GetScalars())
        self.assertEqual(distance.dtype, np.float32)
        distance = distance.reshape(28, 24, 20)
        axes = [o + h * np.arange(n) for o, h, n in
                zip(image.GetOrigin(), image.GetSpacing(), image.GetDimensions())]
        z, y, x = np.meshgrid(axes[2], axes[1], axes[0], indexing="ij")
        exact = np.sqrt(x * x + y * y + z * z) - 1.0
        self.assertLess(np.abs(distance - exact).max(), 0.01)

    def test_a_field_made_with_numpy_attracts(self):
        evolution = es.vtkSurfaceEvolution()
        evolution.SetInputData(0, icosphere(3, 1.5))
        evolution.SetInputData(1, sphere_field())
        evolution.SetTimeStep(0.1)
        evolution.SetNumberOfSteps(40)
        evolution.SetCurvatureSpeed(0.01)
        evolution.Update()
        self.assertLess(np.abs(radii(evolution.GetOutput()) - 1.0).max(), 0.02)

    def test_points_made_with_numpy_are_a_point_set(self):
        generator = np.random.default_rng(7)
        cloud = generator.normal(size=(500, 3))
        cloud /= np.linalg.norm(cloud, axis=1)[:, None]
        points = vtkPoints()
        points.SetData(numpy_to_vtk(cloud, deep=True))
        mesh = vtkPolyData()
        mesh.SetPoints(points)
        sdf = es.vtkMeshSDF()
        sdf.SetInputData(mesh)
        sdf.SetSampleDimensions(9, 9, 9)
        sdf.SetMethodToBruteForce()
        sdf.Update()
        image = sdf.GetOutput()
        samples = np.array([image.GetPoint(i) for i in range(image.GetNumberOfPoints())])
        exact = np.linalg.norm(samples[:, None, :] - cloud[None, :, :], axis=2).min(axis=1)
        found = vtk_to_numpy(image.GetPointData().GetScalars())
        self.assertLess(np.abs(found - exact).max(), 1e-6)
        self.assertEqual(field_value(image, "SignMethod"), es.vtkMeshSDF.UNSIGNED)

    def test_the_adapter_of_vtk_reads_arrays_and_history(self):
        evolution = es.vtkSurfaceEvolution()
        # Areas are those of the points as they are written, arrays those of the flow.
        evolution.SetInputData(icosphere(2, precision=vtkAlgorithm.DOUBLE_PRECISION))
        evolution.SetNumberOfSteps(5)
        evolution.Update()
        surface = dataset_adapter.WrapDataObject(evolution.GetOutput())
        self.assertEqual(surface.PointData["Normals"].shape, (162, 3))
        area = float(np.sum(surface.PointData["CoVolume"]))
        self.assertAlmostEqual(area, field_value(evolution.GetOutput(), "Area"), places=9)
        history = dataset_adapter.WrapDataObject(evolution.GetOutputDataObject(1))
        self.assertEqual(len(history.RowData["Area"]), 6)
        self.assertTrue(np.all(np.diff(history.RowData["Area"]) < 0.0))


class Steps(unittest.TestCase):
    def setUp(self):
        self.evolution = es.vtkSurfaceEvolution()
        self.evolution.SetInputData(icosphere(2))
        self.evolution.SetTimeStep(0.01)
        self.evolution.SetNumberOfSteps(6)
        self.evolution.SetOutputInterval(2)
        self.evolution.RelativeUnitsOff()
        self.evolution.SetCurvatureSpeed(1.0)

    def test_times_are_known_beforehand(self):
        self.evolution.UpdateInformation()
        times = self.evolution.GetOutputInformation(0).Get(
            vtkStreamingDemandDrivenPipeline.TIME_STEPS())
        self.assertEqual(times, (0.0, 0.02, 0.04, 0.06))

    def test_each_time_is_its_state_and_all_are_one_solve(self):
        for time in (0.06, 0.0, 0.04):
            self.evolution.UpdateTimeStep(time)
            exact = np.sqrt(1.0 - 4.0 * time)
            self.assertLess(np.abs(radii(self.evolution.GetOutput()) - exact).max(), 0.02)
        self.assertEqual(self.evolution.GetNumberOfSolves(), 1)

    def test_remeshing_changes_the_number_of_points_on_the_way(self):
        evolution = es.vtkSurfaceEvolution()
        evolution.SetInputData(icosphere(3))
        evolution.SetNumberOfSteps(20)
        evolution.RelativeUnitsOff()
        evolution.SetCurvatureSpeed(1.0)
        evolution.SetTimeStep(0.01)
        evolution.SetRemeshing(es.vtkSurfaceEvolution.UNIFORM)
        counts = []
        for step in (0, 10, 20):
            evolution.UpdateTimeStep(step * 0.01)
            output = evolution.GetOutput()
            counts.append(output.GetNumberOfPoints())
            radius = math.sqrt(1.0 - 0.04 * step)
            self.assertLess(np.abs(radii(output) - radius).max(), 0.15 * radius)
            normals = output.GetPointData().GetArray("Normals")
            self.assertEqual(normals.GetNumberOfTuples(), counts[-1])
        self.assertEqual(counts[0], 642)
        self.assertEqual(counts, sorted(counts, reverse=True))
        self.assertLess(counts[2], 200)

    def test_a_kept_output_does_not_change(self):
        self.evolution.UpdateTimeStep(0.0)
        first = vtkPolyData()
        first.ShallowCopy(self.evolution.GetOutput())
        self.evolution.UpdateTimeStep(0.06)
        self.assertAlmostEqual(radii(first).max(), 1.0, places=6)


class Pipelines(unittest.TestCase):
    def test_from_a_distance_to_an_even_surface(self):
        sdf = es.vtkMeshSDF()
        sdf.SetInputData(icosphere())
        sdf.SetSampleDimensions(32, 32, 32)
        start = vtkFlyingEdges3D()
        start.SetInputConnection(sdf.GetOutputPort())
        start.SetValue(0, 0.15)
        evolution = es.vtkSurfaceEvolution()
        evolution.SetInputConnection(0, start.GetOutputPort())
        evolution.SetDistanceFieldConnection(sdf.GetOutputPort())
        evolution.SetTimeStep(0.1)
        evolution.SetNumberOfSteps(40)
        evolution.SetCurvatureSpeed(0.001)
        even = es.vtkTangentialRedistribution()
        even.SetInputConnection(evolution.GetOutputPort())
        even.SetNumberOfSteps(10)
        even.Update()
        errors = np.abs(radii(even.GetOutput()) - 1.0)
        self.assertLess(np.percentile(errors, 99), 0.01)
        self.assertLess(errors.max(), 0.05)  # slivers of the contour may wait, not fold
        self.assertEqual(even.GetOutput().GetNumberOfPolys(),
                         evolution.GetOutput().GetNumberOfPolys())

    def test_one_filter_does_it_all(self):
        wrap = es.vtkShrinkWrap()
        wrap.SetInputData(icosphere())
        wrap.SetSampleDimensions(32, 32, 32)
        wrap.SetTargetEdgeLength(0.2)
        wrap.SetNumberOfSteps(30)
        wrap.Update()
        surface = wrap.GetOutput()
        self.assertEqual(field_value(surface, "IsClosed"), 1)
        self.assertEqual(field_value(surface, "Genus"), 0)
        self.assertLess(np.abs(radii(surface) - 1.0).max(), 0.03)

    def test_creases_and_corners_can_be_preserved(self):
        box = np.array([[x, y, z] for x in (0, 1) for y in (0, 2) for z in (0, 3)], dtype=float)
        wrap = es.vtkShrinkWrap()
        wrap.SetInputData(box_surface(box))
        wrap.SetSampleDimensions(40, 40, 40)
        wrap.SetTargetEdgeLength(0.25)
        wrap.SetNumberOfSteps(30)
        wrap.SetPreserveFeaturesToOn()
        wrap.SetFeatureAngle(60.0)
        wrap.Update()
        points = vtk_to_numpy(wrap.GetOutput().GetPoints().GetData())
        to_corners = np.linalg.norm(points[:, None] - box[None], axis=2)
        self.assertLess(to_corners.min(axis=0).max(), 1e-6)
        # Every vertex lies on a side, and on edges there are some with two coordinates of sides.
        sides = np.isclose(points, 0.0, atol=1e-6) | np.isclose(points, [1, 2, 3], atol=1e-6)
        self.assertTrue(sides.any(axis=1).all())
        self.assertGreater((sides.sum(axis=1) == 2).sum(), 24 / 0.25 * 0.7)

    def test_boxes_can_be_looked_at(self):
        boxes = es.vtkDistanceHierarchy()
        boxes.SetInputData(icosphere())
        boxes.Update()
        self.assertEqual(boxes.GetOutput().GetNumberOfPolys() % 6, 0)
        level = vtk_to_numpy(boxes.GetOutput().GetCellData().GetArray("Level"))
        self.assertGreater(level.max(), 5)

    def test_figures_of_both_structures_can_be_drawn(self):
        for structure, measure in ((es.vtkDistanceHierarchy.AABB_TREE, "NumberOfTriangles"),
                                   (es.vtkDistanceHierarchy.OCTREE, "Distance")):
            boxes = es.vtkDistanceHierarchy()
            boxes.SetInputData(icosphere())
            boxes.SetStructure(structure)
            boxes.SetSampleDimensions(24, 24, 24)
            boxes.Update()
            leaves = boxes.GetOutput().GetNumberOfPolys()
            self.assertGreater(vtk_to_numpy(
                boxes.GetOutput().GetCellData().GetArray(measure)).max(), 0)
            boxes.SetLevel(-2)                   # all levels
            boxes.Update()
            levels = vtk_to_numpy(boxes.GetOutput().GetCellData().GetArray("Level"))
            self.assertEqual(np.count_nonzero(levels == 0), 6)
            self.assertGreater(len(levels), leaves)


class Errors(unittest.TestCase):
    def test_an_error_is_an_event_with_a_sentence(self):
        messages = []

        def remember(_, __, message):
            messages.append(message)

        remember.CallDataType = "string0"
        sheet = vtkPolyData()
        points = vtkPoints()
        points.InsertNextPoint(0.0, 0.0, 0.0)
        sheet.SetPoints(points)
        evolution = es.vtkSurfaceEvolution()
        evolution.AddObserver("ErrorEvent", remember)
        evolution.GetExecutive().AddObserver("ErrorEvent", lambda *_: None)
        evolution.SetInputData(sheet)
        evolution.Update()
        self.assertEqual(len(messages), 1)
        self.assertIn("no polygons", messages[0])
        self.assertEqual(evolution.GetOutput().GetNumberOfPoints(), 0)


if __name__ == "__main__":
    unittest.main()
