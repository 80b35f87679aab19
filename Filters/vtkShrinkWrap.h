// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @class vtkShrinkWrap
 * @brief any mesh or point set to one clean closed surface
 *
 * vtkShrinkWrap takes a polydata of any quality (open, self-intersecting, duplicated or flipped
 * faces, a soup of triangles, or points alone) and makes a closed, 2-manifold, outward oriented
 * surface of nearly equilateral triangles that lies on it. It fills holes, samples the distance to
 * the input, starts from an iso-surface a little outside (or a sphere around it) and lets it evolve
 * onto the input as vtkSurfaceEvolution does, with new elements after every step. At the end
 * vertices find ridges, the worst triangles are improved, and triangles are fitted to the input by
 * least squares. The orientation of the input is never trusted. Sheets that can be reached from
 * both sides become thin closed walls, about an edge length thick; their rims are sharp edges where
 * those are kept (PreserveFeatures) and no TargetEdgeLength is asked for. Parts that run through
 * each other, or touch, become one surface; where they cross is a sharp edge as any other. (Parts
 * that meet are moved by less than a millionth of the diagonal for that.)
 *
 * Faces of fewer than three corners, and faces and points whose coordinates are not finite, are
 * left out; a warning counts them, and so does Shortcomings.
 *
 * A stage that makes the surface run through itself is undone at that place. What could not be
 * reached, holes and parts that were lost, and angles below 20 degrees, are said in a warning for
 * each, with the place, and in the field array Shortcomings.
 *
 * Point, cell and field data of the input are on the output, too (PassPointData, PassCellData),
 * with their roles, active scalars say. Not so ids, ghost types, normals and tangents, which mean
 * other points and cells, and arrays that an earlier filter of this module made; where another
 * array has the name of one below, it gets "_input" at the end of its name.
 *
 * Times are those of the input, and the one that is asked for is wrapped; with OutputSteps on they
 * are the output's own, and one time step of the input is (`InputTime`).
 *
 * Output 0 is the finished surface; with OutputSteps on it is the series of the evolution, step 0
 * the start and the last step the finished surface, as of vtkSurfaceEvolution. Point and field
 * arrays are those of vtkSurfaceEvolution; the finished surface has these field data as well:
 * IsClosed, IsManifold (0 or 1), SelfIntersections (pairs of triangles), Genus, MinAngle (degrees),
 * MaxDistance (largest distance of its vertices from where they should be: on the input with its
 * holes filled, at OffsetDistance from it, or at a wall's half thickness), and Shortcomings
 * (strings, one for each; no such array when there are none).
 *
 * Points are of the input's type, float or double, and field data are of the points as they are
 * written. Where floats are so far apart that triangles would lose their shapes (angles by a degree
 * on the average), or where rounding would make triangles intersect or add another shortcoming, the
 * points of all times are double, and a warning says so.
 *
 * Output 1 is the vtkTable `History` of vtkSurfaceEvolution.
 *
 * M. Cavarga, "Optimal Discretization of 3D Objects by Evolving Surfaces", 2020, chapter 6.
 *
 * @sa vtkMeshSDF vtkSurfaceEvolution
 */

#ifndef vtkShrinkWrap_h
#define vtkShrinkWrap_h

#include "vtkEvolvingSurfacesFiltersModule.h" // For export macro
#include "vtkPolyDataAlgorithm.h"

#include <cstddef> // For std::size_t
#include <memory>  // For std::unique_ptr
#include <vector>  // For the times

class DistributedInput;

namespace evolving
{
class Execution;
struct FlowState;
struct ShrinkWrapOptions;
}

class VTKEVOLVINGSURFACESFILTERS_EXPORT vtkShrinkWrap : public vtkPolyDataAlgorithm
{
public:
  static vtkShrinkWrap* New();
  vtkTypeMacro(vtkShrinkWrap, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// Values of Start.
  enum
  {
    ISOSURFACE = 0,
    ICOSPHERE = 1
  };

  /// Values of PreserveFeatures.
  enum
  {
    OFF = 0,
    ON = 1,
    AUTOMATIC = 2
  };

  /// Values of InputTime.
  enum
  {
    FIRST_STEP = 0,
    LAST_STEP = 1,
    STEP_INDEX = 2
  };

  ///@{
  /**
   * Publish the evolution as time steps, step 0 the start. Off by default: the output is the
   * finished surface, and its times are those of the input.
   */
  vtkSetMacro(OutputSteps, bool);
  vtkGetMacro(OutputSteps, bool);
  vtkBooleanMacro(OutputSteps, bool);
  ///@}

  ///@{
  /**
   * Where the evolution starts: an ISOSURFACE of the distance just outside the input (the default;
   * it has the input's holes and handles), or an ICOSPHERE around it, as in the thesis.
   */
  vtkSetClampMacro(Start, int, ISOSURFACE, ICOSPHERE);
  vtkGetMacro(Start, int);
  void SetStartToIsosurface() { this->SetStart(ISOSURFACE); }
  void SetStartToIcosphere() { this->SetStart(ICOSPHERE); }
  ///@}

  ///@{
  /**
   * Samples of the distance along each axis, 8 to 4096. The default is 0, automatic: 128, or as
   * many as the triangles need to find holes and gaps of their size, and as the holes and handles
   * of a clean closed input need; 32 million (800 MB) at most in all.
   */
  void SetSampleDimensions(int x, int y, int z);
  void SetSampleDimensions(const int dimensions[3]);
  vtkGetVector3Macro(SampleDimensions, int);
  ///@}

  ///@{
  /**
   * Edge length of the result's triangles, in length units. The default is 0: it follows from
   * TargetNumberOfPoints. With AdaptToCurvature, the mean one. What would need more than two
   * million points is an error.
   */
  vtkSetClampMacro(TargetEdgeLength, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(TargetEdgeLength, double);
  ///@}

  ///@{
  /**
   * About how many points the result has, where TargetEdgeLength is 0. The range is 0 to 1,000,000.
   * The default is 0, automatic: 9000, and more, up to 60,000, beside sharp edges. Parts of the
   * input that cannot be seen from outside do not count; at an OffsetDistance there are more, as
   * there is more area. Beside the sharp edges that PreserveFeatures keeps, triangles become so
   * small that they follow their bends, round holes say, in steps of 23 degrees, and that some fit
   * between two of them, down to an eighth of the edges elsewhere; but not with AdaptToCurvature,
   * nor where the input has sheets, or parts that cross and are not closed.
   */
  vtkSetClampMacro(TargetNumberOfPoints, int, 0, 1000000);
  vtkGetMacro(TargetNumberOfPoints, int);
  ///@}

  ///@{
  /**
   * Holes and gaps narrower than this close, in length units. The default is 0: holes of the kind
   * that scanners leave and openings narrower than six edge lengths are filled, and gaps narrower
   * than an edge length or two cells of the distance grid close.
   */
  vtkSetClampMacro(GapSize, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(GapSize, double);
  ///@}

  ///@{
  /**
   * Smaller triangles where the input is curved and larger ones where it is flat, as many in all.
   * Around thin walls and gaps they may be no good, and triangles stay alike; Shortcomings says so.
   * The default is off.
   */
  vtkSetMacro(AdaptToCurvature, bool);
  vtkGetMacro(AdaptToCurvature, bool);
  vtkBooleanMacro(AdaptToCurvature, bool);
  ///@}

  ///@{
  /**
   * Edges and points of the result on sharp edges and corners of the input, also on those that end
   * inside a face. What triangles of the edge length cannot carry is left out: parts narrower than
   * 0.7 of it, and creases shorter than two. Not where the result does not lie on the input: at an
   * OffsetDistance, and at sheets that become walls.
   * AUTOMATIC, the default, does so on those connected parts of the input whose sharp edges are
   * creases, as of a machined part: more than half of their length folds over six times as much as
   * the other edges beside it. On scans and models of smooth things it does not; but parts made of
   * large facets, edges that fold by two thirds of FeatureAngle being three times as long as those
   * of the result, get the edges of their facets, also faint ones down to a ninth of FeatureAngle
   * that make no angle below 36 degrees with another. Triangles come first: what would leave them
   * angles below 33 degrees, beside facets, at tips and in corners 22, is rounded. ON keeps all
   * sharp edges and, for them, angles down to 22 degrees. OFF keeps none.
   */
  vtkSetClampMacro(PreserveFeatures, int, OFF, AUTOMATIC);
  vtkGetMacro(PreserveFeatures, int);
  void SetPreserveFeaturesToOff() { this->SetPreserveFeatures(OFF); }
  void SetPreserveFeaturesToOn() { this->SetPreserveFeatures(ON); }
  void SetPreserveFeaturesToAutomatic() { this->SetPreserveFeatures(AUTOMATIC); }
  ///@}

  ///@{
  /**
   * Edges whose faces' normals differ by more than this angle, in degrees, are sharp. Used with
   * PreserveFeatures. The default is 45, the range 0 to 180.
   */
  vtkSetClampMacro(FeatureAngle, double, 0.0, 180.0);
  vtkGetMacro(FeatureAngle, double);
  ///@}

  ///@{
  /**
   * Steps of the evolution. The default is 0: 4 from an isosurface, 50 from an icosphere. The range
   * is 0 to 100000.
   */
  vtkSetClampMacro(NumberOfSteps, int, 0, 100000);
  vtkGetMacro(NumberOfSteps, int);
  ///@}

  ///@{
  /**
   * Distance of the result from the input, in length units, outwards. The default is 0: on it.
   */
  vtkSetClampMacro(OffsetDistance, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(OffsetDistance, double);
  ///@}

  ///@{
  /**
   * With OutputSteps: which time step of a temporal input is wrapped: FIRST_STEP,
   * LAST_STEP (the default), or STEP_INDEX, the one of the number InputTimeIndex. The field array
   * InputTime says which time that was.
   */
  vtkSetClampMacro(InputTime, int, FIRST_STEP, STEP_INDEX);
  vtkGetMacro(InputTime, int);
  void SetInputTimeToFirstStep() { this->SetInputTime(FIRST_STEP); }
  void SetInputTimeToLastStep() { this->SetInputTime(LAST_STEP); }
  void SetInputTimeToStepIndex() { this->SetInputTime(STEP_INDEX); }
  ///@}

  ///@{
  /**
   * Number of the time step for STEP_INDEX; inputs that have times must have it. The default is 0,
   * the first one, the range 0 and above.
   */
  vtkSetClampMacro(InputTimeIndex, int, 0, VTK_INT_MAX);
  vtkGetMacro(InputTimeIndex, int);
  ///@}

  ///@{
  /**
   * Point data of the input on the result: at the point of the input that is closest, floats,
   * doubles and colors interpolated on its triangle, of other arrays the value of the nearest
   * corner. Of a point set, those of the closest point. On by default.
   */
  vtkSetMacro(PassPointData, bool);
  vtkGetMacro(PassPointData, bool);
  vtkBooleanMacro(PassPointData, bool);
  ///@}

  ///@{
  /**
   * Cell data of the input on the result: a triangle has those of the cell closest to its middle.
   * On by default.
   */
  vtkSetMacro(PassCellData, bool);
  vtkGetMacro(PassCellData, bool);
  vtkBooleanMacro(PassCellData, bool);
  ///@}

  /**
   * How often the evolution has been solved: it stays at one while only times change.
   */
  vtkGetMacro(NumberOfSolves, int);

protected:
  vtkShrinkWrap();
  ~vtkShrinkWrap() override;

  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int ModifyRequest(vtkInformation* request, int when) override;
  int RequestUpdateExtent(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkShrinkWrap(const vtkShrinkWrap&) = delete;
  void operator=(const vtkShrinkWrap&) = delete;

  evolving::ShrinkWrapOptions Options() const;
  std::vector<double> Times() const;
  void Solve(vtkPolyData* input, const evolving::Execution& execution);
  void WriteState(std::size_t step, vtkPolyData* input, vtkPolyData* output,
    const evolving::Execution& execution);
  void WriteData(vtkPolyData* input, const evolving::FlowState& state, vtkPolyData* output,
    const evolving::Execution& execution);
  void Warn(vtkPolyData* input);

  bool OutputSteps = false;
  int Start = ISOSURFACE;
  int SampleDimensions[3] = { 0, 0, 0 };
  double TargetEdgeLength = 0.0;
  int TargetNumberOfPoints = 0;
  double GapSize = 0.0;
  bool AdaptToCurvature = false;
  int PreserveFeatures = AUTOMATIC;
  double FeatureAngle = 45.0;
  int NumberOfSteps = 0;
  double OffsetDistance = 0.0;
  int InputTime = LAST_STEP;
  int InputTimeIndex = 0;
  bool PassPointData = true;
  bool PassCellData = true;
  int NumberOfSolves = 0;

  struct Cache;
  std::unique_ptr<Cache> Solved;
  std::unique_ptr<DistributedInput> WholeInput;
};

#endif
