// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ShrinkWrap/Shortcomings.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <string>
#include <utility>

namespace evolving
{

namespace
{

/// A result with a smaller angle than this, in degrees, is no good for simulation: about what
/// refinement in the plane guarantees (20.7; Ruppert, *A Delaunay Refinement Algorithm for Quality
/// 2-Dimensional Mesh Generation*, 1995).
constexpr double QualityFloor = 20.0;
/// Losing less than this part of the target is no shortcoming: slits between parts and the corners
/// of sheets are lost always.
constexpr double MostLost = 0.02;
/// Nor is missing less than this part of the length of all creases: their tips.
constexpr double MissingPart = 0.01;
/// Where edges are long, a part of the model's diagonal takes the place of edges: what is that far
/// off is seen at once in a picture of the whole.
constexpr double FarPart = 1.0 / 15.0;
/// Then edges of this part of the diagonal help: two of them are as long.
constexpr double EdgePart = FarPart / FarEdges;
/// Components of a few triangles are specks, unless they have so much of the result's area.
constexpr double MostInSpecks = 0.1;
/// A tenth of a part's diagonal as edge length gives it more than a hundred triangles.
constexpr double EdgePerExtent = 0.1;

class Sentences
{
public:
  Sentences(const SurfaceReport& report, double edgeLength)
    : Report(report)
    , EdgeLength(edgeLength)
    , Far(farDistance(edgeLength, report.modelSize))
  {
  }

  std::vector<std::string> all()
  {
    this->sayOfTopology();
    this->sayOfLostTopology();
    this->sayOfElements();
    this->sayOfAdaptation();
    if (this->Far < FarEdges * this->EdgeLength)
    {
      this->sayOfCoarseShape();
    }
    else
    {
      this->sayOfMembranes();
      this->sayOfLoss();
    }
    this->sayOfCreases();
    this->sayOfCoarseParts();
    return std::move(this->Said);
  }

private:
  template <class... Parts>
  void say(const Parts&... parts)
  {
    std::ostringstream sentence;
    (sentence << ... << parts);
    this->Said.push_back(sentence.str());
  }

  /// Where the edge length is automatic, one that is given would make all triangles alike.
  std::string smallerTriangles() const
  {
    return this->Report.morePoints > 0
      ? "use a TargetNumberOfPoints of " + std::to_string(this->Report.morePoints)
      : "use a smaller TargetEdgeLength";
  }

  void sayOfTopology()
  {
    if (!this->Report.isClosed || !this->Report.isManifold)
    {
      this->say("The result is not a closed manifold; use more SampleDimensions.");
    }
    if (this->Report.selfIntersections > 0)
    {
      this->say("The result has ", this->Report.selfIntersections,
        " pairs of triangles that intersect, one at (", this->Report.intersectionPlace.transpose(),
        "); ", this->smallerTriangles(), ".");
    }
  }

  void sayOfLostTopology()
  {
    if (this->Report.lost)
    {
      this->say(inWords(*this->Report.lost));
    }
  }

  void sayOfElements()
  {
    if (this->Report.minAngle < QualityFloor)
    {
      this->say("The smallest angle of the result is ", this->Report.minAngle, " degrees, below ",
        QualityFloor, ", at (", this->Report.minAnglePlace.transpose(), "); ",
        this->smallerTriangles(), ".");
    }
  }

  void sayOfAdaptation()
  {
    const StageRuns& adaptation = this->Report.adaptation;
    if (adaptation.isLeftOut)
    {
      this->say("Elements could not follow the curvature and are uniform: those of a thin wall or "
                "in a narrow gap would run through each other or be slivers, some at (",
        adaptation.place.transpose(), "); ", this->smallerTriangles(), ", or no AdaptToCurvature.");
    }
  }

  void sayOfCoarseShape()
  {
    if (this->Report.maxDistance > this->Far || this->Report.lostPart > MostLost)
    {
      this->say("The result does not show the shape of the input: ",
        std::round(100.0 * this->Report.lostPart), " % of that is more than ", this->Far,
        " away from the result, some at (", this->Report.lostPlace.transpose(),
        "), and a point of the result is ", this->Report.maxDistance,
        " away from where it should be; TargetEdgeLength is too long with ", this->EdgeLength,
        ", use ", EdgePart * this->Report.modelSize, " or less.");
    }
  }

  void sayOfMembranes()
  {
    if (this->Report.maxDistance > this->Far)
    {
      this->say("A point of the result at (", this->Report.maxDistancePlace.transpose(), ") is ",
        this->Report.maxDistance, " away from where it should be, more than two edge lengths (",
        this->Far,
        "): a membrane was left over a hole or a deep concavity, or the distance grid is too "
        "coarse; use the Isosurface start, a smaller GapSize or more SampleDimensions.");
    }
  }

  void sayOfLoss()
  {
    if (this->Report.lostPart > MostLost)
    {
      this->say("Of the target, ", std::round(100.0 * this->Report.lostPart),
        " % is more than two edge lengths (", this->Far, ") away from the result, some at (",
        this->Report.lostPlace.transpose(),
        "): it is thinner than a triangle, or in a gap that was closed; ", this->smallerTriangles(),
        " or a smaller GapSize.");
    }
  }

  void sayOfCreases()
  {
    const FeatureCoverage& creases = this->Report.creases;
    if (creases.missing > std::max(this->EdgeLength, MissingPart * creases.length))
    {
      this->say("Of the target's creases, ", creases.length, " long in all, ", creases.missing,
        " are not on edges of the result, some at (", creases.place.transpose(),
        "): other parts are too near, angles would be too small, or the result does not lie on the "
        "target there; ",
        this->smallerTriangles(), ", and no OffsetDistance.");
    }
    const double all = creases.length + creases.leftOut.length;
    if (creases.leftOut.length > std::max(this->EdgeLength, MissingPart * all))
    {
      this->say("Of the target's creases, ", all, " long in all, ", creases.leftOut.length,
        " are shorter, or nearer to each other, than triangles of this size can carry and are "
        "rounded, some at (",
        creases.leftOut.place.transpose(), "); ", this->smallerTriangles(), ".");
    }
  }

  void sayOfCoarseParts()
  {
    const CoarseParts& coarse = this->Report.coarse;
    if (coarse.areaPart > MostInSpecks)
    {
      this->say("Parts of the result with ", std::round(100.0 * coarse.areaPart),
        " % of its area have too few triangles to have a shape, one at (", coarse.place.transpose(),
        "); TargetEdgeLength is too long with ", this->EdgeLength, ", use ",
        EdgePerExtent * coarse.extent, " or less.");
    }
    if (coarse.flat > 0)
    {
      this->say("The result has ", coarse.flat, " parts that enclose no volume, one at (",
        coarse.flatPlace.transpose(), "); TargetEdgeLength is too long with ", this->EdgeLength,
        ", use ", EdgePerExtent * coarse.flatExtent, " or less.");
    }
  }

  const SurfaceReport& Report;
  double EdgeLength;
  double Far;
  std::vector<std::string> Said;
};

} // namespace

double farDistance(double edgeLength, double modelSize)
{
  const double far = FarEdges * edgeLength;
  return modelSize > 0.0 ? std::min(far, FarPart * modelSize) : far;
}

std::vector<std::string> shortcomings(const SurfaceReport& report, double edgeLength)
{
  return Sentences(report, edgeLength).all();
}

} // namespace evolving
