// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @class vtkMeshSDF
 * @brief signed distance of a surface mesh on a regular grid
 *
 * vtkMeshSDF samples the distance to a surface on a vtkImageData of cubic cells: negative inside,
 * positive outside, in the input's length unit. The image's active scalars are the float point
 * array `SignedDistance`, so that contour, slice and volume filters take it as it is.
 *
 * The input's triangles, quads, polygons and strips are the surface, however dirty: coincident
 * points are joined first, faces may be duplicated, flipped, degenerate or open. An input without
 * them is a point set, of its vertices or else of all its points (lines do not count), and gets
 * unsigned distances. Coordinates that are not finite, point numbers out of range, and sizes
 * outside 1e-31 ... 1e31 are errors.
 *
 * Which triangle is closest is found by `Method`; which side a sample is on by `Sign`. The field
 * data say which sign method was used (`SignMethod`, an int) and why (`SignReason`, a sentence).
 * What each sign method makes of open, flipped, nested, crossing and other surfaces is one table,
 * in the plugin's help: Plugin/Documentation/Inputs.html.
 *
 * Any update extent is computed alone where the method allows that; FastSweeping and FloodFill
 * need the whole grid and hand out the part. In a parallel run every rank computes its part of the
 * grid from the whole surface: an input that is spread over the ranks is gathered first, and one
 * that cannot be gathered is refused. All ranks must update the filter, as for every filter that
 * exchanges data.
 *
 * Chapter 5 of M. Cavarga, "Optimal Discretization of 3D Objects by Evolving Surfaces", 2020.
 * Zhao, "A fast sweeping method for eikonal equations", Math. Comp. 74, 2005.
 * Baerentzen, Aanaes, "Signed distance computation using the angle weighted pseudonormal", IEEE
 * TVCG 11, 2005.
 * Barill et al., "Fast winding numbers for soups and clouds", ACM TOG 37, 2018.
 *
 * @sa vtkSurfaceEvolution vtkDistanceHierarchy vtkFlyingEdges3D
 */

#ifndef vtkMeshSDF_h
#define vtkMeshSDF_h

#include "vtkEvolvingSurfacesFiltersModule.h" // For export macro
#include "vtkImageAlgorithm.h"

#include <memory> // For std::unique_ptr

class DistributedInput;

namespace evolving
{
struct DistanceGrid;
struct SignedDistanceOptions;
struct SurfaceMesh;
}

