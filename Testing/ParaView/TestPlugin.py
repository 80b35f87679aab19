# SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
# SPDX-License-Identifier: BSD-3-Clause
"""The plugin in pvpython: it loads, all its proxies are there, and the pipelines users write run.

    pvpython TestPlugin.py PLUGIN_FILE DATA_FOLDER OUTPUT_FOLDER
"""

import math
import pathlib
import sys
import unittest

import numpy
import paraview.simple as pv
from vtkmodules.util.numpy_support import vtk_to_numpy

import evolvingsurfaces  # noqa: F401  (makes GetClientSideObject() give the wrapped class)

OUTPUT = pathlib.Path(sys.argv.pop())
DATA = pathlib.Path(sys.argv.pop())
pv.LoadPlugin(sys.argv.pop(), ns=vars(pv))


def data(proxy, port=0, time=None):
    """A copy of what the proxy's algorithm puts out."""
    proxy.UpdatePipeline(*([] if time is None else [time]))
    output = proxy.GetClientSideObject().GetOutputDataObject(port)
    copy = output.NewInstance()
    copy.ShallowCopy(output)
    return copy


def times(proxy):
    proxy.UpdatePipelineInformation()
    return list(proxy.TimestepValues)


def field(surface, name):
    return surface.GetFieldData().GetArray(name).GetValue(0)


def point_array(surface, name):
    return vtk_to_numpy(surface.GetPointData().GetArray(name))


def radii(surface):
    points = vtk_to_numpy(surface.GetPoints().GetData()).astype(float)
    return (points**2).sum(axis=1) ** 0.5


def smallest_angles(surface):
    """The smallest angle of every triangle, in degrees."""
    points = vtk_to_numpy(surface.GetPoints().GetData()).astype(float)
    triangles = vtk_to_numpy(surface.GetPolys().GetConnectivityArray()).reshape(-1, 3)
    corners = points[triangles]
    edges = numpy.roll(corners, -1, axis=1) - corners
    edges /= numpy.linalg.norm(edges, axis=2, keepdims=True)
    cosines = -(edges * numpy.roll(edges, 1, axis=1)).sum(axis=2)
    return numpy.degrees(numpy.arccos(cosines.clip(-1.0, 1.0))).min(axis=1)


def relative_spread(values):
    return values.std() / values.mean()


class Proxies(unittest.TestCase):
    def test_all_proxies_have_constructors(self):
        for name in ("Icosphere", "MeshSDF", "SurfaceEvolution", "TangentialRedistribution",
                     "ShrinkWrap", "DistanceHierarchy", "LabelSurfaces"):
            self.assertTrue(hasattr(pv, name), name)

    def test_outputs_have_names(self):
        for filter_type in (pv.SurfaceEvolution, pv.ShrinkWrap):
            proxy = filter_type(Input=pv.Icosphere(Level=0))
            self.assertEqual(proxy.GetOutputPort(0).Port, 0)
            self.assertEqual(proxy.SMProxy.GetOutputPortName(0), "Surface")
            self.assertEqual(proxy.SMProxy.GetOutputPortName(1), "History")

    def test_enumerations_by_their_texts(self):
        sdf = pv.MeshSDF(Input=pv.Icosphere(Level=1), SampleDimensions=[9, 9, 9])
        sdf.Method = "Brute Force"
        sdf.Sign = "Unsigned"
        image = data(sdf)
        self.assertGreaterEqual(point_array(image, "SignedDistance").min(), 0.0)


class Sources(unittest.TestCase):
    def test_shapes(self):
        counts = {}
        for shape in ("Icosphere", "Cube Sphere", "Box"):
            surface = data(pv.Icosphere(Shape=shape, Level=2, Resolution=4))
            counts[shape] = (surface.GetNumberOfPoints(), surface.GetNumberOfCells())
        quads = (98, 96)
        self.assertEqual(counts, {"Icosphere": (162, 320), "Cube Sphere": quads, "Box": quads})

    def test_radius_and_center(self):
        surface = data(pv.Icosphere(Radius=2.0, Center=[5.0, 0.0, 0.0]))
        self.assertAlmostEqual(surface.GetBounds()[1], 7.0, delta=0.05)


END = 3.0


