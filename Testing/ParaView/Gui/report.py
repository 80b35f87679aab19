# SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
# SPDX-License-Identifier: BSD-3-Clause
"""Writes what ParaView's window shows to a JSON file and two pictures.

A playback runs this file in the window's Python shell; TestGui.py reads what it wrote. The folder
is in EVOLVINGSURFACES_REPORT, the X server's frame buffer in EVOLVINGSURFACES_FRAMEBUFFER.
"""

import json
import os
import shutil
import traceback

import paraview.simple as pv


def field_data(information):
    arrays = information.GetFieldDataInformation()
    values = {}
    for i in range(arrays.GetNumberOfArrays()):
        array = arrays.GetArrayInformation(i)
        values[array.GetName()] = list(array.GetComponentRange(0))
    return values


def port_report(source, port):
    information = source.SMProxy.GetDataInformation(port)
    return {
        "type": information.GetDataClassName(),
        "points": information.GetNumberOfPoints(),
        "cells": information.GetNumberOfCells(),
        "rows": information.GetNumberOfRows(),
        "bounds": list(information.GetBounds()),
        "fields": field_data(information),
    }


def source_report(source):
    ports = source.SMProxy.GetNumberOfOutputPorts()
    times = source.GetProperty("TimestepValues")
    algorithm = source.GetClientSideObject()
    solves = getattr(algorithm, "GetNumberOfSolves", lambda: None)
    return {
        "proxy": source.SMProxy.GetXMLName(),
        "ports": [port_report(source, port) for port in range(ports)],
        "times": [] if times is None else list(times),
        "solves": solves(),
    }


def chart_report(display):
    series = list(display.SeriesVisibility)
    return {
        "x axis": None if display.UseIndexForXAxis else str(display.XArrayName.GetData()),
        "series": [name for name, on in zip(series[::2], series[1::2]) if on != "0"],
    }


def surface_report(display):
    array = display.ColorArrayName[1]
    colors = list(pv.GetColorTransferFunction(array).RGBPoints) if array else None
    return {
        "representation": display.Representation.GetData(),
        "colored by": array,
        "slice": int(display.Slice) if "Slice" in display.ListProperties() else None,
        "range": [colors[0], colors[-4]] if colors else None,
    }


def display_report(source, port, view):
    display = pv.GetDisplayProperties(pv.OutputPort(source, port), view)
    is_chart = "SeriesVisibility" in display.ListProperties()
    return {
        "source": source.SMProxy.GetXMLName(),
        "port": port,
        "view": view.SMProxy.GetXMLName(),
        **(chart_report(display) if is_chart else surface_report(display)),
    }


def visible_displays(view):
    for source in pv.GetSources().values():
        for port in range(source.SMProxy.GetNumberOfOutputPorts()):
            display = view.SMProxy.FindRepresentation(source.SMProxy, port)
            if display and display.GetProperty("Visibility").GetElement(0):
                yield display_report(source, port, view)


def report():
    import evolvingsurfaces  # noqa: F401  (makes GetClientSideObject() give the wrapped class)

    folder = os.environ["EVOLVINGSURFACES_REPORT"]
    view = pv.GetActiveView()
    found = {
        "view": view.SMProxy.GetXMLName(),
        "sources": [source_report(source) for source in pv.GetSources().values()],
        "visible": [display for each in pv.GetViews() for display in visible_displays(each)],
        "time": pv.GetAnimationScene().AnimationTime,
    }
    shutil.copy(os.environ["EVOLVINGSURFACES_FRAMEBUFFER"], os.path.join(folder, "window.xwd"))
    pv.SaveScreenshot(os.path.join(folder, "view.png"), view, ImageResolution=[600, 400])
    return found


def write(found):
    with open(os.path.join(os.environ["EVOLVINGSURFACES_REPORT"], "report.json"), "w") as file:
        file.write(json.dumps(found, indent=1))


try:
    write(report())
except Exception:  # The shell would keep it to itself.
    write({"error": traceback.format_exc()})
