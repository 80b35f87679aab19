// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "JudgeChecks.h"

#include "BaseShapes.h"

#include "vtkCellArray.h"
#include "vtkDataArray.h"
#include "vtkDataObject.h"
#include "vtkFieldData.h"
#include "vtkNew.h"
#include "vtkPolyData.h"

namespace robustness
{

Fault faultOf(const std::function<void()>& judge)
{
  try
  {
    judge();
    return Fault::None;
  }
  catch (const WrongAnswer& answer)
  {
    return answer.fault();
  }
}

Subject ball()
{
  return Subject(icosphere(2, 1.0, Vec3::Zero()));
}

void setField(vtkDataObject* data, const char* name, double value)
{
  data->GetFieldData()->GetArray(name)->SetComponent(0, 0, value);
}

void setFace(vtkPolyData* data, vtkIdType face, const std::function<void(Cell&)>& change)
{
  Surface surface = surfaceOf(data);
  change(surface.faces[static_cast<std::size_t>(face)]);
  vtkNew<vtkCellArray> cells;
  for (const Cell& corners : surface.faces)
  {
    const std::vector<vtkIdType> ids(corners.begin(), corners.end());
    if (!ids.empty())
    {
      cells->InsertNextCell(static_cast<vtkIdType>(ids.size()), ids.data());
    }
  }
  data->SetPolys(cells);
}

} // namespace robustness
