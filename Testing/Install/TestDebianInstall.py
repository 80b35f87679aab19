# SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
# SPDX-License-Identifier: BSD-3-Clause
"""Debian's packages in a bootstrap folder: installed, used by Python, ParaView and CMake, removed.

Takes minutes, root and a connection to a mirror of Debian. EVOLVINGSURFACES_BOOTSTRAP may name a
folder that debootstrap made, which is copied instead of making one. Ends with status 77 where there
can be no such folder.
"""

import argparse
import shutil
import sys
import unittest
from pathlib import Path

from bootstrap import Bootstrap, Unavailable
from packages import add_arguments, make_packages

OPTIONS = argparse.Namespace()
CONSUMER = Path(__file__).resolve().parent / "Consumer"
SKIPPED = 77

WRAP = """
import evolvingsurfaces as es
from vtkmodules.vtkIOGeometry import vtkOBJReader
reader = vtkOBJReader()
reader.SetFileName("/root/cube.obj")
wrap = es.vtkShrinkWrap()
wrap.SetInputConnection(reader.GetOutputPort())
wrap.Update()
field = wrap.GetOutput().GetFieldData()
print(es.__file__, int(field.GetArray("IsClosed").GetValue(0)))
"""

PLUGIN = """
from paraview.simple import *
LoadDistributedPlugin("EvolvingSurfaces", ns=globals())
wrap = ShrinkWrap(Input=Icosphere())
wrap.UpdatePipeline()
field = servermanager.Fetch(wrap).GetFieldData()
print("closed", int(field.GetArray("IsClosed").GetValue(0)))
"""


def install(*packages):
    SYSTEM.run("apt-get", "install", "--yes", "--no-install-recommends", *packages)


def last_line(text):
    return text.strip().splitlines()[-1]


class DebianInstall(unittest.TestCase):
    """The tests go by their names: each needs what those before it did."""

    def test_1_installs(self):
        packages = make_packages(OPTIONS.cpack, OPTIONS.build, OPTIONS.output / "package")
        type(self).names = sorted(packages)
        for name, path in packages.items():
            shutil.copy(path, SYSTEM.folder / f"root/{name}.deb")
        shutil.copy(OPTIONS.source / "Data/cube.obj", SYSTEM.folder / "root")
        SYSTEM.run("apt-get", "update")
        install("/root/evolvingsurfaces.deb")
        type(self).files = SYSTEM.run("dpkg", "--listfiles", "evolvingsurfaces").splitlines()
        self.assertIn("/usr/lib/python3/dist-packages/evolvingsurfaces/__init__.py", self.files)

    def test_2_python_wraps_a_mesh(self):
        self.assertEqual(last_line(SYSTEM.run("python3", "-c", WRAP)),
                         "/usr/lib/python3/dist-packages/evolvingsurfaces/__init__.py 1")

    def test_3_paraview_loads_the_plugin_by_name(self):
        if not OPTIONS.plugin:
            self.skipTest("there is no plugin")
        (SYSTEM.folder / "root/plugin.py").write_text(PLUGIN, encoding="utf-8")
        self.assertEqual(last_line(SYSTEM.run("pvpython", "/root/plugin.py")), "closed 1")

    def test_4_a_project_builds_with_it(self):
        if "evolvingsurfaces-dev" not in self.names:
            self.skipTest("there is no evolvingsurfaces-dev")
        install("/root/evolvingsurfaces-dev.deb", "cmake", "g++", "make")
        self.files.extend(SYSTEM.run("dpkg", "--listfiles", "evolvingsurfaces-dev").splitlines())
        shutil.copytree(CONSUMER, SYSTEM.folder / "root/Consumer")
        SYSTEM.run("cmake", "-S", "/root/Consumer", "-B", "/root/built")
        SYSTEM.run("cmake", "--build", "/root/built")
        self.assertEqual(SYSTEM.run("/root/built/consumer").strip(), "642")

    def test_5_leaves_nothing_behind(self):
        SYSTEM.run("apt-get", "purge", "--yes", *self.names)
        left = [path for path in self.files if SYSTEM.has(path)]
        # Folders that other packages have, too, stay.
        found = SYSTEM.run("sh", "-c", 'dpkg --search "$@" 2>&1 || true', "sh", *left)
        unowned = [line.split()[-1] for line in found.splitlines() if "no path found" in line]
        self.assertTrue(left)
        self.assertEqual(unowned, [])


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__)
    add_arguments(parser)
    OPTIONS, rest = parser.parse_known_args()
    OPTIONS.output.mkdir(parents=True, exist_ok=True)
    try:
        SYSTEM = Bootstrap(OPTIONS.output / "bootstrap")
    except Unavailable as reason:
        print(f"Skipped: {reason}")
        sys.exit(SKIPPED)
    try:
        unittest.main(argv=[sys.argv[0], "--failfast", *rest])
    finally:
        SYSTEM.remove()
