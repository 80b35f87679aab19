#!/usr/bin/python3
# SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
# SPDX-License-Identifier: BSD-3-Clause
"""Shrink-wraps a mesh and writes the evolution, its history, the result and a picture.

    demo.py MESH OUTDIR [--points] [--start isosurface|icosphere] [--steps N]

MESH      .obj, .ply, .stl, .vtk (polydata) or .vtp
OUTDIR    gets evolution.pvd with evolution/*.vtp, history.csv, result.vtp and result.png; they
          replace those of an earlier run, and only when all of them are complete
--points  wrap the points of a file without faces

Run it by Scripts/demo.sh, which builds the package evolvingsurfaces and provides a display.
"""
import argparse
import os
import shutil
import signal
import sys
import tempfile
import time

from demo_files import (
    DemoError, Messages, has_faces, read_mesh, write_collection, write_polydata, write_table)
from demo_picture import write_picture

PRODUCTS = ("evolution.pvd", "evolution", "history.csv", "result.vtp", "result.png")


# --- input ---------------------------------------------------------------------------------------
def read_target(path, folder, points_allowed):
    mesh = read_mesh(path, folder)
    if not has_faces(mesh) and not points_allowed:
        raise DemoError(
            f"'{path}' holds {mesh.GetNumberOfPoints()} points but no faces, expected a surface; "
            "add --points to wrap the points themselves.")
    print(f"{path}: {mesh.GetNumberOfPoints()} points, "
          f"{mesh.GetNumberOfPolys() + mesh.GetNumberOfStrips()} faces")
    return mesh


# --- the wrap ------------------------------------------------------------------------------------
def import_package():
    try:
        import evolvingsurfaces
    except ImportError as error:
        raise DemoError(f"The package evolvingsurfaces cannot be imported ({error}); run "
                        "Scripts/demo.sh, which builds it.") from error
    return evolvingsurfaces


class Progress:
    """Prints every tenth of a filter's progress once, on one line, and stops it on Ctrl-C."""

    def __init__(self, algorithm):
        self.tenths, self.stopped = 0, False
        algorithm.AddObserver("ProgressEvent", self.show)

    def show(self, algorithm, _event):
        try:
            while self.tenths < 10 and algorithm.GetProgress() >= 0.1 * (self.tenths + 1) - 1e-9:
                self.tenths += 1
                print(f"{10 * self.tenths}%", end=" " if self.tenths < 10 else "\n", flush=True)
        except KeyboardInterrupt:
            self.stopped = True
            algorithm.SetAbortExecute(1)


def shrink_wrap(mesh, arguments):
    """The filter, solved, and the times of its steps."""
    wrap = import_package().vtkShrinkWrap()
    wrap.SetInputData(mesh)
    wrap.OutputStepsOn()
    if arguments.start == "icosphere":
        wrap.SetStartToIcosphere()
    if arguments.steps is not None:
        wrap.SetNumberOfSteps(arguments.steps)
    messages = Messages(wrap)
    progress = Progress(wrap)
    wrap.Update()
    if progress.stopped:
        raise KeyboardInterrupt
    if wrap.GetOutput().GetNumberOfPoints() == 0:
        reason = messages.errors[0] if messages.errors else "It made no surface."
        raise DemoError(f"The shrink wrap failed: {reason}")
    for text in messages.errors + messages.warnings:
        print(f"Note: {text}")
    information = wrap.GetOutputInformation(0)
    key = wrap.GetExecutive().TIME_STEPS()
    return wrap, [information.Get(key, i) for i in range(information.Length(key))]


def surface_at(wrap, moment):
    wrap.UpdateTimeStep(moment)
    surface = wrap.GetOutput().NewInstance()
    surface.ShallowCopy(wrap.GetOutput())
    return surface


