# SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
# SPDX-License-Identifier: BSD-3-Clause
"""Two films: a sphere that shrinks onto a model, and a torus that shrinks and closes its hole.

    film.py [FOLDER]

Writes sphere_onto_bunny.ogv and torus.ogv, and film.png with six frames of each. Light and camera
stay. The mesh is drawn in thin grey lines that are mixed with the colour of the surface, for black
or navy ones would be all that one sees, and jump wherever elements are made anew; above 20,000
points, where lines would cover everything, not at all.

What a film must not do is flicker: the number for it compares each frame with those before and
after. A frame at which the picture jumps differs from both by more than these differ from each other.
"""

import sys
from pathlib import Path

import evolvingsurfaces as es
import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonComputationalGeometry import vtkParametricTorus
from vtkmodules.vtkCommonExecutionModel import vtkStreamingDemandDrivenPipeline, vtkTrivialProducer
from vtkmodules.vtkFiltersCore import vtkCleanPolyData, vtkTriangleFilter
from vtkmodules.vtkFiltersSources import vtkParametricFunctionSource
from vtkmodules.vtkRenderingCore import vtkRenderer, vtkRenderWindow, vtkWindowToImageFilter

sys.path.insert(0, str(Path(__file__).resolve().parent / "thesis"))

from drawing import surface  # noqa: E402
from figures import at_time, check, model  # noqa: E402
from pictures import Panel, aim, light, save  # noqa: E402

try:
    from vtkmodules.vtkIOOggTheora import vtkOggTheoraWriter
except ImportError:
    sys.exit("This VTK has no vtkOggTheoraWriter, expected one with the module IOOggTheora.")

SIZE, RATE = 480, 25                             # pixels, frames a second
MOST_WITH_EDGES = 20000                          # points
SHOWN = 6                                        # frames of each in the picture
PALE_EDGE = (0.78, 0.75, 0.68)


def onto_bunny():
    bunny = model("bunny.ply")
    box = np.reshape(bunny.GetBounds(), (3, 2))
    start = es.vtkIcosphereSource()
    start.SetLevel(4)
    start.SetCenter(box.mean(axis=1))
    start.SetRadius(0.55 * np.linalg.norm(box[:, 1] - box[:, 0]))
    distance = es.vtkMeshSDF()
    distance.SetInputData(bunny)
    flow = es.vtkSurfaceEvolution()
    flow.SetInputConnection(0, start.GetOutputPort())
    flow.SetInputConnection(1, distance.GetOutputPort())
    return flow


def closing_torus():
    shape = vtkParametricTorus()
    shape.SetRingRadius(1.0)
    shape.SetCrossSectionRadius(0.7)             # above 0.64 the hole closes, below it is a ring
    source = vtkParametricFunctionSource()
    source.SetParametricFunction(shape)
    source.SetUResolution(72)
    source.SetVResolution(48)
    triangles = vtkTriangleFilter()
    triangles.SetInputConnection(source.GetOutputPort())
    closed = vtkCleanPolyData()                  # joins the seams
    closed.SetInputConnection(triangles.GetOutputPort())
    closed.SetTolerance(1e-6)
    flow = es.vtkSurfaceEvolution()
    flow.SetInputConnection(closed.GetOutputPort())
    return flow


def times_of(flow):
    flow.Update()                                # a surface that shrinks to a point ends earlier
    return flow.GetOutputInformation(0).Get(vtkStreamingDemandDrivenPipeline.TIME_STEPS())


def drawn(data):
    actor = surface(data, edges=data.GetNumberOfPoints() <= MOST_WITH_EDGES, smooth=True)
    actor.GetProperty().SetEdgeColor(PALE_EDGE)
    return actor


def picture_of(window):
    grab = vtkWindowToImageFilter()
    grab.SetInput(window)
    grab.ReadFrontBufferOff()
    grab.Update()
    return grab.GetOutput()


def film(states, path, **look):
    """Writes the film; returns its frames as arrays."""
    window, renderer = vtkRenderWindow(), vtkRenderer()
    window.SetOffScreenRendering(True)
    window.SetMultiSamples(8)
    window.SetSize(SIZE, SIZE)
    renderer.SetBackground(1.0, 1.0, 1.0)
    light(renderer)
    window.AddRenderer(renderer)
    current = vtkTrivialProducer()
    writer = vtkOggTheoraWriter()
    writer.SetInputConnection(current.GetOutputPort())
    writer.SetFileName(str(path))
    writer.SetRate(RATE)
    writer.SetQuality(2)
    frames = []
    bounds = states[0].GetBounds()
    for i, state in enumerate(states):
        renderer.RemoveAllViewProps()
        renderer.AddViewProp(drawn(state))
        aim(renderer, Panel([], **look), bounds)
        window.Render()
        picture = picture_of(window)
        current.SetOutput(picture)
        if i == 0:
            writer.Start()
        writer.Write()
        frames.append(vtk_to_numpy(picture.GetPointData().GetScalars()).astype(float).mean(axis=1))
    writer.End()
    return frames


def flicker(frames):
    """The largest part of a frame's change that the next one takes back, of 255 grey values."""
    jumps = [min(np.abs(b - a).mean(), np.abs(c - b).mean()) - np.abs(c - a).mean()
             for a, b, c in zip(frames, frames[1:], frames[2:])]
    return max(jumps)


def jump(frames):
    """How much more a frame differs from the one before than its neighbours from theirs."""
    changes = np.array([np.abs(b - a).mean() for a, b in zip(frames, frames[1:])])
    return (changes[1:-1] - np.maximum(changes[:-2], changes[2:])).max()


folder = Path(sys.argv[1] if len(sys.argv) > 1 else ".")
films = (("sphere_onto_bunny", onto_bunny(), dict(direction=(0.35, 0.3, 1.0))),
         ("torus", closing_torus(), dict(direction=(0.4, -1.0, 0.9), up=(0.0, 0.0, 1.0), zoom=0.9)))
panels, numbers = [], []
for name, flow, look in films:
    states = [at_time(flow, time) for time in times_of(flow)]
    frames = film(states, folder / f"{name}.ogv", **look)
    for k in np.linspace(0, len(states) - 1, SHOWN).astype(int):
        panels.append(Panel([drawn(states[k])], f"step {k}", **look))
    numbers.append((name, frames))
save(panels, folder / "film.png", columns=SHOWN, height=200)
for name, frames in numbers:
    check(f"{name}: frames", len(frames), 100, 151)
    check(f"{name}: flicker, of 255 grey values", flicker(frames), -255.0, 0.5)
    check(f"{name}: largest jump, of 255 grey values", jump(frames), -255.0, 2.0)
