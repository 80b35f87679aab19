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


class SolvesOnce(unittest.TestCase):
    def setUp(self):
        pv.ResetSession()
        pv.GetActiveViewOrCreate("RenderView")
        self.sphere = pv.Icosphere(Level=3)

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

    def test_surface_evolution_with_a_field(self):
        sdf = pv.MeshSDF(Input=self.sphere, SampleDimensions=[24, 24, 24])
        start = pv.Icosphere(Level=2, Radius=1.4)
        evolution = pv.SurfaceEvolution(Input=start, DistanceField=sdf, NumberOfSteps=5)
        self.assert_once(self.browse(evolution, "field"))

    def test_shrink_wrap(self):
        wrap = pv.ShrinkWrap(Input=self.sphere, SampleDimensions=[24, 24, 24], NumberOfSteps=5,
                             OutputSteps=1)
        self.assert_once(self.browse(wrap, "wrap"))

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
