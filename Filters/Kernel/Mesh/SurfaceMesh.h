// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * A polygonal surface as plain arrays: points, and faces as runs of vertex numbers.
 */

#ifndef EVOLVING_SURFACE_MESH_H
#define EVOLVING_SURFACE_MESH_H

#include "Types.h"

#include <initializer_list>
#include <vector>

namespace evolving
{

/**
 * Points and polygons. Face f has the corners faceOffsets[f] ... faceOffsets[f + 1] - 1, and
 * corner c sits at vertex cornerVertices[c]; corners run counter-clockwise seen from outside.
 * The arrays are public because every algorithm reads them; who writes them keeps
 * faceOffsets.front() == 0 and faceOffsets.back() == cornerVertices.size().
 */
struct SurfaceMesh
{
  std::vector<Vec3> points;
  std::vector<Index> faceOffsets{ 0 };
  std::vector<Index> cornerVertices;

  Index vertexCount() const { return static_cast<Index>(this->points.size()); }
  Index faceCount() const { return static_cast<Index>(this->faceOffsets.size()) - 1; }
  Index cornerCount() const { return static_cast<Index>(this->cornerVertices.size()); }
  Index faceSize(Index face) const
  {
    const auto f = static_cast<std::size_t>(face);
    return this->faceOffsets[f + 1] - this->faceOffsets[f];
  }
  /// The vertex of corner k of a face.
  Index faceVertex(Index face, Index k) const
  {
    const Index corner = this->faceOffsets[static_cast<std::size_t>(face)] + k;
    return this->cornerVertices[static_cast<std::size_t>(corner)];
  }
  /// The point of corner k of a face.
  const Vec3& facePoint(Index face, Index k) const
  {
    return this->points[static_cast<std::size_t>(this->faceVertex(face, k))];
  }

  Index addPoint(const Vec3& point);
  Index addFace(std::initializer_list<Index> vertices);
  Index addFace(const std::vector<Index>& vertices);

  bool hasOnlyTriangles() const;

private:
  Index addFace(const Index* begin, const Index* end);
};

bool operator==(const SurfaceMesh& a, const SurfaceMesh& b);
/// Do two meshes have equal faces, wherever their points are?
bool haveEqualFaces(const SurfaceMesh& a, const SurfaceMesh& b);

/// The box of the vertices that faces use; of all points when there is no face.
Box boundingBox(const SurfaceMesh& mesh);

/// The vector area of a face: its unit normal times its area (exact for planar polygons).
Vec3 faceVectorArea(const SurfaceMesh& mesh, Index face);
/// With the mesh's points elsewhere.
Vec3 faceVectorArea(const SurfaceMesh& mesh, const std::vector<Vec3>& points, Index face);

/// The sum of the lengths of the faces' vector areas.
double surfaceArea(const SurfaceMesh& mesh);

/**
 * The enclosed volume by the divergence theorem, positive when faces point outwards.
 * Computed about the bounding box centre, so that a mesh far from the origin loses nothing;
 * meaningless for a surface with boundary.
 */
double signedVolume(const SurfaceMesh& mesh);
/// About a point near the surface: of an open surface, the volume of the cone from there.
double signedVolume(const SurfaceMesh& mesh, const Vec3& center);

/// The same surface seen from its other side: every face with its corners in reverse order.
SurfaceMesh reversed(const SurfaceMesh& mesh);

/**
 * Joins points with equal coordinates, takes vertices out that follow themselves in a face, and
 * drops faces that then have fewer than three vertices or meet one twice, and points that no
 * face uses. Duplicate faces stay. The mesh must have passed validate().
 * STL files store every triangle with its own points, so they have no topology before this.
 * @param[out] oldVertex when not null, for every new vertex its smallest old number that a face
 * uses
 * @param[out] oldFace when not null, the old number of every kept face
 */
SurfaceMesh weldCoincidentPoints(const SurfaceMesh& mesh, std::vector<Index>* oldVertex = nullptr,
  std::vector<Index>* oldFace = nullptr);

/**
 * @throws InputError when a coordinate is not finite, a vertex number is out of range or a face
 * has fewer than three corners, in words that name the first offender. Points that no face uses
 * are ignored, unless there is no face at all (a point set).
 */
void validate(const SurfaceMesh& mesh);

} // namespace evolving

#endif
