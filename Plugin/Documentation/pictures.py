# SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
# SPDX-License-Identifier: BSD-3-Clause
"""Makes the pictures of the help pages anew.

    xvfb-run -a pvpython pictures.py PLUGIN_FILE DATA_FOLDER OUTPUT_FOLDER
"""

import sys

import paraview.simple as pv

PLUGIN, DATA, OUTPUT = sys.argv[1:4]
pv.LoadPlugin(PLUGIN, ns=globals())


def view_of(proxy):
    """A view of the proxy alone, as it is shown after Apply."""
    view = pv.CreateRenderView(ViewSize=[420, 360], OrientationAxesVisibility=0,
                               UseColorPaletteForBackground=0, Background=[1.0, 1.0, 1.0])
    display = pv.Show(proxy, view)
    pv.ResetCamera(view)
    return view, display


def save(view, name):
    view.CameraParallelProjection = 1
    pv.ResetCamera(view)
    pv.GetActiveCamera().Zoom(1.4)
    pv.Render(view)
    pv.SaveScreenshot(f"{OUTPUT}/{name}.jpg", view, Quality=85)


def save_surface(proxy, name):
    view, display = view_of(proxy)
    display.SetRepresentationType("Surface With Edges")
    display.ColorArrayName = [None, ""]
    display.AmbientColor = display.DiffuseColor = [0.93, 0.87, 0.75]
    display.EdgeColor = [0.35, 0.3, 0.25]
    save(view, name)


bunny = pv.PLYReader(FileNames=[DATA + "/bunny.ply"])

distance = MeshSDF(Input=bunny)
view, display = view_of(distance)
display.SetRepresentationType("Slice")
pv.ColorBy(display, ("POINTS", "SignedDistance"))
pv.GetColorTransferFunction("SignedDistance").RescaleTransferFunction(-2.5, 2.5)
save(view, "slice")

coarse = MeshSDF(Input=bunny, SampleDimensions=[40, 40, 40], Padding=0.25)
contour = pv.Contour(Input=coarse, ContourBy=["POINTS", "SignedDistance"], Isosurfaces=[0.5])
save_surface(contour, "contour")

evolution = SurfaceEvolution(Input=contour, DistanceField=distance, NumberOfSteps=60,
                             TimeStep=0.08, VolumeRedistribution=1.0)
pv.UpdatePipeline(proxy=evolution)
pv.GetAnimationScene().UpdateAnimationUsingDataTimeSteps()
pv.GetAnimationScene().GoToLast()
save_surface(evolution, "evolution")

even = TangentialRedistribution(Input=evolution)
save_surface(even, "redistribution")

save_surface(ShrinkWrap(Input=bunny, TargetEdgeLength=0.2), "wrap")
