// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ContentStamp.h"

#include "KernelBridge.h"

#include "vtkDataSet.h"

//------------------------------------------------------------------------------
bool ContentStamp::Update(vtkDataSet* data)
{
  const vtkMTimeType time = data ? data->GetMTime() : 0;
  if (data == this->Last && time == this->Time)
  {
    return false;
  }
  const std::uint64_t hash = data ? KernelBridge::ContentHash(data) : 0;
  const bool changed = hash != this->Hash || (data == nullptr) != (this->Last == nullptr);
  this->Last = data;
  this->Time = time;
  this->Hash = hash;
  return changed;
}
