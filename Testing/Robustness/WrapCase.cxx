// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "DataJudge.h"
#include "EvolutionJudge.h"
#include "FilterCase.h"
#include "OutputChecks.h"

#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkShrinkWrap.h"
#include "vtkTable.h"

#include <algorithm>

namespace robustness
{

namespace
{

class WrapCase : public FilterCase
{
public:
  WrapCase(const Subject& subject, Random& random)
    : FilterCase(subject, random)
  {
    this->draw(random);
    this->Filter->SetInputDataObject(subject.data);
  }

  vtkAlgorithm* filter() override { return this->Filter; }

  std::string whyRefuse() const override
  {
    if (this->Input.model.points.empty())
    {
      return "";
    }
    for (const char* name : { "TargetEdgeLength", "GapSize", "OffsetDistance" })
    {
      if (this->Parameters.isNaN(name))
      {
        return std::string(name) + " is NaN";
      }
    }
    return "";
  }

  bool mustAccept() const override
  {
    // Faces on a line have an area by the rounding of their corners.
    constexpr double LeastArea = 1e-10;
    const double area = areaOf(this->Input.joined);
    const bool hasExtent = this->Input.hasFaces
      ? area > LeastArea * this->Input.radius * this->Input.radius
      : this->Input.isUsable() && this->hasSurface();
    return this->Parameters.areSensible() && !this->IsCoarse && this->Input.isUsable() && hasExtent;
  }

  void judge(std::size_t warnings) override
  {
    vtkPolyData* result = this->Filter->GetOutput();
    const bool liesOnTarget =
      this->Filter->GetOffsetDistance() == 0.0 && this->Filter->GetGapSize() == 0.0;
    judgeWrap(this->Input, liesOnTarget, warnings, result);
    judgeWrappedData(this->Input, result);
    // MaxDistance and MinAngle of the finished surface mean the distance from where it should be,
    // and are measured anew.
    judgeHistory(vtkTable::SafeDownCast(this->Filter->GetOutputDataObject(1)), result,
      { "Time", "Area", "Volume" });
  }

private:
  /// Do four of the points span more than a line? Fewer, or points on a line, have no surface.
  bool hasSurface() const
  {
    const auto& points = this->Input.model.points;
    if (!this->Input.model.vertices.empty() || points.size() < 4)
    {
      return false;
    }
    Vec3 way = Vec3::Zero();
    for (const Vec3& point : points)
    {
      way = (point - points.front()).norm() > way.norm() ? Vec3(point - points.front()) : way;
    }
    constexpr double Wide = 1e-3; // of their extent
    return std::any_of(points.begin(), points.end(),
      [&](const Vec3& point)
      { return (point - points.front()).cross(way).norm() > Wide * way.squaredNorm(); });
  }

  /// The grid between points and around them.
  bool seesPoints(double size) const
  {
    constexpr int Fewest = 16;                                // six are around the points
    const int* samples = this->Filter->GetSampleDimensions(); // 0 is automatic
    return *std::min_element(samples, samples + 3) >= Fewest && this->Filter->GetGapSize() <= size;
  }

  void draw(Random& random)
  {
    const double size = this->Input.radius;
    const int samples = random.integer(12, 32);
    const bool isCube = random.chance(0.7);
    const auto side = [&]() { return isCube ? samples : random.integer(8, 32); };
    const bool isDefault = random.chance(0.02);
    if (!isDefault)
    {
      this->Filter->SetSampleDimensions(side(), side(), side());
    }
    this->IsCoarse = random.chance(0.1);
    const double length =
      this->IsCoarse ? random.logarithmic(0.2, 10.0) : random.logarithmic(0.05, 0.2);
    this->Filter->SetTargetEdgeLength(
      this->Parameters.number("TargetEdgeLength", isDefault ? 0.0 : length * size));
    this->Filter->SetGapSize(this->Parameters.rate("GapSize", 0.2, 0.01 * size, 2.0 * size));
    this->Filter->SetOffsetDistance(
      this->Parameters.rate("OffsetDistance", 0.15, 0.01 * size, 0.5 * size));
    this->IsCoarse = this->IsCoarse || (!this->Input.hasFaces && !this->seesPoints(size));
    this->Filter->SetFeatureAngle(
      this->Parameters.number("FeatureAngle", random.chance(0.7) ? 45.0 : random.real(0.0, 180.0)));
    this->Filter->SetStart(
      random.chance(0.2) ? vtkShrinkWrap::ICOSPHERE : vtkShrinkWrap::ISOSURFACE);
    this->Filter->SetAdaptToCurvature(random.chance(0.3));
    this->Filter->SetPreserveFeatures(random.integer(0, 2));
    this->Filter->SetOutputSteps(random.chance(0.1));
    this->Filter->SetNumberOfSteps(random.chance(0.7) ? 0 : random.integer(1, 20));
    if (!isDefault && random.chance(0.1))
    {
      this->Filter->SetTargetEdgeLength(0.0);
      this->Filter->SetTargetNumberOfPoints(random.integer(100, 3000));
      this->Filter->SetSampleDimensions(0, 0, 0);
      this->IsCoarse = true;
    }
  }

  vtkNew<vtkShrinkWrap> Filter;
  bool IsCoarse = false; ///< then it may be refused
};

} // namespace

std::unique_ptr<FilterCase> makeWrapCase(const Subject& subject, Random& random)
{
  return std::make_unique<WrapCase>(subject, random);
}

} // namespace robustness
