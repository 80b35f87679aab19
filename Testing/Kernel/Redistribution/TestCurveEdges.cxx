// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Mesh/Angles.h"
#include "Mesh/MeshTopology.h"
#include "Redistribution/CurveEdges.h"
#include "Shapes/Polyhedra.h"
#include "Shapes/Sheets.h"
#include "StartSurface/PrimitiveSurfaces.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace evolving;

namespace
{

/// The number of curve edges.
std::size_t count(const SurfaceMesh& mesh, double creaseAngle)
{
  std::size_t ends = 0;
  for (const std::vector<Index>& neighbours :
    curveNeighbours(mesh, MeshTopology(mesh), creaseAngle))
  {
    ends += neighbours.size();
  }
  return ends / 2;
}

/// A fine flat sheet with one vertex pulled out far.
SurfaceMesh spike()
{
  SurfaceMesh mesh = shapes::sheet(20, true);
  mesh.points[10 * 21 + 10].z() = 0.1;
  return mesh;
}

} // namespace

TEST(CurveEdges, AreTheBoundaryAndTheCreases)
{
  EXPECT_EQ(count(subdividedBox(1), 45.0), 12U);
  EXPECT_EQ(count(subdividedBox(5), 45.0), 60U);
  EXPECT_EQ(count(subdividedBox(5), 95.0), 0U);
  EXPECT_EQ(count(icosphere(3), 45.0), 0U);
  EXPECT_EQ(count(shapes::sheet(5, true), 45.0), 20U);
}

TEST(CurveEdges, ACoarseSolidKeepsItsEdges)
{
  EXPECT_EQ(count(shapes::regularTetrahedron(), 45.0), 6U);
}

TEST(CurveEdges, AFewSharpEdgesOfAFineMeshAreNoCurve)
{
  const SurfaceMesh mesh = spike();
  const MeshTopology topology(mesh);
  EXPECT_EQ(count(mesh, 45.0), 80U); // the boundary
  std::size_t bent = 0;
  for (Index corner = 0; corner < topology.cornerCount(); ++corner)
  {
    const Index opposite = topology.opposite(corner);
    if (opposite != NoIndex && corner > opposite)
    {
      const Vec3 here = faceVectorArea(mesh, topology.faceOf(corner)).normalized();
      const Vec3 there = faceVectorArea(mesh, topology.faceOf(opposite)).normalized();
      bent += here.dot(there) < std::cos(Pi / 4.0) ? 1U : 0U;
    }
  }
  EXPECT_GT(bent, 4U); // although they are bent by more than 45 degrees
}
