# SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
# SPDX-License-Identifier: BSD-3-Clause
"""The plugin in the real ParaView window: a playback clicks, then what the window shows is checked.

    python3 TestGui.py CASE PARAVIEW PLUGIN_PATH DATA_FOLDER OUTPUT_FOLDER

CASE names a playback CASE.xml beside this file. A disabled menu entry ends a playback with exit
status 0 and nothing done: hence the report of report.py. The pictures window.png and view.png in
OUTPUT_FOLDER are for looking at.
"""

import json
import os
import pathlib
import shutil
import subprocess
import sys

import numpy
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkIOImage import vtkPNGReader, vtkPNGWriter

HERE = pathlib.Path(__file__).resolve().parent
SCREEN = "1400x900x24"


def play(case, paraview, plugin_path, data, output):
    shutil.rmtree(output, ignore_errors=True)
    output.mkdir(parents=True)
    output.chmod(0o700)
    environment = dict(
        os.environ,
        PV_PLUGIN_PATH=str(plugin_path),
        PARAVIEW_DATA_ROOT=str(data),
        XDG_RUNTIME_DIR=str(output),
        EVOLVINGSURFACES_REPORT=str(output),
        EVOLVINGSURFACES_REPORT_SCRIPT=str(HERE / "report.py"),
        EVOLVINGSURFACES_FRAMEBUFFER=str(output / "Xvfb_screen0"),
    )
    command = ["xvfb-run", "-a", "-s", f"-screen 0 {SCREEN} -noreset -fbdir {output}", str(paraview), "--dr",
               f"--test-script={HERE / (case + '.xml')}", f"--test-directory={output}", "--exit"]
    done = subprocess.run(command, env=environment, cwd=output, timeout=300, text=True,
                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
    print(done.stdout)
    check("the playback ends with exit status 0", done.returncode == 0, done.returncode)
    check("no error message", "error" not in done.stdout.lower())
    check("the playback wrote its report", (output / "report.json").exists())
    report = json.loads((output / "report.json").read_text())
    check("the report is complete", "error" not in report, report.get("error", ""))
    write_window_picture(output)
    return report


def write_window_picture(output):
    """The X server's frame buffer (an XWD dump) as a PNG."""
    raw = (output / "window.xwd").read_bytes()
    header = numpy.frombuffer(raw, ">u4", 25)
    width, height, line, colors = (int(header[i]) for i in (4, 5, 12, 19))
    start = int(header[0]) + 12 * colors
    rows = numpy.frombuffer(raw, numpy.uint8, line * height, start).reshape(height, line)
    pixels = rows[::-1, :4 * width].reshape(height * width, 4)[:, 2::-1]
    image = vtkImageData()
    image.SetDimensions(width, height, 1)
    image.GetPointData().SetScalars(numpy_to_vtk(numpy.ascontiguousarray(pixels), deep=True))
    writer = vtkPNGWriter()
    writer.SetFileName(str(output / "window.png"))
    writer.SetInputData(image)
    writer.Write()
    (output / "window.xwd").unlink()


def view_pixels(output):
    reader = vtkPNGReader()
    reader.SetFileName(str(output / "view.png"))
    reader.Update()
    image = reader.GetOutput()
    width, height, _ = image.GetDimensions()
    pixels = vtk_to_numpy(image.GetPointData().GetScalars())
    return pixels[:, :3].reshape(height, width, 3).astype(int)


def share(mask):
    return float(mask.mean())


def check(name, holds, detail=""):
    print(f"{'passed' if holds else 'FAILED'}: {name} {detail}", flush=True)
    if not holds:
        sys.exit(1)


def source(report, proxy):
    found = [s for s in report["sources"] if s["proxy"] == proxy]
    check(f"{proxy} is in the pipeline browser", len(found) == 1)
    return found[0]


def shown(report, proxy):
    check("one thing is visible", len(report["visible"]) == 1, report["visible"])
    display = report["visible"][0]
    check(f"it is {proxy}", display["source"] == proxy)
    check("in the render view", display["view"] == "RenderView" == report["view"])
    return display


def check_mesh_sdf(report, pixels):
    image = source(report, "MeshSDF")["ports"][0]
    check("an image of 128^3 samples", image["points"] == 128**3, image["points"])
    display = shown(report, "MeshSDF")
    check("as a slice", display["representation"] == "Slice", display["representation"])
    check("through the middle", 60 <= display["slice"] <= 67, display["slice"])
    check("coloured by the distance", display["colored by"] == "SignedDistance")
    check("of both signs", display["range"][0] < 0 < display["range"][1], display["range"])
    red, blue = pixels[..., 0], pixels[..., 2]
    check("blue and red", share(blue > red + 60) > 0.01 and share(red > blue + 60) > 0.01,
          (share(blue > red + 60), share(red > blue + 60)))


def check_shrink_wrap(report, pixels):
    wrap = source(report, "ShrinkWrap")
    surface, history = wrap["ports"]
    check("about 9000 points", 6000 < surface["points"] < 14000, surface["points"])
    check("triangles of a closed surface", surface["cells"] == 2 * surface["points"] - 4)
    for name, value in (("IsClosed", 1), ("IsManifold", 1), ("Genus", 0)):
        check(name, surface["fields"][name] == [value, value], surface["fields"][name])
    check("a history", history["rows"] > 1, history["rows"])
    check("no time steps", wrap["times"] == [])
    display = shown(report, "ShrinkWrap")
    check("with its edges", display["representation"] == "Surface With Edges")
    background = pixels[0, 0]
    covered = share(abs(pixels - background).sum(axis=2) > 60)
    check("it fills the view", covered > 0.1, covered)


def check_surface_evolution(report, pixels):
    evolution = source(report, "SurfaceEvolution")
    surface, history = evolution["ports"]
    check("the icosphere's points or new ones", 600 < surface["points"] < 3000, surface["points"])
    check("a row for every step", history["rows"] == 151, history["rows"])
    check("a time for every step", len(evolution["times"]) == 151, len(evolution["times"]))
    check("the last state", surface["fields"]["Iteration"] == [150, 150])
    check("on the bunny", surface["fields"]["MeanDistance"][1] < 0.1, surface["fields"])
    check("solved once", evolution["solves"] == 1, evolution["solves"])
    display = [d for d in report["visible"] if d["source"] == "SurfaceEvolution"]
    check("the surface is shown, the table is not", [d["port"] for d in display] == [0], display)
    check("with its edges", display[0]["representation"] == "Surface With Edges")
    check("in the render view", report["view"] == "RenderView")


def check_history(report, pixels):
    evolution = source(report, "SurfaceEvolution")
    check("a row for every step", evolution["ports"][1]["rows"] == 31, evolution["ports"])
    check("played to the end", report["time"] == evolution["times"][-1] == 3.0, report["time"])
    check("the last state", evolution["ports"][0]["fields"]["Iteration"] == [30, 30])
    check("solved once", evolution["solves"] == 1, evolution["solves"])
    displays = {d["port"]: d for d in report["visible"] if d["source"] == "SurfaceEvolution"}
    check("the surface stays in the render view", displays[0]["view"] == "RenderView", displays)
    chart = displays[1]
    check("the history is in the chart", chart["view"] == "XYChartView" == report["view"], chart)
    check("over time", chart["x axis"] == "Time", chart)
    check("the distances alone", sorted(chart["series"]) == ["MaxDistance", "MeanDistance"], chart)
    colored = share(pixels.max(axis=2) - pixels.min(axis=2) > 60)
    check("two curves", 0.002 < colored < 0.05, colored)


def check_distance_hierarchy(report, pixels):
    boxes = [s["ports"][0] for s in report["sources"] if s["proxy"] == "DistanceHierarchy"]
    check("two structures in the pipeline browser", len(boxes) == 2, len(boxes))
    tree, octree = boxes
    for found in boxes:
        check("boxes of six quads", found["cells"] > 0 and 4 * found["cells"] == 3 * found["points"])
    check("leaves of the tree", 6 * 1000 < tree["cells"] < 6 * 10000, tree["cells"])
    check("leaves of the octree", octree["cells"] > 6 * 10000, octree["cells"])
    displays = [d for d in report["visible"] if d["source"] == "DistanceHierarchy"]
    check("both are visible", len(displays) == 2, report["visible"])
    check("as lines", {d["representation"] for d in displays} == {"Wireframe"}, displays)
    covered = share(abs(pixels - pixels[0, 0]).sum(axis=2) > 60)
    check("they fill the view", covered > 0.1, covered)


def check_disabled_entry(report, _):
    source(report, "MeshSDF")
    wraps = [s for s in report["sources"] if s["proxy"] == "ShrinkWrap"]
    check("a filter of surfaces does not take an image", wraps == [])


CASES = {
    "DisabledEntry": check_disabled_entry,
    "DistanceHierarchy": check_distance_hierarchy,
    "History": check_history,
    "MeshSDF": check_mesh_sdf,
    "ShrinkWrap": check_shrink_wrap,
    "SurfaceEvolution": check_surface_evolution,
}


def main(case, paraview, plugin_path, data, output):
    output = pathlib.Path(output).resolve()
    report = play(case, paraview, pathlib.Path(plugin_path).resolve(), data, output)
    print(json.dumps(report, indent=1))
    CASES[case](report, view_pixels(output))


if __name__ == "__main__":
    main(*sys.argv[1:])
