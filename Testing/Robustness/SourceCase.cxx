// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "FilterCase.h"
#include "OutputChecks.h"

#include "vtkIcosphereSource.h"
#include "vtkNew.h"
#include "vtkPolyData.h"

#include <cmath>

namespace robustness
{

namespace
{

/// vtkIcosphereSource takes no input: its parameters are all there is.
class SourceCase : public FilterCase
{
public:
  SourceCase(const Subject& subject, Random& random)
    : FilterCase(subject, random)
  {
    this->Filter->SetShape(random.integer(0, 2));
    this->Filter->SetLevel(random.integer(0, 4));
    this->Filter->SetResolution(random.integer(1, 30));
    this->Filter->SetRadius(
      this->Parameters.number("Radius", random.chance(0.5) ? 1.0 : random.logarithmic(1e-9, 1e9)));
    const double far = random.chance(0.5) ? 0.0 : random.logarithmic(0.1, 1e3);
    const Vec3 centre = far * this->Filter->GetRadius() * random.direction();
    this->Filter->SetCenter(this->Parameters.number("Center", centre.x()), centre.y(), centre.z());
    this->Filter->SetOutputPointsPrecision(random.integer(0, 1));
  }

  vtkAlgorithm* filter() override { return this->Filter; }
  std::string whyRefuse() const override
  {
    return this->Parameters.isNaN("Radius") || this->Parameters.isNaN("Center")
      ? "Radius or Center is NaN"
      : "";
  }
  bool mustAccept() const override { return this->Parameters.areSensible(); }
  bool mayBeEmpty() const override { return false; }

  void judge(std::size_t) override
  {
    const Surface surface = surfaceOf(this->Filter->GetOutput());
    requireUsableFaces(surface);
    const Topology topology = topologyOf(surface);
    requireClosed(topology);
    requireOutward(this->asUnit(surface));
    require(topology.genus() == 0 && topology.components == 1, Fault::NotManifold, "the genus is ",
      topology.genus());
    const int n = this->Filter->GetResolution();
    const bool isIcosphere = this->Filter->GetShape() == vtkIcosphereSource::ICOSPHERE;
    const double expected =
      isIcosphere ? 10.0 * std::pow(4.0, this->Filter->GetLevel()) + 2.0 : 6.0 * n * n + 2.0;
    requireStated("number of points", double(surface.points.size()), expected, 0.0);
    if (this->Filter->GetShape() != vtkIcosphereSource::BOX)
    {
      this->judgeRadius(surface);
    }
  }

private:
  /// Of the smallest radii the volume would not be a number above 0.
  Surface asUnit(Surface surface)
  {
    const Vec3 centre(this->Filter->GetCenter());
    for (Vec3& point : surface.points)
    {
      point = (point - centre) / this->Filter->GetRadius();
    }
    return surface;
  }

  void judgeRadius(const Surface& surface)
  {
    const Vec3 centre(this->Filter->GetCenter());
    const double radius = this->Filter->GetRadius();
    const bool isDouble =
      this->Filter->GetOutputPointsPrecision() == vtkAlgorithm::DOUBLE_PRECISION;
    const double unit = isDouble ? 1e-15 : 1.2e-7;
    for (const Vec3& point : surface.points)
    {
      requireStated(
        "radius", (point - centre).stableNorm(), radius, 4.0 * unit * (radius + centre.norm()));
    }
  }

  vtkNew<vtkIcosphereSource> Filter;
};

} // namespace

std::unique_ptr<FilterCase> makeSourceCase(const Subject& subject, Random& random)
{
  return std::make_unique<SourceCase>(subject, random);
}

} // namespace robustness
