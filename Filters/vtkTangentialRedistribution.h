// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @class vtkTangentialRedistribution
 * @brief moves points along a surface until its elements are even
 *
 * vtkTangentialRedistribution moves the points of a surface by the tangential velocities of
 * section 3.3 of the thesis alone: by volume (co-volumes become equal, or follow the curvature), by
 * angle and by length. Cells, point ids and all input data stay; with PreserveShape points end on
 * the input surface. Sharp edges and corners are kept.
 *
 * The input is an oriented 2-manifold of triangles, quads or polygons, closed or with boundary;
 * points with equal coordinates count as one and stay together. The output has these point arrays
 * in addition: Normals, MeanCurvature, CoVolume, TangentialVelocity, RedistributionPotential, as
 * they are at the end. Arrays of these names that an earlier filter of this module made are
 * replaced; anyone else's stay, under their name with "_input" at its end. Normals and tangents of
 * the input are not those of points that have moved, and are left out; where there were active
 * point normals, the array Normals is active.
 *
 * Points are of the input's type, float or double. Where floats are so far apart that elements
 * would lose their shapes (angles by a degree on the average) or turn over, the points are double,
 * and a warning says so.
 *
 * M. Cavarga, "Optimal Discretization of 3D Objects by Evolving Surfaces", 2020, section 3.3.
 *
 * @sa vtkSurfaceEvolution
 */

#ifndef vtkTangentialRedistribution_h
#define vtkTangentialRedistribution_h

#include "vtkEvolvingSurfacesFiltersModule.h" // For export macro
#include "vtkPolyDataAlgorithm.h"

#include <memory> // For std::unique_ptr

class DistributedInput;

namespace evolving
{
struct SurfaceRedistributionOptions;
}

