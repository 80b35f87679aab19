// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "LabelSurfaces/LabelSurfaces.h"

#include "Checks/Refusal.h"
#include "Checks/SurfaceMeasures.h"
#include "LabelSurfaces/LabelImages.h"

#include <gtest/gtest.h>

#include <limits>

using namespace evolving;
using namespace evolving::testing_labels;

namespace
{

using Distance = std::function<double(const Vec3&)>;

Vec3 gradientOf(const Distance& distance, const Vec3& p)
{
  constexpr double Step = 1e-4;
  Vec3 gradient;
  for (int axis = 0; axis < 3; ++axis)
  {
    const Vec3 step = Step * Vec3::Unit(axis);
    gradient[axis] = distance(p + step) - distance(p - step);
  }
  return gradient.normalized();
}

struct Errors
{
  double normals = 0.0;  ///< root of the mean square, in degrees
  double distance = 0.0; ///< mean
};

/// Of faces that separate `label` from `other`, where the shape's distance is negative in `label`.
Errors errorsOf(const LabelSurfaces& result, const Distance& distance, Material label = 1,
  Material other = Background)
{
  Errors errors;
  double area = 0.0;
  for (Index face = 0; face < result.surfaces.faceCount(); ++face)
  {
    if (result.labels[at(face)] == label && result.others[at(face)] == other)
    {
      const Vec3 vectorArea = faceVectorArea(result.surfaces, face);
      const Vec3 middle = (result.surfaces.facePoint(face, 0) + result.surfaces.facePoint(face, 1) +
                            result.surfaces.facePoint(face, 2)) /
        3.0;
      const Vec3 exact = gradientOf(distance, middle);
      const double angle = std::atan2(vectorArea.cross(exact).norm(), vectorArea.dot(exact));
      errors.normals += vectorArea.norm() * angle * angle;
      errors.distance += vectorArea.norm() * std::abs(distance(middle));
      area += vectorArea.norm();
    }
  }
  errors.normals = std::sqrt(errors.normals / area) * 180.0 / M_PI;
  errors.distance /= area;
  return errors;
}

Distance toBall(Index size, double radius)
{
  return [=](const Vec3& p) { return (p - offCentre(size)).norm() - radius; };
}

double torus(const Vec3& p)
{
  const Vec3 d = p - offCentre(50);
  const double u = 0.8 * d.y() - 0.6 * d.z();
  const double w = 0.6 * d.y() + 0.8 * d.z();
  return std::hypot(std::hypot(d.x(), u) - 15.0, w) - 7.0;
}

/// To first order.
double ellipsoid(const Vec3& p)
{
  const Vec3 radii(20.0, 13.0, 9.0);
  const Vec3 scaled = (p - offCentre(46)).cwiseQuotient(radii);
  return (scaled.norm() - 1.0) * scaled.norm() / scaled.cwiseQuotient(radii).norm();
}

LabelImage imageOf(Index size, const Distance& distance)
{
  return labelsOf(size, [&](const Vec3& p) { return distance(p) < 0.0 ? 1 : 0; });
}

/// Is the corner of voxels that is nearest to a point one where labels differ?
bool isNearACorner(const LabelImage& image, const Vec3& point)
{
  const auto labelAt = [&](const Vec3& voxel) -> int
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      if (voxel[axis] < 0.0 || voxel[axis] >= image.sizes[static_cast<std::size_t>(axis)])
      {
        return 0;
      }
    }
    const double number = voxel[0] + image.sizes[0] * (voxel[1] + image.sizes[1] * voxel[2]);
    return image.materials[static_cast<std::size_t>(number)];
  };
  const Vec3 first = point.array().floor();
  for (int b = 1; b < 8; ++b)
  {
    if (labelAt(first + Vec3(b & 1, b >> 1 & 1, b >> 2)) != labelAt(first))
    {
      return true;
    }
  }
  return false;
}

} // namespace

TEST(LabelSurfaceGeometry, HasNoStairs)
{
  // The voxels' faces are off by 45 degrees and more.
  const Errors ofBall = errorsOf(labelSurfaces(ball(46, 20.0), {}), toBall(46, 20.0));
  EXPECT_LT(ofBall.normals, 1.8);
  EXPECT_LT(ofBall.distance, 0.05);
  const Errors ofTorus = errorsOf(labelSurfaces(imageOf(50, torus), {}), torus);
  EXPECT_LT(ofTorus.normals, 2.8);
  EXPECT_LT(ofTorus.distance, 0.06);
  const Errors ofEllipsoid = errorsOf(labelSurfaces(imageOf(46, ellipsoid), {}), ellipsoid);
  EXPECT_LT(ofEllipsoid.normals, 2.6);
  EXPECT_LT(ofEllipsoid.distance, 0.06);
  // Flat faces of one voxel on a ball of radius 5 are off by 3 degrees themselves.
  EXPECT_LT(errorsOf(labelSurfaces(ball(14, 5.0), {}), toBall(14, 5.0)).normals, 4.5);
}

TEST(LabelSurfaceGeometry, InterfacesBetweenLabelsAreAsSmooth)
{
  const LabelSurfaces result = labelSurfaces(cutBall(46, 20.0), {});
  const auto plane = [](const Vec3& p) { return (p - offCentre(46)).dot(CutNormal) - 1.0; };
  EXPECT_LT(errorsOf(result, toBall(46, 20.0), 1).normals, 2.0);
  EXPECT_LT(errorsOf(result, toBall(46, 20.0), 2).normals, 2.0);
  const Errors between = errorsOf(result, plane, 1, 2);
  EXPECT_LT(between.normals, 2.0);
  EXPECT_LT(between.distance, 0.05);

  const LabelSurfaces nested = labelSurfaces(ballInBall(46, 20.0, 10.0), {});
  EXPECT_LT(errorsOf(nested, toBall(46, 20.0), 1).normals, 1.8);
  EXPECT_LT(errorsOf(nested, toBall(46, 10.0), 2, 1).normals, 3.0);
}