class SpherePipeline(unittest.TestCase):
    """Icosphere -> Mesh SDF -> Contour -> Surface Evolution -> Tangential Redistribution."""

    @classmethod
    def setUpClass(cls):
        cls.sphere = pv.Icosphere(Level=4)
        cls.sdf = pv.MeshSDF(Input=cls.sphere, SampleDimensions=[41, 41, 41], Padding=0.4)
        cls.contour = pv.Contour(Input=cls.sdf, ContourBy=["POINTS", "SignedDistance"],
                                 Isosurfaces=[0.4])
        cls.evolution = pv.SurfaceEvolution(Input=cls.contour, DistanceField=cls.sdf)
        cls.evolution.NumberOfSteps = 30
        cls.evolution.TimeStep = 0.1
        cls.evolution.VolumeRedistribution = 1.0
        cls.evolution.Remeshing = "Off"  # for the redistribution to have something to do
        cls.even = pv.TangentialRedistribution(Input=cls.evolution)

    def test_distance_of_a_sphere(self):
        image = data(self.sdf)
        self.assertEqual(image.GetDimensions(), (41, 41, 41))
        spacing = image.GetSpacing()
        self.assertAlmostEqual(spacing[0], spacing[1], places=12)
        self.assertEqual(image.GetPointData().GetScalars().GetName(), "SignedDistance")
        center = image.FindPoint((0.0, 0.0, 0.0))
        self.assertAlmostEqual(point_array(image, "SignedDistance")[center], -1.0, delta=0.01)
        corner = math.dist(image.GetOrigin(), (0, 0, 0)) - 1.0
        self.assertAlmostEqual(point_array(image, "SignedDistance")[0], corner, delta=0.01)

    def test_contour_takes_the_image_as_it_is(self):
        surface = data(self.contour)
        self.assertAlmostEqual(radii(surface).mean(), 1.4, delta=0.01)

    def test_evolution_reaches_the_sphere(self):
        surface = data(self.evolution, time=END)
        # exp(-C T) of the first distance is left: 0.4 exp(-3), and curvature flow on top.
        self.assertAlmostEqual(radii(surface).mean(), 1.02, delta=0.02)
        self.assertEqual(field(surface, "Iteration"), 30)
        self.assertAlmostEqual(field(surface, "Time"), 3.0, places=12)
        self.assertAlmostEqual(field(surface, "Area"), 4 * math.pi * 1.02**2, delta=0.6)
        for name in ("SignedDistance", "Normals", "MeanCurvature", "CoVolume", "NormalVelocity",
                     "TangentialVelocity", "RedistributionPotential"):
            self.assertIsNotNone(surface.GetPointData().GetArray(name), name)

    def test_history_has_a_row_for_every_step(self):
        history = data(self.evolution, 1)
        self.assertEqual(history.GetClassName(), "vtkTable")
        self.assertEqual(history.GetNumberOfRows(), 31)
        areas = vtk_to_numpy(history.GetColumnByName("Area"))
        self.assertTrue((areas[1:] < areas[:-1]).all())

    def test_time_steps_are_reported(self):
        published = times(self.evolution)
        self.assertEqual(len(published), 31)
        for k, time in enumerate(published):
            self.assertAlmostEqual(time, 0.1 * k, places=12)

    def test_states_at_their_times(self):
        start = data(self.evolution, time=0.0)
        self.assertAlmostEqual(radii(start).mean(), 1.4, delta=0.01)
        middle = data(self.evolution, time=1.5)
        self.assertEqual(field(middle, "Iteration"), 15)

    def test_redistribution_widens_angles(self):
        # Contours have slivers.
        evolved = data(self.evolution, time=END)
        self.assertLess(numpy.percentile(smallest_angles(evolved), 1), 10.0)
        even = data(self.even, time=END)
        self.assertGreater(numpy.percentile(smallest_angles(even), 1), 20.0)
        self.assertEqual(even.GetNumberOfPoints(), evolved.GetNumberOfPoints())

    def test_redistribution_makes_co_volumes_even(self):
        by_volume = pv.TangentialRedistribution(
            Input=self.evolution, VolumeRedistribution=1.0, AngleRedistribution=0.0)
        before = relative_spread(point_array(data(self.evolution, time=END), "CoVolume"))
        after = relative_spread(point_array(data(by_volume, time=END), "CoVolume"))
        self.assertLess(after, 0.85 * before)


