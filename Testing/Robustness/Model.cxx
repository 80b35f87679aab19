// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Model.h"

#include "PolygonEars.h"

#include "vtkCellArray.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cstring>

namespace robustness
{

namespace
{

evolving::Box finiteBox(const Model& model)
{
  evolving::Box box;
  for (const Vec3& point : model.points)
  {
    if (point.allFinite())
    {
      box.extend(point);
    }
  }
  return box;
}

vtkSmartPointer<vtkCellArray> toCells(const std::vector<Cell>& cells)
{
  const auto array = vtkSmartPointer<vtkCellArray>::New();
  for (const Cell& cell : cells)
  {
    const std::vector<vtkIdType> ids(cell.begin(), cell.end());
    array->InsertNextCell(static_cast<vtkIdType>(ids.size()), ids.data());
  }
  return array;
}

/// FNV-1a.
class Hash
{
public:
  void add(std::uint64_t value)
  {
    for (int byte = 0; byte < 8; ++byte)
    {
      this->Value = (this->Value ^ ((value >> (8 * byte)) & 0xFF)) * 1099511628211U;
    }
  }
  void add(double value)
  {
    std::uint64_t bits = 0;
    std::memcpy(&bits, &value, sizeof bits);
    this->add(bits);
  }
  void add(const std::vector<Cell>& cells)
  {
    this->add(std::uint64_t(cells.size()));
    for (const Cell& cell : cells)
    {
      this->add(std::uint64_t(cell.size()));
      for (const std::int64_t id : cell)
      {
        this->add(static_cast<std::uint64_t>(id));
      }
    }
  }
  std::uint64_t value() const { return this->Value; }

private:
  std::uint64_t Value = 14695981039346656037U;
};

} // namespace

std::int64_t Model::addPoint(const Vec3& point)
{
  this->points.push_back(point);
  return static_cast<std::int64_t>(this->points.size()) - 1;
}

void Model::forgetSolid()
{
  this->solid.clear();
  this->isClean = false;
}

bool Model::hasUsableFaces() const
{
  const auto count = static_cast<std::int64_t>(this->points.size());
  return !this->polygons.empty() &&
    std::all_of(this->polygons.begin(), this->polygons.end(),
      [count](const Cell& polygon)
      {
        return polygon.size() >= 3 &&
          std::all_of(polygon.begin(), polygon.end(),
            [count](std::int64_t id) { return id >= 0 && id < count; });
      });
}

std::string Model::describe() const
{
  std::string text;
  for (const std::string& step : this->story)
  {
    text += (text.empty() ? "" : ", ") + step;
  }
  return text + " [" + std::to_string(this->points.size()) + " points, " +
    std::to_string(this->polygons.size() + this->strips.size()) + " faces, " +
    (this->isDouble ? "double]" : "float]");
}

double radiusOf(const Model& model)
{
  const evolving::Box box = finiteBox(model);
  const double radius = box.isEmpty() ? 0.0 : 0.5 * box.diagonal().norm();
  return radius > 0.0 ? radius : 1.0;
}

Vec3 centreOf(const Model& model)
{
  const evolving::Box box = finiteBox(model);
  return box.isEmpty() ? Vec3(Vec3::Zero()) : Vec3(box.center());
}

void append(const Model& other, Model& model)
{
  const auto first = static_cast<std::int64_t>(model.points.size());
  model.points.insert(model.points.end(), other.points.begin(), other.points.end());
  for (Cell polygon : other.polygons)
  {
    for (std::int64_t& id : polygon)
    {
      id += first;
    }
    model.addPolygon(polygon);
  }
  for (const Triangle& t : other.solid)
  {
    model.solid.push_back({ t[0] + first, t[1] + first, t[2] + first });
  }
}

void claimSolid(Model& model)
{
  model.solid.clear();
  for (const Cell& polygon : model.polygons)
  {
    for (const Triangle& ear : earsOf(model.points, polygon))
    {
      model.solid.push_back(ear);
    }
  }
  model.isClean = true;
}

vtkSmartPointer<vtkPolyData> toPolyData(const Model& model)
{
  vtkNew<vtkPoints> points;
  points->SetDataType(model.isDouble ? VTK_DOUBLE : VTK_FLOAT);
  for (const Vec3& point : model.points)
  {
    points->InsertNextPoint(point.data());
  }
  const auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(points);
  data->SetVerts(toCells(model.vertices));
  data->SetLines(toCells(model.lines));
  data->SetPolys(toCells(model.polygons));
  data->SetStrips(toCells(model.strips));
  return data;
}

std::uint64_t hashOf(const Model& model)
{
  Hash hash;
  hash.add(std::uint64_t(model.points.size()));
  for (const Vec3& point : model.points)
  {
    for (const double coordinate : point)
    {
      hash.add(coordinate);
    }
  }
  for (const auto* cells : { &model.vertices, &model.lines, &model.polygons, &model.strips })
  {
    hash.add(*cells);
  }
  hash.add(std::uint64_t(model.isDouble));
  return hash.value();
}

} // namespace robustness
