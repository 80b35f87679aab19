# SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
# SPDX-License-Identifier: BSD-3-Clause
"""The plugin in a server: the client has the data's description alone, and one solve serves it.

    pvpython TestClientServer.py PVSERVER PLUGIN_FILE        (needs a display)
"""

import os
import socket
import subprocess
import sys
import unittest

import paraview.simple as pv
from paraview import servermanager
from vtkmodules.util.numpy_support import vtk_to_numpy

PLUGIN = sys.argv.pop()
PVSERVER = sys.argv.pop()


def free_port():
    with socket.socket() as probe:
        probe.bind(("localhost", 0))
        return probe.getsockname()[1]


def start_server(port):
    """A server that waits for its client."""
    server = subprocess.Popen([PVSERVER, f"--server-port={port}"], text=True,
                              stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
    for line in server.stdout:
        if "Accepting connection" in line:
            return server
    raise RuntimeError("pvserver ended before it could be connected to")


class ClientServer(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        port = free_port()
        cls.server = start_server(port)
        pv.Connect("localhost", port)
        for remote in (True, False):
            pv.LoadPlugin(PLUGIN, remote=remote, ns=vars(pv))
        sdf = pv.MeshSDF(Input=pv.Icosphere(Level=3), SampleDimensions=[24, 24, 24])
        cls.evolution = pv.SurfaceEvolution(Input=pv.Icosphere(Level=2, Radius=1.4),
                                            DistanceField=sdf, NumberOfSteps=5, TimeStep=0.03)

    @classmethod
    def tearDownClass(cls):
        pv.Disconnect()
        cls.server.kill()  # By itself it ends with this process, and perhaps not if a test failed.
        said, _ = cls.server.communicate()
        if "ERR|" in said:
            raise RuntimeError(said)

    def iteration(self):
        fields = self.evolution.GetDataInformation().GetFieldDataInformation()
        return fields.GetArrayInformation("Iteration").GetComponentRange(0)[0]

    def seconds_of_the_steps(self):
        """What two solves never agree on: the wall time of every step."""
        table = servermanager.Fetch(pv.PassArrays(Input=pv.OutputPort(self.evolution, 1),
                                                  RowDataArrays=["Seconds"]))
        return list(vtk_to_numpy(table.GetColumnByName("Seconds")))

    def test_playing_shows_every_step_of_one_solve(self):
        view = pv.CreateView("RenderView")
        pv.Show(self.evolution, view)
        seconds = self.seconds_of_the_steps()
        self.assertEqual(len(seconds), 6)
        scene = pv.GetAnimationScene()
        scene.UpdateAnimationUsingDataTimeSteps()
        seen = []
        for _ in range(2):
            scene.GoToFirst()
            for _ in range(6):
                pv.Render(view)
                seen.append(self.iteration())
                scene.GoToNext()
            scene.Play()
        self.assertEqual(seen, 2 * [0, 1, 2, 3, 4, 5])
        self.assertEqual(self.seconds_of_the_steps(), seconds)
        self.evolution.CurvatureSpeed = 0.2
        self.assertNotEqual(self.seconds_of_the_steps(), seconds)

    def test_surfaces_come_to_the_client(self):
        self.evolution.UpdatePipeline(0.06)
        surface = servermanager.Fetch(self.evolution)
        points = self.evolution.GetDataInformation().GetNumberOfPoints()
        self.assertGreaterEqual(points, 162)
        self.assertEqual(surface.GetNumberOfPoints(), points)
        self.assertEqual(surface.GetFieldData().GetArray("Iteration").GetValue(0), 2)

    def test_the_history_in_a_chart(self):
        chart = pv.CreateView("XYChartView")
        display = pv.Show(pv.OutputPort(self.evolution, 1), chart)
        pv.Render(chart)
        self.assertEqual((display.UseIndexForXAxis, display.XArrayName), (0, "Time"))
        series = list(display.SeriesVisibility)
        drawn = {name for name, on in zip(series[::2], series[1::2]) if on != "0"}
        self.assertEqual(drawn, {"MeanDistance", "MaxDistance"})


if __name__ == "__main__":
    # ParaView 5.11 crashes when a script that has a view ends by sys.exit(), as unittest.main does.
    succeeded = unittest.main(exit=False).result.wasSuccessful()
    sys.stderr.flush()
    if not succeeded:
        os._exit(1)