class VTKEVOLVINGSURFACESFILTERS_EXPORT vtkTangentialRedistribution : public vtkPolyDataAlgorithm
{
public:
  static vtkTangentialRedistribution* New();
  vtkTypeMacro(vtkTangentialRedistribution, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// Values of AngleMethod.
  enum
  {
    WEIGHTED_EDGES = 0,
    SHAPE = 1
  };

  /// Values of AngleWeighting.
  enum
  {
    WEIGHTING_NONE = 0,
    INVERSE_AREA = 1
  };

  /// Values of CurvatureControl.
  enum
  {
    CONTROL_NONE = 0,
    CUBE_ROOT = 1,
    TWO_THIRDS = 2,
    EXPONENTIAL = 3
  };

  /// Values of BoundaryMode.
  enum
  {
    FIXED = 0,
    SLIDE_ALONG = 1,
    FREE = 2
  };

  ///@{
  /**
   * Number of steps. The default is 50, the range 0 to 100000.
   */
  vtkSetClampMacro(NumberOfSteps, int, 0, 100000);
  vtkGetMacro(NumberOfSteps, int);
  ///@}

  ///@{
  /**
   * Length of a step; with the rates below a product of at most 1 (volume) or 0.3 (angle) is taken
   * at once, larger ones in parts. The default is 0.1, the range above 0.
   */
  vtkSetClampMacro(TimeStep, double, 1e-12, 1e12);
  vtkGetMacro(TimeStep, double);
  ///@}

  ///@{
  /**
   * omega of the volume-based redistribution (3.19), per time; 0, the default, switches it off.
   * Equal areas cost angles where points have more or fewer neighbours than six.
   */
  vtkSetClampMacro(VolumeRedistribution, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(VolumeRedistribution, double);
  ///@}

  ///@{
  /**
   * omega of the angle-based redistribution, per time; 0 switches it off. The default is 8.
   */
  vtkSetClampMacro(AngleRedistribution, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(AngleRedistribution, double);
  ///@}

  ///@{
  /**
   * omega of the length-based redistribution (3.23) along boundary curves and regular mesh lines,
   * per time; 0 switches it off. The default is 0.
   */
  vtkSetClampMacro(LengthRedistribution, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(LengthRedistribution, double);
  ///@}

  ///@{
  /**
   * What the angle-based redistribution does: WEIGHTED_EDGES, the velocity (3.24) of the
   * thesis, taken at once up to a product of 0.3 of rate and time step; or SHAPE (the default):
   * each point goes at the given rate to the place between its neighbours where the elements around
   * it have the best shapes (the sum of their squared inverse mean ratios is least), at once up to
   * 0.8. SHAPE improves the worst elements most and keeps differences in size.
   */
  vtkSetClampMacro(AngleMethod, int, WEIGHTED_EDGES, SHAPE);
  vtkGetMacro(AngleMethod, int);
  void SetAngleMethodToWeightedEdges() { this->SetAngleMethod(WEIGHTED_EDGES); }
  void SetAngleMethodToShape() { this->SetAngleMethod(SHAPE); }
  ///@}

  ///@{
  /**
   * Weight of the angle-based velocity: none (the default) or the inverse co-volume (section 6.2).
   */
  vtkSetClampMacro(AngleWeighting, int, WEIGHTING_NONE, INVERSE_AREA);
  vtkGetMacro(AngleWeighting, int);
  void SetAngleWeightingToNone() { this->SetAngleWeighting(WEIGHTING_NONE); }
  void SetAngleWeightingToInverseArea() { this->SetAngleWeighting(INVERSE_AREA); }
  ///@}

  ///@{
  /**
   * What co-volumes become proportional to: 1 / f(H), with f = 1 (the default), |H|^(1/3),
   * |H|^(2/3) or exp(alpha |H|) (3.21).
   */
  vtkSetClampMacro(CurvatureControl, int, CONTROL_NONE, EXPONENTIAL);
  vtkGetMacro(CurvatureControl, int);
  void SetCurvatureControlToNone() { this->SetCurvatureControl(CONTROL_NONE); }
  void SetCurvatureControlToCubeRoot() { this->SetCurvatureControl(CUBE_ROOT); }
  void SetCurvatureControlToTwoThirds() { this->SetCurvatureControl(TWO_THIRDS); }
  void SetCurvatureControlToExponential() { this->SetCurvatureControl(EXPONENTIAL); }
  ///@}

  ///@{
  /**
   * alpha of EXPONENTIAL curvature control, in units of half the diagonal of the input's box. The
   * default is 0.1, the range 0 and above.
   */
  vtkSetClampMacro(CurvatureControlAlpha, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(CurvatureControlAlpha, double);
  ///@}

  ///@{
  /**
   * Keep the shape: after every step points are taken back to the closest point of the input
   * surface. On by default.
   */
  vtkSetMacro(PreserveShape, bool);
  vtkGetMacro(PreserveShape, bool);
  vtkBooleanMacro(PreserveShape, bool);
  ///@}

  ///@{
  /**
   * What boundary points do: stay (FIXED), SLIDE_ALONG the boundary curve (the default), or move
   * as inner points (FREE).
   */
  vtkSetClampMacro(BoundaryMode, int, FIXED, FREE);
  vtkGetMacro(BoundaryMode, int);
  void SetBoundaryModeToFixed() { this->SetBoundaryMode(FIXED); }
  void SetBoundaryModeToSlideAlong() { this->SetBoundaryMode(SLIDE_ALONG); }
  void SetBoundaryModeToFree() { this->SetBoundaryMode(FREE); }
  ///@}

  ///@{
  /**
   * Edges whose faces' normals differ by more than this angle, in degrees, are sharp: points on
   * them stay on them, points where they end or meet stay. Fewer than twelve connected ones in a
   * fine mesh do not count: those are the rough places of a scan. The default is 45, the range 0 to
   * 180 (180: nothing is sharp).
   */
  vtkSetClampMacro(FeatureAngle, double, 0.0, 180.0);
  vtkGetMacro(FeatureAngle, double);
  ///@}

protected:
  vtkTangentialRedistribution();
  ~vtkTangentialRedistribution() override;

  int ModifyRequest(vtkInformation* request, int when) override;
  int RequestUpdateExtent(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkTangentialRedistribution(const vtkTangentialRedistribution&) = delete;
  void operator=(const vtkTangentialRedistribution&) = delete;

  evolving::SurfaceRedistributionOptions Options() const;

  int NumberOfSteps = 50;
  double TimeStep = 0.1;
  double VolumeRedistribution = 0.0;
  double AngleRedistribution = 8.0;
  double LengthRedistribution = 0.0;
  int AngleMethod = SHAPE;
  int AngleWeighting = WEIGHTING_NONE;
  int CurvatureControl = CONTROL_NONE;
  double CurvatureControlAlpha = 0.1;
  bool PreserveShape = true;
  int BoundaryMode = SLIDE_ALONG;
  double FeatureAngle = 45.0;

  std::unique_ptr<DistributedInput> WholeInput;
};

#endif