TEST(LabelSurfaceGeometry, PointsStayWithinHalfAVoxelOfVoxelsFaces)
{
  for (const auto& [name, image] : allKinds())
  {
    SCOPED_TRACE(name);
    const LabelSurfaces smooth = labelSurfaces(image, { 4.0 });
    for (const Vec3& point : smooth.surfaces.points)
    {
      ASSERT_TRUE(isNearACorner(image, point)) << point.transpose();
    }
  }
  const LabelImage image = ball(30, 12.0);
  const SurfaceMesh faces = labelSurfaces(image, { 0.0 }).surfaces;
  const SurfaceMesh smooth = labelSurfaces(image, {}).surfaces;
  EXPECT_LT(checks::hausdorff(smooth, faces, 0.2), 0.5 * std::sqrt(3.0));
}

TEST(LabelSurfaceGeometry, EveryLabelHasTheVolumeOfItsVoxels)
{
  for (const auto& [name, image] : allKinds())
  {
    SCOPED_TRACE(name);
    EXPECT_LT(labelSurfaces(image, {}).largestVolumeError, 1e-5);
  }
  EXPECT_LT(labelSurfaces(sectors(40, 17.0), { 5.0 }).largestVolumeError, 1e-8);
}

TEST(LabelSurfaceGeometry, WithoutSmoothingItIsTheVoxelsFaces)
{
  const LabelSurfaces result = labelSurfaces(cutBall(20, 8.0), { 0.0 });
  for (const Vec3& point : result.surfaces.points)
  {
    EXPECT_EQ(point, Vec3((point.array() - 0.5).round() + 0.5));
  }
  for (std::size_t l = 0; l < result.volumes.size(); ++l)
  {
    EXPECT_NEAR(result.volumes[l], result.voxelVolumes[l], 1e-9);
  }
}

TEST(LabelSurfaceGeometry, IsClosedAndFlatWhereALabelRunsOutOfTheImage)
{
  // A ball that is cut by the side x = -0.5.
  const LabelImage image = labelsOf({ 16, 30, 30 },
    [](const Vec3& p) { return (p - Vec3(0.3, 14.2, 14.6)).norm() < 11.0 ? 1 : 0; });
  const LabelSurfaces result = labelSurfaces(image, {});
  double area = 0.0;
  for (Index face = 0; face < result.surfaces.faceCount(); ++face)
  {
    if (result.others[at(face)] == OutsideImage)
    {
      const Vec3 vectorArea = faceVectorArea(result.surfaces, face);
      EXPECT_LT(vectorArea.x(), 0.0);
      EXPECT_EQ(result.surfaces.facePoint(face, 0).x(), -0.5);
      area += vectorArea.norm();
    }
  }
  EXPECT_NEAR(area, M_PI * (11.0 * 11.0 - 0.8 * 0.8), 4.0);
  EXPECT_LT(result.largestVolumeError, 1e-8);
}

TEST(LabelSurfaceGeometry, GoesWithTheImage)
{
  const LabelImage image = sectors(20, 8.0);
  LabelImage turned = image;
  turned.toSpace.linear() =
    2.0 * Eigen::AngleAxisd(0.7, Vec3(1.0, 2.0, 3.0).normalized()).toRotationMatrix();
  turned.toSpace.linear().col(1) *= -1.0;
  turned.toSpace.translation() = Vec3(100.0, -30.0, 7.0);
  const LabelSurfaces result = labelSurfaces(image, {});
  const LabelSurfaces mirrored = labelSurfaces(turned, {});
  ASSERT_EQ(result.surfaces.vertexCount(), mirrored.surfaces.vertexCount());
  for (Index i = 0; i < result.surfaces.vertexCount(); ++i)
  {
    const Vec3 expected = turned.toSpace * result.surfaces.points[at(i)];
    EXPECT_LT((mirrored.surfaces.points[at(i)] - expected).norm(), 1e-4);
  }
  // Outwards again, and in units of space.
  EXPECT_NEAR(signedVolume(mirrored.surfaces), 8.0 * signedVolume(result.surfaces), 0.1);
  for (std::size_t l = 0; l < image.labelCount; ++l)
  {
    EXPECT_NEAR(mirrored.volumes[l], 8.0 * result.voxelVolumes[l], 1e-2);
  }
}

TEST(LabelSurfaceGeometry, PointsAreDoubleWhereFloatsCannotHoldThem)
{
  LabelImage image = ball(12, 4.0);
  EXPECT_TRUE(labelSurfaces(image, {}).pointsAreFloats);
  image.toSpace.translation() = Vec3(1e7, 0.0, 0.0);
  const LabelSurfaces result = labelSurfaces(image, {});
  EXPECT_FALSE(result.pointsAreFloats);
  EXPECT_NEAR(signedVolume(result.surfaces), result.voxelVolumes[0], 1e-3);
}

TEST(LabelSurfaceGeometry, RefusesALengthThatIsNone)
{
  for (const double length :
    { -1.0, std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity() })
  {
    EXPECT_NE(checks::refusalOf([&]() { labelSurfaces(ball(8, 3.0), { length }); })
                .find("SmoothingLength is"),
      std::string::npos);
  }
}
