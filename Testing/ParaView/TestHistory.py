# SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
# SPDX-License-Identifier: BSD-3-Clause
"""The history of an evolution in a Line Chart View; what is left of it in state files.

    pvpython TestHistory.py PLUGIN_FILE OUTPUT_FOLDER        (needs a display)
"""

import os
import pathlib
import sys
import unittest

import paraview.simple as pv
from paraview import smstate

import evolvingsurfaces  # noqa: F401  (makes GetClientSideObject() give the wrapped class)

OUTPUT = pathlib.Path(sys.argv.pop())
pv.LoadPlugin(sys.argv.pop(), ns=vars(pv))
DISTANCES = ["MaxDistance", "MeanDistance"]
COLUMNS = DISTANCES + ["Area", "Iteration", "MinAngle", "Seconds", "SolverIterations", "Time",
                       "Volume"]


def series(display):
    """Every series of the chart and whether it is drawn."""
    values = list(display.SeriesVisibility)
    return {name: on != "0" for name, on in zip(values[::2], values[1::2])}


def drawn(display):
    return sorted(name for name, on in series(display).items() if on)


def evolution_onto_a_sphere():
    sdf = pv.MeshSDF(Input=pv.Icosphere(Level=3), SampleDimensions=[24, 24, 24])
    return pv.SurfaceEvolution(registrationName="Evolution", DistanceField=sdf, NumberOfSteps=5, TimeStep=0.03,
                               Input=pv.Icosphere(Level=2, Radius=1.4), CurvatureSpeed=0.2)


class HistoryTest(unittest.TestCase):
    def setUp(self):
        pv.ResetSession()

    def assert_distances_over_time(self, display):
        self.assertEqual(display.AttributeType, "Row Data")
        self.assertEqual(display.UseIndexForXAxis, 0)
        self.assertEqual(display.XArrayName, "Time")
        self.assertEqual(drawn(display), DISTANCES)
        self.assertEqual(sorted(series(display)), sorted(COLUMNS))


class Chart(HistoryTest):
    def show(self, source):
        chart = pv.CreateView("XYChartView")
        display = pv.Show(pv.OutputPort(source, 1), chart)
        pv.Render(chart)
        return display

    def test_of_surface_evolution(self):
        self.assert_distances_over_time(self.show(evolution_onto_a_sphere()))

    def test_without_a_field(self):
        evolution = pv.SurfaceEvolution(Input=pv.Icosphere(Level=2), NumberOfSteps=5)
        self.assert_distances_over_time(self.show(evolution))

    def test_of_shrink_wrap(self):
        wrap = pv.ShrinkWrap(Input=pv.Icosphere(), SampleDimensions=[24, 24, 24], NumberOfSteps=5)
        self.assert_distances_over_time(self.show(wrap))

    def test_what_the_user_switches_on_stays_on(self):
        evolution = evolution_onto_a_sphere()
        display = self.show(evolution)
        display.SeriesVisibility = ["Area", "1", "MeanDistance", "0"]
        evolution.NumberOfSteps = 7
        pv.Render()
        self.assertEqual(series(display)["Area"], True)
        self.assertEqual(series(display)["MeanDistance"], False)

    def test_the_surface_is_not_drawn_in_it(self):
        evolution = evolution_onto_a_sphere()
        display = self.show(evolution)
        self.assertIsNone(display.SMProxy.GetProperty("Representation"))
        other = pv.Show(pv.OutputPort(evolution, 0), pv.CreateView("RenderView"))
        self.assertEqual(other.Representation, "Surface With Edges")


class States(HistoryTest):
    def prepare(self):
        """A surface and its history side by side, the area switched on; then all is saved."""
        evolution = evolution_onto_a_sphere()
        surfaces = pv.CreateView("RenderView")
        chart = pv.CreateView("XYChartView")
        pv.AssignViewToLayout(surfaces)
        pv.AssignViewToLayout(chart)
        pv.Show(evolution, surfaces)
        display = pv.Show(pv.OutputPort(evolution, 1), chart)
        display.SeriesVisibility = ["MaxDistance", "1", "Area", "1"]
        scene = pv.GetAnimationScene()
        scene.UpdateAnimationUsingDataTimeSteps()
        scene.GoToLast()
        pv.RenderAllViews()

    def assert_restored(self):
        evolution = pv.FindSource("Evolution")
        chart = next(view for view in pv.GetViews() if view.SMProxy.GetXMLName() == "XYChartView")
        display = pv.GetDisplayProperties(pv.OutputPort(evolution, 1), chart)
        self.assertEqual(drawn(display), ["Area", "MaxDistance"])
        self.assertEqual(display.XArrayName, "Time")
        self.assertEqual(evolution.CurvatureSpeed, 0.2)
        pv.RenderAllViews()
        pv.GetAnimationScene().Play()
        algorithm = evolution.GetClientSideObject()
        self.assertEqual(algorithm.GetNumberOfSolves(), 1)
        iteration = algorithm.GetOutput().GetFieldData().GetArray("Iteration").GetValue(0)
        self.assertEqual(iteration, 5)
        self.assertEqual(algorithm.GetOutputDataObject(1).GetNumberOfRows(), 6)

    def test_state_file(self):
        self.prepare()
        path = str(OUTPUT / "history.pvsm")
        pv.SaveState(path)
        pv.ResetSession()
        pv.LoadState(path)
        self.assert_restored()

    def test_python_state(self):
        self.prepare()
        state = smstate.get_state()
        pv.ResetSession()
        exec(compile(state, "state", "exec"), {"__name__": "state"})
        # Sources of a Python state have the times of their defaults until they are asked again,
        # ParaView's own (Temporal Shift Scale) as ours, and ParaView 5.13 plays these.
        pv.GetAnimationScene().UpdateAnimationUsingDataTimeSteps()
        self.assert_restored()


if __name__ == "__main__":
    # ParaView 5.11 crashes when a script that has a view ends by sys.exit(), as unittest.main does.
    succeeded = unittest.main(exit=False).result.wasSuccessful()
    sys.stderr.flush()
    if not succeeded:
        os._exit(1)
