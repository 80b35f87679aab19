// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

// What changes the connectivity of an EditableSurface: split, flip and collapse.

#include "Remeshing/EditableSurface.h"

#include <algorithm>

namespace evolving
{

void EditableSurface::join(Index e, Index f)
{
  if (e != NoIndex)
  {
    this->Opposite[at(e)] = f;
  }
  if (f != NoIndex)
  {
    this->Opposite[at(f)] = e;
  }
}

Index EditableSurface::addFace(Index label)
{
  const Index f = this->faceSlots();
  this->Vertex.resize(at(3 * f + 3), NoIndex);
  this->Opposite.resize(at(3 * f + 3), NoIndex);
  this->Curves.resize(at(3 * f + 3), NoIndex);
  this->Labels.push_back(label);
  return f;
}

void EditableSurface::setEdge(Index e, Index from, Index opposite, Index curve)
{
  this->Vertex[at(e)] = from;
  this->Curves[at(e)] = curve;
  this->Opposite[at(e)] = NoIndex;
  this->join(e, opposite);
}

void EditableSurface::removeFace(Index f)
{
  std::fill_n(this->Vertex.begin() + 3 * f, 3, NoIndex);
  std::fill_n(this->Opposite.begin() + 3 * f, 3, NoIndex);
}

/// Makes e, or the boundary edge clockwise from it, the first edge of its vertex.
void EditableSurface::settleOutgoing(Index v, Index e)
{
  this->Outgoing[at(v)] = e;
  for (Index back = this->opposite(e); back != NoIndex;
       back = this->opposite(this->Outgoing[at(v)]))
  {
    const Index clockwise = next(back);
    if (clockwise == e)
    {
      return;
    }
    this->Outgoing[at(v)] = clockwise;
  }
}

Index EditableSurface::split(Index e, const Vec3& point)
{
  const Index o = this->opposite(e);
  const Index a = this->from(e);
  const Index b = this->to(e);
  const Index curve = this->curve(e);
  const Index m = this->vertexSlots();
  this->Points.push_back(point);
  this->Sizes.push_back(this->size(a, b));
  this->Guesses.push_back(this->guess(a));
  this->Holds.push_back(0);
  this->Outgoing.push_back(NoIndex);
  // (a, b, c) becomes (a, m, c) and a new face (m, b, c).
  const auto halve = [this, m](Index edge)
  {
    const Index c = this->apex(edge);
    const Index far = this->to(edge);
    const Index n = next(edge);
    const Index face = this->addFace(this->label(faceOf(edge)));
    this->setEdge(3 * face + 1, far, this->opposite(n), this->curve(n));
    this->setEdge(3 * face, m, NoIndex, NoIndex);
    this->setEdge(3 * face + 2, c, NoIndex, NoIndex);
    this->setEdge(n, m, 3 * face + 2, NoIndex);
    return 3 * face;
  };
  const Index mb = halve(e);
  Index ma = NoIndex;
  if (o != NoIndex)
  {
    ma = halve(o);
    this->join(mb, o);
    this->join(e, ma);
    this->setCurve(o, curve);
    this->setCurve(ma, curve);
  }
  this->setCurve(mb, curve);
  this->setCurve(e, curve);
  this->Outgoing[at(m)] = mb;
  this->settleOutgoing(b, next(mb));
  this->settleOutgoing(a, e);
  this->settleOutgoing(m, mb);
  return m;
}

bool EditableSurface::canFlip(Index e) const
{
  const Index o = this->opposite(e);
  if (o == NoIndex || this->isFeature(e) || this->isLockedFace(faceOf(e)) ||
    this->isLockedFace(faceOf(o)))
  {
    return false;
  }
  const Index c = this->apex(e);
  const Index d = this->apex(o);
  const auto hasRoom = [this](Index v) { return this->isBoundary(v) || this->valence(v) > 3; };
  return c != d && hasRoom(this->from(e)) && hasRoom(this->to(e)) && !this->areNeighbours(c, d);
}

void EditableSurface::flip(Index e)
{
  const Index o = this->opposite(e);
  const Index a = this->from(e);
  const Index b = this->to(e);
  const Index c = this->apex(e);
  const Index d = this->apex(o);
  const Index bc = next(e);
  const Index ca = previous(e);
  const Index ad = next(o);
  const Index db = previous(o);
  const Index outerCA = this->opposite(ca);
  const Index outerDB = this->opposite(db);
  const Index curveCA = this->curve(ca);
  const Index curveDB = this->curve(db);
  // (a, b, c), (b, a, d) become (d, b, c), (c, a, d): e is d-b, o is c-a, the new edge c-d.
  this->setEdge(e, d, outerDB, curveDB);
  this->setEdge(o, c, outerCA, curveCA);
  this->setEdge(ca, c, NoIndex, NoIndex);
  this->setEdge(db, d, ca, NoIndex);
  this->settleOutgoing(a, ad);
  this->settleOutgoing(b, bc);
  this->settleOutgoing(c, o);
  this->settleOutgoing(d, e);
}

bool EditableSurface::canCollapse(Index e) const
{
  const Index o = this->opposite(e);
  const Index a = this->from(e);
  const Index b = this->to(e);
  if (o != NoIndex && this->isBoundary(a) && this->isBoundary(b))
  {
    return false; // the surface would be pinched
  }
  const auto apexHasRoom = [this](Index edge)
  {
    const Index c = this->apex(edge);
    // Two features that become one edge enclose a patch, or a boundary, that would vanish.
    const bool isBetweenFeatures = this->isFeature(next(edge)) && this->isFeature(previous(edge));
    return !isBetweenFeatures && (this->isBoundary(c) || this->valence(c) > 3);
  };
  if (!apexHasRoom(e) || (o != NoIndex && !apexHasRoom(o)))
  {
    return false;
  }
  Index common = 0;
  this->forEachNeighbour(
    a, [&](Index u) { common += u != b && this->areNeighbours(b, u) ? 1 : 0; });
  return common == (o == NoIndex ? 1 : 2);
}

/// Joins what lay beyond the two edges of a face that an edge of it, now a point, leaves alone.
void EditableSurface::closeGap(Index face, Index edge)
{
  const Index first = next(edge);
  const Index second = previous(edge);
  const Index outerFirst = this->opposite(first);
  const Index outerSecond = this->opposite(second);
  const Index curve = std::max(this->curve(first), this->curve(second));
  const Index b = this->from(first);
  const Index c = this->from(second);
  this->removeFace(face);
  this->join(outerFirst, outerSecond);
  for (const Index outer : { outerFirst, outerSecond })
  {
    if (outer != NoIndex)
    {
      this->Curves[at(outer)] = curve;
    }
  }
  // outerFirst runs c -> b, outerSecond b -> c.
  const Index atB = outerSecond != NoIndex ? outerSecond : next(outerFirst);
  const Index atC = outerFirst != NoIndex ? outerFirst : next(outerSecond);
  this->Outgoing[at(b)] = atB;
  this->Outgoing[at(c)] = atC;
}

void EditableSurface::collapse(Index e)
{
  const Index o = this->opposite(e);
  const Index a = this->from(e);
  const Index b = this->to(e);
  const Index c = this->apex(e);
  const Index d = o == NoIndex ? NoIndex : this->apex(o);
  std::vector<Index> moved;
  this->forEachOutgoing(a, [&](Index out) { moved.push_back(out); });
  for (const Index out : moved)
  {
    this->Vertex[at(out)] = b;
  }
  this->closeGap(faceOf(e), e);
  if (o != NoIndex)
  {
    this->closeGap(faceOf(o), o);
    this->settleOutgoing(d, this->Outgoing[at(d)]);
  }
  this->settleOutgoing(b, this->Outgoing[at(b)]);
  this->settleOutgoing(c, this->Outgoing[at(c)]);
  this->Outgoing[at(a)] = NoIndex;
}

void EditableSurface::takeOver(Index v, Index from)
{
  this->Points[at(v)] = this->Points[at(from)];
  this->Sizes[at(v)] = this->Sizes[at(from)];
  this->Guesses[at(v)] = this->Guesses[at(from)];
  this->Holds[at(v)] = this->Holds[at(from)];
}

} // namespace evolving
