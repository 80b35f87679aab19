// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * A rendered picture and its comparison with a baseline.
 */

#ifndef Picture_h
#define Picture_h

#include "vtkNew.h"

#include <string>

class vtkActor;
class vtkDataSet;
class vtkPolyData;
class vtkRenderWindow;
class vtkRenderer;

/**
 * Renders surfaces off screen in one or several views side by side, writes the picture to the
 * tests' output folder and compares it with VTK's own comparison. That comparison forgives
 * moderate changes of geometry, so every test that uses it asserts a number as well.
 */
class Picture
{
public:
  explicit Picture(int width = 300, int height = 300, int views = 1);
  ~Picture();

  ///@{
  /// Adds a surface to a view: shaded, with its edges, as lines, or coloured about zero.
  vtkActor* AddSurface(vtkPolyData* surface, int view = 0);
  vtkActor* AddEdges(vtkPolyData* surface, int view = 0);
  vtkActor* AddLines(vtkPolyData* surface, int view = 0);
  vtkActor* AddColours(vtkDataSet* data, double limit, int view = 0);
  ///@}

  /// Looks at everything in a view from a direction.
  void LookFrom(double x, double y, double z, int view = 0);

  /// Is the picture the baseline of this name? Writes it, and a difference when it is not.
  bool Matches(const std::string& baseline, const std::string& picture);
  bool Matches(const std::string& baseline) { return this->Matches(baseline, baseline); }

private:
  vtkActor* Add(vtkPolyData* surface, int view);
  vtkRenderer* View(int view);

  vtkNew<vtkRenderWindow> Window;
};

#endif
