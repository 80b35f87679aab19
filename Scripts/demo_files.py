# SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
# SPDX-License-Identifier: BSD-3-Clause
"""Files for demo.py: VTK's readers and writers with errors as exceptions.

    demo_files.py MESH COPY   reads a mesh and writes it as .vtp, coincident points joined
"""
import os
import re
import subprocess
import sys

from vtkmodules.util.misc import calldata_type
from vtkmodules.util.vtkConstants import VTK_STRING
from vtkmodules.vtkCommonCore import vtkLogger, vtkOutputWindow, vtkStringOutputWindow
from vtkmodules.vtkFiltersCore import vtkCleanPolyData
from vtkmodules.vtkIOCore import vtkDelimitedTextWriter
from vtkmodules.vtkIOGeometry import vtkOBJReader, vtkSTLReader
from vtkmodules.vtkIOLegacy import vtkPolyDataReader
from vtkmodules.vtkIOPLY import vtkPLYReader
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader, vtkXMLPolyDataWriter

READERS = {".obj": vtkOBJReader, ".ply": vtkPLYReader, ".stl": vtkSTLReader,
           ".vtk": vtkPolyDataReader, ".vtp": vtkXMLPolyDataReader}

# Helpers inside readers and pipelines report on their own, after their owners have; what matters
# reaches the user by Messages below.
vtkOutputWindow.SetInstance(vtkStringOutputWindow())
vtkLogger.SetStderrVerbosity(vtkLogger.VERBOSITY_OFF)


class DemoError(Exception):
    """What goes wrong for a reason outside this program; the text is one sentence for the user."""


class Messages:
    """Collects what an object reports instead of letting it print."""

    def __init__(self, source):
        self.errors, self.warnings = [], []
        for event, texts in (("ErrorEvent", self.errors), ("WarningEvent", self.warnings)):
            source.AddObserver(event, self.collector(texts))

    @staticmethod
    def collector(texts):
        @calldata_type(VTK_STRING)
        def collect(_source, _event, text):
            texts.append(plain(text))
        return collect


def plain(text):
    """A VTK message without the place in the sources that it begins with."""
    text = text or "the message is not text"
    text = re.sub(r"^\s*(ERROR|Warning|Generic Warning): In .*?, line \d+\s*", "", text, flags=re.S)
    text = re.sub(r"^\w+ \((0x[0-9a-f]+|nullptr)\): ", "", text)
    return " ".join(text.split())


# --- reading -------------------------------------------------------------------------------------
def suffix_of(path):
    return os.path.splitext(path)[1].lower()


def read_mesh(path, folder):
    """The mesh in a file; folder is for a temporary copy.

    VTK's readers end the process on some damaged files, so another process reads first.
    """
    if not os.path.isfile(path) or not os.access(path, os.R_OK):
        raise DemoError(f"'{path}' is not a readable file; give the path of a mesh.")
    if suffix_of(path) not in READERS:
        raise DemoError(f"'{path}' has the suffix '{suffix_of(path)}', expected one of "
                        f"{' '.join(READERS)}; convert the mesh to one of these formats.")
    copy = os.path.join(folder, "input.vtp")
    reading = subprocess.run(
        [sys.executable, os.path.abspath(__file__), path, copy],
        stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True, errors="replace", check=False)
    if reading.returncode == 1 and reading.stderr.startswith("'"):
        raise DemoError(reading.stderr.strip())
    if reading.returncode != 0:
        raise DemoError(f"'{path}' is damaged, VTK's reader for {suffix_of(path)} files gives up "
                        "on it; export it again.")
    reader = vtkXMLPolyDataReader()
    reader.SetFileName(copy)
    reader.Update()
    os.remove(copy)
    return reader.GetOutput()


def read_directly(path):
    reader = READERS[suffix_of(path)]()
    reader.SetFileName(path)
    messages = Messages(reader)
    reader.Update()
    mesh = reader.GetOutput()
    if messages.errors or reader.GetErrorCode():
        detail = f" ({messages.errors[0]})" if messages.errors else ""
        raise DemoError(f"'{path}' cannot be read as its suffix says{detail}; export it again.")
    if mesh.GetNumberOfPoints() == 0:
        raise DemoError(f"'{path}' holds no points and no faces, expected a mesh; export it again.")
    require_existing_points(mesh, path)
    return welded(mesh, path) if has_faces(mesh) else mesh


def require_existing_points(mesh, path):
    """VTK's readers do not look whether faces refer to points that there are."""
    for cells in (mesh.GetVerts(), mesh.GetLines(), mesh.GetPolys(), mesh.GetStrips()):
        if cells.GetNumberOfConnectivityIds() > 0:
            lowest, highest = cells.GetConnectivityArray().GetRange()
            if lowest < 0 or highest >= mesh.GetNumberOfPoints():
                raise DemoError(f"'{path}' has a face with a point that is not among its "
                                f"{mesh.GetNumberOfPoints()} points; export it again.")


def has_faces(mesh):
    return mesh.GetNumberOfPolys() + mesh.GetNumberOfStrips() > 0


def welded(mesh, path):
    """STL stores every triangle with its own points, and OBJ splits points at texture seams."""
    if suffix_of(path) not in (".stl", ".obj"):
        return mesh
    weld = vtkCleanPolyData()
    weld.SetInputData(mesh)
    weld.SetTolerance(0.0)
    weld.ConvertPolysToLinesOff()
    weld.Update()
    return weld.GetOutput()


# --- writing -------------------------------------------------------------------------------------
def require_written(writer, messages, path):
    if messages.errors or writer.GetErrorCode() or not os.path.getsize(path):
        detail = f" ({messages.errors[0]})" if messages.errors else ""
        raise DemoError(f"{os.path.basename(path)} could not be written{detail}; earlier results "
                        "are unchanged.")


def write_polydata(mesh, path):
    writer = vtkXMLPolyDataWriter()
    messages = Messages(writer)
    writer.SetInputData(mesh)
    writer.SetFileName(path)
    # ParaView's VTK reads its own appended data back empty.
    writer.SetDataModeToBinary()
    writer.Write()
    require_written(writer, messages, path)


def write_table(port, path):
    writer = vtkDelimitedTextWriter()
    messages = Messages(writer)
    writer.SetInputConnection(port)
    writer.SetFileName(path)
    writer.Write()
    require_written(writer, messages, path)


def write_collection(names, times, path):
    """ParaView's file of a time series; names are relative to it."""
    lines = ['<?xml version="1.0"?>',
             '<VTKFile type="Collection" version="0.1" byte_order="LittleEndian">',
             "  <Collection>"]
    lines += [f'    <DataSet timestep="{moment!r}" part="0" file="{name}"/>'
              for name, moment in zip(names, times)]
    lines += ["  </Collection>", "</VTKFile>", ""]
    with open(path, "w", encoding="ascii") as file:
        file.write("\n".join(lines))


if __name__ == "__main__":
    try:
        write_polydata(read_directly(sys.argv[1]), sys.argv[2])
    except DemoError as error:
        sys.exit(str(error))
