// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @class vtkSurfaceEvolution
 * @brief evolves a surface by curvature, towards a distance field, with even elements
 *
 * vtkSurfaceEvolution moves the points of a surface by
 *
 *   d_t F = epsilon Laplace F + eta N + v_T                                              (4.1)
 *
 * with mean curvature flow (epsilon), advection along a signed distance field (eta) and
 * tangential redistribution of the points (v_T); finite volumes in space, semi-implicit in time.
 * Without a field the flow may also hold the volume (`VolumePreserving`), or be surface diffusion
 * (`Flow`).
 *
 * Input 0 is the start surface: triangles, quads or polygons, oriented and 2-manifold, closed or
 * with boundary; coincident points are joined first, but for those of parts that are closed as they
 * are, and a closed surface that is inside out, as contour filters make it of a signed distance, is
 * turned. Input 1, optional, is a vtkImageData
 * whose active scalars are the field: a signed distance (negative inside, as vtkMeshSDF makes
 * it), or an image to segment (`FieldMode`); its direction matrix may turn or mirror it. Another
 * array, of the points or the cells, is chosen by SetInputArrayToProcess(0, 1, 0, association,
 * name); it must have one number for each, and cells count as samples at their middles. Without it
 * the flow is pure mean curvature flow.
 *
 * A field that cannot attract the start is refused with a sentence that says what it is like: a
 * distance changes by about 1 per length near its zero level (to a factor of 2), has such a level
 * or comes closer to zero than a cell, and samples along all three axes, where the start is.
 *
 * Output 0 is the surface at a time step: t = 0 is the start, then every OutputInterval-th step,
 * the last one always. An update without a time gives the last step, the result. Times are
 * multiples of TimeStep; where that is automatic, which needs the surface, they are numbers of
 * steps, and field data and history know the time itself. The flow is solved once, whatever the
 * order in which times are asked for. Point arrays: SignedDistance, DistanceGradient (with a
 * field), Normals, MeanCurvature, CoVolume, NormalVelocity, TangentialVelocity,
 * RedistributionPotential; at the boundary MeanCurvature contains the pull along the surface. Field
 * data: Iteration, Time, TimeStep, Area, Volume, MeanDistance, MaxDistance, MinAngle; EdgeSharpness
 * of an IMAGE; and, where that happened, Stopped, the step after which the flow could not go on,
 * ExtinctionTime, StepsWithoutRedistribution, the number of steps in which elements were so
 * degenerate that the volume-based redistribution could not be computed, or Shortcomings, what the
 * last state has not reached of a distance field's zero level, which a warning says too: membranes
 * over holes and between parts, which a flow never opens, and what of the level is farther from the
 * surface than an edge of it and two cells, with places and sizes.
 *
 * Point and cell data of the input go with the points: they are as they are while the elements are
 * the start's (of coincident points those of the first). A point of new elements has the data of
 * the place on the start where it came from: floats, doubles and colors interpolated, of other
 * arrays the value of the nearest corner; a new cell has those of the cell there; ids and ghost
 * types end with the elements that they mean. Arrays of the names above that an earlier filter of
 * this module made are replaced; anyone else's stay, under their name with "_input" at its end.
 * Active scalars stay active. Normals and tangents of the input are not those of a surface that has
 * moved, and are left out; where there were active point normals, the array Normals is active.
 *
 * Times are the output's own: of an input with time steps one is evolved (`InputTime`), and field
 * data, InputTime, say which.
 *
 * No step turns an element over: where the flow would, at a neck that pinches off or at slivers,
 * points also move along the surface, go with those around them, or wait. A step that would turn
 * over more than a fifth of the elements is tried again in parts, and ends the run when that does
 * not help. A component that has shrunk to a point stays there; with Remeshing it is left out where
 * others remain.
 *
 * Points are of the input's type, float or double, and field data and history are of the points as
 * they are written. Where floats are so far apart that the elements would lose their shapes (angles
 * by a degree on the average), the points of all times are double, and a warning says so.
 *
 * Output 1 is a vtkTable `History` with one row for every computed step.
 *
 * Units. With RelativeUnits on, lengths are measured in L, the radius of the target's bounding
 * sphere (half the diagonal of the box of the samples inside, along the image's own axes; without a
 * field, and for an edge detector, of the input's box), so that the same numbers serve a model of
 * any size. Rates are per unit of time.
 *
 * M. Cavarga, "Optimal Discretization of 3D Objects by Evolving Surfaces", 2020, chapters 3, 4, 6.
 *
 * @sa vtkMeshSDF vtkTangentialRedistribution vtkShrinkWrap vtkIcosphereSource
 */

#ifndef vtkSurfaceEvolution_h
#define vtkSurfaceEvolution_h

#include "vtkEvolvingSurfacesFiltersModule.h" // For export macro
#include "vtkPolyDataAlgorithm.h"

#include <memory>   // For std::unique_ptr
#include <optional> // For the options of remeshing

class DistributedInput;
class EvolutionOutput;
class ImageArray;
class vtkImageData;
class vtkPolyData;

namespace evolving
{
class Execution;
class ScalarImage;
struct FlowOptions;
struct SurfaceRemeshingOptions;
}

class VTKEVOLVINGSURFACESFILTERS_EXPORT vtkSurfaceEvolution : public vtkPolyDataAlgorithm
{
public:
  static vtkSurfaceEvolution* New();
  vtkTypeMacro(vtkSurfaceEvolution, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// Values of Flow.
  enum
  {
    MEAN_CURVATURE = 0,
    SURFACE_DIFFUSION = 1
  };

  /// Values of FieldMode.
  enum
  {
    DISTANCE_FIELD = 0,
    IMAGE = 1,
    EDGE_IMAGE = 2
  };

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
    INVERSE_AREA = 1,
    DISTANCE = 2
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

  /// Values of Remeshing.
  enum
  {
    OFF = 0,
    UNIFORM = 1,
    CURVATURE_ADAPTIVE = 2,
    AUTOMATIC = 3
  };

  /// Values of InputTime.
  enum
  {
    FIRST_STEP = 0,
    LAST_STEP = 1,
    STEP_INDEX = 2
  };

  /// The field: a vtkImageData on input port 1.
  void SetDistanceFieldConnection(vtkAlgorithmOutput* field) { this->SetInputConnection(1, field); }

  ///@{
  /**
   * Length of a time step tau. 0, the default, is an automatic one, with which NumberOfSteps steps
   * lead as far as one wants to see: without a field half of what a sphere-like surface takes to
   * shrink to a point (with a boundary, until the minimal surface is reached), with a distance
   * field until a thousandth of the distance is left also in hollows, where curvature holds the
   * surface back (14 / AdvectionSpeed in all), where volumes are held until a thousandth of what
   * differs from a ball is left, with an image until the start itself would have vanished. The
   * value is in the field data, TimeStep. The range is 0 to 1e12.
   */
  vtkSetClampMacro(TimeStep, double, 0.0, 1e12);
  vtkGetMacro(TimeStep, double);
  ///@}

  ///@{
  /**
   * Number of time steps. The default is 150, the range 0 to 1000000.
   */
  vtkSetClampMacro(NumberOfSteps, int, 0, 1000000);
  vtkGetMacro(NumberOfSteps, int);
  ///@}

  ///@{
  /**
   * Every how many steps a state is published as a time step. The default is 1.
   */
  vtkSetClampMacro(OutputInterval, int, 1, 1000000);
  vtkGetMacro(OutputInterval, int);
  ///@}

  ///@{
  /**
   * What moves a surface by its own shape: MEAN_CURVATURE (the default), d_t F = C1 Laplace F,
   * which shrinks it; or SURFACE_DIFFUSION, d_t F = C1 Laplace_S H N, as atoms on the surface of a
   * metal do: the area falls, and what goes at one place comes at another, so that each component
   * keeps its volume and ends as a ball. Without a field and for closed surfaces only.
   */
  vtkSetClampMacro(Flow, int, MEAN_CURVATURE, SURFACE_DIFFUSION);
  vtkGetMacro(Flow, int);
  void SetFlowToMeanCurvature() { this->SetFlow(MEAN_CURVATURE); }
  void SetFlowToSurfaceDiffusion() { this->SetFlow(SURFACE_DIFFUSION); }
  ///@}

  ///@{
  /**
   * Volume-preserving mean curvature flow, d_t F = C1 (mean H - H) N: each connected component
   * keeps its volume, to rounding, by a multiplier that is solved for in every step, and ends as a
   * ball of that volume; in between it is the smoother that takes nothing away. Remeshing gives
   * back what it changes. A surface with a boundary keeps the volume between it and where it began,
   * and its boundary must be FIXED. Without a field only; SURFACE_DIFFUSION does it anyway. Points
   * are double then, as floats round volumes too. Off by default.
   */
  vtkSetMacro(VolumePreserving, bool);
  vtkGetMacro(VolumePreserving, bool);
  vtkBooleanMacro(VolumePreserving, bool);
  ///@}

  ///@{
  /**
   * C1 of (3.7), the speed of mean curvature flow far from the target, in length^2/time (L^2/time
   * in relative units); b of the edge detector. Without a field this is epsilon itself, and the
   * speed of SURFACE_DIFFUSION, in length^4/time (L^4/time). 0 switches the term off. The default
   * is 0.1, the range 0 and above.
   */
  vtkSetClampMacro(CurvatureSpeed, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(CurvatureSpeed, double);
  ///@}

  ///@{
  /**
   * C2 of (3.7), in length^2 (L^2 in relative units): mean curvature flow fades within its root of
   * the target. The default is 0.1, the range above 0.
   */
  vtkSetClampMacro(CurvatureRange, double, VTK_DBL_MIN, VTK_DOUBLE_MAX);
  vtkGetMacro(CurvatureRange, double);
  ///@}

  ///@{
  /**
   * C of (3.8), the rate at which the distance to the target decreases, per time; a of the edge
   * detector. 0 switches the term off. The default is 1, the range 0 and above.
   */
  vtkSetClampMacro(AdvectionSpeed, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(AdvectionSpeed, double);
  ///@}

  ///@{
  /**
   * D of (3.8): how much a surface also moves where the field's gradient is tangential to it. It
   * pulls the surface into concavities. The default is 0, the range 0 to 1.
   */
  vtkSetClampMacro(AdvectionBalance, double, 0.0, 1.0);
  vtkGetMacro(AdvectionBalance, double);
  ///@}

  ///@{
  /**
   * Measure lengths in L (see above). On by default.
   */
  vtkSetMacro(RelativeUnits, bool);
  vtkGetMacro(RelativeUnits, bool);
  vtkBooleanMacro(RelativeUnits, bool);
  ///@}

  ///@{
  /**
   * What the image is: DISTANCE_FIELD (the default); IMAGE, an intensity I whose edges attract the
   * surface by v_N = b e Laplace F - a (grad e . N) N + s e N, e = 1 / (1 + K |grad I|^2) (section
   * 3.2), with NormalSpeed s; or EDGE_IMAGE, e itself: 1 where there is no edge, near 0 at edges.
   * Where the image is uniform curvature moves the surface, inwards: start around the objects, or
   * inside them with a NormalSpeed.
   */
  vtkSetClampMacro(FieldMode, int, DISTANCE_FIELD, EDGE_IMAGE);
  vtkGetMacro(FieldMode, int);
  void SetFieldModeToDistanceField() { this->SetFieldMode(DISTANCE_FIELD); }
  void SetFieldModeToImage() { this->SetFieldMode(IMAGE); }
  void SetFieldModeToEdgeImage() { this->SetFieldMode(EDGE_IMAGE); }
  ///@}

  ///@{
  /**
   * K of an IMAGE, in (length/intensity)^2 (times L^2 in relative units). 0, the default, is an
   * automatic one, from the gradients of the image: e is 0.1 at a typical edge and 1 where
   * gradients are no larger than those of noise, n; the image is smoothed by 0.8 samples before,
   * and e = 1 / (1 + K max(0, |grad I|^2 - n^2)). An image without edges that stand out is refused.
   * With a value above 0 e is as FieldMode says, of the image as it is. The value used is in the
   * field data, EdgeSharpness. Edges far below the typical one, as an organ's beside bone and air,
   * are not seen: smooth the image, and set 10 to 100 times that value. The range is 0 and above.
   */
  vtkSetClampMacro(EdgeSharpness, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(EdgeSharpness, double);
  ///@}

  ///@{
  /**
   * s, the speed along the normal in an IMAGE or EDGE_IMAGE, in length/time (L/time in relative
   * units): outwards above 0, as a balloon that a seed inside an object is blown up to its border
   * with, inwards below 0. It is weighted by e, and beyond the image there is none outwards. It
   * should be above 2 b / r, the speed by curvature, for a seed of radius r to grow, or for one to
   * grow through a neck half as wide: 1 is good for most in relative units, where L is the seed's.
   * With it the automatic time step is the one for a cell a step. 0, the default, switches the term
   * off; any number is allowed.
   */
  vtkSetClampMacro(NormalSpeed, double, -VTK_DOUBLE_MAX, VTK_DOUBLE_MAX);
  vtkGetMacro(NormalSpeed, double);
  ///@}

  ///@{
  /**
   * omega of the volume-based redistribution (3.19), per time: co-volumes become equal at this
   * rate. 0, the default, switches it off.
   */
  vtkSetClampMacro(VolumeRedistribution, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(VolumeRedistribution, double);
  ///@}

  ///@{
  /**
   * omega of the angle-based redistribution (3.24), per time; AngleMethod says how. 0, the default,
   * switches it off.
   */
  vtkSetClampMacro(AngleRedistribution, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(AngleRedistribution, double);
  ///@}

  ///@{
  /**
   * omega of the length-based redistribution (3.23) along boundary curves and regular mesh lines,
   * per time. 0, the default, switches it off.
   */
  vtkSetClampMacro(LengthRedistribution, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(LengthRedistribution, double);
  ///@}

  ///@{
  /**
   * What the angle-based redistribution does: WEIGHTED_EDGES (the default), the velocity (3.24) of
   * the thesis, taken at once up to a product of 0.3 of rate and time step; or SHAPE: each point
   * goes at the given rate to the place between its neighbours where the elements around it have
   * the best shapes (the sum of their squared inverse mean ratios is least), at once up to 0.8.
   * SHAPE improves the worst elements most and keeps differences in size; it does so best at 0.8
   * over the time step.
   */
  vtkSetClampMacro(AngleMethod, int, WEIGHTED_EDGES, SHAPE);
  vtkGetMacro(AngleMethod, int);
  void SetAngleMethodToWeightedEdges() { this->SetAngleMethod(WEIGHTED_EDGES); }
  void SetAngleMethodToShape() { this->SetAngleMethod(SHAPE); }
  ///@}

  ///@{
  /**
   * Weight of the angle-based velocity, against the accumulation of points at irregular ones
   * (section 6.2): none (the default), the inverse co-volume, or the distance to the target.
   */
  vtkSetClampMacro(AngleWeighting, int, WEIGHTING_NONE, DISTANCE);
  vtkGetMacro(AngleWeighting, int);
  void SetAngleWeightingToNone() { this->SetAngleWeighting(WEIGHTING_NONE); }
  void SetAngleWeightingToInverseArea() { this->SetAngleWeighting(INVERSE_AREA); }
  void SetAngleWeightingToDistance() { this->SetAngleWeighting(DISTANCE); }
  ///@}

  ///@{
  /**
   * What the volume-based redistribution makes co-volumes proportional to: 1 / f(H), with f = 1
   * (the default), |H|^(1/3), |H|^(2/3) or exp(alpha |H|) (3.21).
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
   * alpha of EXPONENTIAL curvature control, a length (times L in relative units). The default
   * is 0.1, the range 0 and above.
   */
  vtkSetClampMacro(CurvatureControlAlpha, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(CurvatureControlAlpha, double);
  ///@}

  ///@{
  /**
   * Steps of smoothing after the evolution (section 6.3). The default is 0, the range to 100000.
   */
  vtkSetClampMacro(SmoothingSteps, int, 0, 100000);
  vtkGetMacro(SmoothingSteps, int);
  ///@}

  ///@{
  /**
   * S0 of the smoothing speed epsilon(t) = S0 exp(-lambda t), length^2/time (L^2/time in relative
   * units). The default is 0.001, the range 0 and above.
   */
  vtkSetClampMacro(SmoothingSpeed, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(SmoothingSpeed, double);
  ///@}

  ///@{
  /**
   * lambda of the smoothing speed, per smoothing step. The default is 0.1, the range 0 and above.
   */
  vtkSetClampMacro(SmoothingDecay, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(SmoothingDecay, double);
  ///@}

  ///@{
  /**
   * What boundary points do: FIXED (the default), SLIDE_ALONG the boundary curve, or FREE.
   */
  vtkSetClampMacro(BoundaryMode, int, FIXED, FREE);
  vtkGetMacro(BoundaryMode, int);
  void SetBoundaryModeToFixed() { this->SetBoundaryMode(FIXED); }
  void SetBoundaryModeToSlideAlong() { this->SetBoundaryMode(SLIDE_ALONG); }
  void SetBoundaryModeToFree() { this->SetBoundaryMode(FREE); }
  ///@}

  ///@{
  /**
   * A point that leaves the box of the start and the field's samples, enlarged by this factor, ends
   * the run with what was reached (algorithm 7). The default is 2, the range 1 and above.
   */
  vtkSetClampMacro(SurfaceGuard, double, 1.0, VTK_DOUBLE_MAX);
  vtkGetMacro(SurfaceGuard, double);
  ///@}

  ///@{
  /**
   * End when no point moves faster than this fraction of L in the flow's own time, 1 / C with a
   * distance field: then none is farther from where it comes to rest. By curvature alone that time
   * is L^2 / C1, and no closed surface rests. Later time steps repeat the last state. 0: run all
   * steps. The default is 0.001.
   */
  vtkSetClampMacro(ConvergenceTolerance, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(ConvergenceTolerance, double);
  ///@}

  ///@{
  /**
   * New elements during the evolution, by splitting, collapsing and flipping edges: OFF, UNIFORM,
   * of one size, CURVATURE_ADAPTIVE, about as many that are smaller where the surface is curved, or
   * AUTOMATIC (the default): the elements stay as they are, points and polygons, until one has an
   * angle below 20 degrees (5 before sharp edges are rounded off), then there are uniform ones, as
   * good as can be at the end. With a field a start of less than a quarter of the points that
   * TargetEdgeLength stands for, as a box of eight, gets new elements at once. Points, polygons and
   * arrays of a time step are those of its elements; the start is as it was, but without the
   * slivers and nearly coincident points of a contour (where there were any, the first step has new
   * elements), and polygons are split into triangles (AUTOMATIC: when there are new elements). New
   * points lie on the smooth surface that the evolved triangles stand for, so that nothing shrinks.
   * A boundary keeps its shape: its edges are split, and only points in a straight line vanish
   * (others, too, where it is FREE, or, at the start, where that moves it by less than a fiftieth
   * of the edges around). Creases are not kept as such. The genus stays, also where a neck has
   * closed.
   */
  vtkSetClampMacro(Remeshing, int, OFF, AUTOMATIC);
  vtkGetMacro(Remeshing, int);
  void SetRemeshingToOff() { this->SetRemeshing(OFF); }
  void SetRemeshingToUniform() { this->SetRemeshing(UNIFORM); }
  void SetRemeshingToCurvatureAdaptive() { this->SetRemeshing(CURVATURE_ADAPTIVE); }
  void SetRemeshingToAutomatic() { this->SetRemeshing(AUTOMATIC); }
  ///@}

  ///@{
  /**
   * Mean edge length that remeshing aims at, in length units. 0, the default: of a closed surface
   * with a distance field as many points as the start has, and 2562 at least, on the area of its
   * zero level, and no more than 4 times as many on the way; AUTOMATIC: as many, whatever the size
   * by then; otherwise the mean edge length of the start.
   * A component keeps at least some hundred points, however small it has become. What would need
   * more than two million points, and more than four times those that are there, is an error. Used
   * with Remeshing.
   */
  vtkSetClampMacro(TargetEdgeLength, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(TargetEdgeLength, double);
  ///@}

  ///@{
  /**
   * Every how many steps elements are looked at, and made anew where they are not good; the last
   * state always has new ones. Used with Remeshing. The default is 1, the range 1 and above.
   */
  vtkSetClampMacro(RemeshingInterval, int, 1, 1000000);
  vtkGetMacro(RemeshingInterval, int);
  ///@}

  ///@{
  /**
   * Relative residual at which the linear solvers stop. The default is 1e-10, the range 1e-15 to
   * 1e-2.
   */
  vtkSetClampMacro(SolverTolerance, double, 1e-15, 1e-2);
  vtkGetMacro(SolverTolerance, double);
  ///@}

  ///@{
  /**
   * Which time step of temporal inputs is evolved, as times of the output are its own: FIRST_STEP,
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
   * Memory for the states of the series, in MiB. Above it every second state is dropped and
   * computed again when asked for; then what they are computed from counts too. The default is
   * 2048, the range 1 and above.
   */
  vtkSetClampMacro(CacheLimit, int, 1, VTK_INT_MAX);
  vtkGetMacro(CacheLimit, int);
  ///@}

  /**
   * How often the flow has been solved from its start: it stays at one while only times change.
   */
  vtkGetMacro(NumberOfSolves, int);

protected:
  vtkSurfaceEvolution();
  ~vtkSurfaceEvolution() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int ModifyRequest(vtkInformation* request, int when) override;
  int RequestUpdateExtent(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkSurfaceEvolution(const vtkSurfaceEvolution&) = delete;
  void operator=(const vtkSurfaceEvolution&) = delete;

  double PublishedTimeStep() const;
  evolving::FlowOptions Options() const;
  std::optional<evolving::SurfaceRemeshingOptions> RemeshingOptions() const;
  std::unique_ptr<EvolutionOutput> Solve(vtkPolyData* input, vtkImageData* field,
    const evolving::FlowOptions& options, const evolving::Execution& execution);
  void WarnOfEnd(const evolving::ScalarImage* field, const evolving::FlowOptions& options,
    EvolutionOutput& series, const evolving::Execution& execution);
  void UpdateSeries(
    vtkPolyData* input, vtkInformationVector** inputVector, const evolving::Execution& execution);
  void WriteState(
    vtkPolyData* input, vtkInformationVector* outputVector, const evolving::Execution& execution);

  double TimeStep = 0.0;
  int NumberOfSteps = 150;
  int OutputInterval = 1;
  int Flow = MEAN_CURVATURE;
  bool VolumePreserving = false;
  double CurvatureSpeed = 0.1;
  double CurvatureRange = 0.1;
  double AdvectionSpeed = 1.0;
  double AdvectionBalance = 0.0;
  bool RelativeUnits = true;
  int FieldMode = DISTANCE_FIELD;
  double EdgeSharpness = 0.0;
  double NormalSpeed = 0.0;
  double VolumeRedistribution = 0.0;
  double AngleRedistribution = 0.0;
  double LengthRedistribution = 0.0;
  int AngleMethod = WEIGHTED_EDGES;
  int AngleWeighting = WEIGHTING_NONE;
  int CurvatureControl = CONTROL_NONE;
  double CurvatureControlAlpha = 0.1;
  int SmoothingSteps = 0;
  double SmoothingSpeed = 0.001;
  double SmoothingDecay = 0.1;
  int BoundaryMode = FIXED;
  double SurfaceGuard = 2.0;
  double ConvergenceTolerance = 0.001;
  int Remeshing = AUTOMATIC;
  double TargetEdgeLength = 0.0;
  int RemeshingInterval = 1;
  double SolverTolerance = 1e-10;
  int InputTime = LAST_STEP;
  int InputTimeIndex = 0;
  int CacheLimit = 2048;
  int NumberOfSolves = 0;

  struct Cache;
  std::unique_ptr<Cache> Solved;
  std::unique_ptr<DistributedInput> WholeInput;
  std::unique_ptr<ImageArray> FieldArray;
};

#endif
