// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * The surfaces that the filters are tested on, with known distances and volumes.
 */

#ifndef SampleSurfaces_h
#define SampleSurfaces_h

#include "vtkSmartPointer.h"
#include "vtkType.h"

#include <array>
#include <string>
#include <vector>

class vtkAlgorithm;
class vtkImageData;
class vtkPolyData;

namespace Sample
{

using Surface = vtkSmartPointer<vtkPolyData>;
using Point = std::array<double, 3>;
using Polygon = std::vector<vtkIdType>;

/// A polydata of points and polygons.
Surface Make(
  const std::vector<Point>& points, const std::vector<Polygon>& polygons, int type = VTK_DOUBLE);

/// 10 * 4^level + 2 points on a sphere, with double coordinates.
Surface Icosphere(int level, double radius = 1.0, const Point& center = { 0.0, 0.0, 0.0 });

/// Quads on a sphere, resolution x resolution a side of the cube.
Surface CubeSphere(int resolution, double radius = 1.0);

/// The cube [-1, 1]^3 of resolution x resolution quads a side.
Surface Box(int resolution);

/// The square [-1, 1]^2 at z = 0: one open sheet of triangles, n x n quads cut in two.
Surface Sheet(int n);

/// A band of n quads with half a twist: one side, one boundary, no orientation.
Surface Moebius(int n);

/// An octahedron of eight points on the axes, at a distance from the origin.
Surface Octahedron(double radius = 1.0);

/// A file of the folder Data: .ply, .vtk or .obj.
Surface Read(const std::string& name);

/// An image of n^3 samples of the distance to a sphere about the origin, over [-size, size]^3.
vtkSmartPointer<vtkImageData> SphereImage(int n, double size, double radius);

/// The corners of polygon number i.
Polygon PolygonOf(vtkPolyData* surface, vtkIdType number);

std::vector<Polygon> PolygonsOf(vtkPolyData* surface);
std::vector<Point> CoordinatesOf(vtkPolyData* surface);

} // namespace Sample

#endif
