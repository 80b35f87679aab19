// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * Targets with known creases, and surfaces on them that know nothing of the creases yet.
 */

#ifndef EVOLVING_CAPTURE_SHAPES_H
#define EVOLVING_CAPTURE_SHAPES_H

#include "Distance/DistanceShapes.h"
#include "FeatureCapture/FeatureCapture.h"
#include "Features/FeatureShapes.h"
#include "Features/TargetFeatures.h"
#include "Remeshing/EditableSurface.h"
#include "Remeshing/ReferenceSurface.h"
#include "Remeshing/Relaxation.h"
#include "Remeshing/Remeshing.h"
#include "Remeshing/SizingField.h"

#include <array>
#include <ostream>
#include <string>
#include <vector>

namespace evolving::capture
{

/// What is sharp on a shape is known without any search.
struct Shape
{
  std::string name;
  SurfaceMesh target;
  double angle = 45.0; ///< of the creases
  double size = 0.15;  ///< of the elements
  std::size_t curves = 0;
  std::size_t corners = 0;
  double length = 0.0; ///< of all creases
  /// Where creases end inside a patch: they may end an element early, without a pin.
  int looseEnds = 0;
};

/// For messages of failing tests.
inline void PrintTo(const Shape& shape, std::ostream* stream)
{
  *stream << shape.name;
}

inline SurfaceMesh wedge()
{
  return test::extruded({ Vec3(0, 0, 0), Vec3(1.5, 0, 0), Vec3(0.75, 1.1, 0) }, 1.2);
}

inline SurfaceMesh ell()
{
  return test::extruded(
    { Vec3(0, 0, 0), Vec3(2, 0, 0), Vec3(2, 1, 0), Vec3(1, 1, 0), Vec3(1, 2, 0), Vec3(0, 2, 0) },
    1.0);
}

inline SurfaceMesh cylinder()
{
  return test::extruded(test::regularPolygon(48), 1.5);
}

/// Radius and height 1: no crease leads to the apex.
inline SurfaceMesh cone()
{
  constexpr Index Sides = 48;
  SurfaceMesh mesh;
  mesh.points = test::regularPolygon(Sides);
  const Index foot = mesh.addPoint(Vec3::Zero());
  const Index apex = mesh.addPoint(Vec3::UnitZ());
  for (Index i = 0; i < Sides; ++i)
  {
    const Index j = (i + 1) % Sides;
    mesh.addFace({ j, i, foot });
    mesh.addFace({ i, j, apex });
  }
  return mesh;
}

/**
 * A box whose top falls off to both sides of a ridge that ends in its middle: from there a fold of
 * 77 degrees runs to the middle of one side, all others on the top are below 30.
 */
inline SurfaceMesh boxWithDart()
{
  SurfaceMesh mesh;
  mesh.points = { Vec3(-1, -1, -1.8), Vec3(1, -1, -1.8), Vec3(1, 1, -1.8), Vec3(-1, 1, -1.8),
    Vec3(-1, -1, -0.8), Vec3(1, -1, 0), Vec3(1, 1, 0), Vec3(-1, 1, -0.8), Vec3(-1, 0, 0),
    Vec3(0, 0, 0) };
  const std::vector<std::array<Index, 3>> faces = { { 0, 2, 1 }, { 0, 3, 2 }, { 0, 1, 5 },
    { 0, 5, 4 }, { 1, 2, 6 }, { 1, 6, 5 }, { 2, 3, 7 }, { 2, 7, 6 }, { 0, 4, 8 }, { 0, 8, 3 },
    { 3, 8, 7 }, { 9, 8, 4 }, { 9, 4, 5 }, { 9, 5, 6 }, { 9, 6, 7 }, { 9, 7, 8 } };
  for (const auto& [a, b, c] : faces)
  {
    mesh.addFace({ a, b, c });
  }
  return mesh;
}

/// A cube with an edge cut off that leaves less room than an element needs.
inline SurfaceMesh chamferedCube(double width)
{
  return test::extruded(
    { Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(1, 1 - width, 0), Vec3(1 - width, 1, 0), Vec3(0, 1, 0) },
    1.0);
}

/// Of a regular polygon around the unit circle.
inline double rimLength(int sides)
{
  return 2.0 * sides * std::sin(std::acos(-1.0) / sides);
}

inline std::vector<Shape> shapes()
{
  const double slope = std::sqrt(0.75 * 0.75 + 1.1 * 1.1);
  return {
    { "Box", test::box(Vec3(0, 0, 0), Vec3(1, 2, 3)), 45.0, 0.2, 12, 8, 24.0 },
    { "Wedge", wedge(), 45.0, 0.12, 9, 6, 2.0 * (1.5 + 2.0 * slope) + 3.6 },
    { "Cylinder", cylinder(), 45.0, 0.15, 2, 0, 2.0 * rimLength(48) },
    { "Ell", ell(), 45.0, 0.15, 18, 12, 22.0 },
    { "Cone", cone(), 45.0, 0.15, 1, 0, rimLength(48) },
    { "Dart", boxWithDart(), 45.0, 0.15, 14, 10,
      16.6 + 2.0 * std::sqrt(4.64) + 2.0 * std::sqrt(1.64), 1 },
  };
}

/// All creases that elements of that size can carry.
inline TargetFeatures featuresOf(const Shape& shape)
{
  FeatureOptions options;
  options.angle = shape.angle;
  options.edgeLength = shape.size;
  return findFeatures(shape.target, options);
}

/// Good elements on the target, that cut across the creases.
inline EditableSurface landed(const SurfaceMesh& target, double size)
{
  EditableSurface surface(target);
  setUniformSizes(surface, size);
  const OffsetReference reference(target, 0.0);
  constexpr int Passes = 4;
  for (int pass = 0; pass < Passes; ++pass)
  {
    remeshOnce(surface, reference, {});
  }
  land(surface, reference);
  surface.compact();
  return surface;
}

inline EditableSurface captured(const Shape& shape, const TargetFeatures& features)
{
  EditableSurface surface = landed(shape.target, shape.size);
  captureFeatures(surface, features);
  return surface;
}

inline std::vector<Index> facesOf(const EditableSurface& surface)
{
  std::vector<Index> faces;
  for (Index f = 0; f < surface.faceSlots(); ++f)
  {
    if (surface.hasFace(f))
    {
      faces.push_back(f);
    }
  }
  return faces;
}

} // namespace evolving::capture

#endif
