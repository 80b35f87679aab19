# SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
# SPDX-License-Identifier: BSD-3-Clause
"""The wheel of pyproject.toml, as far as it can be tried with the VTK of the system.

Builds with the options and installs the components that pyproject.toml names.
"""

import argparse
import os
import shutil
import sys
import tomllib
import unittest
from pathlib import Path

from commands import run

ROOT = Path(__file__).resolve().parents[2]
OPTIONS = argparse.Namespace()
CODE = ("import evolvingsurfaces as es; source = es.vtkIcosphereSource(); wrap = es.vtkShrinkWrap(); "
        "wrap.SetInputConnection(source.GetOutputPort()); wrap.SetTargetNumberOfPoints(500); "
        "wrap.Update(); print(wrap.GetOutput().GetFieldData().GetArray('IsClosed').GetValue(0))")


class Wheel(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.project = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))
        settings = cls.project["tool"]["scikit-build"]
        tree = OPTIONS.output / "build"
        cls.site = OPTIONS.output / "site"
        shutil.rmtree(cls.site, ignore_errors=True)
        definitions = [f"-D{name}={value}" for name, value in settings["cmake"]["define"].items()]
        run(OPTIONS.cmake, "-G", "Ninja", "-S", ROOT, "-B", tree, "-DCMAKE_BUILD_TYPE=Release",
            f"-DVTK_DIR={OPTIONS.vtk_dir}", f"-DPython3_EXECUTABLE={sys.executable}", *definitions)
        for target in settings["build"]["targets"]:
            run(OPTIONS.cmake, "--build", tree, "--target", target)
        for component in settings["install"]["components"]:
            run(OPTIONS.cmake, "--install", tree, "--prefix", cls.site, "--component", component)

    def test_has_the_package_and_nothing_else(self):
        files = {str(path.relative_to(self.site)) for path in self.site.rglob("*") if path.is_file()}
        self.assertEqual(files, {"evolvingsurfaces/__init__.py",
                                 "evolvingsurfaces/libvtkEvolvingSurfacesFilters.so",
                                 "evolvingsurfaces/vtkEvolvingSurfacesFilters.so"})

    def test_has_the_files_of_the_plain_package(self):
        plain = OPTIONS.build / OPTIONS.python_dir / "evolvingsurfaces"
        names = {path.name for path in plain.iterdir() if path.is_file()}
        self.assertEqual(names, {"__init__.py", "vtkEvolvingSurfacesFilters.so"})
        self.assertEqual((plain / "__init__.py").read_text(encoding="utf-8"),
                         (self.site / "evolvingsurfaces/__init__.py").read_text(encoding="utf-8"))

    def test_finds_its_libraries_beside_itself(self):
        for path in self.site.rglob("*.so"):
            with self.subTest(path.name):
                line = next(line for line in run("readelf", "-d", path).splitlines()
                            if "RUNPATH" in line or "RPATH" in line)
                folders = line[line.index("[") + 1:line.index("]")].split(":")
                self.assertIn("$ORIGIN", folders)
                self.assertIn("$ORIGIN/../vtkmodules", folders)
                self.assertTrue(all(f.startswith("$ORIGIN") for f in folders), folders)

    def test_python_wraps_a_mesh_with_it(self):
        environment = dict(os.environ, PYTHONPATH=str(self.site))
        self.assertEqual(run(sys.executable, "-c", CODE, environment=environment).strip(), "1")


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--cmake", required=True)
    parser.add_argument("--build", required=True, type=Path)
    parser.add_argument("--vtk-dir", required=True)
    parser.add_argument("--python-dir", required=True)
    parser.add_argument("--output", required=True, type=Path)
    OPTIONS, rest = parser.parse_known_args()
    unittest.main(argv=[sys.argv[0], *rest])
