# SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
# SPDX-License-Identifier: BSD-3-Clause
"""The sample shapes: the files are what the script writes, and their topology what they are for."""

import subprocess
import sys
import unittest
from collections import Counter
from pathlib import Path

DATA = Path(__file__).resolve().parents[2] / "Data"
sys.path.insert(0, str(DATA))
sys.dont_write_bytecode = True                   # the folder is for data

from make_shapes import SHAPES  # noqa: E402

# The genus of closed ones, the parts of assemblies (each of genus 0), the boundary edges of sheets.
GENUS = {"cube.obj": 0, "arc.vtk": 0, "torus.ply": 1, "genus_two.obj": 2, "clamp.obj": 2,
         "perforated_sheet.obj": 12, "bracket.vtk": 2}
PARTS = {"rib_cooler.obj": 7, "bar_heap.ply": 18}
BOUNDARY = {"disc.vtk": 72, "bowl.ply": 48}


def directed_edges(faces):
    return Counter(edge for face in faces for edge in zip(face, face[1:] + face[:1]))


def euler_characteristic(points, faces):
    return len(points) - len({frozenset(edge) for edge in directed_edges(faces)}) + len(faces)


def volume(points, faces):
    total = 0.0
    for face in faces:
        for i in range(1, len(face) - 1):
            (a, b, c), (d, e, f), (g, h, k) = (points[face[j]] for j in (0, i, i + 1))
            total += a * (e * k - f * h) - b * (d * k - f * g) + c * (d * h - e * g)
    return total / 6.0


class SampleShapes(unittest.TestCase):
    def test_each_is_checked(self):
        self.assertEqual(set(SHAPES), {*GENUS, *PARTS, *BOUNDARY})

    def test_files_are_what_the_script_writes(self):
        self.assertEqual(0, subprocess.run([sys.executable, DATA / "make_shapes.py",
                                            "--check"]).returncode)

    def test_edges_have_one_face_each_way(self):
        for name, shape in SHAPES.items():
            edges = directed_edges(shape()[1])
            self.assertEqual({1}, set(edges.values()), name)
            self.assertEqual(BOUNDARY.get(name, 0), sum(e[::-1] not in edges for e in edges), name)

    def test_closed_ones_face_outwards(self):
        for name in {**GENUS, **PARTS}:
            self.assertGreater(volume(*SHAPES[name]()), 0.0, name)

    def test_genus(self):
        for name, genus in GENUS.items():
            self.assertEqual(2 - 2 * genus, euler_characteristic(*SHAPES[name]()), name)
        for name, parts in PARTS.items():
            self.assertEqual(2 * parts, euler_characteristic(*SHAPES[name]()), name)


if __name__ == "__main__":
    unittest.main()
