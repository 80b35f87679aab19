// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * An input on its way to a filter, and what a judge may expect of an answer to it.
 */

#ifndef ROBUSTNESS_SUBJECT_H
#define ROBUSTNESS_SUBJECT_H

#include "Model.h"
#include "Surface.h"

#include "vtkSmartPointer.h"

namespace robustness
{

struct Subject
{
  explicit Subject(const Model& made);

  Model model; ///< its solid only where coordinates, as they are, bear it out
  vtkSmartPointer<vtkPolyData> data;
  Surface surface;   ///< the faces as they are
  Surface joined;    ///< welded; empty unless all faces are usable
  Topology topology; ///< of the joined surface
  ///@{
  /// Of the box of the faces, or of the points where there is none: half its diagonal, its middle.
  double radius = 1.0;
  Vec3 centre;
  ///@}

  bool hasFaces = false;
  /// Point numbers that are not there, or faces of fewer than three corners.
  bool isDamaged = false;
  /// Numbers that are none, in points that count.
  bool hasNaN = false;

  bool isUsable() const { return !this->isDamaged && !this->hasNaN; }
  bool isSolid() const { return !this->model.solid.empty(); }

private:
  void measure();
};

} // namespace robustness

#endif
