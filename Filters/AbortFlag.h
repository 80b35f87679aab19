// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * The abort flag of a filter, the same with all versions of VTK. Private to the module.
 *
 * An abort that is asked for before an update holds in it, and until SetAbortExecute(0). VTK 9.1
 * takes the flag back as a filter starts to execute; so it is kept beside the filter until then.
 */

#ifndef AbortFlag_h
#define AbortFlag_h

class vtkAlgorithm;
class vtkInformation;

namespace AbortFlag
{

/// To be called from the filter's ModifyRequest(), the last of the filter before VTK takes it back.
void Keep(vtkAlgorithm* filter, vtkInformation* request, int when);

/// To be called from RequestData(): sets the flag again if it was set.
void Restore(vtkAlgorithm* filter);

/// True when the filter, or what VTK knows to be aborted before it, is to stop.
bool IsSet(vtkAlgorithm* filter);

} // namespace AbortFlag

#endif
