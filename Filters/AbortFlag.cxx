// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "AbortFlag.h"

#include "vtkAlgorithm.h"
#include "vtkDemandDrivenPipeline.h"
#include "vtkExecutive.h"
#include "vtkInformation.h"
#include "vtkInformationIntegerKey.h"
#include "vtkVersionMacros.h"

namespace AbortFlag
{

namespace
{

constexpr bool VTKKeepsIt = VTK_VERSION_NUMBER >= 90220230111ULL;

//------------------------------------------------------------------------------
/// In the information of a filter: the flag as it was before VTK took it back.
vtkInformationIntegerKey* Kept()
{
  static vtkInformationIntegerKey* key =
    vtkInformationIntegerKey::MakeKey("KEPT_ABORT", "EvolvingSurfaces");
  return key;
}

} // namespace

//------------------------------------------------------------------------------
void Keep(vtkAlgorithm* filter, vtkInformation* request, int when)
{
  if (!VTKKeepsIt && when == vtkExecutive::AfterForward &&
    request->Has(vtkDemandDrivenPipeline::REQUEST_DATA()))
  {
    filter->GetInformation()->Set(Kept(), filter->GetAbortExecute());
  }
}

//------------------------------------------------------------------------------
void Restore(vtkAlgorithm* filter)
{
  if (filter->GetInformation()->Get(Kept()))
  {
    filter->GetInformation()->Remove(Kept());
    filter->SetAbortExecute(1);
  }
}

//------------------------------------------------------------------------------
bool IsSet(vtkAlgorithm* filter)
{
#if VTK_VERSION_NUMBER >= 90220230111ULL
  return filter->CheckAbort();
#else
  return filter->GetAbortExecute() != 0;
#endif
}

} // namespace AbortFlag
