// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Evolution/ControlFunctions.h"

#include "Evolution/AutomaticEdgeDetector.h"
#include "ParallelLoops.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace evolving
{

namespace
{

/// Gradients shorter than this have no direction.
constexpr double SmallestGradient = 1e-6;

EdgeDetector edgesOf(const ScalarImage& image, double sharpness, const Execution& execution)
{
  if (sharpness == 0.0)
  {
    return automaticEdgeDetector(image, execution);
  }
  return { std::make_shared<const ScalarImage>(edgeDetector(image, sharpness, execution)),
    sharpness, 0.0 };
}

Vec3 direction(const Vec3& gradient)
{
  const double length = gradient.norm();
  return length < SmallestGradient ? Vec3(Vec3::Zero()) : Vec3(gradient / length);
}

} // namespace

double curvatureControl(double distance, double curvatureSpeed, double curvatureRange)
{
  return -curvatureSpeed * std::expm1(-distance * distance / curvatureRange);
}

double advectionControl(
  double distance, double slope, double advectionSpeed, double advectionBalance)
{
  const double across = std::sqrt(std::max(0.0, 1.0 - slope * slope));
  return advectionSpeed * distance * (slope - advectionBalance * across);
}

double smoothingControl(double smoothingSpeed, double smoothingDecay, int smoothingStep)
{
  return smoothingSpeed * std::exp(-smoothingDecay * smoothingStep);
}

ControlField::ControlField(
  std::shared_ptr<const ScalarImage> field, const FlowOptions& options, const Execution& execution)
  : Field(std::move(field))
  , Options(options)
{
  if (!this->Field)
  {
    return;
  }
  if (options.fieldMode == FieldMode::Image)
  {
    const EdgeDetector edges = edgesOf(*this->Field, options.edgeSharpness, execution);
    this->Field = edges.e;
    this->EdgeSharpness = edges.sharpness;
    this->EdgeBlur = edges.blur;
  }
  this->NearTarget = options.unsignedField ? 2.0 * this->Field->grid().spacing.maxCoeff() : 0.0;
}

ControlValues ControlField::sampleField(
  const std::vector<Vec3>& points, const Execution& execution) const
{
  ControlValues values;
  values.epsilon.assign(points.size(), this->Options.curvatureSpeed);
  values.eta.assign(points.size(), 0.0);
  if (this->Field)
  {
    const bool isEdgeDetector = hasEdges(this->Options.fieldMode);
    values.value.resize(points.size());
    values.gradient.resize(points.size());
    forEachIndex(execution, static_cast<std::int64_t>(points.size()),
      [&](Index i)
      {
        const ScalarImage::Sample sample = isEdgeDetector
          ? static_cast<ScalarImage::Sample>(sampleEdgeDetector(*this->Field, points[at(i)]))
          : this->Field->at(points[at(i)]);
        values.value[at(i)] = sample.value;
        values.gradient[at(i)] = sample.gradient;
      });
  }
  return values;
}

double ControlField::etaOfDistance(double distance, const Vec3& gradient, const Vec3& normal) const
{
  const double balance =
    std::abs(distance) < this->NearTarget ? 0.0 : this->Options.advectionBalance;
  const double slope = std::clamp(-gradient.dot(normal), -1.0, 1.0);
  return advectionControl(distance, slope, this->Options.advectionSpeed, balance);
}

double ControlField::etaOfEdges(const Vec3& point, const Vec3& normal) const
{
  const EdgeSample sample = sampleEdgeDetector(*this->Field, point);
  const double speed = this->Options.normalSpeed;
  const double balloon = sample.isOutside && speed > 0.0 ? 0.0 : speed * sample.value;
  return balloon - this->Options.advectionSpeed * sample.gradient.dot(normal);
}

/// By a difference over one cell: eta is linear in it.
double ControlField::stiffnessOfEdges(const Vec3& point, const Vec3& normal) const
{
  const double cell = this->Field->grid().spacing.minCoeff();
  const Vec3 half = 0.5 * cell * normal;
  const double change =
    this->etaOfEdges(point + half, normal) - this->etaOfEdges(point - half, normal);
  return std::max(0.0, -change / cell);
}

ControlValues ControlField::evaluate(const std::vector<Vec3>& points,
  const std::vector<Vec3>& normals, const Execution& execution) const
{
  ControlValues values = this->sampleField(points, execution);
  if (!this->Field)
  {
    return values;
  }
  const FlowOptions& o = this->Options;
  const bool isEdgeDetector = hasEdges(o.fieldMode);
  values.stiffness.resize(isEdgeDetector ? points.size() : 0);
  forEachIndex(execution, static_cast<std::int64_t>(points.size()),
    [&](Index i)
    {
      const double value = values.value[at(i)];
      const Vec3 gradient = values.gradient[at(i)];
      values.gradient[at(i)] = direction(gradient);
      if (isEdgeDetector)
      {
        values.epsilon[at(i)] = std::max(0.0, o.curvatureSpeed * value);
        values.eta[at(i)] = this->etaOfEdges(points[at(i)], normals[at(i)]);
        values.stiffness[at(i)] = this->stiffnessOfEdges(points[at(i)], normals[at(i)]);
      }
      else
      {
        values.epsilon[at(i)] = curvatureControl(value, o.curvatureSpeed, o.curvatureRange);
        values.eta[at(i)] = this->etaOfDistance(value, values.gradient[at(i)], normals[at(i)]);
      }
    });
  return values;
}

ControlValues ControlField::evaluateSmoothing(
  const std::vector<Vec3>& points, double epsilon, const Execution& execution) const
{
  ControlValues values = this->sampleField(points, execution);
  values.epsilon.assign(points.size(), epsilon);
  for (Vec3& gradient : values.gradient)
  {
    gradient = direction(gradient);
  }
  return values;
}

std::vector<double> ControlField::valuesAt(
  const std::vector<Vec3>& points, const Execution& execution) const
{
  return this->sampleField(points, execution).value;
}

void ControlField::limitAdvection(double timeStep, ControlValues& values) const
{
  if (!this->Field || !hasEdges(this->Options.fieldMode))
  {
    return;
  }
  const double cell = this->Field->grid().spacing.minCoeff();
  for (std::size_t i = 0; i < values.eta.size(); ++i)
  {
    const double fastest = cell / timeStep + cell * values.stiffness[i];
    values.eta[i] = std::clamp(values.eta[i], -fastest, fastest);
  }
}

} // namespace evolving
