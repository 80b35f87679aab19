# SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
# SPDX-License-Identifier: BSD-3-Clause
"""A flow is solved once, whatever ParaView asks for: showing, stepping back, playing, saving.

    pvpython TestSolvesOnce.py PLUGIN_FILE OUTPUT_FOLDER        (needs a display)
"""

import os
import pathlib
import sys
import unittest

import paraview.simple as pv

import evolvingsurfaces  # noqa: F401  (makes GetClientSideObject() give the wrapped class)

OUTPUT = pathlib.Path(sys.argv.pop())
pv.LoadPlugin(sys.argv.pop(), ns=vars(pv))


def solves(proxy):
    return proxy.GetClientSideObject().GetNumberOfSolves()


def data_of(proxy, time):
    proxy.UpdatePipeline(time)
    return proxy.GetClientSideObject().GetOutputDataObject(0)


class SolvesOnce(unittest.TestCase):
    def setUp(self):
        pv.ResetSession()
        pv.GetActiveViewOrCreate("RenderView")
        self.sphere = pv.Icosphere(Level=3)

    def with_a_field(self, **properties):
        sdf = pv.MeshSDF(Input=self.sphere, SampleDimensions=[24, 24, 24])
        start = pv.Icosphere(Level=2, Radius=1.4)
        return pv.SurfaceEvolution(Input=start, DistanceField=sdf, TimeStep=0.03, **properties)

    def browse(self, proxy, name):
        """What a user does with a time series; the number of solves after each part."""
        view = pv.GetActiveView()
        scene = pv.GetAnimationScene()
        scene.UpdateAnimationUsingDataTimeSteps()
        counts = {}
        pv.Show(proxy, view)
        pv.Render(view)
        counts["show"] = solves(proxy)
        scene.GoToLast()
        for _ in range(2):
            scene.GoToPrevious()
        scene.GoToNext()
        counts["steps"] = solves(proxy)
        scene.Play()
        scene.GoToFirst()
        scene.Play()
        counts["play twice"] = solves(proxy)
        pv.SaveData(str(OUTPUT / f"{name}.pvd"), proxy=proxy, WriteTimeSteps=1, DataMode="Binary")
        pv.SaveData(str(OUTPUT / f"{name}.vtp"), proxy=proxy, Writetimestepsasfileseries=1,
                    DataMode="Binary")
        counts["save"] = solves(proxy)
        pv.SaveAnimation(str(OUTPUT / f"{name}.png"), view, ImageResolution=[64, 64])
        counts["save animation"] = solves(proxy)
        pv.ColorBy(pv.GetDisplayProperties(proxy, view), ("POINTS", "MeanCurvature"))
        pv.Render(view)
        counts["color"] = solves(proxy)
        return counts

    def assert_once(self, counts):
        self.assertEqual(counts, dict.fromkeys(counts, 1))

    def test_surface_evolution(self):
        evolution = pv.SurfaceEvolution(Input=self.sphere, NumberOfSteps=5)
        self.assert_once(self.browse(evolution, "evolution"))
        self.assertEqual(len(pv.GetAnimationScene().TimeKeeper.TimestepValues), 6)
        self.assertEqual(len(list(OUTPUT.glob("evolution.*.png"))), 6)

    def test_times_end_where_a_surface_vanishes(self):
        evolution = pv.SurfaceEvolution(Input=self.sphere, NumberOfSteps=100, TimeStep=0.02)
        evolution.UpdatePipelineInformation()
        self.assertEqual(len(evolution.TimestepValues), 101)
        view = pv.GetActiveView()
        scene = pv.GetAnimationScene()
        scene.UpdateAnimationUsingDataTimeSteps()
        pv.Show(evolution, view)
        pv.Render(view)
        scene.UpdateAnimationUsingDataTimeSteps()
        self.assertLess(len(scene.TimeKeeper.TimestepValues), 60)
        last = data_of(evolution, 2.0).GetFieldData().GetArray("Time").GetValue(0)
        self.assertEqual(evolution.TimestepValues[-1], last)
        self.assertEqual(solves(evolution), 1)

    def test_surface_evolution_with_a_field(self):
        self.assert_once(self.browse(self.with_a_field(NumberOfSteps=5), "field"))

    def test_shrink_wrap(self):
        wrap = pv.ShrinkWrap(Input=self.sphere, SampleDimensions=[24, 24, 24], NumberOfSteps=5,
                             OutputSteps=1)
        self.assert_once(self.browse(wrap, "wrap"))

    def test_with_its_history_in_a_chart_beside(self):
        evolution = self.with_a_field(NumberOfSteps=5)
        surfaces = pv.GetActiveView()
        chart = pv.CreateView("XYChartView")
        pv.AssignViewToLayout(chart)
        pv.Show(pv.OutputPort(evolution, 1), chart)
        pv.SetActiveView(surfaces)
        self.assert_once(self.browse(evolution, "chart"))
        history = evolution.GetClientSideObject().GetOutputDataObject(1)
        self.assertEqual(history.GetNumberOfRows(), 6)

    def test_a_cache_that_holds_few_states(self):
        # A state has 642 points of about 160 bytes: a MiB holds ten of the 41.
        evolution = pv.SurfaceEvolution(Input=self.sphere, NumberOfSteps=40, TimeStep=0.01,
                                        CacheLimit=1)
        self.assert_once(self.browse(evolution, "tight"))

    def test_temporal_filters(self):
        evolution = pv.SurfaceEvolution(Input=self.sphere, NumberOfSteps=5, TimeStep=0.1)
        between = data_of(pv.TemporalInterpolator(Input=evolution), 0.25)
        # Half the way between the states of 0.2 and 0.3.
        self.assertAlmostEqual(between.GetPoint(0)[0], 0.5 * sum(
            data_of(evolution, time).GetPoint(0)[0] for time in (0.2, 0.3)), delta=1e-6)
        picked = pv.ExtractTimeSteps(Input=evolution, TimeStepIndices=[0, 3])
        picked.UpdatePipelineInformation()
        self.assertEqual([round(time, 9) for time in picked.TimestepValues], [0.0, 0.3])
        self.assertEqual(data_of(picked, 0.3).GetNumberOfPoints(), 642)
        statistics = pv.TemporalStatistics(Input=evolution)
        self.assertIsNotNone(data_of(statistics, 0.0).GetPointData().GetArray("CoVolume_average"))
        self.assertEqual(solves(evolution), 1)

    def test_filters_after_it(self):
        evolution = self.with_a_field(NumberOfSteps=5)
        filters = [
            pv.Clip(Input=evolution),
            pv.Contour(Input=evolution, ContourBy=["POINTS", "MeanCurvature"], Isosurfaces=[1.5]),
            pv.PlotSelectionOverTime(
                Input=evolution, Selection=pv.IDSelectionSource(IDs=[0, 0], FieldType="POINT")),
            pv.TangentialRedistribution(Input=evolution, NumberOfSteps=2)]
        for each in filters[:2]:
            pv.Show(each)
        pv.Render()
        pv.GetAnimationScene().UpdateAnimationUsingDataTimeSteps()
        pv.GetAnimationScene().Play()
        for each in filters:
            pv.UpdatePipeline(proxy=each, time=0.06)
        self.assertGreater(filters[0].GetDataInformation().GetNumberOfCells(), 0)
        self.assertEqual(solves(evolution), 1)

    def test_a_new_parameter_solves_again(self):
        evolution = pv.SurfaceEvolution(Input=self.sphere, NumberOfSteps=3)
        pv.UpdatePipeline(proxy=evolution)
        evolution.CurvatureSpeed = 0.2
        pv.UpdatePipeline(proxy=evolution)
        self.assertEqual(solves(evolution), 2)

    def test_the_history_does_not_solve_again(self):
        evolution = pv.SurfaceEvolution(Input=self.sphere, NumberOfSteps=3)
        pv.UpdatePipeline(proxy=evolution)
        plot = pv.PassArrays(Input=pv.OutputPort(evolution, 1))
        pv.UpdatePipeline(proxy=plot)
        self.assertEqual(solves(evolution), 1)


if __name__ == "__main__":
    # ParaView 5.11 crashes when a script that has a view ends by sys.exit(), as unittest.main does.
    succeeded = unittest.main(exit=False).result.wasSuccessful()
    sys.stderr.flush()
    if not succeeded:
        os._exit(1)
