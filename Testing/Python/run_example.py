# SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
# SPDX-License-Identifier: BSD-3-Clause
"""Runs an example without arguments in an empty folder; what it writes must be there to read.

    run_example.py SCRIPT
"""

import subprocess
import sys
import tempfile
from pathlib import Path

from vtkmodules.vtkIOImage import vtkJPEGReader, vtkPNGReader
from vtkmodules.vtkIOXML import vtkXMLGenericDataObjectReader

SKIPPED = 77                                     # what an example ends with that has no data
PICTURES = {".jpg": vtkJPEGReader, ".png": vtkPNGReader}


def is_blank(path):
    reader = PICTURES[path.suffix]()
    reader.SetFileName(str(path))
    reader.Update()
    colors = reader.GetOutput().GetPointData().GetScalars()
    if colors is None or colors.GetNumberOfTuples() == 0:
        return True
    ranges = [colors.GetRange(i) for i in range(colors.GetNumberOfComponents())]
    return all(low == high for low, high in ranges)


def check(path):
    """A file has content: points in VTK's own formats, more than one colour in a picture."""
    if path.stat().st_size == 0:
        return f"{path.name} is empty"
    if path.suffix in (".vtp", ".vti"):
        reader = vtkXMLGenericDataObjectReader()
        reader.SetFileName(str(path))
        reader.Update()
        if reader.GetOutput() is None or reader.GetOutput().GetNumberOfPoints() == 0:
            return f"{path.name} has no points"
    if path.suffix in PICTURES and is_blank(path):
        return f"{path.name} is of one colour, or cannot be read"
    return None


def main(script):
    with tempfile.TemporaryDirectory() as folder:
        run = subprocess.run([sys.executable, str(Path(script).resolve())], cwd=folder)
        if run.returncode == SKIPPED:
            sys.exit(SKIPPED)                    # it has said why
        if run.returncode != 0:
            sys.exit(f"{script} ended with status {run.returncode}")
        written = [path for path in Path(folder).rglob("*") if path.is_file()]
        problems = [problem for problem in map(check, written) if problem]
        print(f"{script} wrote {[path.name for path in written]}")
        sys.exit("; ".join(problems) if problems else 0)


if __name__ == "__main__":
    main(sys.argv[1])
