# SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
# SPDX-License-Identifier: BSD-3-Clause
"""An installed tree runs wherever it is moved, and find_package() finds it and the build tree."""

import argparse
import os
import shutil
import sys
import unittest
from pathlib import Path

from commands import run

CONSUMER = Path(__file__).resolve().parent / "Consumer"
OPTIONS = argparse.Namespace()


def python_in(tree, code):
    environment = dict(os.environ, PYTHONPATH=str(tree / OPTIONS.python_dir))
    return run(sys.executable, "-c", code, environment=environment).strip()


def configure(name, *arguments, succeeds=True):
    folder = OPTIONS.output / name
    shutil.rmtree(folder, ignore_errors=True)
    return folder, run(OPTIONS.cmake, "-G", OPTIONS.generator, "-S", CONSUMER, "-B", folder,
                       *arguments, succeeds=succeeds)


class InstalledTree(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        first = OPTIONS.output / "first place"
        cls.tree = OPTIONS.output / "moved here"
        for folder in (first, cls.tree):
            shutil.rmtree(folder, ignore_errors=True)
        cls.said = run(OPTIONS.cmake, "--install", OPTIONS.build, "--prefix", first)
        first.rename(cls.tree)

    def test_says_what_to_set(self):
        first = OPTIONS.output / "first place"
        self.assertIn(f"PYTHONPATH={first}/{OPTIONS.python_dir}", self.said)
        self.assertIn(f"-DCMAKE_PREFIX_PATH={first}", self.said)

    def test_python_imports_it(self):
        points = python_in(
            self.tree, "import evolvingsurfaces as es; source = es.vtkIcosphereSource(); "
            "source.Update(); print(source.GetOutput().GetNumberOfPoints())")
        self.assertEqual(points, "642")

    def test_uses_its_own_library(self):
        maps = python_in(self.tree, "import evolvingsurfaces; print(open('/proc/self/maps').read())")
        libraries = {line.split(maxsplit=5)[-1] for line in maps.splitlines()
                     if "EvolvingSurfacesFilters" in line}
        self.assertEqual(len(libraries), 2, libraries)  # the module and its Python part
        for library in libraries:
            self.assertTrue(library.startswith(str(self.tree)), library)

    def test_names_no_folder_of_the_builder(self):
        for path in self.tree.rglob("*.so"):
            dynamic = run("readelf", "-d", path)
            for line in dynamic.splitlines():
                if "RUNPATH" in line or "RPATH" in line:
                    self.assertNotIn(str(OPTIONS.build), line, path)

    def test_a_project_builds_with_it(self):
        for name, tree in (("with installed", self.tree), ("with built", OPTIONS.build)):
            with self.subTest(name):
                folder, _ = configure(name, f"-DCMAKE_PREFIX_PATH={tree}")
                run(OPTIONS.cmake, "--build", folder)
                self.assertEqual(run(folder / "consumer").strip(), "642")

    def test_another_vtk_is_refused_in_one_sentence(self):
        other = OPTIONS.output / "other-vtk"
        other.mkdir(parents=True, exist_ok=True)
        (other / "vtk-config.cmake").write_text("set(VTK_FOUND TRUE)\nset(VTK_VERSION 7.1.0)\n",
                                                encoding="utf-8")
        _, said = configure("refused", f"-DCMAKE_PREFIX_PATH={self.tree}", f"-DVTK_DIR={other}",
                            succeeds=False)
        words = " ".join(said.split())
        self.assertIn("but VTK 7.1.0 was found in", words)
        self.assertIn("set VTK_DIR to the former", words)

    def test_another_minor_version_is_refused(self):
        config = self.tree.rglob("EvolvingSurfacesConfigVersion.cmake")
        script = OPTIONS.output / "version.cmake"
        script.write_text(f'set(PACKAGE_FIND_VERSION 0.7)\ninclude("{next(config)}")\n'
                          'if (PACKAGE_VERSION_COMPATIBLE)\n  message(FATAL_ERROR "taken")\nendif ()\n',
                          encoding="utf-8")
        run(OPTIONS.cmake, "-P", script)


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--cmake", required=True)
    parser.add_argument("--generator", required=True)
    parser.add_argument("--build", required=True, type=Path)
    parser.add_argument("--python-dir", required=True)
    parser.add_argument("--output", required=True, type=Path)
    OPTIONS, rest = parser.parse_known_args()
    OPTIONS.output.mkdir(parents=True, exist_ok=True)
    unittest.main(argv=[sys.argv[0], *rest])
