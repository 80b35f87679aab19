# SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
# SPDX-License-Identifier: BSD-3-Clause
"""What is in the Debian packages that cpack makes, and what they depend on."""

import argparse
import os
import shutil
import stat
import sys
import unittest

from commands import run
from packages import add_arguments, make_packages

OPTIONS = argparse.Namespace()


class DebianPackage(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.packages = make_packages(OPTIONS.cpack, OPTIONS.build, OPTIONS.output / "package")
        cls.trees = {}
        for name, path in cls.packages.items():
            cls.trees[name] = OPTIONS.output / "contents" / name
            shutil.rmtree(cls.trees[name], ignore_errors=True)
            cls.trees[name].parent.mkdir(exist_ok=True)
            run("dpkg-deb", "--extract", path, cls.trees[name])
        cls.tree = cls.trees["evolvingsurfaces"]

    def field(self, package, name):
        return run("dpkg-deb", "--field", self.packages[package], name).strip()

    def dependencies(self, package):
        """The conditions on each package that this one depends on: {"python3": [">= 3.11", ...]}."""
        found = {}
        for part in self.field(package, "Depends").split(","):
            name, _, condition = part.strip().partition(" ")
            found.setdefault(name, []).append(condition.strip("()"))
        return found

    def check_one_minor(self, dependencies, name):
        relations = {condition.split(" ")[0] for condition in dependencies.get(name, [])}
        self.assertEqual(relations, {">=", "<<"}, f"{name} in {dependencies}")

    def test_which_there_are(self):
        expected = {"evolvingsurfaces", "evolvingsurfaces-dev"}
        self.assertEqual(set(self.packages), expected if OPTIONS.development else expected - {
            "evolvingsurfaces-dev"})
        architecture = run("dpkg", "--print-architecture").strip()
        for name, path in self.packages.items():
            self.assertEqual(path.name,
                             f"{name}_{self.field(name, 'Version')}_{architecture}.deb")

    def test_what_it_depends_on(self):
        dependencies = self.dependencies("evolvingsurfaces")
        self.check_one_minor(dependencies, "python3")
        self.check_one_minor(dependencies, OPTIONS.python_vtk)
        if OPTIONS.plugin:
            self.check_one_minor(dependencies, "paraview")
        self.assertIn("libstdc++6", dependencies)

    def test_what_building_with_it_depends_on(self):
        if not OPTIONS.development:
            self.skipTest("there is no evolvingsurfaces-dev")
        dependencies = self.dependencies("evolvingsurfaces-dev")
        version = self.field("evolvingsurfaces", "Version")
        self.assertEqual(dependencies.pop("evolvingsurfaces"), [f"= {version}"])
        self.assertEqual(len(dependencies), 1, dependencies)
        self.check_one_minor(dependencies, *dependencies)

    def test_python_has_its_package(self):
        package = self.tree / "usr/lib/python3/dist-packages/evolvingsurfaces"
        self.assertTrue((package / "__init__.py").is_file())
        self.assertEqual(len(list(package.glob("*.so"))), 1)

    def test_paraview_comes_upon_the_plugin(self):
        if not OPTIONS.plugin:
            self.skipTest("there is no plugin")
        places = {"usr/bin/plugins", "usr/share/paraview/plugins"}
        found = {place for place in places if os.path.lexists(self.tree / place)}
        self.assertIn("usr/share/paraview/plugins", found)
        for place in found:  # by links that lead to it within the package
            plugin = self.tree / place / "EvolvingSurfaces/EvolvingSurfaces.so"
            self.assertTrue(plugin.is_file(), plugin)
            self.assertTrue(plugin.resolve().is_relative_to(self.tree), plugin.resolve())

    def test_libraries_are_looked_for_inside(self):
        libraries = [path for path in self.tree.rglob("*.so*") if not path.is_symlink()]
        self.assertEqual(len(libraries), 3 if OPTIONS.plugin else 2, libraries)
        for library in libraries:
            for line in run("readelf", "--dynamic", library).splitlines():
                if "RPATH" in line or "RUNPATH" in line:
                    folders = line.split("[")[1].rstrip("]").split(":")
                    for folder in folders:
                        self.assertTrue(folder.startswith("$ORIGIN"), f"{library}: {line}")

    def test_texts_name_no_folder_of_the_builder(self):
        builders = [str(OPTIONS.build), str(OPTIONS.source)]
        read = 0
        for path in (path for tree in self.trees.values() for path in tree.rglob("*")):
            if path.suffix in (".cmake", ".h", ".py", ".txt") and path.is_file():
                read += 1
                for builder in builders:
                    self.assertNotIn(builder, path.read_text(encoding="utf-8"), path)
        self.assertGreater(read, 0)

    def test_files_are_of_root_and_readable(self):
        for name, path in self.packages.items():
            for line in run("dpkg-deb", "--contents", path).splitlines():
                self.assertEqual(line.split()[1], "root/root", line)
            for entry in self.trees[name].rglob("*"):
                mode = stat.S_IMODE(entry.lstat().st_mode)
                expected = {0o777} if entry.is_symlink() else {0o755} if entry.is_dir() else {0o644}
                self.assertIn(mode, expected, entry)

    def test_no_file_is_in_both(self):
        names = [{path.relative_to(tree) for path in tree.rglob("*")
                  if path.is_symlink() or not path.is_dir()} for tree in self.trees.values()]
        self.assertFalse(set.intersection(*names) if len(names) > 1 else set())

    def test_lintian_finds_no_error(self):
        if not shutil.which("lintian"):
            self.skipTest("lintian is not installed")
        run("lintian", "--allow-root", "--fail-on", "error", *self.packages.values())


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__)
    add_arguments(parser)
    parser.add_argument("--python-vtk", required=True, help="Debian's package of VTK for Python")
    parser.add_argument("--development", action="store_true", help="there is evolvingsurfaces-dev")
    OPTIONS, rest = parser.parse_known_args()
    unittest.main(argv=[sys.argv[0], *rest])
