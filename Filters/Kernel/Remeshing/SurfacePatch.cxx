// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Remeshing/SurfacePatch.h"

#include <algorithm>

namespace evolving
{

namespace
{

/// The faces at some vertices, in ascending order.
std::vector<Index> facesAt(const EditableSurface& surface, const std::vector<Index>& vertices)
{
  std::vector<Index> faces;
  for (const Index v : vertices)
  {
    surface.forEachOutgoing(v, [&faces](Index e) { faces.push_back(EditableSurface::faceOf(e)); });
  }
  std::sort(faces.begin(), faces.end());
  faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
  return faces;
}

/// The values of a face's three edges.
std::array<Index, 3> threeOf(const std::vector<Index>& values, Index face)
{
  return { values[at(3 * face)], values[at(3 * face + 1)], values[at(3 * face + 2)] };
}

void putThree(const std::array<Index, 3>& three, Index face, std::vector<Index>& values)
{
  std::copy(three.begin(), three.end(), values.begin() + 3 * face);
}

} // namespace

SurfacePatch::SurfacePatch(const EditableSurface& surface, const std::vector<Index>& vertices)
  : VertexSlots(surface.vertexSlots())
  , FaceSlots(surface.faceSlots())
{
  for (const Index v : vertices)
  {
    this->Vertices.push_back({ v, surface.Points[at(v)], surface.Outgoing[at(v)],
      surface.Sizes[at(v)], surface.Guesses[at(v)], surface.Holds[at(v)] });
  }
  for (const Index f : facesAt(surface, vertices))
  {
    this->Faces.push_back({ f, threeOf(surface.Vertex, f), threeOf(surface.Opposite, f),
      threeOf(surface.Curves, f), surface.Labels[at(f)] });
  }
}

void SurfacePatch::resize(EditableSurface& surface, Index vertices, Index faces)
{
  surface.Points.resize(at(vertices));
  surface.Outgoing.resize(at(vertices));
  surface.Sizes.resize(at(vertices));
  surface.Guesses.resize(at(vertices));
  surface.Holds.resize(at(vertices));
  surface.Vertex.resize(at(3 * faces));
  surface.Opposite.resize(at(3 * faces));
  surface.Curves.resize(at(3 * faces));
  surface.Labels.resize(at(faces));
}

void SurfacePatch::restore(EditableSurface& surface) const
{
  resize(surface, this->VertexSlots, this->FaceSlots);
  for (const VertexState& v : this->Vertices)
  {
    surface.Points[at(v.number)] = v.point;
    surface.Outgoing[at(v.number)] = v.outgoing;
    surface.Sizes[at(v.number)] = v.size;
    surface.Guesses[at(v.number)] = v.guess;
    surface.Holds[at(v.number)] = v.holds;
  }
  for (const FaceState& f : this->Faces)
  {
    putThree(f.vertices, f.number, surface.Vertex);
    putThree(f.opposites, f.number, surface.Opposite);
    putThree(f.curves, f.number, surface.Curves);
    surface.Labels[at(f.number)] = f.label;
  }
}

} // namespace evolving