# --- output --------------------------------------------------------------------------------------
def write_all(folder, mesh, wrap, times):
    os.mkdir(os.path.join(folder, "evolution"))
    names = [f"evolution/evolution_{i:04d}.vtp" for i in range(len(times))]
    shown = {}
    for i, (name, moment) in enumerate(zip(names, times)):
        surface = surface_at(wrap, moment)
        write_polydata(surface, os.path.join(folder, name))
        if i in (0, max(1, len(times) // 8), len(times) - 1):
            shown[i] = surface
    write_collection(names, times, os.path.join(folder, "evolution.pvd"))
    write_table(wrap.GetOutputPort(1), os.path.join(folder, "history.csv"))
    write_polydata(surface, os.path.join(folder, "result.vtp"))
    last = len(times) - 1
    panels = [(f"input: {mesh.GetNumberOfPoints()} points", mesh, False)]
    panels += [(title(i, last, surface), surface, True) for i, surface in shown.items()]
    write_picture(panels, os.path.join(folder, "result.png"))
    return surface


def title(step, last, surface):
    name = "start" if step == 0 else "result" if step == last else f"step {step} of {last}"
    return f"{name}: {surface.GetNumberOfPoints()} points"


def temporary_folder(output):
    """A new folder on the output's file system: inside it, or in the folder to hold it."""
    place = output
    while not os.path.lexists(place):
        place = os.path.dirname(place)
    if not os.path.isdir(place):
        raise DemoError(f"'{place}' is a file, expected a folder to write to; give another name.")
    try:
        return tempfile.mkdtemp(prefix=".evolvingsurfaces-", dir=place)
    except OSError as error:
        raise DemoError(f"Cannot write to '{place}' ({error.strerror}); give another output "
                        "folder.") from error


def move_into_place(source, output):
    """Puts the products from source into output; earlier ones come back when a move fails."""
    earlier = os.path.join(source, "earlier")
    os.mkdir(earlier)
    os.makedirs(output, exist_ok=True)
    done = []
    try:
        for name in PRODUCTS:
            target = os.path.join(output, name)
            for old, new in ((target, os.path.join(earlier, name)),
                             (os.path.join(source, name), target)):
                if os.path.lexists(old):
                    os.rename(old, new)
                    done.append((old, new))
    except OSError:
        for old, new in reversed(done):
            os.rename(new, old)
        raise


def report(result, output, seconds):
    values = []
    for name in ("IsClosed", "IsManifold", "Genus", "MinAngle", "MaxDistance"):
        array = result.GetFieldData().GetArray(name)
        if array:
            values.append(f"{name} {array.GetTuple1(0):.4g}")
    print(f"{', '.join(values)}" if values else "", end="\n" if values else "")
    print(f"{result.GetNumberOfPoints()} points, {result.GetNumberOfCells()} faces in "
          f"{seconds:.1f} s; written to {output}: {', '.join(PRODUCTS)}")


# --- the command ---------------------------------------------------------------------------------
def parse_arguments():
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("mesh", metavar="MESH")
    parser.add_argument("output", metavar="OUTDIR")
    parser.add_argument("--points", action="store_true", help="wrap points without faces")
    parser.add_argument("--start", choices=("isosurface", "icosphere"), default="isosurface")
    parser.add_argument("--steps", type=int, help="steps of the evolution")
    return parser.parse_args()


def run(arguments):
    began = time.monotonic()
    if not os.environ.get("DISPLAY"):
        raise DemoError("There is no display to draw the picture; run Scripts/demo.sh, which "
                        "provides one.")
    output = os.path.abspath(arguments.output)
    folder = temporary_folder(output)
    try:
        mesh = read_target(arguments.mesh, folder, arguments.points)
        wrap, times = shrink_wrap(mesh, arguments)
        print(f"{len(times)} time steps; writing")
        result = write_all(folder, mesh, wrap, times)
        move_into_place(folder, output)
    finally:
        shutil.rmtree(folder, ignore_errors=True)
    report(result, output, time.monotonic() - began)


def main():
    signal.signal(signal.SIGTERM, signal.default_int_handler)
    try:
        run(parse_arguments())
    except DemoError as error:
        sys.exit(f"demo: {error}")
    except OSError as error:
        sys.exit(f"demo: The results could not be written ({error}); earlier ones are unchanged.")
    except KeyboardInterrupt:
        sys.exit("demo: Stopped; nothing was written.")


if __name__ == "__main__":
    main()
