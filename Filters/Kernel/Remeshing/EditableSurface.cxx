// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Remeshing/EditableSurface.h"

#include "Errors.h"
#include "Mesh/MeshTopology.h"

namespace evolving
{

namespace
{

/// New numbers, in order, for those that are used; NoIndex for the others.
template <class IsUsed>
std::vector<Index> numbersOfUsed(Index slots, const IsUsed& isUsed)
{
  std::vector<Index> numbers;
  Index used = 0;
  for (Index i = 0; i < slots; ++i)
  {
    numbers.push_back(isUsed(i) ? used++ : NoIndex);
  }
  return numbers;
}

/// Moves values to their new numbers, so many to a number, and drops the others.
template <class Value>
void keepNumbered(
  std::vector<Value>& values, const std::vector<Index>& numbers, std::size_t width = 1)
{
  auto end = values.begin();
  for (std::size_t i = 0; i < numbers.size(); ++i)
  {
    for (std::size_t k = 0; numbers[i] != NoIndex && k < width; ++k)
    {
      *end++ = values[width * i + k];
    }
  }
  values.erase(end, values.end());
}

} // namespace

EditableSurface::EditableSurface(const SurfaceMesh& mesh)
  : Points(mesh.points)
  , Outgoing(mesh.points.size(), NoIndex)
  , Sizes(mesh.points.size(), 0.0)
  , Guesses(mesh.points.size(), NoIndex)
  , Holds(mesh.points.size(), 0)
  , Vertex(mesh.cornerVertices)
  , Opposite(mesh.cornerVertices.size(), NoIndex)
  , Curves(mesh.cornerVertices.size(), NoIndex)
  , Labels(static_cast<std::size_t>(mesh.faceCount()), 0)
{
  if (!mesh.hasOnlyTriangles())
  {
    throw InputError("The surface has faces that are not triangles, expected triangles only; "
                     "triangulate it before remeshing.");
  }
  const MeshTopology topology(mesh);
  for (Index e = 0; e < this->edgeSlots(); ++e)
  {
    this->Opposite[at(e)] = topology.opposite(e);
  }
  for (Index v = 0; v < this->vertexSlots(); ++v)
  {
    if (topology.isUsed(v))
    {
      this->Outgoing[at(v)] = topology.ringCorners(v)[0];
    }
  }
}

SurfaceMesh EditableSurface::mesh() const
{
  SurfaceMesh mesh;
  const auto numbers =
    numbersOfUsed(this->vertexSlots(), [this](Index v) { return this->hasVertex(v); });
  mesh.points = this->Points;
  keepNumbered(mesh.points, numbers);
  for (Index f = 0; f < this->faceSlots(); ++f)
  {
    if (this->hasFace(f))
    {
      mesh.addFace({ numbers[at(this->from(3 * f))], numbers[at(this->from(3 * f + 1))],
        numbers[at(this->from(3 * f + 2))] });
    }
  }
  return mesh;
}

void EditableSurface::compact()
{
  const auto vertices =
    numbersOfUsed(this->vertexSlots(), [this](Index v) { return this->hasVertex(v); });
  const auto faces = numbersOfUsed(this->faceSlots(), [this](Index f) { return this->hasFace(f); });
  keepNumbered(this->Points, vertices);
  keepNumbered(this->Sizes, vertices);
  keepNumbered(this->Guesses, vertices);
  keepNumbered(this->Holds, vertices);
  keepNumbered(this->Outgoing, vertices);
  keepNumbered(this->Labels, faces);
  keepNumbered(this->Vertex, faces, 3);
  keepNumbered(this->Opposite, faces, 3);
  keepNumbered(this->Curves, faces, 3);
  for (Index& v : this->Vertex)
  {
    v = vertices[at(v)];
  }
  for (std::vector<Index>* edges : { &this->Outgoing, &this->Opposite })
  {
    for (Index& e : *edges)
    {
      e = e == NoIndex ? NoIndex : 3 * faces[at(faceOf(e))] + e % 3;
    }
  }
}

bool EditableSurface::isLockedFace(Index f) const
{
  return this->isLocked(this->from(3 * f)) && this->isLocked(this->from(3 * f + 1)) &&
    this->isLocked(this->from(3 * f + 2));
}

void EditableSurface::releaseLocks()
{
  for (unsigned char& hold : this->Holds)
  {
    hold &= static_cast<unsigned char>(~Lock);
  }
}

Vec3 EditableSurface::doubleArea(Index f) const
{
  const Vec3& origin = this->corner(f, 0);
  return (this->corner(f, 1) - origin).cross(this->corner(f, 2) - origin);
}

void EditableSurface::setCurve(Index e, Index curve)
{
  this->Curves[at(e)] = curve;
  if (this->opposite(e) != NoIndex)
  {
    this->Curves[at(this->opposite(e))] = curve;
  }
}

Index EditableSurface::valence(Index v) const
{
  Index count = 0;
  this->forEachNeighbour(v, [&](Index) { ++count; });
  return count;
}

bool EditableSurface::areNeighbours(Index v, Index w) const
{
  bool found = false;
  this->forEachNeighbour(v, [&](Index u) { found = found || u == w; });
  return found;
}

Index EditableSurface::featureEdges(Index v) const
{
  Index count = 0;
  this->forEachOutgoing(v,
    [&](Index e)
    {
      count += this->isFeature(e) ? 1 : 0;
      count += this->opposite(previous(e)) == NoIndex ? 1 : 0;
    });
  return count;
}

Vec3 EditableSurface::normal(Index v) const
{
  Vec3 sum = Vec3::Zero();
  this->forEachOutgoing(v, [&](Index e) { sum += this->doubleArea(faceOf(e)); });
  return sum.stableNormalized();
}

Vec3 EditableSurface::middleOfNeighbours(Index v) const
{
  Vec3 sum = Vec3::Zero();
  double count = 0.0;
  this->forEachNeighbour(v,
    [&](Index u)
    {
      sum += this->point(u);
      count += 1.0;
    });
  return sum / count;
}

} // namespace evolving
