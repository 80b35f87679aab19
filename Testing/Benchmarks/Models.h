// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * The surfaces that are measured: read from files, subdivided, or a sphere.
 */

#ifndef BENCHMARK_MODELS_H
#define BENCHMARK_MODELS_H

#include "Mesh/SurfaceMesh.h"

#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <string>

namespace benchmark
{

struct Model
{
  std::string name; ///< for a table's title
  vtkSmartPointer<vtkPolyData> surface;

  long long triangles() const { return static_cast<long long>(this->surface->GetNumberOfPolys()); }
};

/// A .obj, .ply, .stl, .vtk or .vtp file as its reader gives it. Leaves the program when it has
/// nothing.
Model readModel(const std::string& path);

/**
 * A file made as large as a scan: coincident points joined, polygons cut into triangles, and
 * subdivided by Loop's scheme.
 * @param subdivisions Arguments::Automatic: towards 80,000 triangles
 */
Model readScan(const std::string& path, int subdivisions);

/// An icosphere whose facets lie within 0.002 cells of the unit sphere on a grid of size^3.
Model unitSphere(int size);

/// The polygons for calls of the kernel; without strips.
evolving::SurfaceMesh kernelMesh(vtkPolyData* surface);

} // namespace benchmark

#endif
