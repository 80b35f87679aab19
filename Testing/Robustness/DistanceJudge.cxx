// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "DistanceJudge.h"

#include "OutputChecks.h"
#include "Verdict.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkMeshSDF.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace robustness
{

namespace
{

constexpr double Infinity = std::numeric_limits<double>::infinity();

/// Evaluations of a triangle that a judge takes for one image: a second or so.
constexpr std::size_t MostEvaluations = 4000000;

/// What a sample is held against.
class Sampler
{
public:
  Sampler(const Subject& subject, vtkMeshSDF* filter, vtkImageData* image)
    : Input(subject)
    , Filter(filter)
    , Image(image)
    , Reference(subject.data)
    , Distances(pointArray(image, "SignedDistance", 1))
  {
    const double* spacing = image->GetSpacing();
    this->Cell = *std::max_element(spacing, spacing + 3);
    const double least = *std::min_element(spacing, spacing + 3);
    this->Band = filter->GetBandWidth() > 0.0 ? filter->GetBandWidth() * least : Infinity;
    this->Sign = static_cast<int>(fieldNumber(image, "SignMethod"));
  }

  void judgeAll()
  {
    const auto samples = static_cast<std::size_t>(this->Image->GetNumberOfPoints());
    const std::size_t cost = std::max<std::size_t>(1, this->Reference.size());
    // An odd step, so that it meets all places in the blocks of a grid of even sides.
    const std::size_t step = 1 + 2 * (samples * cost / MostEvaluations / 2);
    for (std::size_t s = 0; s < samples; s += step)
    {
      this->judge(static_cast<vtkIdType>(s));
    }
  }

private:
  /// Coordinates are floats relative to the box: units in the last place of the largest one.
  double roundingAt(const Vec3& place) const
  {
    const double farthest = (place - this->Reference.box().center()).cwiseAbs().maxCoeff() +
      0.5 * this->Reference.box().sizes().maxCoeff();
    constexpr double Units = 1e-6;
    return Units * (farthest + this->Cell);
  }

  void judge(vtkIdType sample)
  {
    Vec3 place;
    this->Image->GetPoint(sample, place.data());
    const double value = this->Distances->GetTuple1(sample);
    const DistanceBounds truth = this->Reference(place);
    this->judgeDistance(place, value, truth);
    if (truth.lower == truth.upper)
    {
      this->judgeSign(place, value, truth.lower);
      this->judgeArrays(sample, place, truth.lower);
    }
  }

  void judgeDistance(const Vec3& place, double value, const DistanceBounds& truth) const
  {
    double below = this->roundingAt(place);
    double above = below;
    if (this->Filter->GetSmoothingSigma() > 0.0)
    {
      // A mean of values that change by no more than their distance; signs may cancel.
      const double reach = std::ceil(3.0 * this->Filter->GetSmoothingSigma()) * 1.7321 * this->Cell;
      above += reach;
      below = Infinity;
    }
    if (this->Filter->GetMethod() == vtkMeshSDF::FAST_SWEEPING)
    {
      const bool reachesAll = this->Filter->GetNumberOfSweeps() >= 8;
      above = reachesAll ? above + this->sweepingError(truth.upper) : Infinity;
      below += this->sweepingError(truth.upper);
    }
    const double distance = std::abs(value);
    require(distance >= std::min(truth.lower, this->Band) - below &&
        distance <= std::min(truth.upper, this->Band) + above,
      Fault::WrongDistance, "|d| at (", place.transpose(), ") is ", distance, ", and between ",
      truth.lower, " and ", truth.upper, " by brute force; a cell is ", this->Cell);
  }

  /// First order: a cell whose only given neighbour lies across a corner is reached in three steps,
  /// 1.4 cells too far from a value of up to half a diagonal; errors grow with the logarithm.
  double sweepingError(double distance) const
  {
    return this->Cell * (2.5 + 0.5 * std::log2(1.0 + distance / this->Cell));
  }

  /// Is the side that the method gives known there?
  bool knowsSide(const Vec3& place, double distance) const
  {
    if (!this->Input.isSolid() || this->Filter->GetSmoothingSigma() > 0.0)
    {
      return false;
    }
    // Normals of fins, however narrow, say nothing of the solid's sides.
    const Topology& topology = this->Input.topology;
    const bool hasFins = !topology.isClosed() || !topology.isManifold();
    if (this->Sign == vtkMeshSDF::PSEUDONORMAL && hasFins)
    {
      return false;
    }
    const bool byCells = this->Sign == vtkMeshSDF::FLOOD_FILL;
    const double margin = byCells ? 2.0 * this->Cell : 1e-3 * this->Cell + this->roundingAt(place);
    if (distance <= margin || (byCells && !this->isAllInGrid()))
    {
      return false;
    }
    return true;
  }

  /// Flood Fill comes in from the border of the grid, which must be outside.
  bool isAllInGrid() const
  {
    double bounds[6];
    this->Image->GetBounds(bounds);
    const evolving::Box grid(
      Vec3(bounds[0], bounds[2], bounds[4]), Vec3(bounds[1], bounds[3], bounds[5]));
    return grid.contains(this->Reference.box()) && grid.exteriorDistance(grid.center()) == 0.0 &&
      (grid.max() - this->Reference.box().max()).minCoeff() > 2.0 * this->Cell &&
      (this->Reference.box().min() - grid.min()).minCoeff() > 2.0 * this->Cell;
  }

  void judgeSign(const Vec3& place, double value, double distance) const
  {
    if (this->Sign == vtkMeshSDF::UNSIGNED)
    {
      require(value >= 0.0, Fault::WrongSign, "an unsigned distance is ", value);
      return;
    }
    if (this->knowsSide(place, distance))
    {
      const Model& model = this->Input.model;
      const double winding = windingNumber(model.points, model.solid, place);
      require((winding > 0.5) == (value < 0.0), Fault::WrongSign, "d at (", place.transpose(),
        ") is ", value, " by sign method ", this->Sign, ", but the solid winds ", winding,
        " times around it; a cell is ", this->Cell);
    }
  }

  void judgeArrays(vtkIdType sample, const Vec3& place, double distance) const
  {
    const double rounding = 4.0 * this->roundingAt(place);
    if (this->Filter->GetComputeClosestPoint())
    {
      Vec3 closest;
      pointArray(this->Image, "ClosestPoint", 3)->GetTuple(sample, closest.data());
      // The point is written as floats of absolute coordinates.
      const double written = rounding + 2e-7 * closest.cwiseAbs().maxCoeff();
      const double away = (closest - place).norm();
      require(std::abs(away - distance) <= written && this->Reference(closest).lower <= written,
        Fault::WrongDistance, "ClosestPoint of (", place.transpose(), ") is ", away,
        " away, the surface ", distance, "; a cell is ", this->Cell);
    }
    if (this->Filter->GetComputeClosestCellId() && !this->Reference.isLoose())
    {
      const double id = pointArray(this->Image, "ClosestCellId", 1)->GetTuple1(sample);
      const double away = this->Reference.toCell(place, static_cast<std::int64_t>(id));
      require(std::abs(away - distance) <= rounding, Fault::WrongDistance, "ClosestCellId of (",
        place.transpose(), ") is ", id, ", which is ", away, " away, the surface ", distance);
    }
    if (this->Filter->GetComputeGradient())
    {
      Vec3 gradient;
      pointArray(this->Image, "Gradient", 3)->GetTuple(sample, gradient.data());
      const double length = gradient.norm();
      require(length == 0.0 || std::abs(length - 1.0) < 1e-5, Fault::Misstated,
        "a gradient has the length ", length);
    }
  }

  const Subject& Input;
  vtkMeshSDF* Filter;
  vtkImageData* Image;
  DistanceReference Reference;
  vtkDataArray* Distances;
  double Cell = 1.0;
  double Band = Infinity;
  int Sign = 0;
};

void requireSignMethod(vtkMeshSDF* filter, vtkImageData* image)
{
  const int used = static_cast<int>(fieldNumber(image, "SignMethod"));
  const int asked = filter->GetSign();
  const bool isOne = used >= vtkMeshSDF::FLOOD_FILL && used <= vtkMeshSDF::UNSIGNED;
  require(isOne && (asked == vtkMeshSDF::AUTOMATIC || asked == used), Fault::Misstated,
    "SignMethod is ", used, ", and Sign ", asked);
}

} // namespace

void judgeDistances(const Subject& subject, vtkMeshSDF* filter, vtkImageData* image)
{
  int dimensions[3];
  image->GetDimensions(dimensions);
  require(std::equal(dimensions, dimensions + 3, filter->GetSampleDimensions()), Fault::Misstated,
    "the image has ", dimensions[0], " x ", dimensions[1], " x ", dimensions[2], " samples");
  requireSignMethod(filter, image);
  Sampler(subject, filter, image).judgeAll();
}

void judgePart(vtkImageData* part, vtkImageData* whole)
{
  int extent[6];
  part->GetExtent(extent);
  for (int k = extent[4]; k <= extent[5]; ++k)
  {
    for (int j = extent[2]; j <= extent[3]; ++j)
    {
      for (int i = extent[0]; i <= extent[1]; ++i)
      {
        const double ofPart = part->GetScalarComponentAsDouble(i, j, k, 0);
        const double ofWhole = whole->GetScalarComponentAsDouble(i, j, k, 0);
        require(ofPart == ofWhole, Fault::Misstated, "sample (", i, ", ", j, ", ", k, ") is ",
          ofPart, " in a part of the grid and ", ofWhole, " in the whole");
      }
    }
  }
}

} // namespace robustness
