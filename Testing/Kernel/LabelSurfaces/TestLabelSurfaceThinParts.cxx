// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "LabelSurfaces/LabelSurfaces.h"

#include "LabelSurfaces/LabelImages.h"
#include "Mesh/Angles.h"

#include <gtest/gtest.h>

using namespace evolving;
using namespace evolving::testing_labels;

namespace
{

/// The smallest width, along y and z, of the surface near any x between two.
double smallestWidth(const SurfaceMesh& surface, double first, double last)
{
  double smallest = 1e9;
  for (double x = first; x <= last; x += 1.0)
  {
    Box box;
    for (const Vec3& point : surface.points)
    {
      if (std::abs(point.x() - x) <= 0.75)
      {
        box.extend(point);
      }
    }
    smallest = std::min({ smallest, box.sizes().y(), box.sizes().z() });
  }
  return smallest;
}

double smallestAngle(const SurfaceMesh& surface)
{
  double smallest = M_PI;
  for (Index face = 0; face < surface.faceCount(); ++face)
  {
    for (Index k = 0; k < 3; ++k)
    {
      const Vec3& a = surface.facePoint(face, k);
      smallest = std::min(smallest,
        angleBetween(Vec3(surface.facePoint(face, (k + 1) % 3) - a),
          Vec3(surface.facePoint(face, (k + 2) % 3) - a)));
    }
  }
  return smallest * 180.0 / M_PI;
}

bool isInThread(const Vec3& p)
{
  return p.y() == 10.0 && p.z() == 10.0 && p.x() >= 3.0 && p.x() <= 24.0;
}

} // namespace

TEST(LabelSurfaceThinParts, AThreadOfOneVoxelStaysAThread)
{
  const LabelSurfaces alone =
    labelSurfaces(labelsOf(28, [](const Vec3& p) { return isInThread(p) ? 1 : 0; }), {});
  EXPECT_GT(smallestWidth(alone.surfaces, 6.0, 21.0), 0.9);
  // At a ball it is half as thick at least, though the ball has volume enough for both.
  const LabelSurfaces atBall = labelSurfaces(labelsOf(28,
                                               [](const Vec3& p)
                                               {
                                                 const Vec3 centre(6.0, 10.0, 10.0);
                                                 return isInThread(p) || (p - centre).norm() < 5.0;
                                               }),
    {});
  EXPECT_GT(smallestWidth(atBall.surfaces, 13.0, 23.0), 0.45);
}

TEST(LabelSurfaceThinParts, ASheetOfOneVoxelStaysASheet)
{
  const LabelSurfaces result = labelSurfaces(
    labelsOf(24,
      [](const Vec3& p)
      { return p.z() == 11.0 && p.x() > 2.0 && p.x() < 20.0 && p.y() > 2.0 && p.y() < 20.0; }),
    {});
  for (const Vec3& point : result.surfaces.points)
  {
    EXPECT_GT(std::abs(point.z() - 11.0), 0.24);
  }
  EXPECT_GT(smallestAngle(result.surfaces), 20.0);
}

TEST(LabelSurfaceThinParts, OneVoxelStaysWhatItIs)
{
  const LabelSurfaces result = labelSurfaces(voxels(3, { { 1, 1, 1 } }), {});
  for (const Vec3& point : result.surfaces.points)
  {
    EXPECT_LT((point - Vec3::Ones()).cwiseAbs().maxCoeff(), 0.51);
    EXPECT_GT((point - Vec3::Ones()).cwiseAbs().minCoeff(), 0.49);
  }
}

TEST(LabelSurfaceThinParts, ElementsOfSmoothShapesAreGood)
{
  EXPECT_GT(smallestAngle(labelSurfaces(ball(40, 17.0), {}).surfaces), 25.0);
}
