// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * Surfaces as files deliver them, made from clean ones.
 */

#ifndef ChangedSurfaces_h
#define ChangedSurfaces_h

#include "SampleSurfaces.h"

namespace Sample
{

/// Every polygon with points of its own, as STL files have them.
Surface Soup(vtkPolyData* surface);

/// Every polygon cut into triangles that share its first corner.
Surface Triangulated(vtkPolyData* surface);

/// The points alone.
Surface PointsOf(vtkPolyData* surface);

/// Both, one after the other.
Surface Together(vtkPolyData* a, vtkPolyData* b);

/// The polygons that the numbers of `kept` allow, with all the points.
Surface KeepPolygons(vtkPolyData* surface, bool (*kept)(vtkIdType number));

/// Every point through a map.
Surface Mapped(vtkPolyData* surface, Point (*map)(const Point& point));

/// Every polygon the other way round.
Surface InsideOut(vtkPolyData* surface);

/// Polygons whose number is even run the other way.
Surface WithMixedOrientation(vtkPolyData* surface);

/// A map of the unit sphere that draws points towards the north pole: elements of all sizes.
Point TowardsThePole(const Point& p);

/// A map of the cube [-1, 1]^3 that draws points towards a corner, along its sides.
Point TowardsACorner(const Point& p);

} // namespace Sample

#endif
