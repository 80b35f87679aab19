// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Features/ChartBorders.h"

#include "Features/MinimumCut.h"
#include "Features/SurfacePatches.h"

#include <set>

namespace evolving
{

namespace
{

std::size_t at(Index i)
{
  return static_cast<std::size_t>(i);
}

/// The border of two charts, and the triangles between which it may move.
class BorderSwap
{
public:
  BorderSwap(const TargetTriangles& target, const SharpEdges& sharp,
    const std::vector<char>& isFixed, std::vector<Index>& names)
    : Target(target)
    , Sharp(sharp)
    , IsFixed(isFixed)
    , Names(names)
    , NodeOfFace(names.size(), NoIndex)
  {
    for (std::size_t face = 0; face < names.size(); ++face)
    {
      this->FacesOfName[names[face]].push_back(static_cast<Index>(face));
    }
  }

  /// @return whether the border changed
  bool improve(Index first, Index second)
  {
    std::vector<Index> faces = this->FacesOfName[first];
    const std::vector<Index>& others = this->FacesOfName[second];
    faces.insert(faces.end(), others.begin(), others.end());
    MinimumCut cut(this->numberNodes(faces, first));
    for (const Index face : faces)
    {
      this->addEdges(cut, face);
    }
    return this->rename(faces, cut.sourceSide(First, Second), first, second);
  }

private:
  static constexpr Index First = 0;  ///< the node of the first chart's fixed triangles
  static constexpr Index Second = 1; ///< of the second's

  Index numberNodes(const std::vector<Index>& faces, Index first)
  {
    Index nodes = 2;
    for (const Index face : faces)
    {
      const Index fixedNode = this->Names[at(face)] == first ? First : Second;
      this->NodeOfFace[at(face)] = this->IsFixed[at(face)] != 0 ? fixedNode : nodes++;
    }
    return nodes;
  }

  void addEdges(MinimumCut& cut, Index face) const
  {
    forEachSmoothNeighbour(this->Target, this->Sharp, face,
      [&](Index other, Index edge)
      {
        const Index a = this->NodeOfFace[at(face)];
        const Index b = this->NodeOfFace[at(other)];
        if (face < other && b != NoIndex && a != b)
        {
          cut.addEdge(a, b, this->cost(edge));
        }
      });
  }

  /// Per length little where the surface folds nearly enough for a crease.
  double cost(Index edge) const
  {
    constexpr double MostSaved = 0.9;
    return this->Target.edgeLength(edge) * (1.0 - MostSaved * this->Sharp.relativeFold(edge));
  }

  /// The faces' names by the side of the cut; a cut that costs as much as the border changes none.
  bool rename(
    const std::vector<Index>& faces, const std::vector<char>& onFirst, Index first, Index second)
  {
    const double tolerance = 1e-9;
    double before = 0.0;
    double after = 0.0;
    for (const Index face : faces)
    {
      forEachSmoothNeighbour(this->Target, this->Sharp, face,
        [&](Index other, Index edge)
        {
          const Index node = this->NodeOfFace[at(other)];
          const double cost = node == NoIndex ? 0.0 : this->cost(edge);
          before += this->Names[at(face)] != this->Names[at(other)] ? cost : 0.0;
          const bool cuts =
            node != NoIndex && onFirst[at(node)] != onFirst[at(this->NodeOfFace[at(face)])];
          after += cuts ? cost : 0.0;
        });
    }
    const bool isCheaper = after < (1.0 - tolerance) * before;
    std::vector<Index> ofFirst;
    std::vector<Index> ofSecond;
    for (const Index face : faces)
    {
      if (isCheaper)
      {
        this->Names[at(face)] = onFirst[at(this->NodeOfFace[at(face)])] != 0 ? first : second;
      }
      (this->Names[at(face)] == first ? ofFirst : ofSecond).push_back(face);
      this->NodeOfFace[at(face)] = NoIndex;
    }
    this->FacesOfName[first] = std::move(ofFirst);
    this->FacesOfName[second] = std::move(ofSecond);
    return isCheaper;
  }

  const TargetTriangles& Target;
  const SharpEdges& Sharp;
  const std::vector<char>& IsFixed;
  std::vector<Index>& Names;
  std::vector<Index> NodeOfFace; ///< NoIndex outside the two charts
  std::map<Index, std::vector<Index>> FacesOfName;
};

} // namespace

BorderLengths artificialBorders(
  const TargetTriangles& target, const SharpEdges& sharp, const std::vector<Index>& names)
{
  BorderLengths borders;
  for (Index face = 0; face < target.mesh().faceCount(); ++face)
  {
    forEachSmoothNeighbour(target, sharp, face,
      [&](Index other, Index edge)
      {
        if (names[at(face)] < names[at(other)])
        {
          borders[{ names[at(face)], names[at(other)] }] += target.edgeLength(edge);
        }
      });
  }
  return borders;
}

void improveBorders(const TargetTriangles& target, const SharpEdges& sharp,
  const std::vector<char>& isFixed, std::vector<Index>& names)
{
  BorderSwap swap(target, sharp, isFixed, names);
  constexpr int MostSweeps = 5;                      // the first does nearly all
  std::set<Index> moved(names.begin(), names.end()); // others need no second look
  for (int sweep = 0; sweep < MostSweeps && !moved.empty(); ++sweep)
  {
    std::set<Index> movedNow;
    for (const auto& [pair, length] : artificialBorders(target, sharp, names))
    {
      const bool isNew = moved.count(pair.first) + moved.count(pair.second) +
          movedNow.count(pair.first) + movedNow.count(pair.second) >
        0;
      if (isNew && swap.improve(pair.first, pair.second))
      {
        movedNow.insert({ pair.first, pair.second });
      }
    }
    moved = std::move(movedNow);
  }
}

} // namespace evolving
