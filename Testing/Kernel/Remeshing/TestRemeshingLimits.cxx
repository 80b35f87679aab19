// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Mesh/MeshQuality.h"
#include "Mesh/MeshTopology.h"
#include "Mesh/SelfIntersections.h"
#include "Remeshing/CurvedReference.h"
#include "Remeshing/EditingChecks.h"
#include "Remeshing/PeakFit.h"
#include "Remeshing/Remeshing.h"
#include "Remeshing/RemeshingShapes.h"
#include "Remeshing/StarOptimization.h"
#include "Remeshing/SurfaceFit.h"
#include "Remeshing/TargetSamples.h"
#include "Shapes/Sheets.h"
#include "Shapes/Spheres.h"
#include "Trees/AABBTree.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <vector>

namespace
{

using namespace evolving;
using namespace evolving::editing;

double farthestBetween(const SurfaceMesh& from, const SurfaceMesh& to)
{
  // Each boundary as triangles that are segments.
  const auto boundary = [](const SurfaceMesh& mesh)
  {
    SurfaceMesh segments;
    segments.points = mesh.points;
    const MeshTopology topology(mesh);
    for (const std::vector<Index>& loop : topology.boundaryLoops())
    {
      for (std::size_t i = 0; i < loop.size(); ++i)
      {
        const Index next = loop[(i + 1) % loop.size()];
        segments.addFace({ loop[i], next, next });
      }
    }
    return segments;
  };
  const AABBTree tree(boundary(to));
  const SurfaceMesh segments = boundary(from);
  double squared = 0.0;
  for (Index s = 0; s < segments.faceCount(); ++s)
  {
    for (int i = 0; i <= 4; ++i)
    {
      const Vec3 p =
        (1.0 - 0.25 * i) * segments.facePoint(s, 0) + 0.25 * i * segments.facePoint(s, 1);
      squared = std::max(squared, tree.closest(p).at.squaredDistance);
    }
  }
  return std::sqrt(squared);
}

TEST(Remeshing, KeepsABoundaryCurve)
{
  for (const double size : { 0.05, 0.1, 0.2 })
  {
    for (const SurfaceMesh& mesh :
      { shapes::halfSphere(16), shapes::disc(16), shapes::shakenSheet(16, true, 0.2, 1) })
    {
      const CurvedReference reference(mesh);
      EditableSurface surface = shapes::sized(mesh, size);
      for (int pass = 0; pass < 6; ++pass)
      {
        remeshOnce(surface, reference, {});
      }
      expectSound(surface, { 1, 1, 1 });
      EXPECT_TRUE(selfIntersections(surface.mesh()).empty());
      EXPECT_GT(smallestAngle(surface.mesh()), 20.0);
      EXPECT_LT(farthestBetween(surface.mesh(), mesh), 0.1 * size);
      EXPECT_LT(farthestBetween(mesh, surface.mesh()), 0.2 * size);
    }
  }
}

std::set<std::array<Place, 3>> lockedFaces(const EditableSurface& surface)
{
  std::set<std::array<Place, 3>> faces;
  for (Index f = 0; f < surface.faceSlots(); ++f)
  {
    if (surface.hasFace(f) && surface.isLockedFace(f))
    {
      std::array<Place, 3> face = { placeOf(surface.corner(f, 0)), placeOf(surface.corner(f, 1)),
        placeOf(surface.corner(f, 2)) };
      std::rotate(face.begin(), std::min_element(face.begin(), face.end()), face.end());
      faces.insert(face);
    }
  }
  return faces;
}

TEST(Remeshing, NothingChangesALockedFace)
{
  const SurfaceMesh target = shapes::bumpySphere(4);
  const OffsetReference reference(target, 0.0);
  EditableSurface surface = shapes::sized(shapes::shakenSphere(3, 0.3, 4), 0.1);
  for (const Index v : verticesOf(surface))
  {
    if (surface.point(v).z() > 0.2)
    {
      surface.setLocked(v);
    }
  }
  const auto before = lockedFaces(surface);
  ASSERT_GT(before.size(), 300U);
  remeshOnce(surface, reference, {});
  remeshOnce(surface, reference, {});
  polishOnce(surface, reference, {});
  optimizeStars(surface, reference, 50.0, 2);
  fitToReference(surface, reference, { 2, 1.0, 0.5 });
  fitPeaks(surface, reference, samplesOf(target, 0.05), {});
  const auto after = lockedFaces(surface);
  EXPECT_TRUE(std::includes(after.begin(), after.end(), before.begin(), before.end()));
}

} // namespace
