// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * What a surface that can be a start must be: closed, manifold and oriented.
 */

#ifndef EVOLVING_TESTING_CLOSED_SURFACE_H
#define EVOLVING_TESTING_CLOSED_SURFACE_H

#include "Mesh/MeshTopology.h"
#include "Mesh/SurfaceMesh.h"
#include "Mesh/TopologySummary.h"

#include <gtest/gtest.h>

namespace evolving::checks
{

/// Expects a closed, oriented manifold of finite points, all of them in use.
inline TopologySummary expectClosedManifold(const SurfaceMesh& mesh)
{
  const TopologySummary summary = summarizeTopology(mesh);
  EXPECT_TRUE(summary.isClosed());
  EXPECT_TRUE(summary.isOriented());
  EXPECT_EQ(summary.eulerCharacteristic() % 2, 0);
  EXPECT_EQ(summary.usedVertices, mesh.vertexCount());
  EXPECT_NO_THROW(MeshTopology{ mesh });
  for (const Vec3& point : mesh.points)
  {
    EXPECT_TRUE(point.allFinite());
  }
  return summary;
}

} // namespace evolving::checks

#endif
