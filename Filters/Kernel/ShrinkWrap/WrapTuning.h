// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * The numbers of shrink-wrapping that no user sets. Where mathematics leaves room they were chosen
 * by measurement: Testing/Benchmarks/WrapConstants varies one at a time and prints what changes.
 */

#ifndef EVOLVING_WRAP_TUNING_H
#define EVOLVING_WRAP_TUNING_H

#include "Remeshing/EdgeLengthLimits.h"

namespace evolving
{

/// Lengths around the target, in edge lengths of the result where nothing else is said.
struct TargetTuning
{
  ///@{
  /// From the target to the start surface: near enough for its holes and handles to be there, and
  /// to arrive without folds (columns "mean least" and p1: nearer and farther starts cost five
  /// degrees); in cells, so that the grid does not show in the start.
  double startPerEdge = 0.5;
  double startPerCell = 0.8;
  ///@}
  /// Half the thickness of the walls that sheets become when both sides can be reached. Rims are
  /// half circles of that radius: smaller ones are collapsed and collapsed, and draw back from the
  /// sheet's edge by two edge lengths (0.3; column "hausdorff" of a square), larger ones only lie
  /// farther off.
  double wallPerEdge = 0.5;
  /// And at most this part of the model's diagonal: with few elements it would not have its shape.
  double largestWall = 0.05;
  ///@{
  /// Cracks up to so much wider than the start level closes are looked for, in such steps, and a
  /// target counts as closed when it encloses this part of what it encloses without cracks: a
  /// crack lets in nearly all or nearly nothing, so any part between would do.
  double largestCrackEdges = 2.0;
  double crackStepEdges = 0.5;
  double closedPart = 0.5;
  ///@}
  /// Openings of a smaller diameter are closed: elements cannot line the thin pipes behind them.
  double narrowEdges = 6.0;
};

/// Of the flow from the start surface to the target.
struct FlowTuning
{
  ///@{
  /// Squared edge lengths that curvature smooths over in a step: half and twice as much cost angles
  /// ("mean least"). From a sphere more: it draws the
  /// rims of double sheets back (FrontContacts.h).
  double curvaturePerStep = 0.1;
  double sphereCurvaturePerStep = 0.6;
  ///@}
  /// FlowOptions::advectionBalance from a sphere: between membranes over holes, which only a
  /// larger one brings in, and rims of double sheets, which fall behind their sides with it.
  double sphereBalance = 0.2;
  /// Of the way to the best angles that a step goes: all that ExplicitLimits::Shape allows.
  double anglePerStep = 0.8;
  /// How far a vertex moves in a step at most, in its edge lengths: farther would pass a neighbour.
  double longestAdvection = 0.5;
  ///@{
  /// When no vertex moves farther in a step, in edge lengths, the surface has arrived or has met a
  /// membrane; nor when it has come no nearer in so many steps.
  double arrivedEdges = 0.2;
  int stallSteps = 15;
  ///@}
  ///@{
  /// Far from the target elements grow by so much of the distance, to so many sizes, and from
  /// element to element by so much of the length between.
  double farGrowth = 0.4;
  double farLargestSize = 6.0;
  double farGradation = 0.3;
  ///@}
  /// Sides of the surface that are far from the target keep this distance, in sizes.
  double frontSizes = 1.5;
};

/// Of the surface that has arrived: how its elements become good and close to the target. Lengths
/// in sizes of elements, angles in degrees.
struct FinishTuning
{
  /// The size that makes remeshing end with edges of a length, in that length: edges from 4/5 to
  /// 4/3 of a size stay (EdgeLengthLimits.h), and so are a little longer on average.
  double shortening = 0.97;
  ///@{
  /// Of remeshing. More before creases are captured would wear the acute ones off, fewer leave
  /// elements that do not fit them; the passes afterwards make good what capture leaves, and too
  /// many move along the creases what fits (column "least angle" with --features).
  int uniformPasses = 10;
  int passesBeforeCapture = 4;
  int capturePasses = 16;
  int adaptivePasses = 8;
  int polishPasses = 3;
  ///@}
  ///@{
  /// Of elements that follow the curvature.
  double smallestSize = SmallestAdaptiveSize;
  double largestSize = LargestAdaptiveSize;
  ///@}
  /// Remeshing by curvature ends with this fraction of the vertices that its sizes ask for.
  double verticesPerExpected = 0.95;
  ///@{
  /// What moving along the surface costs in the first fit: less finds ridges better and leaves
  /// worse elements.
  double uniformInertia = 1.5;
  double adaptedInertia = 0.5;
  ///@}
  ///@{
  /// Smallest angles up to this are worth a search, and how many rounds of it: more cost distance
  /// (hausdorff, forward rms), fewer angles.
  double wantedAngle = 46.0;
  int starRounds = 5;
  ///@}
  /// Triangles with smaller angles may be replaced by others.
  double soundAngle = 42.0;
  ///@{
  /// Before creases are captured, tips up to so far away are reached for, by elements that may
  /// have angles down to this: remeshing wears tips off by up to two sizes, out of the capture's
  /// reach.
  double farthestTip = 3.0;
  double leastAngleBeforeCapture = 15.0;
  ///@}
  ///@{
  /// Peaks of the target up to so far beside a face and so deep are reached for, in rounds that
  /// may cost elements their angles down to the bearable one, and a last one after which no angle
  /// is smaller than the least one (hausdorff against "least angle" and CPU s).
  double farthestPeak = 1.5;
  double deepestValley = 0.35;
  double bearableAngle = 38.0;
  double leastUniformAngle = 44.5;
  double leastAdaptedAngle = 42.5;
  int peakRounds = 2;
  ///@}
  /// Between samples of the target, to find what triangles cut off.
  double sampleSpacing = 0.4;
  /// Samples nearer than this part of the tolerance will be no peaks either.
  double nearlyPeak = 0.5;
  /// Small elements must not slip into grooves that are narrower than large ones: adaptive stages
  /// that leave smaller angles are undone there.
  double leastAngleOfAdapted = 15.0;
  ///@{
  /// Creases that leave elements smaller angles than this are let go: those that no result should
  /// have (sliverAngle), and some to spare. Remeshing after it may need some rounds; on most models
  /// one is enough.
  double leastFeatureAngle = 22.0;
  /// The same where PreserveFeatures is automatic, and elements count as much: half of an
  /// equilateral one's, and some to spare for the stages that follow. Tips and edges of facets may
  /// cost as much as creases that are asked for: without them a figure has another shape.
  double leastAutomaticAngle = 33.0;
  /// The weakest creases of each place are let go first, so often, then all that are there.
  int releaseRounds = 5;
  int recoveringPasses = 2;
  ///@}
  /// Faces farther from their patch of the target, in sizes of the smallest, have no place there.
  /// Nearer than that, many that belong there are lost (column "least angle" with --features).
  double reachSizes = 2.0;
  /// Of the volume before: a wrap that loses more by the capture of creases has collapsed.
  double leastVolumeAfterCapture = 0.5;
  /// The same by the fairing of ridges, which may take their height off, but not the body's.
  double leastVolumeAfterFairing = 0.9;
  ///@{
  /// Triangles with smaller angles are slivers, what Shortcomings names; so far around them a
  /// surface is remeshed once more, so often.
  double sliverAngle = 20.0;
  double mendedSizes = 4.0;
  int mendingPasses = 6;
  ///@}
  int settleRounds = 2;  ///< at rims of walls
  int landingRounds = 4; ///< on an offset, which is a promise for vertices
};

/// Of the surface amidst points. Lengths in mean distances between points.
struct PointTuning
{
  ///@{
  /// Diameters of balls that are tried. Through a square grid of points balls of 1.4 fit; the
  /// largest ones are for sparse parts of scans.
  double smallestGap = 2.0;
  double largestGap = 12.0;
  double gapStep = 0.5;
  ///@}
  /// Of the grid, in lengths of the model: larger ones see no more than a lump.
  double largestCell = 0.25;
  /// A ball that comes in leaves nothing of the inside, or specks: less than this part of what the
  /// best one leaves.
  double closedPart = 0.5;
  /// An inside that is on average thinner than this is none: points are as rough.
  double leastThickness = 0.5;
  ///@{
  /// How near balls come to the points: in cells around an inside; in distances around a sheet,
  /// where the balls of neighbours overlap from a half on.
  double touchPerCell = 0.1;
  double wallPerSpacing = 0.6;
  ///@}
  /// Of the surface's elements: equilateral ones of 1.07 have a vertex for every point, and with a
  /// few more points than vertices noise cancels out.
  double elementPerSpacing = 1.2;
  ///@{
  /// Of fitToPoints(), and how often surfaces are fitted and remeshed in turn.
  double stiffness = 0.5;
  int fitRounds = 3;
  int fitIterations = 2;
  ///@}
};

struct WrapTuning
{
  PointTuning points;
  TargetTuning target;
  FlowTuning flow;
  FinishTuning finish;
};

} // namespace evolving

#endif
