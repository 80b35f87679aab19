// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "KernelBridge.h"

#include "vtkCellArray.h"
#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <cstring>

namespace KernelBridge
{

namespace
{

//------------------------------------------------------------------------------
/// FNV-1a over 64 bits at a time. A product never reaches the bits below, and the sign of a number
/// is its highest bit: folded down, it counts too, so that a mirrored surface is another one.
void HashArray(vtkDataArray* array, std::uint64_t& hash)
{
  if (!array)
  {
    return;
  }
  for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
  {
    for (int c = 0; c < array->GetNumberOfComponents(); ++c)
    {
      std::uint64_t bits = 0;
      const double value = array->GetComponent(i, c);
      std::memcpy(&bits, &value, sizeof(bits));
      hash = (hash ^ bits) * 1099511628211ULL;
      hash ^= hash >> 32;
    }
  }
}

//------------------------------------------------------------------------------
void HashImage(vtkImageData* image, std::uint64_t& hash)
{
  vtkNew<vtkDoubleArray> layout;
  for (int axis = 0; axis < 3; ++axis)
  {
    layout->InsertNextValue(image->GetOrigin()[axis]);
    layout->InsertNextValue(image->GetSpacing()[axis]);
    layout->InsertNextValue(image->GetExtent()[2 * axis]);
    layout->InsertNextValue(image->GetExtent()[2 * axis + 1]);
  }
  HashArray(layout, hash);
  HashArray(image->GetPointData()->GetScalars(), hash);
}

//------------------------------------------------------------------------------
void HashSurface(vtkPolyData* surface, std::uint64_t& hash)
{
  HashArray(surface->GetPoints() ? surface->GetPoints()->GetData() : nullptr, hash);
  for (vtkCellArray* cells :
    { surface->GetVerts(), surface->GetLines(), surface->GetPolys(), surface->GetStrips() })
  {
    HashArray(cells->GetOffsetsArray(), hash);
    HashArray(cells->GetConnectivityArray(), hash);
  }
}

} // namespace

//------------------------------------------------------------------------------
std::uint64_t ContentHash(vtkDataSet* data)
{
  std::uint64_t hash = 14695981039346656037ULL;
  if (auto* image = vtkImageData::SafeDownCast(data))
  {
    HashImage(image, hash);
  }
  if (auto* surface = vtkPolyData::SafeDownCast(data))
  {
    HashSurface(surface, hash);
  }
  return hash;
}

} // namespace KernelBridge
