# SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
# SPDX-License-Identifier: BSD-3-Clause
"""Runs an example in an empty folder: what it writes must be there to read, and look as it is shown.

    run_example.py SCRIPT [ARGUMENT ...] [--picture MADE=SHOWN]

A picture that lies beside the script by the same name is the one that the repository shows; another
one is named by --picture. With EVOLVINGSURFACES_KEEP_PICTURES=1 the new one takes its place.
"""

import argparse
import os
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

from picture_difference import PICTURES, difference, is_blank
from vtkmodules.vtkIOXML import vtkXMLGenericDataObjectReader

SKIPPED = 77                                     # what an example ends with that has no data
# Of 255, for the average of a block. An edge drawn on other pixels stays below it; a digit in a caption,
# a triangle elsewhere do not.
LARGEST_DIFFERENCE = 24.0


def problem_of(path, shown):
    """A file has content: points in VTK's own formats, in a picture what the repository shows."""
    if path.stat().st_size == 0:
        return f"{path.name} is empty"
    if path.suffix in (".vtp", ".vti"):
        reader = vtkXMLGenericDataObjectReader()
        reader.SetFileName(str(path))
        reader.Update()
        if reader.GetOutput() is None or reader.GetOutput().GetNumberOfPoints() == 0:
            return f"{path.name} has no points"
    if path.suffix in PICTURES:
        return problem_of_picture(path, shown.get(path.name))
    return None


def problem_of_picture(path, shown):
    if is_blank(path):
        return f"{path.name} is of one colour, or cannot be read"
    if shown is None:
        return None
    if os.environ.get("EVOLVINGSURFACES_KEEP_PICTURES") == "1":
        shutil.copyfile(path, shown)
        return None
    off = difference(path, shown)
    print(f"{path.name}: off {shown.name} by {off:.1f} of 255 where they differ most, at most {LARGEST_DIFFERENCE}")
    if off <= LARGEST_DIFFERENCE:
        return None
    return (f"{path.name} is off {shown} by {off:.0f} of 255 where they differ most; look at both, and "
            "where the new one is right, run Scripts/pictures.sh")


def shown_pictures(script, named):
    """The pictures of the repository by the names of those that the script makes."""
    own = (script.with_suffix(suffix) for suffix in PICTURES)
    shown = {path.name: path for path in own if path.exists()}
    for pair in named:
        made, kept = pair.split("=")
        shown[made] = Path(kept).resolve()
    return shown


def main(script, arguments, named):
    script = script.resolve()
    shown = shown_pictures(script, named)
    with tempfile.TemporaryDirectory() as folder:
        run = subprocess.run([sys.executable, str(script), *arguments], cwd=folder, check=False)
        if run.returncode == SKIPPED:
            sys.exit(SKIPPED)                    # it has said why
        if run.returncode != 0:
            sys.exit(f"{script} ended with status {run.returncode}")
        written = [path for path in Path(folder).rglob("*") if path.is_file()]
        print(f"{script} wrote {[path.name for path in written]}")
        problems = [problem for problem in (problem_of(path, shown) for path in written) if problem]
        problems += [f"{name} was not made" for name in set(shown) - {path.name for path in written}]
        sys.exit("; ".join(problems) if problems else 0)


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("script", type=Path)
    parser.add_argument("arguments", nargs="*")
    parser.add_argument("--picture", action="append", default=[], metavar="MADE=SHOWN")
    chosen = parser.parse_args()
    main(chosen.script, chosen.arguments, chosen.picture)