class BunnyPipeline(unittest.TestCase):
    """Reader -> Mesh SDF -> Contour -> Surface Evolution; reader -> Shrink Wrap."""

    @classmethod
    def setUpClass(cls):
        cls.bunny = pv.PLYReader(FileNames=[str(DATA / "bunny.ply")])

    def test_evolution_onto_the_bunny(self):
        sdf = pv.MeshSDF(Input=self.bunny, SampleDimensions=[40, 40, 40])
        bounds = data(self.bunny).GetBounds()
        size = max(bounds[1] - bounds[0], bounds[3] - bounds[2], bounds[5] - bounds[4])
        contour = pv.Contour(Input=sdf, ContourBy=["POINTS", "SignedDistance"],
                             Isosurfaces=[0.05 * size])
        evolution = pv.SurfaceEvolution(Input=contour, DistanceField=sdf, NumberOfSteps=20,
                                        TimeStep=0.1, OutputInterval=5)
        self.assertEqual(len(times(evolution)), 5)
        result = data(evolution)
        self.assertLess(abs(point_array(result, "SignedDistance")).mean(), 0.02 * size)
        self.assertLess(field(result, "MeanDistance"), 0.02 * size)

    def test_shrink_wrap(self):
        torus = pv.PLYReader(FileNames=[str(DATA / "torus.ply")])
        wrap = pv.ShrinkWrap(Input=torus, SampleDimensions=[64, 64, 64], TargetEdgeLength=0.1)
        self.assertEqual(times(wrap), [])
        result = data(wrap)
        bounds = torus.GetDataInformation().GetBounds()
        size = bounds[1] - bounds[0]
        self.assertEqual(field(result, "IsClosed"), 1)
        self.assertEqual(field(result, "IsManifold"), 1)
        self.assertEqual(field(result, "SelfIntersections"), 0)
        self.assertEqual(field(result, "Genus"), 1)
        self.assertLess(field(result, "MaxDistance"), 0.02 * size)
        self.assertEqual(data(wrap, 1).GetNumberOfRows(), 5)

    def test_shrink_wrap_as_a_series(self):
        wrap = pv.ShrinkWrap(Input=pv.Icosphere(), SampleDimensions=[32, 32, 32],
                             TargetEdgeLength=0.2, NumberOfSteps=10, OutputSteps=1)
        start = data(wrap, time=0.0)
        self.assertGreater(radii(start).min(), 1.02)
        self.assertAlmostEqual(radii(data(wrap, time=times(wrap)[-1])).mean(), 1.0, delta=0.02)
        self.assertEqual(len(times(wrap)), 11)
        wrap.OutputSteps = 0
        self.assertEqual(len(times(wrap)), 0)

    def test_boxes_of_the_search_tree(self):
        boxes = pv.DistanceHierarchy(Input=self.bunny, Level=0)
        root = data(boxes)
        self.assertEqual(root.GetNumberOfCells(), 6)
        leaves = data(pv.DistanceHierarchy(Input=self.bunny))
        self.assertGreater(leaves.GetNumberOfCells(), 6 * 100)

    def test_boxes_of_the_octree(self):
        boxes = pv.DistanceHierarchy(Input=self.bunny, Structure="Octree",
                                     SampleDimensions=[32, 32, 32])
        leaves = data(boxes)
        self.assertGreater(leaves.GetNumberOfCells(), 6 * 100)
        cell = pv.MeshSDF(Input=self.bunny, SampleDimensions=[32, 32, 32])
        distance = vtk_to_numpy(leaves.GetCellData().GetArray("Distance"))
        self.assertLess(distance.max(), 0.87 * data(cell).GetSpacing()[0])
        boxes.Level = -2
        self.assertGreater(data(boxes).GetNumberOfCells(), leaves.GetNumberOfCells())


