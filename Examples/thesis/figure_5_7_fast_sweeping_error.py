# SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
# SPDX-License-Identifier: BSD-3-Clause
"""Figure 5.7: what fast sweeping errs by around the bunny, on a grid of 45 samples a side.

G = |d by fast sweeping - exact d|; the thesis's L2 error is the mean of G^2 over the samples.

    figure_5_7_fast_sweeping_error.py [PICTURE.png]
"""
from math import log2

import evolvingsurfaces as es
import numpy
from drawing import IVORY, image_slice, scalar_bar, sequential, surface, volume
from figures import array, check, copy_of, model
from pictures import Panel, save

bunny = model("bunny.ply")


def distance_by(method, samples):
    distance = es.vtkMeshSDF()
    distance.SetInputData(bunny)
    distance.SetSampleDimensions(samples, samples, samples)
    distance.SetSignToUnsigned()
    distance.SetMethod(method)
    return copy_of(distance)


def error_on_grid(samples):
    """An image of G."""
    exact = distance_by(es.vtkMeshSDF.BRUTE_FORCE, samples)
    swept = distance_by(es.vtkMeshSDF.FAST_SWEEPING, samples)
    g = array(swept, "SignedDistance")
    g[:] = abs(g - array(exact, "SignedDistance"))
    return swept


def errors(image):
    """Mean in cells, largest in cells, and the thesis's L2 error."""
    g, cell = array(image, "SignedDistance"), image.GetSpacing()[0]
    return numpy.mean(g) / cell, numpy.max(g) / cell, numpy.mean(g ** 2)


coarse, fine = error_on_grid(45), error_on_grid(90)
(mean, largest, l2), finer = errors(coarse), errors(fine)[2]
colors, cell = sequential(0.0, 0.4), coarse.GetSpacing()[0]
haze = ((0.0, 0.0), (0.1, 0.0), (0.4, 0.12))     # opacity shows where G is large
save([Panel([volume(coarse, colors, haze), surface(bunny, IVORY, edges=False)], "volume"),
      Panel([image_slice(coarse, 2, 22, colors)], "middle slice across z",
            direction=(0.0, 0.0, 1.0)),
      Panel([image_slice(coarse, 0, 22, colors)], "middle slice across x",
            direction=(1.0, 0.0, 0.0))],
     width=1000, height=320, bar=scalar_bar(colors, f"error G (a cell is {cell:.2f} wide)"))

print("L2 error of the thesis on 90^3:", finer)
check("mean error on 45^3, in cells", mean, 0.25, 0.4)
check("largest error on 45^3, in cells", largest, 1.0, 2.0)
check("L2 error of the thesis on 45^3", l2, 0.01, 0.015)
check("order of the L2 error, of squares", log2(l2 / finer), 1.5, 2.1)
