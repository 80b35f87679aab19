// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "LabelSurfaces/LabelSurfaces.h"

#include "Checks/ClosedSurface.h"
#include "LabelSurfaces/LabelImages.h"
#include "Mesh/SelfIntersections.h"
#include "ThreadedExecution.h"

#include <gtest/gtest.h>

#include <map>

using namespace evolving;
using namespace evolving::testing_labels;

namespace
{

/// The points of a face, turned so that the smallest is the first.
using Corners = std::array<std::array<double, 3>, 3>;

Corners cornersOf(const SurfaceMesh& mesh, Index face, bool reversed)
{
  Corners corners{};
  for (Index k = 0; k < 3; ++k)
  {
    const Vec3& p = mesh.facePoint(face, reversed ? 2 - k : k);
    corners[at(k)] = { p.x(), p.y(), p.z() };
  }
  std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
  return corners;
}

/// The surface of one label.
SurfaceMesh surfaceOf(const LabelSurfaces& result, Material label)
{
  SurfaceMesh mesh;
  mesh.points = result.surfaces.points;
  for (Index face = 0; face < result.surfaces.faceCount(); ++face)
  {
    if (result.labels[at(face)] == label)
    {
      mesh.addFace({ result.surfaces.faceVertex(face, 0), result.surfaces.faceVertex(face, 1),
        result.surfaces.faceVertex(face, 2) });
    }
  }
  return mesh;
}

double totalOf(const std::vector<double>& values)
{
  double sum = 0.0;
  for (const double value : values)
  {
    sum += value;
  }
  return sum;
}

} // namespace

TEST(LabelSurfaceTopology, EveryLabelHasAClosedManifoldThatPointsOutwards)
{
  for (const auto& [name, image] : allKinds())
  {
    SCOPED_TRACE(name);
    for (const double length : { 0.0, 2.0 })
    {
      const LabelSurfaces result = labelSurfaces(image, { length });
      checks::expectClosedManifold(result.surfaces);
      ASSERT_EQ(result.volumes.size(), image.labelCount);
      for (std::size_t l = 0; l < image.labelCount; ++l)
      {
        const SurfaceMesh one = surfaceOf(result, static_cast<Material>(l + 1));
        const double voxels = result.voxelVolumes[l];
        EXPECT_NEAR(one.faceCount() > 0 ? signedVolume(one) : 0.0, voxels, 1e-4 * voxels + 1e-9);
      }
    }
  }
}

TEST(LabelSurfaceTopology, SmoothingKeepsItLabelByLabel)
{
  for (const auto& [name, image] : allKinds())
  {
    SCOPED_TRACE(name);
    const LabelSurfaces smooth = labelSurfaces(image, {});
    const LabelSurfaces faces = labelSurfaces(image, { 0.0 });
    for (std::size_t l = 0; l < image.labelCount; ++l)
    {
      const auto label = static_cast<Material>(l + 1);
      const TopologySummary found = summarizeTopology(surfaceOf(smooth, label));
      const TopologySummary expected = summarizeTopology(surfaceOf(faces, label));
      EXPECT_EQ(found.components, expected.components);
      EXPECT_EQ(found.eulerCharacteristic(), expected.eulerCharacteristic());
    }
  }
}

TEST(LabelSurfaceTopology, LabelsThatTouchHaveTheSameTriangles)
{
  for (const auto& [name, image] : allKinds())
  {
    SCOPED_TRACE(name);
    const LabelSurfaces result = labelSurfaces(image, {});
    std::map<std::pair<Material, Corners>, Material> others;
    for (Index face = 0; face < result.surfaces.faceCount(); ++face)
    {
      others[{ result.labels[at(face)], cornersOf(result.surfaces, face, true) }] =
        result.others[at(face)];
    }
    for (Index face = 0; face < result.surfaces.faceCount(); ++face)
    {
      const Material other = result.others[at(face)];
      if (isLabel(other))
      {
        const auto found = others.find({ other, cornersOf(result.surfaces, face, false) });
        ASSERT_NE(found, others.end());
        EXPECT_EQ(found->second, result.labels[at(face)]);
      }
    }
  }
}

TEST(LabelSurfaceTopology, InterfacesDoNotIntersect)
{
  for (const auto& [name, image] : allKinds())
  {
    SCOPED_TRACE(name);
    const LabelSurfaces result = labelSurfaces(image, {});
    EXPECT_TRUE(selfIntersections(result.interfaces).empty());
    ASSERT_EQ(at(result.interfaces.faceCount()), result.sides.size());
    for (const auto& sides : result.sides)
    {
      EXPECT_TRUE(isInterface(sides[0], sides[1]));
    }
  }
}

TEST(LabelSurfaceTopology, VoxelsThatMeetByAnEdgeOrACornerAreApart)
{
  for (const auto& second : { std::array<int, 3>{ 2, 2, 1 }, std::array<int, 3>{ 2, 2, 2 } })
  {
    const LabelSurfaces result = labelSurfaces(voxels(4, { { 1, 1, 1 }, second }), { 0.0 });
    EXPECT_EQ(result.surfaces.vertexCount(), 16);
    EXPECT_EQ(summarizeTopology(result.surfaces).components, 2);
  }
}

TEST(LabelSurfaceTopology, AnEdgeThatALabelPassesTwiceIsSplit)
{
  const LabelImage image = allKinds()[8].image;
  const LabelSurfaces result = labelSurfaces(image, { 0.0 });
  const auto isMiddle = [](const Vec3& p) { return p == Vec3(1.5, 1.5, 2.0); };
  const auto& points = result.surfaces.points;
  EXPECT_EQ(std::count_if(points.begin(), points.end(), isMiddle), 2);
}

TEST(LabelSurfaceTopology, ThreadsGiveTheSameBits)
{
  for (const auto& image : { sectors(30, 12.0), randomLabels(12, 4, 7) })
  {
    const LabelSurfaces one = labelSurfaces(image, {});
    for (const int threads : { 2, 8 })
    {
      const LabelSurfaces many =
        labelSurfaces(image, {}, threadedExecution(threads, static_cast<unsigned>(threads)));
      EXPECT_TRUE(one.surfaces == many.surfaces);
      EXPECT_TRUE(one.interfaces == many.interfaces);
      EXPECT_EQ(one.volumes, many.volumes);
    }
  }
}

TEST(LabelSurfaceTopology, AnImageOfBackgroundHasNoSurface)
{
  const LabelSurfaces result = labelSurfaces(labelsOf(4, [](const Vec3&) { return 0; }), {});
  EXPECT_EQ(result.surfaces.faceCount(), 0);
  EXPECT_EQ(result.interfaces.faceCount(), 0);
  EXPECT_EQ(totalOf(result.volumes), 0.0);
}
