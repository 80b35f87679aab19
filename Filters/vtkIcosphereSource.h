// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @class vtkIcosphereSource
 * @brief regular closed start surfaces: icosphere, cube-sphere, subdivided box
 *
 * vtkIcosphereSource makes the closed surfaces that an evolution starts from or is measured on.
 *
 * - Icosphere: the icosahedron, each triangle split into four `Level` times, the points moved onto
 *   the sphere: 12, 42, 162, 642, 2562, ... points (figure 1.1 of the thesis).
 * - CubeSphere: six sides of `Resolution` x `Resolution` quads on the sphere, with equal angles
 *   between the grid lines.
 * - Box: the cube of half side `Radius`, `Resolution` x `Resolution` quads a side.
 *
 * All are closed, 2-manifold and oriented outwards.
 *
 * @sa vtkSurfaceEvolution
 */

#ifndef vtkIcosphereSource_h
#define vtkIcosphereSource_h

#include "vtkEvolvingSurfacesFiltersModule.h" // For export macro
#include "vtkPolyDataAlgorithm.h"

class VTKEVOLVINGSURFACESFILTERS_EXPORT vtkIcosphereSource : public vtkPolyDataAlgorithm
{
public:
  static vtkIcosphereSource* New();
  vtkTypeMacro(vtkIcosphereSource, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum
  {
    ICOSPHERE = 0,
    CUBE_SPHERE = 1,
    BOX = 2
  };

  ///@{
  /**
   * Which surface to make. The default is ICOSPHERE.
   */
  vtkSetClampMacro(Shape, int, ICOSPHERE, BOX);
  vtkGetMacro(Shape, int);
  void SetShapeToIcosphere() { this->SetShape(ICOSPHERE); }
  void SetShapeToCubeSphere() { this->SetShape(CUBE_SPHERE); }
  void SetShapeToBox() { this->SetShape(BOX); }
  ///@}

  ///@{
  /**
   * How often the icosahedron's triangles are split into four; 10 * 4^Level + 2 points. The default
   * is 3 (642 points), the range 0 to 9.
   */
  vtkSetClampMacro(Level, int, 0, 9);
  vtkGetMacro(Level, int);
  ///@}

  ///@{
  /**
   * Quads along each edge of the cube-sphere and the box; 6 * Resolution^2 + 2 points. The default
   * is 10, the range 1 to 1000.
   */
  vtkSetClampMacro(Resolution, int, 1, 1000);
  vtkGetMacro(Resolution, int);
  ///@}

  ///@{
  /**
   * Radius of the sphere, half the side of the box, in length units. The default is 1, the range
   * above 0. Points that overflow or fall together in the output's precision are an error.
   */
  vtkSetClampMacro(Radius, double, VTK_DBL_MIN, VTK_DOUBLE_MAX);
  vtkGetMacro(Radius, double);
  ///@}

  ///@{
  /**
   * Centre of the surface. The default is the origin.
   */
  vtkSetVector3Macro(Center, double);
  vtkGetVector3Macro(Center, double);
  ///@}

  ///@{
  /**
   * Type of the output points: vtkAlgorithm::SINGLE_PRECISION (the default) or DOUBLE_PRECISION.
   */
  vtkSetClampMacro(OutputPointsPrecision, int, SINGLE_PRECISION, DOUBLE_PRECISION);
  vtkGetMacro(OutputPointsPrecision, int);
  ///@}

protected:
  vtkIcosphereSource();
  ~vtkIcosphereSource() override = default;

  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkIcosphereSource(const vtkIcosphereSource&) = delete;
  void operator=(const vtkIcosphereSource&) = delete;

  int Shape = ICOSPHERE;
  int Level = 3;
  int Resolution = 10;
  double Radius = 1.0;
  double Center[3] = { 0.0, 0.0, 0.0 };
  int OutputPointsPrecision = SINGLE_PRECISION;
};

#endif
