// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Evolution/ControlFunctions.h"

#include "Evolution/EdgeDetector.h"
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
  if (options.fieldMode == FieldMode::EdgeDetector && options.edgeSharpness > 0.0)
  {
    this->Field = std::make_shared<const ScalarImage>(
      edgeDetector(*this->Field, options.edgeSharpness, execution));
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
    const bool isEdgeDetector = this->Options.fieldMode == FieldMode::EdgeDetector;
    values.value.resize(points.size());
    values.gradient.resize(points.size());
    forEachIndex(execution, static_cast<std::int64_t>(points.size()),
      [&](Index i)
      {
        const ScalarImage::Sample sample = isEdgeDetector
          ? sampleEdgeDetector(*this->Field, points[at(i)])
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

ControlValues ControlField::evaluate(const std::vector<Vec3>& points,
  const std::vector<Vec3>& normals, const Execution& execution) const
{
  ControlValues values = this->sampleField(points, execution);
  if (!this->Field)
  {
    return values;
  }
  const FlowOptions& o = this->Options;
  forEachIndex(execution, static_cast<std::int64_t>(points.size()),
    [&](Index i)
    {
      const double value = values.value[at(i)];
      const Vec3 gradient = values.gradient[at(i)];
      values.gradient[at(i)] = direction(gradient);
      if (o.fieldMode == FieldMode::EdgeDetector)
      {
        values.epsilon[at(i)] = std::max(0.0, o.curvatureSpeed * value);
        values.eta[at(i)] = -o.advectionSpeed * gradient.dot(normals[at(i)]);
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
  if (this->Field && this->Options.fieldMode == FieldMode::EdgeDetector)
  {
    const double fastest = this->Field->grid().spacing.minCoeff() / timeStep;
    for (double& eta : values.eta)
    {
      eta = std::clamp(eta, -fastest, fastest);
    }
  }
}

} // namespace evolving
