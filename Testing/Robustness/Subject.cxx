// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Subject.h"

#include "DataJudge.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkIdList.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <algorithm>

namespace robustness
{

namespace
{

/// Is the solid, with its points as they are, closed, oriented outwards and free of intersections?
bool isTrue(const Model& model)
{
  Surface solid;
  solid.points = model.points;
  for (const Triangle& t : model.solid)
  {
    solid.faces.emplace_back(t.begin(), t.end());
  }
  const Topology topology = topologyOf(solid);
  // Sharp slivers may turn over when they are rounded once more.
  constexpr double SmallestAngle = 1e-3;
  return topology.isClosed() && topology.isManifold() && topology.isOriented() &&
    smallestAngleOf(solid) > SmallestAngle && intersectionsOf(solid) == 0 &&
    smallestOuterVolume(solid) > 0.0;
}

/// Do thin triangles, as rounded, still lie side by side?
bool areSplitsTrue(const Model& model, const Surface& joined)
{
  const bool canTell = !model.hasDuplicates &&
    std::all_of(
      joined.faces.begin(), joined.faces.end(), [](const Cell& face) { return face.size() == 3; });
  return !model.hasSplits || (canTell && intersectionsOf(joined) == 0);
}

/// Of a point set, only vertices count, or all points where there is none.
bool hasWrongVertices(const Model& model)
{
  const auto count = static_cast<std::int64_t>(model.points.size());
  return std::any_of(model.vertices.begin(), model.vertices.end(),
    [count](const Cell& cell)
    {
      return std::any_of(
        cell.begin(), cell.end(), [count](std::int64_t id) { return id < 0 || id >= count; });
    });
}

bool hasShortStrips(const Model& model)
{
  return std::any_of(
    model.strips.begin(), model.strips.end(), [](const Cell& strip) { return strip.size() < 3; });
}

bool hasNaNVertices(const Model& model)
{
  const auto isNaN = [&](std::int64_t id)
  { return !model.points[static_cast<std::size_t>(id)].allFinite(); };
  if (model.vertices.empty())
  {
    return std::any_of(model.points.begin(), model.points.end(),
      [](const Vec3& point) { return !point.allFinite(); });
  }
  return std::any_of(model.vertices.begin(), model.vertices.end(),
    [&](const Cell& cell) { return std::any_of(cell.begin(), cell.end(), isNaN); });
}

/// With data to be found again on outputs.
vtkSmartPointer<vtkPolyData> dressed(const vtkSmartPointer<vtkPolyData>& data)
{
  vtkNew<vtkDoubleArray> places;
  places->SetName(PlaceArray);
  places->SetNumberOfComponents(3);
  for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i)
  {
    Vec3 point;
    data->GetPoint(i, point.data());
    places->InsertNextTuple(point.allFinite() ? point.data() : Vec3(Vec3::Zero()).data());
  }
  data->GetPointData()->AddArray(places);
  vtkNew<vtkIdTypeArray> numbers;
  numbers->SetName(NumberArray);
  for (vtkIdType i = 0; i < data->GetNumberOfCells(); ++i)
  {
    numbers->InsertNextValue(i);
  }
  data->GetCellData()->AddArray(numbers);
  return data;
}

} // namespace

Subject::Subject(const Model& made)
  : model(made)
  , data(dressed(toPolyData(made)))
  , surface(surfaceOf(this->data))
  , radius(radiusOf(made))
  , centre(centreOf(made))
{
  this->hasFaces = !made.polygons.empty() || !made.strips.empty();
  this->isDamaged = this->hasFaces ? !hasUsableFaces(this->surface) || hasShortStrips(made)
                                   : hasWrongVertices(made);
  if (!this->isDamaged)
  {
    this->hasNaN = this->hasFaces ? !hasFiniteCorners(this->surface) : hasNaNVertices(made);
  }
  if (this->isUsable())
  {
    this->joined = welded(this->surface);
    this->topology = topologyOf(this->joined);
    this->measure();
  }
  if (this->isSolid() && !(isTrue(this->model) && areSplitsTrue(this->model, this->joined)))
  {
    this->model.forgetSolid();
  }
}

void Subject::measure()
{
  evolving::Box box;
  for (const Cell& face : this->surface.faces)
  {
    for (std::size_t k = 0; k < face.size(); ++k)
    {
      box.extend(this->surface.corner(face, k));
    }
  }
  if (!box.isEmpty())
  {
    this->centre = box.center();
    const double half = 0.5 * box.diagonal().norm();
    this->radius = half > 0.0 ? half : 1.0;
  }
}

} // namespace robustness
