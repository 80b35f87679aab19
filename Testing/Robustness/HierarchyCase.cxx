// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "DistanceReference.h"
#include "FilterCase.h"
#include "OutputChecks.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDistanceHierarchy.h"
#include "vtkNew.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>

namespace robustness
{

namespace
{

constexpr int Sides = 6;
constexpr int Corners = 8;

class HierarchyCase : public FilterCase
{
public:
  HierarchyCase(const Subject& subject, Random& random)
    : FilterCase(subject, random)
  {
    this->Filter->SetStructure(random.integer(0, 1));
    this->Filter->SetLevel(random.chance(0.6) ? -1 : random.integer(-2, 8));
    const auto side = [&]() { return random.integer(2, 24); };
    this->Filter->SetSampleDimensions(side(), side(), side());
    this->Filter->SetPadding(
      this->Parameters.number("Padding", random.chance(0.5) ? 0.1 : random.real(0.0, 1.0)));
    this->Filter->SetInputDataObject(subject.data);
  }

  vtkAlgorithm* filter() override { return this->Filter; }

  std::string whyRefuse() const override
  {
    const std::string why = this->whySurfaceIsRefused();
    const bool usesGrid = this->Filter->GetStructure() == vtkDistanceHierarchy::OCTREE;
    return why.empty() && usesGrid && this->Input.hasFaces && this->Parameters.isNaN("Padding")
      ? "Padding is NaN"
      : why;
  }

  bool mustAccept() const override
  {
    return this->Parameters.areSensible() && this->Input.isUsable() && this->Input.hasFaces &&
      !this->Input.joined.faces.empty();
  }

  /// A level may have no boxes.
  bool mayBeEmpty() const override
  {
    return this->Filter->GetLevel() >= 0 || this->Input.joined.faces.empty();
  }

  void judge(std::size_t) override
  {
    const std::vector<evolving::Box> boxes = this->boxes();
    vtkCellData* data = this->Filter->GetOutput()->GetCellData();
    const bool isTree = this->Filter->GetStructure() == vtkDistanceHierarchy::AABB_TREE;
    for (const char* name : { "Level", isTree ? "NumberOfTriangles" : "Distance" })
    {
      vtkDataArray* array = data->GetArray(name);
      require(array && array->GetNumberOfTuples() == Sides * vtkIdType(boxes.size()),
        Fault::Misstated, "the cell array ", name, " is not there, or has another size");
    }
    if (this->Filter->GetLevel() == -1)
    {
      isTree ? this->judgeLeaves(boxes) : this->judgeCells(boxes);
    }
  }

private:
  std::vector<evolving::Box> boxes()
  {
    const Surface sides = surfaceOf(this->Filter->GetOutput());
    require(sides.points.size() % Corners == 0 &&
        sides.faces.size() * Corners == sides.points.size() * Sides,
      Fault::NotTriangles, "the output is no set of boxes of eight points and six quads");
    std::vector<evolving::Box> boxes(sides.points.size() / Corners);
    for (std::size_t i = 0; i < sides.points.size(); ++i)
    {
      boxes[i / Corners].extend(sides.points[i]);
    }
    return boxes;
  }

  /// Units in the last place of the coordinates, as they are written.
  double rounding() const
  {
    // Boxes are floats from the middle of the model; they are written as the input's points are.
    constexpr double OfFloats = 3e-7;
    constexpr double OfDoubles = 1e-14;
    return OfFloats * this->Input.radius +
      (this->Input.model.isDouble ? OfDoubles : OfFloats) * this->Input.centre.norm();
  }

  /// The leaves cover all triangles, which may be cut between them, and nothing far from them.
  void judgeLeaves(const std::vector<evolving::Box>& boxes)
  {
    vtkDataArray* counts = this->Filter->GetOutput()->GetCellData()->GetArray("NumberOfTriangles");
    double sum = 0.0;
    evolving::Box all;
    for (std::size_t b = 0; b < boxes.size(); ++b)
    {
      sum += counts->GetTuple1(vtkIdType(b) * Sides);
      all.extend(boxes[b]);
    }
    std::size_t triangles = 0;
    evolving::Box model;
    for (const Cell& face : this->Input.surface.faces)
    {
      triangles += face.size() - 2;
      this->judgeCover(boxes, face);
      for (std::size_t k = 0; k < face.size(); ++k)
      {
        model.extend(this->Input.surface.corner(face, k));
      }
    }
    require(sum >= double(triangles), Fault::Misstated, "NumberOfTriangles is ", sum,
      " in all, of ", triangles);
    const double off = std::max((all.min() - model.min()).cwiseAbs().maxCoeff(),
      (all.max() - model.max()).cwiseAbs().maxCoeff());
    require(off <= this->rounding() + 1e-6 * this->Input.radius, Fault::TooFar,
      "the leaves' box is ", off, " off that of the faces, of radius ", this->Input.radius);
  }

  /// Points of a triangle: its corners, and some between them.
  void judgeCover(const std::vector<evolving::Box>& boxes, const Cell& face) const
  {
    constexpr int Parts = 4;
    for (int i = 0; face.size() == 3 && i <= Parts; ++i)
    {
      for (int j = 0; i + j <= Parts; ++j)
      {
        const Surface& surface = this->Input.surface;
        const Vec3 place = (i * surface.corner(face, 0) + j * surface.corner(face, 1) +
                             (Parts - i - j) * surface.corner(face, 2)) /
          Parts;
        require(std::any_of(boxes.begin(), boxes.end(),
                  [&](const evolving::Box& box)
                  { return box.exteriorDistance(place) <= this->rounding(); }),
          Fault::TooFar, "the point (", place.transpose(), ") of a triangle is in no leaf's box");
      }
    }
  }

  /// A cell's distance is that of its middle.
  void judgeCells(const std::vector<evolving::Box>& boxes)
  {
    const DistanceReference reference(this->Input.data, true);
    vtkDataArray* distances = this->Filter->GetOutput()->GetCellData()->GetArray("Distance");
    const std::size_t step = 1 + boxes.size() * reference.size() / 2000000;
    for (std::size_t b = 0; b < boxes.size(); b += step)
    {
      const double said = distances->GetTuple1(vtkIdType(b) * Sides);
      const DistanceBounds truth = reference(boxes[b].center());
      const double tolerance = 1e-5 * boxes[b].diagonal().norm() + this->rounding();
      require(said >= truth.lower - tolerance && said <= truth.upper + tolerance,
        Fault::WrongDistance, "Distance of a cell is ", said, ", between ", truth.lower, " and ",
        truth.upper, " by brute force; its diagonal is ", boxes[b].diagonal().norm());
    }
  }

  vtkNew<vtkDistanceHierarchy> Filter;
};

} // namespace

std::unique_ptr<FilterCase> makeHierarchyCase(const Subject& subject, Random& random)
{
  return std::make_unique<HierarchyCase>(subject, random);
}

} // namespace robustness
