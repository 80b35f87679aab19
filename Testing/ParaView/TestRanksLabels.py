# SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
# SPDX-License-Identifier: BSD-3-Clause
"""Several ranks: the surfaces of labels and their interfaces exist once, on the first rank, and are
the serial ones bit for bit, whatever parts of the image the ranks have."""

import paraview.simple as pv
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkImagingCore import vtkRTAnalyticSource

import evolvingsurfaces as es
import ranks

HALF = 12                                         # of the image's side
FORMULA = "floor(RTData/80)"                      # 0 to 3, from outside in


def labels():
    """VTK's wavelet in levels: a source that makes every rank its part."""
    wavelet = pv.Wavelet(WholeExtent=3 * [-HALF, HALF])
    return pv.Calculator(Input=wavelet, Function=FORMULA, ResultArrayName="Label")


def whole_labels():
    """The same, computed by this rank alone."""
    source = vtkRTAnalyticSource()
    source.SetWholeExtent(-HALF, HALF, -HALF, HALF, -HALF, HALF)
    source.Update()
    image = source.GetOutput()
    values = vtk_to_numpy(image.GetPointData().GetScalars()).astype(float) // 80
    array = numpy_to_vtk(values, deep=True)
    array.SetName("Label")
    image.GetPointData().SetScalars(array)
    return image


def check_port_once(name, proxy, port, expected):
    surface = ranks.part(proxy, port)
    points = expected.GetNumberOfPoints()
    ranks.check(name + ": once", ranks.total(surface.GetNumberOfPoints()) == points > 0,
                f"{surface.GetNumberOfPoints()} of {points} points")
    ranks.check(name + ": on the first rank",
                (surface.GetNumberOfPoints() > 0) == (ranks.RANK == 0))
    if ranks.RANK == 0:
        same = (vtk_to_numpy(surface.GetPoints().GetData())
                == vtk_to_numpy(expected.GetPoints().GetData())).all()
    ranks.check(name + ": as in a serial run", ranks.RANK > 0 or same)
    ranks.check(name + ": the same arrays", ranks.array_names(surface.GetCellData())
                == ranks.array_names(expected.GetCellData()))


def main():
    ranks.load_plugin(globals())
    source = labels()
    own = ranks.part(source)
    whole = whole_labels()
    ranks.check("a part of the image", 0 < own.GetNumberOfPoints() < whole.GetNumberOfPoints(),
                str(own.GetExtent()))
    reference = es.vtkLabelSurfaces()
    reference.SetInputData(whole)
    reference.Update()
    surfaces = LabelSurfaces(Input=source, LabelArray=["POINTS", "Label"])
    for port, name in enumerate(("surfaces", "interfaces")):
        check_port_once(f"Label Surfaces, {name}", surfaces, port,
                        reference.GetOutputDataObject(port))
    print(f"rank {ranks.RANK}: all passed", flush=True)


main()
