// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Mesh/SurfaceMesh.h"

#include "Checks/Refusal.h"
#include "Errors.h"
#include "Mesh/Angles.h"
#include "Mesh/TopologySummary.h"
#include "Shapes/MeshVariants.h"
#include "Shapes/Polyhedra.h"
#include "Shapes/Tubes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <string>

namespace evolving
{

using namespace evolving::shapes;

namespace
{

std::string messageOf(const SurfaceMesh& mesh)
{
  return checks::refusalOf([&] { validate(mesh); });
}

/// The first quadrant of an L: six corners, the fourth one concave; area 3.
SurfaceMesh letterL()
{
  return makeMesh({ { 0, 0, 0 }, { 2, 0, 0 }, { 2, 1, 0 }, { 1, 1, 0 }, { 1, 2, 0 }, { 0, 2, 0 } },
    { { 0, 1, 2, 3, 4, 5 } });
}

TEST(SurfaceMesh, EmptyMeshHasZeroMeasures)
{
  const SurfaceMesh empty;
  EXPECT_EQ(empty.vertexCount(), 0);
  EXPECT_EQ(empty.faceCount(), 0);
  EXPECT_EQ(empty.cornerCount(), 0);
  EXPECT_TRUE(boundingBox(empty).isEmpty());
  EXPECT_EQ(surfaceArea(empty), 0.0);
  EXPECT_EQ(signedVolume(empty), 0.0);
  EXPECT_EQ(weldCoincidentPoints(empty).vertexCount(), 0);
  EXPECT_NO_THROW(validate(empty));
}

TEST(SurfaceMesh, PointsWithoutFacesHaveABoxAndNoVolume)
{
  const SurfaceMesh points = makeMesh({ { 1, 2, 3 }, { -1, 5, 3 } }, {});
  EXPECT_EQ(boundingBox(points).min(), Vec3(-1, 2, 3));
  EXPECT_EQ(boundingBox(points).max(), Vec3(1, 5, 3));
  EXPECT_EQ(signedVolume(points), 0.0);
  EXPECT_NO_THROW(validate(points));
}

TEST(SurfaceMesh, BoxIgnoresUnusedPoints)
{
  SurfaceMesh mesh = cornerTetrahedron();
  mesh.addPoint({ 100, 100, 100 });
  EXPECT_EQ(boundingBox(mesh).max(), Vec3(1, 1, 1));
}

TEST(SurfaceMesh, FacesKeepTheirOrder)
{
  const SurfaceMesh mesh = makeMesh(
    { { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 } }, { { 0, 1, 2, 3 }, { 3, 2, 0 } });
  EXPECT_EQ(mesh.faceSize(0), 4);
  EXPECT_EQ(mesh.faceSize(1), 3);
  EXPECT_EQ(mesh.faceVertex(1, 0), 3);
  EXPECT_EQ(mesh.facePoint(1, 1), Vec3(1, 1, 0));
  EXPECT_FALSE(mesh.hasOnlyTriangles());
  EXPECT_TRUE(cornerTetrahedron().hasOnlyTriangles());
}

TEST(SurfaceMesh, VolumeAndAreaOfTetrahedronAndCube)
{
  EXPECT_NEAR(signedVolume(cornerTetrahedron()), 1.0 / 6.0, 1e-15);
  EXPECT_NEAR(surfaceArea(cornerTetrahedron()), 1.5 + std::sqrt(3.0) / 2.0, 1e-15);
  EXPECT_NEAR(signedVolume(unitCube()), 1.0, 1e-15);
  EXPECT_NEAR(surfaceArea(unitCube()), 6.0, 1e-15);
}

TEST(SurfaceMesh, VolumeChangesSignWithOrientation)
{
  EXPECT_NEAR(signedVolume(reversed(unitCube())), -1.0, 1e-15);
}

TEST(SurfaceMesh, VolumeOfTorusConvergesToPappus)
{
  double lastError = 0.0;
  for (const Index n : { 24, 48, 96 })
  {
    const double error = 2.0 * Pi * Pi * 2.0 * 0.25 - signedVolume(quadTorus(2 * n, n, 2.0, 0.5));
    if (lastError > 0.0)
    {
      EXPECT_NEAR(lastError / error, 4.0, 0.05) << "second order";
    }
    lastError = error;
    EXPECT_GT(error, 0.0);
  }
}

/// Two tetrahedra of a millionth of the distance between them.
TEST(SurfaceMesh, VolumeIsThatOfSmallPartsFarApart)
{
  SurfaceMesh mesh;
  for (const double x : { 0.0, 1.0 })
  {
    const Index first = mesh.vertexCount();
    for (const Vec3& corner : { Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1) })
    {
      mesh.addPoint(Vec3(x, 0.3 * x, 0.0) + 0x1p-20 * corner);
    }
    mesh.addFace({ first, first + 2, first + 1 });
    mesh.addFace({ first, first + 1, first + 3 });
    mesh.addFace({ first, first + 3, first + 2 });
    mesh.addFace({ first + 1, first + 2, first + 3 });
  }
  const double volume = 2.0 * 0x1p-60 / 6.0;
  EXPECT_NEAR(signedVolume(mesh), volume, 1e-8 * volume);
}

TEST(SurfaceMesh, MeasuresDoNotDependOnPlaceOrRotation)
{
  std::mt19937 generator(11);
  const SurfaceMesh shape = quadTorus(12, 9, 2.0, 0.5);
  const SurfaceMesh turned = mapped(shape, randomRotation(generator));
  EXPECT_NEAR(signedVolume(turned), signedVolume(shape), 1e-12);
  EXPECT_NEAR(surfaceArea(turned), surfaceArea(shape), 1e-12);
  const SurfaceMesh far = transformed(shape, 1.0, { 1e6, -3e6, 2e6 });
  EXPECT_NEAR(signedVolume(far), signedVolume(shape), 1e-8) << "about 1e-9 is in the points";
  EXPECT_NEAR(signedVolume(transformed(unitCube(), 1.0, Vec3::Constant(1LL << 40))), 1.0, 1e-15)
    << "these points are exact";
}

TEST(SurfaceMesh, MeasuresScale)
{
  for (const double scale : { 1e-30, 1e-3, 1e30 })
  {
    const SurfaceMesh cube = transformed(unitCube(), scale, Vec3::Zero());
    EXPECT_NEAR(signedVolume(cube) / (scale * scale * scale), 1.0, 1e-14);
    EXPECT_NEAR(surfaceArea(cube) / (scale * scale), 6.0, 1e-14);
  }
}

TEST(SurfaceMesh, VectorAreaOfConcavePolygonIsExactFromEveryCorner)
{
  const SurfaceMesh shape = letterL();
  for (Index shift = 0; shift < 6; ++shift)
  {
    SurfaceMesh turned;
    turned.points = shape.points;
    std::vector<Index> face;
    for (Index k = 0; k < 6; ++k)
    {
      face.push_back((k + shift) % 6);
    }
    turned.addFace(face);
    EXPECT_EQ(faceVectorArea(turned, 0), Vec3(0, 0, 3)) << "begun at corner " << shift;
  }
}

TEST(SurfaceMesh, VectorAreaOfRegularPolygon)
{
  for (const Index count : { 3, 5, 17, 1000 })
  {
    SurfaceMesh polygon;
    std::vector<Index> face;
    for (Index i = 0; i < count; ++i)
    {
      const double angle = 2.0 * Pi * i / count;
      face.push_back(polygon.addPoint({ std::cos(angle), std::sin(angle), 7.0 }));
    }
    polygon.addFace(face);
    const Vec3 area = faceVectorArea(polygon, 0);
    EXPECT_NEAR(area.z(), 0.5 * count * std::sin(2.0 * Pi / count), 1e-12);
    EXPECT_NEAR(area.head<2>().norm(), 0.0, 1e-12);
  }
}

TEST(SurfaceMesh, VectorAreasOfAClosedSurfaceSumToZero)
{
  const SurfaceMesh shape = quadTorus(13, 7, 2.0, 0.7);
  Vec3 sum = Vec3::Zero();
  for (Index face = 0; face < shape.faceCount(); ++face)
  {
    sum += faceVectorArea(shape, face);
  }
  EXPECT_NEAR(sum.norm(), 0.0, 1e-13);
}

TEST(SurfaceMesh, AcceptsWhatIsValid)
{
  SurfaceMesh mesh = unitCube();
  EXPECT_EQ(messageOf(mesh), "");
  mesh.addPoint(Vec3::Constant(std::numeric_limits<double>::quiet_NaN()));
  EXPECT_EQ(messageOf(mesh), "") << "no face uses that point";
}

TEST(SurfaceMesh, RefusesPointsThatAreNotFinite)
{
  for (const double bad :
    { std::numeric_limits<double>::quiet_NaN(), -std::numeric_limits<double>::infinity() })
  {
    SurfaceMesh mesh = unitCube();
    mesh.points[5].y() = bad;
    EXPECT_EQ(messageOf(mesh).rfind("Point 5 has the coordinates (", 0), 0U) << messageOf(mesh);
    EXPECT_NE(messageOf(mesh).find("expected finite numbers"), std::string::npos);
    mesh.faceOffsets = { 0 };
    mesh.cornerVertices.clear();
    EXPECT_EQ(messageOf(mesh).rfind("Point 5", 0), 0U) << "in a point set every point counts";
  }
}

TEST(SurfaceMesh, RefusesVertexNumbersOutOfRange)
{
  for (const Index bad : { -1, 4, std::numeric_limits<Index>::max() })
  {
    SurfaceMesh mesh = cornerTetrahedron();
    mesh.cornerVertices[7] = bad;
    EXPECT_EQ(messageOf(mesh),
      "Face 2 refers to point " + std::to_string(bad) +
        ", but there are only 4 points; the file is damaged, export it again.");
  }
}

TEST(SurfaceMesh, RefusesFacesWithFewerThanThreeCorners)
{
  SurfaceMesh mesh = cornerTetrahedron();
  mesh.addFace({ 0, 1 });
  EXPECT_EQ(
    messageOf(mesh), "Face 4 has 2 corners, expected at least 3; remove it before this filter.");
}

} // namespace

} // namespace evolving
