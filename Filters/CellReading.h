// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * Points and cells of a polydata as the kernel's, before anything but their numbers is looked at.
 */

#ifndef CellReading_h
#define CellReading_h

#include "KernelBridge.h"

namespace KernelBridge
{

/// The polygons and strips, these as triangles, with whatever may be wrong with them.
/// @throws evolving::InputError for corners out of range, and for more points than are supported
Surface ReadAnySurface(vtkPolyData* input);

/// The points of vertex cells, or all points when there is none, whatever their coordinates.
/// @throws evolving::InputError as ReadAnySurface()
Surface ReadAnyPointSet(vtkPolyData* input);

} // namespace KernelBridge

#endif
