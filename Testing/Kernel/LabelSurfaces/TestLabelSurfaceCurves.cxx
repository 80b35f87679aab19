// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

// Curves where three labels meet, against those of bodies cut by planes.

#include "LabelSurfaces/LabelImages.h"
#include "LabelSurfaces/LabelSurfaces.h"
#include "Mesh/Angles.h"

#include <Eigen/Dense>
#include <gtest/gtest.h>

#include <map>
#include <set>

using namespace evolving;
using namespace evolving::testing_labels;

namespace
{

using Distance = std::function<double(const Vec3&)>;

constexpr Index Size = 46;

/// A body cut into labels, by what bounds it and what separates two labels.
struct CutBody
{
  std::string name;
  Distance outside;
  std::map<std::array<int, 2>, Distance> between;
  std::function<int(const Vec3&)> label;
};

/// To first order; all radii 20 make a ball.
Distance ellipsoid(const Vec3& radii)
{
  return [=](const Vec3& p)
  {
    const Vec3 scaled = (p - offCentre(Size)).cwiseQuotient(radii);
    return (scaled.norm() - 1.0) * scaled.norm() / scaled.cwiseQuotient(radii).norm();
  };
}

CutBody halves(const std::string& name, const Vec3& radii, const Vec3& way, double offset)
{
  CutBody body{ name, ellipsoid(radii), {}, {} };
  const Vec3 normal = way.normalized();
  const Distance plane = [=](const Vec3& p) { return (p - offCentre(Size)).dot(normal) - offset; };
  body.between[{ 1, 2 }] = plane;
  body.label = [=, outside = body.outside](const Vec3& p) {
    return outside(p) >= 0.0 ? 0 : plane(p) < 0.0 ? 1 : 2;
  };
  return body;
}

/// Three labels around an axis.
CutBody thirds(
  const std::string& name, const Vec3& radii, const Vec3& way, const std::array<double, 3>& degrees)
{
  CutBody body{ name, ellipsoid(radii), {}, {} };
  const Vec3 axis = way.normalized();
  const Vec3 u = axis.unitOrthogonal();
  const Vec3 v = axis.cross(u);
  std::array<double, 3> begin{};
  double angle = 0.3;
  for (std::size_t i = 0; i < 3; ++i)
  {
    begin[i] = angle;
    const Vec3 normal = std::cos(angle) * v - std::sin(angle) * u;
    const int own = static_cast<int>(i) + 1;
    const int before = own == 1 ? 3 : own - 1;
    body.between[{ std::min(own, before), std::max(own, before) }] = [=](const Vec3& p)
    { return (p - offCentre(Size)).dot(normal); };
    angle += degrees[i] * RadiansPerDegree;
  }
  body.label = [=, outside = body.outside](const Vec3& p)
  {
    const Vec3 d = p - offCentre(Size);
    double at = std::atan2(d.dot(v), d.dot(u));
    at += at < begin[0] ? 2.0 * M_PI : 0.0;
    return outside(p) >= 0.0 ? 0 : at < begin[1] ? 1 : at < begin[2] ? 2 : 3;
  };
  return body;
}

/// The distance of a point to where all functions are zero, by Newton's method.
double distanceToAll(const std::vector<Distance>& functions, const Vec3& point)
{
  Vec3 place = point;
  for (int round = 0; round < 10; ++round)
  {
    Eigen::MatrixXd gradients(functions.size(), 3);
    Eigen::VectorXd values(functions.size());
    for (std::size_t i = 0; i < functions.size(); ++i)
    {
      const auto row = static_cast<Eigen::Index>(i);
      values[row] = functions[i](place);
      for (int axis = 0; axis < 3; ++axis)
      {
        const Vec3 step = 1e-5 * Vec3::Unit(axis);
        gradients(row, axis) = (functions[i](place + step) - functions[i](place - step)) / 2e-5;
      }
    }
    // Three planes through one axis are two.
    place -= gradients.jacobiSvd(Eigen::ComputeThinU | Eigen::ComputeThinV)
               .setThreshold(1e-3)
               .solve(values);
  }
  return (place - point).norm();
}

/// What the labels that meet at every vertex of the interfaces are.
std::vector<std::set<int>> labelsAt(const LabelSurfaces& result)
{
  std::vector<std::set<int>> labels(result.interfaces.points.size());
  for (Index face = 0; face < result.interfaces.faceCount(); ++face)
  {
    for (Index k = 0; k < 3; ++k)
    {
      labels[at(result.interfaces.faceVertex(face, k))].insert(
        result.sides[at(face)].begin(), result.sides[at(face)].end());
    }
  }
  return labels;
}

struct Errors
{
  double rms = 0.0;
  double most = 0.0;
};

/// Of the vertices at which just three labels, or background, meet.
Errors errorsOf(const CutBody& body, const LabelSurfaces& result)
{
  const std::vector<std::set<int>> labels = labelsAt(result);
  Errors errors;
  double count = 0.0;
  for (std::size_t i = 0; i < labels.size(); ++i)
  {
    if (labels[i].size() != 3)
    {
      continue;
    }
    std::vector<Distance> functions;
    if (labels[i].count(0) > 0)
    {
      functions.push_back(body.outside);
    }
    for (const auto& [pair, between] : body.between)
    {
      if (labels[i].count(pair[0]) > 0 && labels[i].count(pair[1]) > 0)
      {
        functions.push_back(between);
      }
    }
    const double distance = distanceToAll(functions, result.interfaces.points[i]);
    errors.rms += distance * distance;
    errors.most = std::max(errors.most, distance);
    count += 1.0;
  }
  errors.rms = std::sqrt(errors.rms / count);
  return errors;
}

/// Of all elements the smallest angles, ascending, in degrees.
std::vector<double> smallestAngles(const SurfaceMesh& mesh)
{
  std::vector<double> angles;
  for (Index face = 0; face < mesh.faceCount(); ++face)
  {
    double smallest = M_PI;
    for (Index k = 0; k < 3; ++k)
    {
      const Vec3& own = mesh.facePoint(face, k);
      smallest = std::min(smallest,
        angleBetween(Vec3(mesh.facePoint(face, (k + 1) % 3) - own),
          Vec3(mesh.facePoint(face, (k + 2) % 3) - own)));
    }
    angles.push_back(smallest * DegreesPerRadian);
  }
  std::sort(angles.begin(), angles.end());
  return angles;
}

/// At general orientations: a plane along the grid may lie anywhere between its voxels.
std::vector<CutBody> bodies()
{
  const Vec3 ball = Vec3::Constant(20.0);
  const Vec3 radii(20.0, 13.0, 9.0);
  return { halves("ball, (.48, .6, .64)", ball, CutNormal, 1.0),
    halves("ball, (1, 1, 1)", ball, Vec3(1.0, 1.0, 1.0), 0.2),
    halves("ball, off its middle", ball, Vec3(0.3, -0.5, 0.8), 8.0),
    halves("ball, along the grid", ball, Vec3(0.0, 0.0, 1.0), 1.3),
    halves("ellipsoid, (.3, .8, -.4)", radii, Vec3(0.3, 0.8, -0.4), 2.0),
    halves("ellipsoid, (.9, .1, .3)", radii, Vec3(0.9, 0.1, 0.3), -1.0),
    thirds("thirds, (.3, .5, .8)", ball, Vec3(0.3, 0.5, 0.8), { 120.0, 120.0, 120.0 }),
    thirds("thirds, (-.7, .2, .4)", ball, Vec3(-0.7, 0.2, 0.4), { 90.0, 180.0, 90.0 }),
    thirds("thirds, (.1, .9, -.4)", Vec3(20.0, 15.0, 18.0), Vec3(0.1, 0.9, -0.4),
      { 100.0, 120.0, 140.0 }) };
}

} // namespace

