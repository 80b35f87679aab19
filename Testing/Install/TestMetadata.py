# SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
# SPDX-License-Identifier: BSD-3-Clause
"""What the plain build's package and the recipe say of themselves is what pyproject.toml says."""

import argparse
import email
import re
import sys
import tomllib
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
OPTIONS = argparse.Namespace()


def text_of(name):
    return (ROOT / name).read_text(encoding="utf-8")


class Metadata(unittest.TestCase):
    def setUp(self):
        self.toml = tomllib.loads(text_of("pyproject.toml"))
        self.project = self.toml["project"]
        # As scikit-build-core takes the version from the CMake project.
        provider = self.toml["tool"]["scikit-build"]["metadata"]["version"]
        self.version = re.search(provider["regex"], text_of(provider["input"]))["value"]

    def test_the_plain_package_says_the_same(self):
        files = list(OPTIONS.package_dir.glob("evolvingsurfaces-*.dist-info/METADATA"))
        self.assertEqual([file.parent.name for file in files],
                         [f"evolvingsurfaces-{self.version}.dist-info"])
        said = email.message_from_string(files[0].read_text(encoding="utf-8"))
        for field, value in (("Name", self.project["name"]), ("Version", self.version),
                             ("Summary", self.project["description"]),
                             ("License", self.project["license"]),
                             ("Author", self.project["authors"][0]["name"]),
                             ("Requires-Python", self.project["requires-python"])):
            with self.subTest(field):
                self.assertEqual(said[field], value)

    def test_the_recipe_says_the_same(self):
        recipe = text_of("Packaging/conda/recipe.yaml")
        for line in (f'version: "{self.version}"', f"name: {self.project['name']}",
                     f"summary: {self.project['description']}",
                     f"license: {self.project['license']}"):
            with self.subTest(line):
                self.assertIn(line, recipe)

    def test_the_citation_says_the_same(self):
        citation = text_of("CITATION.cff")
        self.assertIn(f"\nversion: {self.version}\n", citation)
        self.assertIn(f"\nlicense: {self.project['license']}\n", citation)

    def test_the_wheel_is_built_and_used_with_one_vtk(self):
        used = [name for name in self.project["dependencies"] if name.startswith("vtk==")]
        built = [name for name in self.toml["build-system"]["requires"] if name.startswith("vtk-sdk==")]
        self.assertEqual([name.replace("vtk-sdk", "vtk") for name in built], used)


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--package-dir", required=True, type=Path)
    OPTIONS, rest = parser.parse_known_args()
    unittest.main(argv=[sys.argv[0], *rest])
