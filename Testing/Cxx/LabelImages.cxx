// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "LabelImages.h"

#include "vtkCell.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkLabelSurfaces.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkShortArray.h"

#include <cmath>

namespace
{

constexpr double Spacing[3] = { 0.5, 0.5, 1.25 };
constexpr double Origin[3] = { -10.0, 20.0, 5.0 };

} // namespace

//------------------------------------------------------------------------------
Image LabelImage(vtkDataArray* array, const std::function<double(double, double, double)>& label)
{
  const auto image = Image::New();
  image->SetExtent(3, 34, -2, 29, 0, 13);
  image->SetSpacing(Spacing);
  image->SetOrigin(Origin);
  array->SetName("Segmentation");
  array->SetNumberOfTuples(image->GetNumberOfPoints());
  double center[3];
  image->GetCenter(center);
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    double p[3];
    image->GetPoint(i, p);
    array->SetComponent(
      i, 0, label(p[0] - center[0] - 0.1, p[1] - center[1] - 0.07, p[2] - center[2] - 0.03));
  }
  image->GetPointData()->SetScalars(array);
  return image;
}

//------------------------------------------------------------------------------
Image Halves()
{
  return LabelImage(vtkNew<vtkShortArray>(),
    [](double x, double y, double z) {
      return std::hypot(x, y, z) > 5.5 ? -1.0 : x + 0.5 * y + 0.2 * z < 0.4 ? 5.0 : 9.0;
    });
}

//------------------------------------------------------------------------------
Image Ball()
{
  return LabelImage(vtkNew<vtkShortArray>(),
    [](double x, double y, double z) { return std::hypot(x, y, z) > 5.5 ? 0.0 : 1.0; });
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkLabelSurfaces> FilterOf(vtkImageData* image, double background)
{
  auto filter = vtkSmartPointer<vtkLabelSurfaces>::New();
  filter->SetInputData(image);
  filter->SetBackgroundLabel(background);
  return filter;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> SurfaceOf(vtkLabelSurfaces* filter, double label)
{
  filter->Update();
  vtkPolyData* all = filter->GetOutput();
  const auto surface = vtkSmartPointer<vtkPolyData>::New();
  surface->SetPoints(all->GetPoints());
  vtkNew<vtkCellArray> triangles;
  for (vtkIdType cell = 0; cell < all->GetNumberOfCells(); ++cell)
  {
    if (all->GetCellData()->GetArray("Label")->GetComponent(cell, 0) == label)
    {
      triangles->InsertNextCell(all->GetCell(cell));
    }
  }
  surface->SetPolys(triangles);
  return surface;
}
