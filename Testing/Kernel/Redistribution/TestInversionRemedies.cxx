// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Mesh/MeshTopology.h"
#include "Redistribution/InversionRemedies.h"
#include "Shapes/Sheets.h"

#include <gtest/gtest.h>

using namespace evolving;

namespace
{

/// Vertex 12 is the middle one of a sheet of 4 x 4 squares, cut into triangles.
constexpr std::size_t Middle = 12;

std::vector<Index> facesAt(const SurfaceMesh& mesh, Index vertex)
{
  std::vector<Index> faces;
  for (Index face = 0; face < mesh.faceCount(); ++face)
  {
    for (Index k = 0; k < 3; ++k)
    {
      if (mesh.faceVertex(face, k) == vertex)
      {
        faces.push_back(face);
      }
    }
  }
  return faces;
}

} // namespace

TEST(InversionRemedies, ReshapingGoesBackIntoTheRing)
{
  const SurfaceMesh start = shapes::sheet(4, true);
  SurfaceMesh mesh = start;
  const std::vector<Vec3> normals(mesh.points.size(), Vec3::UnitZ());
  std::vector<Vec3> moves(mesh.points.size(), Vec3::Zero());
  moves[Middle] = Vec3(0.4, 0.1, -0.2); // beyond its neighbour at 0.25
  mesh.points[Middle] += moves[Middle];
  reshape(mesh, MeshTopology(start), normals, { facesAt(mesh, 12)[0] }, moves);
  EXPECT_NEAR(moves[Middle].z(), -0.2, 1e-15); // along the surface only
  EXPECT_LT(moves[Middle].head<2>().norm(), 0.41);
  EXPECT_GT(moves[Middle].head<2>().norm(), 0.15);
  const double correction = (moves[Middle] - Vec3(0.4, 0.1, -0.2)).norm();
  EXPECT_GT(correction, 0.01);
  EXPECT_LT(correction, Vec3(0.4, 0.1, -0.2).norm()); // by less than the step
}

TEST(InversionRemedies, ASurfaceAtRestStaysAtRest)
{
  const SurfaceMesh mesh = shapes::shakenSheet(4, true, 0.3, 5);
  const std::vector<Vec3> normals(mesh.points.size(), Vec3::UnitZ());
  std::vector<Vec3> moves(mesh.points.size(), Vec3::Zero());
  reshape(mesh, MeshTopology(mesh), normals, facesAt(mesh, 12), moves);
  for (const Vec3& move : moves)
  {
    EXPECT_EQ(move, Vec3(Vec3::Zero()));
  }
}

TEST(InversionRemedies, EveningOutCarriesAFaceAlong)
{
  const SurfaceMesh mesh = shapes::sheet(4, true);
  std::vector<Vec3> moves(mesh.points.size(), Vec3::Zero());
  moves[Middle] = Vec3(0.3, 0.6, 0.9);
  const Index face = facesAt(mesh, 12)[0];
  evenOut(mesh, { face }, moves);
  for (Index k = 0; k < 3; ++k)
  {
    const auto vertex = static_cast<std::size_t>(mesh.faceVertex(face, k));
    EXPECT_LT((moves[vertex] - Vec3(0.1, 0.2, 0.3)).norm(), 1e-15);
  }
}

TEST(InversionRemedies, ShorteningCountsEveryVertexOnce)
{
  const SurfaceMesh mesh = shapes::sheet(4, true);
  std::vector<double> fraction(mesh.points.size(), 1.0);
  shorten(mesh, facesAt(mesh, 12), 0.5, fraction);
  EXPECT_EQ(fraction[Middle], 0.5); // of six faces
  EXPECT_EQ(fraction[0], 1.0);
}
