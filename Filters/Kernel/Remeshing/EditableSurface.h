// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * A triangle surface whose elements can be split, collapsed and flipped in place.
 */

#ifndef EVOLVING_EDITABLE_SURFACE_H
#define EVOLVING_EDITABLE_SURFACE_H

#include "Mesh/SurfaceMesh.h"
#include "Mesh/TriangleView.h"
#include "Types.h"

#include <vector>

namespace evolving
{

/**
 * An oriented 2-manifold of triangles, closed or with boundary, as a table of half-edges: edge
 * 3 f + k runs from corner k of face f to the next corner. Editing leaves vertices and faces
 * behind that are no longer used; compact() numbers the others anew.
 *
 * Every operation keeps the surface a manifold: it is refused where it would not (the link
 * condition of Dey, Edelsbrunner, Guha, Nekhayev, *Topology preserving edge contraction*, 1999).
 * Whether it is good for the elements is for others to judge.
 */
class EditableSurface
{
public:
  /// @throws InputError as MeshTopology, or when a face is not a triangle
  explicit EditableSurface(const SurfaceMesh& mesh);

  /// Vertices and faces in order, without those that are no longer used.
  SurfaceMesh mesh() const;
  /// The same as they stand, for a moment: the surface must be compact.
  TriangleView triangles() const { return { this->Points, this->Vertex }; }
  /// Numbers vertices and faces anew, in order.
  void compact();

  Index vertexSlots() const { return static_cast<Index>(this->Points.size()); }
  Index faceSlots() const { return static_cast<Index>(this->Vertex.size() / 3); }
  Index edgeSlots() const { return static_cast<Index>(this->Vertex.size()); }
  bool hasVertex(Index v) const { return this->Outgoing[at(v)] != NoIndex; }
  bool hasFace(Index f) const { return this->Vertex[at(3 * f)] != NoIndex; }
  bool hasEdge(Index e) const { return this->Vertex[at(e)] != NoIndex; }

  static Index faceOf(Index e) { return e / 3; }
  static Index next(Index e) { return e % 3 == 2 ? e - 2 : e + 1; }
  static Index previous(Index e) { return e % 3 == 0 ? e + 2 : e - 1; }
  Index from(Index e) const { return this->Vertex[at(e)]; }
  Index to(Index e) const { return this->Vertex[at(next(e))]; }
  /// The vertex of the edge's face that is not on the edge.
  Index apex(Index e) const { return this->Vertex[at(previous(e))]; }
  /// The same edge in the other direction; NoIndex at the boundary.
  Index opposite(Index e) const { return this->Opposite[at(e)]; }
  /// Each edge has one half-edge for which this holds.
  bool isFirstHalf(Index e) const { return this->opposite(e) == NoIndex || e < this->opposite(e); }

  const Vec3& point(Index v) const { return this->Points[at(v)]; }
  void setPoint(Index v, const Vec3& point) { this->Points[at(v)] = point; }
  const Vec3& corner(Index f, Index k) const { return this->point(this->Vertex[at(3 * f + k)]); }
  double length(Index e) const
  {
    return (this->point(this->to(e)) - this->point(this->from(e))).norm();
  }
  /// Twice the area times the unit normal.
  Vec3 doubleArea(Index f) const;

  /// The length that edges at a vertex should have; carried on to the vertices of split edges.
  double size(Index v) const { return this->Sizes[at(v)]; }
  void setSize(Index v, double size) { this->Sizes[at(v)] = size; }
  /// Of the two ends, the mean.
  double size(Index from, Index to) const { return 0.5 * (this->size(from) + this->size(to)); }

  /// A triangle of the target near the vertex, to begin a search with; NoIndex when unknown.
  Index guess(Index v) const { return this->Guesses[at(v)]; }
  void setGuess(Index v, Index triangle) { this->Guesses[at(v)] = triangle; }

  /// The curve of a target that an edge lies on; NoIndex unless set.
  Index curve(Index e) const { return this->Curves[at(e)]; }
  void setCurve(Index e, Index curve);
  /// An edge of a curve or of the boundary stays one: it never flips, and its ends stay on it.
  bool isFeature(Index e) const
  {
    return this->curve(e) != NoIndex || this->opposite(e) == NoIndex;
  }
  /// A vertex that stays where it is; edges may still be drawn into it.
  bool isPinned(Index v) const { return this->Holds[at(v)] != 0; }
  void setPinned(Index v) { this->Holds[at(v)] |= Pin; }
  void releasePin(Index v) { this->Holds[at(v)] &= static_cast<unsigned char>(~Pin); }
  /// A pinned vertex; faces between three locked ones do not change at all.
  bool isLocked(Index v) const { return (this->Holds[at(v)] & Lock) != 0; }
  bool isLockedFace(Index f) const;
  void setLocked(Index v) { this->Holds[at(v)] |= Lock; }
  void releaseLocks();
  /// The part of a target that a face lies on; 0 unless set.
  Index label(Index f) const { return this->Labels[at(f)]; }
  void setLabel(Index f, Index label) { this->Labels[at(f)] = label; }

  /// The edges that leave a vertex, counter-clockwise; visit(edge).
  template <class Visit>
  void forEachOutgoing(Index v, Visit visit) const
  {
    const Index first = this->Outgoing[at(v)];
    for (Index e = first; e != NoIndex;)
    {
      visit(e);
      e = this->opposite(previous(e));
      if (e == first)
      {
        return;
      }
    }
  }
  /// The vertices joined to a vertex by an edge.
  template <class Visit>
  void forEachNeighbour(Index v, Visit visit) const
  {
    this->forEachOutgoing(v,
      [&](Index e)
      {
        visit(this->to(e));
        if (this->opposite(previous(e)) == NoIndex)
        {
          visit(this->apex(e));
        }
      });
  }
  Index valence(Index v) const;
  bool isBoundary(Index v) const { return this->opposite(this->Outgoing[at(v)]) == NoIndex; }
  bool areNeighbours(Index v, Index w) const;
  /// The number of feature edges at a vertex: 0 inside a patch, 2 on a curve, else a corner.
  Index featureEdges(Index v) const;
  /// The sum of the faces' vector areas, normalized; zero where they cancel.
  Vec3 normal(Index v) const;
  Vec3 middleOfNeighbours(Index v) const;

  /// Puts a vertex on an edge. @return the vertex
  Index split(Index e, const Vec3& point);
  /// May the edge turn to join the apexes of its two faces?
  bool canFlip(Index e) const;
  void flip(Index e);
  /// May from(e) be drawn into to(e)?
  bool canCollapse(Index e) const;
  /// to(e) stays where it is.
  void collapse(Index e);
  /// Gives a vertex the point, size, guess and holds of another.
  void takeOver(Index v, Index from);

private:
  friend class SurfacePatch;

  static constexpr unsigned char Pin = 1;
  static constexpr unsigned char Lock = 2;

  void join(Index e, Index f);
  Index addFace(Index label);
  void setEdge(Index e, Index from, Index opposite, Index curve);
  void removeFace(Index f);
  void settleOutgoing(Index v, Index e);
  void closeGap(Index face, Index edge);

  std::vector<Vec3> Points;
  std::vector<Index> Outgoing; ///< of a boundary vertex the one at the boundary
  std::vector<double> Sizes;
  std::vector<Index> Guesses;
  std::vector<unsigned char> Holds; ///< Pin and Lock
  std::vector<Index> Vertex;        ///< where each half-edge begins; NoIndex when unused
  std::vector<Index> Opposite;
  std::vector<Index> Curves;
  std::vector<Index> Labels;
};

} // namespace evolving

#endif
