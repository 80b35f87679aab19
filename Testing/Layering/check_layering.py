#!/usr/bin/python3
# SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
# SPDX-License-Identifier: BSD-3-Clause
"""Checks the one arrow: kernel -> VTK filters -> ParaView plugin, never back.

    check_layering.py [ROOT]

Prints one line per violation and ends with 'N passed, N failed'; the exit status is 1 when there
is a violation. check_layering.py --self-test makes violations in a temporary tree and expects
each to be found.
"""
import os
import re
import sys
import tempfile

INCLUDE = re.compile(r'^\s*#\s*include\s*([<"])([^>"]+)[>"]', re.MULTILINE)
CODE = (".h", ".cxx", ".hxx")
# Headers of the module that its public ones may not include.
PRIVATE_HEADERS = ("CarriedArrays.h", "ClosestElements.h", "ContentStamp.h", "DataTransfer.h",
                   "DistributedInput.h", "EvolutionOutput.h", "EvolutionStart.h", "ImageArray.h",
                   "InputStep.h", "KernelBridge.h", "PartsOnRanks.h", "ResultArrays.h",
                   "TimeSteps.h")

# Which folders of the kernel a folder may include; its own and the root files always.
KERNEL_ARROWS = {
    "": set(),
    "Mesh": set(),
    "Trees": {"Mesh"},
    "Algebra": set(),
    "Operators": {"Mesh", "Algebra"},
    "Distance": {"Mesh", "Trees"},
    "Crossings": {"Mesh", "Trees", "Distance"},
    "Features": {"Mesh", "Trees", "Distance"},
    "StartSurface": {"Mesh", "Trees", "Distance"},
    "Remeshing": {"Mesh", "Trees", "Algebra", "Distance"},
    "FeatureCapture": {"Mesh", "Trees", "Distance", "Features", "Remeshing"},
    "Redistribution": {"Mesh", "Trees", "Algebra", "Operators"},
    "VolumeFlows": {"Mesh", "Algebra", "Operators"},
    "Evolution": {"Mesh", "Trees", "Distance", "Algebra", "Operators", "Redistribution",
                  "Remeshing", "VolumeFlows"},
    "LabelSurfaces": {"Mesh", "Algebra"},
    "LostTopology": {"Mesh", "Trees", "Remeshing"},
    "ShrinkWrap": {"Mesh", "Trees", "Distance", "Crossings", "Features", "StartSurface", "Remeshing",
                   "FeatureCapture", "Evolution", "LostTopology"},
}


def files(folder, endings):
    for path, folders, names in os.walk(folder):
        folders.sort()
        for name in sorted(names):
            if name.endswith(endings):
                yield os.path.join(path, name)


def read(path):
    with open(path, encoding="utf-8") as file:
        return file.read()


def includes(path):
    return INCLUDE.findall(read(path))


def check_kernel_file(root, path):
    kernel = os.path.join(root, "Filters", "Kernel")
    folder = os.path.relpath(os.path.dirname(path), kernel).split(os.sep)[0].replace(".", "")
    allowed = KERNEL_ARROWS.get(folder)
    if allowed is None:
        yield f"folder {folder} of the kernel has no place in the layering"
        return
    for bracket, name in includes(path):
        if bracket == "<":
            if "/" in name and not name.startswith("Eigen/") or name.startswith("vtk"):
                yield f"includes <{name}>; the kernel includes the standard library and Eigen only"
        elif not os.path.exists(os.path.join(kernel, name)):
            yield f'includes "{name}", which is no file of the kernel'
        else:
            target = os.path.dirname(name).split("/")[0]
            if target not in ("", folder) and target not in allowed:
                yield f'includes "{name}"; {folder or "the root"} may not know {target}'


def check_filter_file(root, path):
    public = os.path.basename(path).startswith("vtk") and path.endswith(".h")
    bridge = os.path.basename(path).startswith("KernelBridge")
    for _, name in includes(path):
        kernel = os.path.exists(os.path.join(root, "Filters", "Kernel", name))
        if name.startswith("Eigen/"):
            yield f"includes <{name}>; Eigen stays in the kernel"
        if kernel and not bridge:
            yield f'includes "{name}"; filters talk to the kernel through KernelBridge'
        if public and name in PRIVATE_HEADERS:
            yield f'includes "{name}", which is private to the module'


def check_plugin(root):
    for path in files(os.path.join(root, "Plugin"), (".h", ".cxx", ".cpp", ".hpp", ".cc")):
        yield path, "C++ in the plugin; it has XML only"


def check_licence(path):
    if "SPDX-License-Identifier: BSD-3-Clause" not in read(path)[:400]:
        yield "has no SPDX licence line"


def violations(root):
    """All (path, sentence) of a tree, and how many files were looked at."""
    found, looked_at = list(check_plugin(root)), 0
    filters = os.path.join(root, "Filters")
    for path in files(filters, CODE):
        looked_at += 1
        in_kernel = os.path.relpath(path, filters).startswith("Kernel" + os.sep)
        check = check_kernel_file if in_kernel else check_filter_file
        found += [(path, sentence) for sentence in check(root, path)]
    for folder in ("Filters", "Testing"):
        for path in files(os.path.join(root, folder), CODE):
            found += [(path, sentence) for sentence in check_licence(path)]
    return found, looked_at


def self_test():
    """Every rule must find its violation."""
    licence = "// SPDX-License-Identifier: BSD-3-Clause\n"
    bad = {
        "Filters/Kernel/Mesh/A.h": '#include "Distance/B.h"',
        "Filters/Kernel/Distance/B.h": "#include <vtkPolyData.h>",
        "Filters/Kernel/Mesh/C.cxx": '#include "vtkPolyData.h"',
        "Filters/Kernel/Other/D.h": "",
        "Filters/vtkE.h": "#include <Eigen/Core>",
        "Filters/vtkF.cxx": '#include "Mesh/A.h"',
        "Filters/vtkG.h": '#include "KernelBridge.h"',
        "Plugin/h.cxx": "",
    }
    with tempfile.TemporaryDirectory() as root:
        for name, text in bad.items():
            path = os.path.join(root, name)
            os.makedirs(os.path.dirname(path), exist_ok=True)
            with open(path, "w", encoding="utf-8") as file:
                file.write(licence + text + "\n")
        with open(os.path.join(root, "Filters", "vtkI.cxx"), "w", encoding="utf-8") as file:
            file.write("int i;\n")
        found = {os.path.relpath(path, root) for path, _ in violations(root)[0]}
        return sorted((set(bad) | {"Filters/vtkI.cxx"}) - found)


def main():
    missed = self_test()
    for name in missed:
        print(f"self-test: the violation in {name} was not found")
    if "--self-test" in sys.argv:
        print(f"{9 - len(missed)} passed, {len(missed)} failed")
        return 1 if missed else 0
    here = os.path.dirname(os.path.abspath(__file__))
    root = sys.argv[1] if len(sys.argv) > 1 else os.path.dirname(os.path.dirname(here))
    found, looked_at = violations(root)
    for path, sentence in found:
        print(f"{os.path.relpath(path, root)}: {sentence}")
    bad = len({path for path, _ in found})
    print(f"{looked_at - bad} passed, {bad} failed")
    return 1 if found or missed or looked_at == 0 else 0


if __name__ == "__main__":
    sys.exit(main())
