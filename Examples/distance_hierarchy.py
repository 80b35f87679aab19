"""Draws the AABB tree and the octree of a mesh: all boxes left, the leaves right.

    distance_hierarchy.py [MESH.ply [PICTURE.png]]
"""
import sys
from pathlib import Path

import evolvingsurfaces as es
import vtkmodules.vtkRenderingFreeType  # noqa: F401  (what vtkRenderingCore draws text with)
import vtkmodules.vtkRenderingOpenGL2  # noqa: F401  (and everything else)
from vtkmodules.vtkIOImage import vtkPNGWriter
from vtkmodules.vtkIOPLY import vtkPLYReader
from vtkmodules.vtkRenderingCore import (vtkActor, vtkPolyDataMapper, vtkRenderer, vtkRenderWindow,
                                         vtkTextActor, vtkWindowToImageFilter)

LEAVES, ALL = -1, -2                             # values of Level
SIZE = 1200

sample = Path(__file__).resolve().parent.parent / "Data" / "bunny.ply"
reader = vtkPLYReader()
reader.SetFileName(sys.argv[1] if len(sys.argv) > 1 else str(sample))


def boxes_of(structure, level):
    boxes = es.vtkDistanceHierarchy()
    boxes.SetInputConnection(reader.GetOutputPort())
    boxes.SetStructure(structure)
    boxes.SetLevel(level)
    boxes.SetSampleDimensions(30, 30, 30)        # of the octree: coarse enough to see its cells
    return boxes


def actor_of(algorithm, color, line_width=None):
    mapper = vtkPolyDataMapper()
    mapper.SetInputConnection(algorithm.GetOutputPort())
    mapper.ScalarVisibilityOff()
    actor = vtkActor()
    actor.SetMapper(mapper)
    look = actor.GetProperty()
    look.SetColor(color)
    if line_width:
        look.SetRepresentationToWireframe()
        look.SetLighting(False)
        look.SetLineWidth(line_width)
    return actor


def view_of(boxes, title, viewport):
    view = vtkRenderer()
    view.SetViewport(viewport)
    view.SetBackground(1.0, 1.0, 1.0)
    view.AddActor(actor_of(reader, (0.93, 0.87, 0.75)))
    view.AddActor(actor_of(boxes, (0.1, 0.25, 0.5), 1.0))
    boxes.Update()
    count = boxes.GetOutput().GetNumberOfPolys() // 6
    text = vtkTextActor()
    text.SetInput(f"{title}: {count} boxes")
    text.GetTextProperty().SetColor(0.0, 0.0, 0.0)
    text.GetTextProperty().SetFontSize(20)
    text.SetPosition(20, SIZE // 2 - 35)
    view.AddViewProp(text)
    camera = view.GetActiveCamera()
    camera.SetFocalPoint(0.0, 0.0, 0.0)
    camera.SetPosition(0.35, 0.3, 1.0)
    camera.ParallelProjectionOn()
    view.ResetCamera()
    camera.Zoom(1.1)
    print(f"{title}: {count} boxes")
    return view


window = vtkRenderWindow()
window.SetOffScreenRendering(True)
window.SetMultiSamples(8)
window.SetSize(SIZE, SIZE)
tree, octree = es.vtkDistanceHierarchy.AABB_TREE, es.vtkDistanceHierarchy.OCTREE
for row, (structure, name) in enumerate(((octree, "Octree"), (tree, "AABB tree"))):
    for column, (level, which) in enumerate(((ALL, "all levels"), (LEAVES, "leaves"))):
        x, y = 0.5 * column, 0.5 * row           # figure 5.2 above, figure 5.4 below
        window.AddRenderer(view_of(boxes_of(structure, level), f"{name}, {which}",
                                   (x, y, x + 0.5, y + 0.5)))

picture = vtkWindowToImageFilter()
picture.SetInput(window)
writer = vtkPNGWriter()
writer.SetFileName(sys.argv[2] if len(sys.argv) > 2 else "distance_hierarchy.png")
writer.SetInputConnection(picture.GetOutputPort())
writer.Write()
sys.exit(writer.GetErrorCode())
