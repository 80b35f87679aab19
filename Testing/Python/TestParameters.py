# SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
# SPDX-License-Identifier: BSD-3-Clause
"""Every parameter of every class: default, range, one modification per change, documentation.

The parameters are found by their Set and Get methods, so that a new one is tested without a line
here.
"""

import math
import unittest

import evolvingsurfaces as es


class Parameter:
    """A parameter of a fresh object."""

    def __init__(self, cls, name):
        self.made = cls()
        self.name = name
        self.label = f"{cls.__name__}.{name}"

    def get(self):
        return getattr(self.made, "Get" + self.name)()

    def set(self, value):
        """Sets a value as Get returns it: a number, or a tuple of numbers."""
        setter = getattr(self.made, "Set" + self.name)
        setter(*value) if isinstance(value, tuple) else setter(value)

    @property
    def documentation(self):
        return getattr(self.made, "Set" + self.name).__doc__

    @property
    def is_vector(self):
        return isinstance(self.get(), tuple)

    @property
    def is_switch(self):
        return hasattr(self.made, self.name + "On") and hasattr(self.made, self.name + "Off")

    @property
    def range(self):
        """The smallest and the largest value; None without a range."""
        if not hasattr(self.made, f"Get{self.name}MinValue"):
            return None
        return (getattr(self.made, f"Get{self.name}MinValue")(),
                getattr(self.made, f"Get{self.name}MaxValue")())

    def modifies(self, action):
        before = self.made.GetMTime()
        action()
        return self.made.GetMTime() > before


def parameters(wanted=lambda parameter: True):
    """All that have SetX and GetX in the class itself."""
    found = []
    for cls in (getattr(es, name) for name in dir(es) if name.startswith("vtk")):
        own = vars(cls)
        names = sorted(key[3:] for key in own if key[:3] == "Set" and "Get" + key[3:] in own)
        found += [Parameter(cls, name) for name in names]
    return [parameter for parameter in found if wanted(parameter)]


class Parameters(unittest.TestCase):
    def test_there_are_as_many_as_promised(self):
        self.assertGreater(len(parameters()), 55)

    def test_every_number_has_a_range_or_is_a_switch(self):
        for parameter in parameters(lambda p: not p.is_vector):
            with self.subTest(parameter.label):
                self.assertTrue(parameter.is_switch or parameter.range)
                self.assertEqual(parameter.is_switch, isinstance(parameter.get(), bool))

    def test_defaults_are_in_their_ranges(self):
        for parameter in parameters(lambda p: p.range):
            with self.subTest(parameter.label):
                lower, upper = parameter.range
                self.assertLessEqual(lower, parameter.get())
                self.assertLessEqual(parameter.get(), upper)

    def test_values_outside_are_clamped(self):
        for parameter in parameters(lambda p: p.range):
            with self.subTest(parameter.label):
                far = math.inf if isinstance(parameter.get(), float) else 2**31 - 1
                parameter.set(far)
                self.assertEqual(parameter.get(), parameter.range[1])
                parameter.set(-far)
                self.assertEqual(parameter.get(), parameter.range[0])

    def test_the_same_value_is_no_modification(self):
        for parameter in parameters():
            with self.subTest(parameter.label):
                value = parameter.get()
                self.assertFalse(parameter.modifies(lambda: parameter.set(value)))
                self.assertEqual(parameter.get(), value)

    def test_another_value_is_a_modification(self):
        for parameter in parameters(lambda p: p.range and p.range[0] < p.range[1]):
            with self.subTest(parameter.label):
                lower, upper = parameter.range
                other = lower if parameter.get() != lower else upper
                self.assertTrue(parameter.modifies(lambda: parameter.set(other)))
                self.assertFalse(parameter.modifies(lambda: parameter.set(other)))

    def test_switches_switch(self):
        for parameter in parameters(lambda p: p.is_switch):
            for value, name in ((True, "On"), (False, "Off")):
                with self.subTest(parameter.label + name):
                    getattr(parameter.made, parameter.name + name)()
                    self.assertIs(parameter.get(), value)
                    self.assertFalse(parameter.modifies(lambda: parameter.set(value)))

    def test_sample_dimensions_are_clamped(self):
        for parameter in parameters(lambda p: p.name == "SampleDimensions"):
            with self.subTest(parameter.label):
                parameter.set((-5, 10**9, 20))
                lowest, largest, _ = parameter.get()
                automatic = parameter.made.IsA("vtkShrinkWrap")
                self.assertGreaterEqual(lowest, 0 if automatic else 1)
                self.assertLessEqual(largest, 65536)
                self.assertFalse(parameter.modifies(lambda: parameter.set((0, 2**31 - 1, 20))))
                parameter.made.SetSampleDimensions((9, 10, 11))
                self.assertEqual(parameter.get(), (9, 10, 11))

    def test_every_parameter_is_printed(self):
        for parameter in parameters():
            with self.subTest(parameter.label):
                self.assertIn(f"\n  {parameter.name}: ", str(parameter.made))

    def test_every_parameter_is_documented_with_its_default(self):
        for parameter in parameters():
            with self.subTest(parameter.label):
                self.assertRegex(parameter.documentation, r"default|Off[;.]")


if __name__ == "__main__":
    unittest.main()
