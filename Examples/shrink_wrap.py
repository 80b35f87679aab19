"""Any mesh in, one clean closed surface out."""
from pathlib import Path
import evolvingsurfaces as es
from vtkmodules.vtkIOPLY import vtkPLYReader
from vtkmodules.vtkIOXML import vtkXMLPolyDataWriter

reader = vtkPLYReader()
reader.SetFileName(str(Path(__file__).parents[1] / "Data" / "bunny.ply"))
wrap = es.vtkShrinkWrap()                      # polygons in any state, or points alone
wrap.SetInputConnection(reader.GetOutputPort())
writer = vtkXMLPolyDataWriter()
writer.SetInputConnection(wrap.GetOutputPort())
writer.SetFileName("wrapped.vtp")
writer.SetDataModeToBinary()
writer.Write()