class FieldArrays(unittest.TestCase):
    """Which array of the image is the field, as panel and scripts choose it."""

    @classmethod
    def setUpClass(cls):
        sphere = pv.Icosphere(Level=3)
        sdf = pv.MeshSDF(Input=sphere, SampleDimensions=[32, 32, 32], Padding=0.3)
        cls.image = pv.Calculator(Input=sdf, Function="SignedDistance + 0.2",
                                  ResultArrayName="Inside")
        cls.cells = pv.PointDatatoCellData(Input=cls.image, PassPointData=0)
        for proxy in (cls.image, cls.cells):
            proxy.UpdatePipeline()  # as Apply does: panels offer what is there
        cls.start = pv.Icosphere(Level=3, Radius=1.4)

    def radius(self, **settings):
        self.evolution = pv.SurfaceEvolution(Input=self.start, Remeshing="Off", **settings)
        return radii(data(self.evolution)).mean()

    def test_by_default_it_is_the_active_array(self):
        self.assertAlmostEqual(self.radius(DistanceField=self.image), 0.8, delta=0.02)
        self.assertEqual(self.evolution.FieldArray[:], ["POINTS", "Inside"])

    def test_another_one_is_chosen(self):
        radius = self.radius(DistanceField=self.image, FieldArray=["POINTS", "SignedDistance"])
        self.assertAlmostEqual(radius, 1.0, delta=0.02)

    def test_arrays_of_cells_are_offered(self):
        radius = self.radius(DistanceField=self.cells, FieldArray=["CELLS", "SignedDistance"])
        self.assertAlmostEqual(radius, 1.0, delta=0.02)

    def test_a_field_that_comes_later_has_its_active_array(self):
        evolution = pv.SurfaceEvolution(Input=self.start, Remeshing="Off")
        evolution.DistanceField = self.image
        self.assertAlmostEqual(radii(data(evolution)).mean(), 0.8, delta=0.02)


class InputTimes(unittest.TestCase):
    """A series as input: an evolution of a sphere."""

    @classmethod
    def setUpClass(cls):
        cls.series = pv.SurfaceEvolution(Input=pv.Icosphere(Level=2), NumberOfSteps=4,
                                         TimeStep=0.04, CurvatureSpeed=1.0, RelativeUnits=0)

    def test_a_wrap_follows_it(self):
        wrap = pv.ShrinkWrap(Input=self.series, SampleDimensions=[24, 24, 24],
                             TargetEdgeLength=0.2)
        self.assertEqual(times(wrap), times(self.series))
        for time in times(wrap)[::2]:
            radius = radii(data(wrap, time=time)).mean()
            self.assertAlmostEqual(radius, radii(data(self.series, time=time)).mean(), delta=0.02)

    def test_an_evolution_takes_one_of_its_times(self):
        for settings, time in (({}, 0.16), ({"InputTime": "First Step"}, 0.0),
                               ({"InputTime": "Step Index", "InputTimeIndex": 1}, 0.04)):
            evolution = pv.SurfaceEvolution(Input=self.series, NumberOfSteps=2, **settings)
            start = data(evolution, time=0.0)
            self.assertAlmostEqual(field(start, "InputTime"), time)
            expected = radii(data(self.series, time=time)).mean()
            self.assertAlmostEqual(radii(start).mean(), expected, places=6)


class Files(unittest.TestCase):
    def test_series_reads_back(self):
        evolution = pv.SurfaceEvolution(Input=pv.Icosphere(Level=2), NumberOfSteps=6, TimeStep=0.01,
                                        CurvatureSpeed=1.0, RelativeUnits=0)
        scene = pv.GetAnimationScene()
        scene.UpdateAnimationUsingDataTimeSteps()
        path = OUTPUT / "series.pvd"
        pv.SaveData(str(path), proxy=evolution, WriteTimeSteps=1, DataMode="Binary")
        reader = pv.PVDReader(FileName=str(path))
        self.assertEqual(len(times(reader)), 7)
        for time in times(reader):
            read = data(reader, time=time)
            surface = read.GetBlock(0) if read.IsA("vtkMultiBlockDataSet") else read
            self.assertEqual(surface.GetNumberOfPoints(), 162)
            # Mean curvature flow of a sphere: r^2 = 1 - 4 t.
            self.assertAlmostEqual(radii(surface).mean(), math.sqrt(1 - 4 * time), delta=0.01)


if __name__ == "__main__":
    unittest.main()
