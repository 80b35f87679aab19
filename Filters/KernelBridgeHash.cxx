// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "KernelBridge.h"

#include "vtkCellArray.h"
#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkMatrix3x3.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <cstring>

namespace KernelBridge
{

namespace
{

/// FNV-1a over 64 bits at a time. A product never reaches the bits below, and the sign of a number
/// is its highest bit: folded down, it counts too, so that a mirrored surface is another one.
class Hash
{
public:
  std::uint64_t Value() const { return this->State; }

  void Add(double value)
  {
    std::uint64_t bits = 0;
    std::memcpy(&bits, &value, sizeof(bits));
    this->State = (this->State ^ bits) * 1099511628211ULL;
    this->State ^= this->State >> 32;
  }

  void Add(const double* values, int count)
  {
    for (int i = 0; i < count; ++i)
    {
      this->Add(values[i]);
    }
  }

  /// Shape and values. What is not there is what is empty: ranks without a part have either.
  void Add(vtkDataArray* array)
  {
    const vtkIdType tuples = array ? array->GetNumberOfTuples() : 0;
    const int components = tuples > 0 ? array->GetNumberOfComponents() : 0;
    this->Add(static_cast<double>(tuples));
    this->Add(components);
    for (vtkIdType i = 0; i < tuples; ++i)
    {
      for (int c = 0; c < components; ++c)
      {
        this->Add(array->GetComponent(i, c));
      }
    }
  }

private:
  std::uint64_t State = 14695981039346656037ULL;
};

//------------------------------------------------------------------------------
void AddImage(vtkImageData* image, Hash& hash)
{
  constexpr int Axes = 3;
  hash.Add(image->GetOrigin(), Axes);
  hash.Add(image->GetSpacing(), Axes);
  hash.Add(image->GetDirectionMatrix()->GetData(), Axes * Axes);
  for (int end = 0; end < 2 * Axes; ++end)
  {
    hash.Add(image->GetExtent()[end]);
  }
  hash.Add(image->GetPointData()->GetScalars());
}

//------------------------------------------------------------------------------
void AddSurface(vtkPolyData* surface, Hash& hash)
{
  if (surface->GetNumberOfPoints() > 0)
  {
    hash.Add(surface->GetPoints()->GetDataType()); // the output's points have it too
    hash.Add(surface->GetPoints()->GetData());
  }
  for (vtkCellArray* cells :
    { surface->GetVerts(), surface->GetLines(), surface->GetPolys(), surface->GetStrips() })
  {
    hash.Add(cells->GetOffsetsArray());
    hash.Add(cells->GetConnectivityArray());
  }
}

} // namespace

//------------------------------------------------------------------------------
std::uint64_t ContentHash(vtkDataSet* data)
{
  Hash hash;
  if (auto* image = vtkImageData::SafeDownCast(data))
  {
    AddImage(image, hash);
  }
  if (auto* surface = vtkPolyData::SafeDownCast(data))
  {
    AddSurface(surface, hash);
  }
  return hash.Value();
}

} // namespace KernelBridge
