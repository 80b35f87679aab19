# SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
# SPDX-License-Identifier: BSD-3-Clause
"""The package has its classes, with their documentation and their named values."""

import re
import unittest

import evolvingsurfaces as es
from vtkmodules.test.BlackBox import Tester
from vtkmodules.vtkCommonCore import vtkObject
from vtkmodules.vtkCommonExecutionModel import vtkAlgorithm, vtkPolyDataAlgorithm

CLASSES = ("vtkMeshSDF", "vtkSurfaceEvolution", "vtkTangentialRedistribution", "vtkShrinkWrap",
           "vtkIcosphereSource", "vtkLabelSurfaces", "vtkDistanceHierarchy")

# The public constants, as scripts have them.
CONSTANTS = {
    "vtkMeshSDF": {
        "CLOSEST_POINT": 0, "FAST_SWEEPING": 1, "BRUTE_FORCE": 2,
        "AUTOMATIC": 0, "FLOOD_FILL": 1, "WINDING_NUMBER": 2, "PSEUDONORMAL": 3, "UNSIGNED": 4},
    "vtkSurfaceEvolution": {
        "MEAN_CURVATURE": 0, "SURFACE_DIFFUSION": 1, "DISTANCE_FIELD": 0, "IMAGE": 1, "EDGE_IMAGE": 2,
        "WEIGHTED_EDGES": 0, "SHAPE": 1,
        "WEIGHTING_NONE": 0, "INVERSE_AREA": 1, "DISTANCE": 2,
        "CONTROL_NONE": 0, "CUBE_ROOT": 1, "TWO_THIRDS": 2, "EXPONENTIAL": 3,
        "FIXED": 0, "SLIDE_ALONG": 1, "FREE": 2, "OFF": 0, "UNIFORM": 1, "CURVATURE_ADAPTIVE": 2,
        "AUTOMATIC": 3, "FIRST_STEP": 0, "LAST_STEP": 1, "STEP_INDEX": 2},
    "vtkTangentialRedistribution": {
        "WEIGHTED_EDGES": 0, "SHAPE": 1,
        "WEIGHTING_NONE": 0, "INVERSE_AREA": 1,
        "CONTROL_NONE": 0, "CUBE_ROOT": 1, "TWO_THIRDS": 2, "EXPONENTIAL": 3,
        "FIXED": 0, "SLIDE_ALONG": 1, "FREE": 2},
    "vtkShrinkWrap": {"ISOSURFACE": 0, "ICOSPHERE": 1, "OFF": 0, "ON": 1, "AUTOMATIC": 2,
                      "FIRST_STEP": 0, "LAST_STEP": 1, "STEP_INDEX": 2},
    "vtkIcosphereSource": {"ICOSPHERE": 0, "CUBE_SPHERE": 1, "BOX": 2},
    "vtkDistanceHierarchy": {"AABB_TREE": 0, "OCTREE": 1},
    "vtkLabelSurfaces": {},
}


def constant_name(value_name):
    """ClosestPoint -> CLOSEST_POINT, AABBTree -> AABB_TREE."""
    return re.sub(r"(?<=[a-z])(?=[A-Z])|(?<=[A-Z])(?=[A-Z][a-z])", "_", value_name).upper()


class Classes(unittest.TestCase):
    def test_the_package_has_its_classes_and_a_version(self):
        found = {name for name in dir(es) if name.startswith("vtk")}
        self.assertTrue(found.issuperset(CLASSES), found)
        self.assertRegex(es.__version__, r"^\d+\.\d+\.\d+$")

    def test_the_package_says_how_it_is_used(self):
        self.assertIn("import evolvingsurfaces as es", es.__doc__)

    def test_classes_are_algorithms_with_documentation(self):
        for name in CLASSES:
            with self.subTest(name):
                made = getattr(es, name)()
                self.assertIsInstance(made, vtkAlgorithm)
                self.assertEqual(made.GetClassName(), name)
                self.assertGreater(len(made.__doc__), 300)

    def test_black_box(self):
        # VTK's parser of methods calls every getter, also those that need a connection.
        vtkObject.GlobalWarningDisplayOff()
        self.addCleanup(vtkObject.GlobalWarningDisplayOn)
        inherited = [key[3:] for key in dir(vtkPolyDataAlgorithm) if key.startswith("Set")]
        for name in CLASSES:
            with self.subTest(name):
                made = getattr(es, name)()
                tester = Tester()
                tester.testParse(made)
                tester.testGetSet(made, excluded_methods=inherited)
                tester.testBoolean(made)


class Enumerations(unittest.TestCase):
    def test_constants_have_their_values(self):
        for name, constants in CONSTANTS.items():
            for constant, value in constants.items():
                self.assertEqual(getattr(getattr(es, name), constant), value, constant)

    def test_there_are_no_other_constants(self):
        for name, constants in CONSTANTS.items():
            own = vars(getattr(es, name)).items()
            found = {key for key, value in own if key.isupper() and isinstance(value, int)}
            self.assertEqual(found, set(constants), name)

    def test_every_value_has_a_setter_by_name(self):
        for name, constants in CONSTANTS.items():
            made = getattr(es, name)()
            reached = set()
            for setter in vars(type(made)):
                parts = re.match(r"Set(\w+?)To([A-Z]\w*)$", setter)
                if not parts or not hasattr(made, "Get" + parts.group(1)):
                    continue  # AdaptToCurvature is a switch
                parameter, value_name = parts.groups()
                getattr(made, setter)()
                plain = constant_name(value_name)
                candidates = [key for key in constants
                              if key == plain or key.endswith("_" + plain) and plain == "NONE"]
                value = getattr(made, "Get" + parameter)()
                self.assertTrue(any(constants[key] == value for key in candidates), setter)
                reached.update(candidates)
            self.assertEqual(reached, set(constants), name)


if __name__ == "__main__":
    unittest.main()
