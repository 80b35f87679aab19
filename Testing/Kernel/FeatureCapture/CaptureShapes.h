// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * Targets with known creases, and surfaces on them that know nothing of the creases yet.
 */

#ifndef EVOLVING_CAPTURE_SHAPES_H
#define EVOLVING_CAPTURE_SHAPES_H

#include "FeatureCapture/FeatureCapture.h"
#include "Features/TargetFeatures.h"
#include "Mesh/Angles.h"
#include "Remeshing/EditableSurface.h"
#include "Remeshing/ReferenceSurface.h"
#include "Remeshing/Relaxation.h"
#include "Remeshing/Remeshing.h"
#include "Remeshing/SizingField.h"
#include "Shapes/CreasedShapes.h"
#include "Shapes/Polyhedra.h"

#include <cmath>
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

/// Of a regular polygon around the unit circle.
inline double rimLength(int sides)
{
  return 2.0 * sides * std::sin(Pi / sides);
}

inline std::vector<Shape> creasedShapes()
{
  const double slope = std::sqrt(0.75 * 0.75 + 1.1 * 1.1);
  return {
    { "Box", shapes::box(Vec3(0, 0, 0), Vec3(1, 2, 3)), 45.0, 0.2, 12, 8, 24.0 },
    { "Wedge", shapes::wedge(), 45.0, 0.12, 9, 6, 2.0 * (1.5 + 2.0 * slope) + 3.6 },
    { "Cylinder", shapes::cylinder(), 45.0, 0.15, 2, 0, 2.0 * rimLength(48) },
    { "Ell", shapes::ell(), 45.0, 0.15, 18, 12, 22.0 },
    { "Cone", shapes::cone(), 45.0, 0.15, 1, 0, rimLength(48) },
    { "Dart", shapes::boxWithDart(), 45.0, 0.15, 14, 10,
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

} // namespace evolving::capture

#endif