class VTKEVOLVINGSURFACESFILTERS_EXPORT vtkMeshSDF : public vtkImageAlgorithm
{
public:
  static vtkMeshSDF* New();
  vtkTypeMacro(vtkMeshSDF, vtkImageAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// Values of Method.
  enum
  {
    CLOSEST_POINT = 0,
    FAST_SWEEPING = 1,
    BRUTE_FORCE = 2
  };

  /// Values of Sign.
  enum
  {
    AUTOMATIC = 0,
    FLOOD_FILL = 1,
    WINDING_NUMBER = 2,
    PSEUDONORMAL = 3,
    UNSIGNED = 4
  };

  ///@{
  /**
   * Samples along each axis. The default is 128 x 128 x 128, the range 1 to 65536 an axis.
   */
  void SetSampleDimensions(int x, int y, int z);
  void SetSampleDimensions(const int dimensions[3]);
  vtkGetVector3Macro(SampleDimensions, int);
  ///@}

  ///@{
  /**
   * Space added on every side of the input's bounds, as a fraction of their longest side; then the
   * box grows symmetrically until the cells are cubes. Not used with ModelBounds. The default is
   * 0.1, the range 0 to 100.
   */
  vtkSetClampMacro(Padding, double, 0.0, 100.0);
  vtkGetMacro(Padding, double);
  ///@}

  ///@{
  /**
   * The box of the grid (x0, x1, y0, y1, z0, z1), taken as it is. When x0 > x1, y0 > y1 and z0 > z1
   * (the default, 1, -1, 1, -1, 1, -1) it is automatic: the input's bounds and Padding. A box that
   * ends before it begins along one or two axes, or has no length along one that has several
   * samples, is an error.
   */
  vtkSetVector6Macro(ModelBounds, double);
  vtkGetVector6Macro(ModelBounds, double);
  ///@}

  ///@{
  /**
   * How the closest triangle of a sample is found. CLOSEST_POINT (the default) is exact
   * everywhere, to the rounding of floats: blocks of samples are searched together. FAST_SWEEPING
   * freezes the octree's leaf cells at their exact distance and solves the eikonal equation (first
   * order; cubic cells only). BRUTE_FORCE asks the AABB tree for every sample, in double: the
   * reference, and slow.
   */
  vtkSetClampMacro(Method, int, CLOSEST_POINT, BRUTE_FORCE);
  vtkGetMacro(Method, int);
  void SetMethodToClosestPoint() { this->SetMethod(CLOSEST_POINT); }
  void SetMethodToFastSweeping() { this->SetMethod(FAST_SWEEPING); }
  void SetMethodToBruteForce() { this->SetMethod(BRUTE_FORCE); }
  ///@}

  ///@{
  /**
   * How inside is told from outside. AUTOMATIC (the default) takes PSEUDONORMAL for closed
   * surfaces whose parts are apart, WINDING_NUMBER for all others and UNSIGNED for point sets.
   * FLOOD_FILL calls outside what can be reached from the border of the grid without crossing the
   * surface.
   */
  vtkSetClampMacro(Sign, int, AUTOMATIC, UNSIGNED);
  vtkGetMacro(Sign, int);
  void SetSignToAutomatic() { this->SetSign(AUTOMATIC); }
  void SetSignToFloodFill() { this->SetSign(FLOOD_FILL); }
  void SetSignToWindingNumber() { this->SetSign(WINDING_NUMBER); }
  void SetSignToPseudonormal() { this->SetSign(PSEUDONORMAL); }
  void SetSignToUnsigned() { this->SetSign(UNSIGNED); }
  ///@}

  ///@{
  /**
   * Only distances up to this many cells are computed, all others get this value with their sign.
   * The default is 0: the whole grid.
   */
  vtkSetClampMacro(BandWidth, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(BandWidth, double);
  ///@}

  ///@{
  /**
   * Standard deviation, in cells, of a Gaussian that smooths the distance (section 3.2 of the
   * thesis: d = G * d+). The default is 0: none; the range 0 to 32.
   */
  vtkSetClampMacro(SmoothingSigma, double, 0.0, 32.0);
  vtkGetMacro(SmoothingSigma, double);
  ///@}

  ///@{
  /**
   * Sweeps of FAST_SWEEPING. The default is 8, the range 1 to 64. Fewer than 4 do not reach every
   * sample; the others hold a value far above any distance.
   */
  vtkSetClampMacro(NumberOfSweeps, int, 1, 64);
  vtkGetMacro(NumberOfSweeps, int);
  ///@}

  ///@{
  /**
   * Add the point array `ClosestPoint` (3 floats): the closest point of the surface. Off by
   * default.
   */
  vtkSetMacro(ComputeClosestPoint, bool);
  vtkGetMacro(ComputeClosestPoint, bool);
  vtkBooleanMacro(ComputeClosestPoint, bool);
  ///@}

  ///@{
  /**
   * Add the point array `ClosestCellId`: the input cell that the closest point lies on. When the
   * input was gathered from several ranks, it is the cell's global id if the input has some
   * (vtkGenerateGlobalIds makes them), otherwise cells are counted rank after rank without ghosts:
   * first all vertices, then lines, polygons and strips. Off by default.
   */
  vtkSetMacro(ComputeClosestCellId, bool);
  vtkGetMacro(ComputeClosestCellId, bool);
  vtkBooleanMacro(ComputeClosestCellId, bool);
  ///@}

  ///@{
  /**
   * Add the point array `Gradient` (3 floats): the unit gradient of the distance, zero where it
   * has none. Off by default.
   */
  vtkSetMacro(ComputeGradient, bool);
  vtkGetMacro(ComputeGradient, bool);
  vtkBooleanMacro(ComputeGradient, bool);
  ///@}

protected:
  vtkMeshSDF();
  ~vtkMeshSDF() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int ModifyRequest(vtkInformation* request, int when) override;
  int RequestUpdateExtent(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkMeshSDF(const vtkMeshSDF&) = delete;
  void operator=(const vtkMeshSDF&) = delete;

  evolving::SignedDistanceOptions Options() const;
  evolving::DistanceGrid GridFor(const evolving::SurfaceMesh& mesh) const;
  void PublishGrid(vtkInformation* info) const;

  int SampleDimensions[3] = { 128, 128, 128 };
  double Padding = 0.1;
  double ModelBounds[6] = { 1.0, -1.0, 1.0, -1.0, 1.0, -1.0 };
  int Method = CLOSEST_POINT;
  int Sign = AUTOMATIC;
  double BandWidth = 0.0;
  double SmoothingSigma = 0.0;
  int NumberOfSweeps = 8;
  bool ComputeClosestPoint = false;
  bool ComputeClosestCellId = false;
  bool ComputeGradient = false;

  std::unique_ptr<DistributedInput> WholeInput;
};

#endif
