# SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
# SPDX-License-Identifier: BSD-3-Clause
"""Figure 5.6: the distance to the bunny after one to eight sweeps of the fast sweeping method.

What lies behind a plane is rendered as a volume; samples that no sweep has reached yet are
transparent.

    figure_5_6_fast_sweeping.py [PICTURE.png]
"""
import evolvingsurfaces as es
import numpy
from drawing import IVORY, scalar_bar, sequential, surface, volume
from figures import array, check, copy_of, model
from pictures import Panel, save
from vtkmodules.vtkImagingCore import vtkExtractVOI

SAMPLES, SWEEPS = 60, range(1, 9)
bunny = model("bunny.ply")


def distance_by(method, sweeps=8):
    distance = es.vtkMeshSDF()
    distance.SetInputData(bunny)
    distance.SetSampleDimensions(SAMPLES, SAMPLES, SAMPLES)
    distance.SetSignToUnsigned()
    distance.SetMethod(method)
    distance.SetNumberOfSweeps(sweeps)
    return copy_of(distance)


def values(image):
    return array(image, "SignedDistance")


def back_part(image):
    part = vtkExtractVOI()
    part.SetInputData(image)
    part.SetVOI(0, SAMPLES - 1, 0, SAMPLES - 1, 0, 2 * SAMPLES // 5)
    return part


exact = distance_by(es.vtkMeshSDF.BRUTE_FORCE)
farthest = values(exact).max()
swept = [distance_by(es.vtkMeshSDF.FAST_SWEEPING, n) for n in SWEEPS]
reached = [numpy.mean(values(image) < 1e6) for image in swept]
for image in swept:
    values(image)[:] = numpy.minimum(values(image), 2.0 * farthest)
errors = [numpy.mean(abs(values(image) - values(exact))) for image in swept]

colors = sequential(0.0, farthest)
opacities = ((0.0, 0.3), (1.2 * farthest, 0.3), (1.21 * farthest, 0.0), (2.0 * farthest, 0.0))
captions = [f"sweep {n}\n" + (f"{r:.0%} reached" if r < 1.0 else f"mean error {e:.3f}")
            for n, r, e in zip(SWEEPS, reached, errors)]
save([Panel([volume(back_part(image), colors, opacities), surface(bunny, IVORY, edges=False)],
            caption)
      for image, caption in zip(swept, captions)],
     columns=4, width=1000, height=230, bar=scalar_bar(colors, "distance"))

for n, low, high in ((1, 0.4, 0.8), (2, 0.6, 0.9), (3, 0.8, 0.95), (4, 1.0, 1.0), (8, 1.0, 1.0)):
    check(f"part of the samples reached by sweep {n}", reached[n - 1], low, high)
check("least fall of the mean error in a sweep", -max(numpy.diff(errors)), 1e-3, farthest)
cell = exact.GetSpacing()[0]
check("mean error after 4 sweeps, in cells", errors[3] / cell, 0.4, 1.5)
check("mean error after 8 sweeps, in cells", errors[7] / cell, 0.2, 0.4)
