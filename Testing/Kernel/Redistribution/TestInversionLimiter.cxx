// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Redistribution/InversionLimiter.h"

#include "Errors.h"
#include "Mesh/MeshTopology.h"
#include "Mesh/VertexNormals.h"
#include "Shapes/MeshVariants.h"
#include "Shapes/Sheets.h"
#include "Shapes/Spheres.h"
#include "StartSurface/PrimitiveSurfaces.h"

#include <gtest/gtest.h>

#include <functional>

using namespace evolving;

namespace
{

/// A start and a limited move of it.
class TestedMove
{
public:
  explicit TestedMove(const SurfaceMesh& start)
    : Start(start)
    , Topology(start)
    , Vanished(start, this->Topology)
    , Normals(angleWeightedNormals(start))
    , Limiter(start, this->Topology, this->Normals, this->Vanished)
  {
  }

  /// Moves from `before` by displacements; returns the number of vertices that end elsewhere.
  Index move(const std::vector<Vec3>& before, const std::vector<Vec3>& displacement)
  {
    this->Mesh = this->Start;
    LimitedMove move{ displacement, std::vector<double>(before.size(), 1.0) };
    const auto place = [&]
    {
      for (std::size_t i = 0; i < before.size(); ++i)
      {
        this->Mesh.points[i] = before[i] + move.fraction[i] * move.displacement[i];
      }
    };
    place();
    this->Vanished.update(this->Mesh);
    const std::vector<Vec3> wanted = this->Mesh.points;
    this->Limiter.limit(this->Mesh, before, this->Normals, move, place, Execution());
    Index changed = 0;
    for (std::size_t i = 0; i < wanted.size(); ++i)
    {
      changed += this->Mesh.points[i] != wanted[i];
    }
    return changed;
  }

  SurfaceMesh Start;
  MeshTopology Topology;
  VanishedComponents Vanished;
  std::vector<Vec3> Normals;
  InversionLimiter Limiter;
  SurfaceMesh Mesh;
};

Index turnedFaces(const SurfaceMesh& before, const SurfaceMesh& after)
{
  Index turned = 0;
  for (Index face = 0; face < before.faceCount(); ++face)
  {
    turned += faceVectorArea(before, face).dot(faceVectorArea(after, face)) < 0.0;
  }
  return turned;
}

} // namespace

TEST(InversionLimiter, LeavesAnOrdinaryStepAlone)
{
  const SurfaceMesh start = shapes::bumpySphere(2);
  TestedMove limited(start);
  std::vector<Vec3> displacement;
  for (const Vec3& p : start.points)
  {
    displacement.push_back(-0.1 * p + Vec3(0.5, 0.0, 0.0));
  }
  EXPECT_EQ(limited.move(start.points, displacement), 0);
  EXPECT_EQ(limited.Mesh.points[5], Vec3(start.points[5] + displacement[5]));
}

TEST(InversionLimiter, AVertexThatGoesTooFarStopsBeforeItsFacesTurn)
{
  const SurfaceMesh start = icosphere(2);
  TestedMove limited(start);
  std::vector<Vec3> displacement(start.points.size(), Vec3::Zero());
  displacement[100] = -1.6 * start.points[100]; // through the sphere
  displacement[7] = Vec3(0.01, 0.0, 0.0);
  const Index shortened = limited.move(start.points, displacement);
  EXPECT_EQ(turnedFaces(start, limited.Mesh), 0);
  EXPECT_GE(shortened, 1);
  EXPECT_LE(shortened, 1 + limited.Topology.ringVertices(100).size());
  EXPECT_EQ(limited.Mesh.points[7], Vec3(start.points[7] + displacement[7]));
}

TEST(InversionLimiter, ASurfaceThatTurnsOverHasFailed)
{
  const SurfaceMesh start = icosphere(2);
  TestedMove limited(start);
  std::vector<Vec3> mirrored;
  for (const Vec3& p : start.points)
  {
    mirrored.push_back(Vec3(0.0, 0.0, -2.0 * p.z()));
  }
  try
  {
    limited.move(start.points, mirrored);
    FAIL() << "nothing was thrown";
  }
  catch (const SolverError& error)
  {
    EXPECT_NE(std::string(error.what()).find("of 320 faces turned over"), std::string::npos)
      << error.what();
  }
}

TEST(InversionLimiter, FacesThatStartTheWrongWayRoundMayUnfold)
{
  const SurfaceMesh good = shapes::shakenSheet(8, true, 0.2, 3);
  SurfaceMesh folded = good;
  const Index vertex = 40; // in the middle
  folded.points[vertex] += Vec3(0.16, 0.05, 0.0);
  ASSERT_GT(turnedFaces(good, folded), 0);
  TestedMove limited(folded);
  std::vector<Vec3> displacement(folded.points.size(), Vec3::Zero());
  displacement[vertex] = good.points[vertex] - folded.points[vertex];
  EXPECT_EQ(limited.move(folded.points, displacement), 0);
  EXPECT_LT((limited.Mesh.points[vertex] - good.points[vertex]).norm(), 1e-15);
}

TEST(InversionLimiter, AVanishedComponentHasNoSides)
{
  // The smaller sphere becomes a point, and what rounding makes of it is turned inside out.
  const SurfaceMesh small = shapes::transformed(icosphere(2), 0.1, Vec3(4.0, 0.0, 0.0));
  const SurfaceMesh start = shapes::merged(icosphere(2), small);
  TestedMove limited(start);
  std::vector<Vec3> displacement(start.points.size(), Vec3::Zero());
  for (std::size_t i = 162; i < start.points.size(); ++i)
  {
    displacement[i] = -(1.0 + 1e-6) * (start.points[i] - Vec3(4.0, 0.0, 0.0));
  }
  EXPECT_EQ(limited.move(start.points, displacement), 0);
  EXPECT_FALSE(limited.Vanished.contain(161));
  EXPECT_TRUE(limited.Vanished.contain(162));
}

TEST(VanishedComponents, TheOnlyComponentIsNotLookedAt)
{
  const SurfaceMesh start = icosphere(1);
  const MeshTopology topology(start);
  VanishedComponents vanished(start, topology);
  vanished.update(shapes::transformed(start, 1e-7, Vec3::Zero()));
  EXPECT_FALSE(vanished.contain(3));
}
