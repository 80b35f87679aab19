# SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
# SPDX-License-Identifier: BSD-3-Clause
"""Every number of every class at its limits, far beyond them, and no number at all.

Whatever a parameter is set to is clamped into its range, or refused with one sentence that names
it; what comes out is finite, nothing hangs and nothing crashes.
"""

import itertools
import math
import unittest

import cases
from observing import Messages, is_finite, outputs_of

# Any of these; a parameter that is a length has no other limits than that its squares are numbers.
NUMBERS = (math.nan, math.inf, -math.inf, -1.0, 0.0, 1e-300, 1e-100, 1e-31, 1e-10, 1e10, 1e31, 1e38,
           1e100, 1e160, 1e300)
WHOLE_NUMBERS = (-2**31, -1, 0, 1, 2**31 - 1)

# As many steps as there may be: those that do nothing, or that end when nothing moves.
ENDING = {
    ("vtkSurfaceEvolution", "NumberOfSteps"): {"ConvergenceTolerance": 1e9},
    ("vtkSurfaceEvolution", "SmoothingSteps"): {"NumberOfSteps": 0, "ConvergenceTolerance": 1e9},
}
# And those that are left before their end.
LONG = {"NumberOfSteps", "SmoothingSteps", "TargetEdgeLength", "TargetNumberOfPoints",
        "OffsetDistance"}
FEW_PROGRESSES = 1
# Surfaces of millions of points, which take their time.
NOT_MADE = {("vtkIcosphereSource", "Level"): 5, ("vtkIcosphereSource", "Resolution"): 50}


def vectors(usual, values):
    """A vector with each of its components each of the values in turn, and all of them one."""
    for value in values:
        for k in range(len(usual)):
            yield tuple(value if i == k else x for i, x in enumerate(usual))
        yield tuple(value for _ in usual)


def inverted(box):
    """A box that ends before it begins along some axes, but not along all."""
    for turned in itertools.product((False, True), repeat=3):
        if any(turned) and not all(turned):
            sides = [box[2 * a:2 * a + 2] for a in range(3)]
            yield sum((side[::-1] if turn else side for side, turn in zip(sides, turned)), ())


class Limits(unittest.TestCase):
    def parameters(self):
        for name, table in cases.OTHER_VALUES.items():
            for parameter, (value, beside) in table.items():
                if not isinstance(value, bool):
                    yield name, parameter, value, {**beside, **ENDING.get((name, parameter), {})}

    def values(self, name, parameter, usual):
        """What to set."""
        first = usual[0] if isinstance(usual, tuple) else usual
        made = cases.make(name)
        if hasattr(made, f"Get{parameter}MinValue"):
            whole = WHOLE_NUMBERS if isinstance(first, int) else NUMBERS
            return (*whole, getattr(made, f"Get{parameter}MinValue")(),
                    getattr(made, f"Get{parameter}MaxValue")())
        if isinstance(first, int):  # one sample along the others, for there are too many else
            return list(vectors((1, 1, 1), WHOLE_NUMBERS))
        return list(vectors(usual, NUMBERS)) + (list(inverted(usual)) if len(usual) == 6 else [])

    def test_any_number_is_clamped_refused_or_used(self):
        for name, parameter, usual, beside in self.parameters():
            for value in self.values(name, parameter, usual):
                with self.subTest(f"{name}.{parameter} = {value}"):
                    self.check(name, parameter, value, beside)

    def check(self, name, parameter, value, beside):
        made = cases.make(name, beside)
        cases.assign(made, {parameter: value})
        self.check_range(made, parameter)
        if (name, parameter) in NOT_MADE and (
                getattr(made, "Get" + parameter)() > NOT_MADE[name, parameter]):
            return
        messages = Messages(made)
        progress = itertools.count()
        made.AddObserver("ProgressEvent", lambda *_: made.SetAbortExecute(
            parameter in LONG and next(progress) > FEW_PROGRESSES))
        made.Update()
        stored = getattr(made, "Get" + parameter)()
        must_refuse = not all(map(math.isfinite, stored if isinstance(stored, tuple) else [stored]))
        self.check_messages(made, parameter, messages, must_refuse)
        for output in outputs_of(made):
            self.assertTrue(is_finite(output))

    def check_range(self, made, parameter):
        """What is a number is in the range."""
        if hasattr(made, f"Get{parameter}MinValue"):
            stored = getattr(made, "Get" + parameter)()
            self.assertFalse(stored < getattr(made, f"Get{parameter}MinValue")())
            self.assertFalse(stored > getattr(made, f"Get{parameter}MaxValue")())

    def check_messages(self, made, parameter, messages, must_refuse):
        self.assertLessEqual(len(messages.errors), 1)
        self.assertTrue(messages.errors or not must_refuse, "it was to be refused")
        for sentence in messages.errors + messages.warnings:
            self.assertRegex(sentence, r"^[A-Z].*\.$")
            self.assertNotRegex(sentence, r"\. |\n|least inf")
        stopped = outputs_of(made)[0].GetFieldData().GetArray("Stopped") is not None
        for sentence in messages.errors if not stopped else []:
            self.assertIn(parameter, sentence)
            self.assertEqual(outputs_of(made)[0].GetNumberOfPoints(), 0)


if __name__ == "__main__":
    unittest.main()
