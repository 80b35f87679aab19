// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "LostTopology/OuterParts.h"

#include "Mesh/ConnectedComponents.h"
#include "Trees/AABBTree.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace evolving
{

namespace
{

class Parts
{
public:
  explicit Parts(const SurfaceMesh& surface)
    : Surface(surface)
    , Components(connectedComponents(surface))
    , FirstFace(at(this->Components.count), NoIndex)
    , SixVolumes(at(this->Components.count), 0.0)
  {
    // Near the surface: far from it rounding would take the place of volumes.
    const Vec3 center = boundingBox(surface).center();
    for (Index face = surface.faceCount() - 1; face >= 0; --face)
    {
      const std::size_t part = at(this->of(face));
      this->FirstFace[part] = face;
      this->SixVolumes[part] +=
        faceVectorArea(surface, face).dot(surface.facePoint(face, 0) - center);
    }
  }

  Index count() const { return this->Components.count; }
  Index of(Index face) const
  {
    return this->Components.ofVertex[at(this->Surface.faceVertex(face, 0))];
  }
  bool isInsideOut(Index part) const { return this->SixVolumes[at(part)] < 0.0; }

  /// A ray from a part to the outside crosses each part around it an odd number of times.
  bool isEnclosed(Index part, const AABBTree& tree) const
  {
    const Vec3 askew(0.5718, 0.3141, 0.7577); // along no axis, which faces often lie along
    std::vector<char> isAround(at(this->count()), 0);
    const Index face = this->FirstFace[at(part)];
    for (const RayHit& hit : tree.hits(Ray(tree.triangle(face).centroid(), askew)))
    {
      isAround[at(this->of(hit.triangle))] ^= 1;
    }
    isAround[at(part)] = 0;
    return std::find(isAround.begin(), isAround.end(), 1) != isAround.end();
  }

private:
  const SurfaceMesh& Surface;
  ConnectedComponents Components;
  std::vector<Index> FirstFace;
  std::vector<double> SixVolumes; // half of them: only the signs matter
};

std::vector<char> enclosedParts(
  const SurfaceMesh& surface, const Parts& parts, const Execution& execution)
{
  std::vector<char> isEnclosed(at(parts.count()), 0);
  if (parts.count() > 1)
  {
    const AABBTree tree(surface, execution);
    for (Index part = 0; part < parts.count(); ++part)
    {
      isEnclosed[at(part)] = parts.isEnclosed(part, tree);
    }
  }
  return isEnclosed;
}

} // namespace

SurfaceMesh outerParts(const SurfaceMesh& surface, const Execution& execution)
{
  const Parts parts(surface);
  const std::vector<char> isEnclosed = enclosedParts(surface, parts, execution);
  SurfaceMesh outer;
  outer.points = surface.points;
  for (Index face = 0; face < surface.faceCount(); ++face)
  {
    Index second = surface.faceVertex(face, 1);
    Index third = surface.faceVertex(face, 2);
    if (parts.isInsideOut(parts.of(face)))
    {
      std::swap(second, third);
    }
    if (!isEnclosed[at(parts.of(face))])
    {
      outer.addFace({ surface.faceVertex(face, 0), second, third });
    }
  }
  return outer;
}

} // namespace evolving
