# SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
# SPDX-License-Identifier: BSD-3-Clause
"""Every picture that the repository shows is made by a script, and another one is told from it."""

import tempfile
import unittest
from pathlib import Path

import numpy as np
from picture_difference import PICTURES, difference, read
from run_example import LARGEST_DIFFERENCE
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOImage import vtkPNGWriter

ROOT = Path(__file__).resolve().parents[2]
EXAMPLES = ROOT / "Examples"
# Made by Scripts/demo.py, the test Example.demo.
OF_THE_DEMO = EXAMPLES / "demo.png"


def pictures():
    return [path for path in EXAMPLES.rglob("*") if path.suffix in PICTURES]


class Pictures(unittest.TestCase):
    def test_every_one_has_its_script(self):
        for path in pictures():
            with self.subTest(path.name):
                self.assertTrue(path == OF_THE_DEMO or path.with_suffix(".py").exists(), path)

    def test_every_one_is_shown(self):
        pages = "".join(page.read_text(encoding="utf-8") for page in
                        (ROOT / "README.md", EXAMPLES / "thesis" / "README.md"))
        for path in pictures():
            with self.subTest(path.name):
                self.assertIn(path.name, pages)

    def test_a_picture_equals_itself(self):
        self.assertEqual(difference(OF_THE_DEMO, OF_THE_DEMO), 0.0)

    def test_another_digit_makes_another_picture(self):
        """Twelve by sixteen pixels of a caption, drawn white."""
        image = read(OF_THE_DEMO)
        colors = image.GetPointData().GetScalars()
        width, height, _ = image.GetDimensions()
        pixels = vtk_to_numpy(colors).reshape(height, width, -1)
        # Captions are what is dark below the panels; row 0 is the lowest.
        rows, columns = np.nonzero(pixels[height // 6:height // 4].max(axis=2) < 80)
        low, left = rows[0] + height // 6, columns[0]
        pixels[low:low + 16, max(0, left - 6):left + 6] = 255
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder) / "without.png"
            writer = vtkPNGWriter()
            writer.SetInputData(image)
            writer.SetFileName(str(path))
            writer.Write()
            self.assertGreater(difference(path, OF_THE_DEMO), LARGEST_DIFFERENCE)


if __name__ == "__main__":
    unittest.main()