TEST(LabelSurfaceCurves, LieWhereTheBodiesMeet)
{
  for (const CutBody& body : bodies())
  {
    SCOPED_TRACE(body.name);
    const LabelSurfaces result = labelSurfaces(labelsOf(Size, body.label), {});
    const Errors errors = errorsOf(body, result);
    EXPECT_LT(errors.rms, 0.1);
    EXPECT_LT(errors.most, 0.4);
    EXPECT_LT(result.largestVolumeError, 1e-6);
  }
}

TEST(LabelSurfaceCurves, HaveGoodElements)
{
  for (const CutBody& body : bodies())
  {
    SCOPED_TRACE(body.name);
    const LabelSurfaces result = labelSurfaces(labelsOf(Size, body.label), {});
    const std::vector<double> angles = smallestAngles(result.interfaces);
    EXPECT_GT(angles[angles.size() / 1000], 25.0);
    EXPECT_GT(angles[angles.size() / 100], 33.0);
  }
}

TEST(LabelSurfaceCurves, ACurveInAPlaneOfTheGridIsAsSmoothAsTheBall)
{
  const CutBody body = halves("", Vec3::Constant(20.0), Vec3(0.0, 0.0, 1.0), 1.3);
  const Errors errors = errorsOf(body, labelSurfaces(labelsOf(Size, body.label), {}));
  EXPECT_LT(errors.rms, 0.06);
  EXPECT_LT(errors.most, 0.2);
}
