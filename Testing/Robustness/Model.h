// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * An input as the generator makes it: cells of any kind, however wrong, and what is known of them.
 */

#ifndef ROBUSTNESS_MODEL_H
#define ROBUSTNESS_MODEL_H

#include "Random.h"

#include "vtkSmartPointer.h"

#include <array>
#include <cstdint>
#include <string>
#include <vector>

class vtkPolyData;

namespace robustness
{

/// The point numbers of a cell; nothing says that they are any good.
using Cell = std::vector<std::int64_t>;
using Triangle = std::array<std::int64_t, 3>;

struct Model
{
  std::vector<Vec3> points;
  std::vector<Cell> vertices;
  std::vector<Cell> lines;
  std::vector<Cell> polygons;
  std::vector<Cell> strips;
  bool isDouble = true;

  /// What it was made of, step by step.
  std::vector<std::string> story;

  /**
   * The closed surface that the model bounds a solid with, where that is known: oriented outwards,
   * manifold, free of intersections. Empty where nothing is known.
   */
  std::vector<Triangle> solid;
  /// The polygons are the solid's: nothing has been added, flipped or split.
  bool isClean = false;
  /// Some faces are there more than once; when one of them is split, the solid is no longer known.
  bool hasDuplicates = false;
  /// Triangles have been split into thin ones, which rounding may turn over.
  bool hasSplits = false;

  std::int64_t addPoint(const Vec3& point);
  void addPolygon(const Cell& corners) { this->polygons.push_back(corners); }
  void forgetSolid();
  /// Do all polygons have three corners or more, all of them points that are there?
  bool hasUsableFaces() const;
  std::string describe() const;
};

/// Half the diagonal of the box of all finite points; 1 when there is no extent.
double radiusOf(const Model& model);
/// The middle of that box.
Vec3 centreOf(const Model& model);

/// Appends the cells of another model.
void append(const Model& other, Model& model);

/// Polygons become the solid: they must be planar, and bound it already.
void claimSolid(Model& model);

vtkSmartPointer<vtkPolyData> toPolyData(const Model& model);

/// A number of everything that reaches a filter: equal seeds must make equal inputs.
std::uint64_t hashOf(const Model& model);

} // namespace robustness

#endif
