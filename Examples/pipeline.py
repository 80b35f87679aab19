"""From a contour to even elements: distance, contour, evolution, redistribution.

    pipeline.py [MESH.ply [OUT.vtp]]

The contour of an image, here one cell outside of a mesh, is good to look at, but no mesh to compute
on: where it passes close to a sample its triangles are needles. Evolution takes it onto the zero of
the distance with new elements, redistribution moves points along the surface until those are even.
Writes the result and a picture of both beside it.
"""
import sys
from pathlib import Path

import evolvingsurfaces as es
from vtkmodules.vtkFiltersCore import vtkFlyingEdges3D
from vtkmodules.vtkFiltersVerdict import vtkMeshQuality
from vtkmodules.vtkIOPLY import vtkPLYReader
from vtkmodules.vtkIOXML import vtkXMLPolyDataWriter

sample = Path(__file__).resolve().parent.parent / "Data" / "bunny.ply"
reader = vtkPLYReader()
reader.SetFileName(sys.argv[1] if len(sys.argv) > 1 else str(sample))

distance = es.vtkMeshSDF()
distance.SetInputConnection(reader.GetOutputPort())
distance.SetSampleDimensions(64, 64, 64)
distance.Update()
cell = distance.GetOutput().GetSpacing()[0]

contour = vtkFlyingEdges3D()
contour.SetInputConnection(distance.GetOutputPort())
contour.SetValue(0, cell)                        # outside, by a cell

evolution = es.vtkSurfaceEvolution()
evolution.SetInputConnection(0, contour.GetOutputPort())
evolution.SetInputConnection(1, distance.GetOutputPort())

even = es.vtkTangentialRedistribution()
even.SetInputConnection(evolution.GetOutputPort())

out = Path(sys.argv[2] if len(sys.argv) > 2 else "pipeline.vtp")
writer = vtkXMLPolyDataWriter()
writer.SetFileName(str(out))
writer.SetDataModeToBinary()
writer.SetInputConnection(even.GetOutputPort())
if not writer.Write():
    sys.exit(f"cannot write {out}")

# What it is worth, in numbers and in a picture.
sys.path.insert(0, str(Path(__file__).resolve().parent / "thesis"))

from drawing import surface  # noqa: E402
from figures import array, check  # noqa: E402
from pictures import Panel, save  # noqa: E402


def smallest_angle(source):
    """Of all triangles, in degrees."""
    quality = vtkMeshQuality()
    quality.SetInputConnection(source.GetOutputPort())
    quality.SetTriangleQualityMeasureToMinAngle()
    quality.Update()
    return quality.GetOutput().GetCellData().GetArray("Quality").GetRange()[0]


stages = (("contour", contour), ("evolution", evolution), ("redistribution", even))
angles = [smallest_angle(source) for _, source in stages]
save([Panel([surface(source)], f"{name}\nsmallest angle {angle:.2g}\u00b0", zoom=2.8, direction=(0.25, 0.2, 1.0))
      for (name, source), angle in zip(stages, angles)], out.with_suffix(".png"))
off = abs(array(evolution.GetOutput(), "SignedDistance")).mean() / cell
check("mean distance from the mesh, in cells", off, 0.0, 0.1)
check("smallest angle, in degrees", angles[-1], 35.0, 60.0)
