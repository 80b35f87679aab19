"""The pipeline part by part: distance, start surface, evolution, redistribution.

    pipeline.py [MESH.ply [OUT.vtp]]
"""
import sys
from pathlib import Path

import evolvingsurfaces as es
from vtkmodules.vtkFiltersCore import vtkFlyingEdges3D
from vtkmodules.vtkIOPLY import vtkPLYReader
from vtkmodules.vtkIOXML import vtkXMLPolyDataWriter

sample = Path(__file__).resolve().parent.parent / "Data" / "bunny.ply"
reader = vtkPLYReader()
reader.SetFileName(sys.argv[1] if len(sys.argv) > 1 else str(sample))

distance = es.vtkMeshSDF()
distance.SetInputConnection(reader.GetOutputPort())
distance.SetSampleDimensions(64, 64, 64)
distance.Update()

start = vtkFlyingEdges3D()                       # an iso-surface one cell outside
start.SetInputConnection(distance.GetOutputPort())
start.SetValue(0, distance.GetOutput().GetSpacing()[0])

evolution = es.vtkSurfaceEvolution()
evolution.SetInputConnection(0, start.GetOutputPort())
evolution.SetInputConnection(1, distance.GetOutputPort())
evolution.SetNumberOfSteps(60)
evolution.SetTimeStep(0.1)
evolution.SetCurvatureSpeed(0.001)
evolution.SetAngleRedistribution(3.0)

even = es.vtkTangentialRedistribution()
even.SetInputConnection(evolution.GetOutputPort())
even.Update()

history = evolution.GetOutputDataObject(1)
last = history.GetNumberOfRows() - 1
for name in ("Time", "MeanDistance", "MaxDistance", "MinAngle"):
    print(name, history.GetValueByName(0, name), "->", history.GetValueByName(last, name))

writer = vtkXMLPolyDataWriter()
writer.SetFileName(sys.argv[2] if len(sys.argv) > 2 else "pipeline.vtp")
writer.SetDataModeToBinary()
writer.SetInputConnection(even.GetOutputPort())
sys.exit(0 if writer.Write() else 1)
