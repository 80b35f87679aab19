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
      if (isFixed[face] == 0)
      {
        this->FreeFaces[names[face]].push_back(static_cast<Index>(face));
      }
    }
  }

  /// @return whether the border changed
  bool improve(Index first, Index second)
  {
    // The search for ways begins in the first and stays near it when it is the smaller one.
    if (this->FreeFaces[second].size() < this->FreeFaces[first].size())
    {
      std::swap(first, second);
    }
    this->First = first;
    this->Second = second;
    this->Free = this->FreeFaces[first];
    const std::vector<Index>& others = this->FreeFaces[second];
    this->Free.insert(this->Free.end(), others.begin(), others.end());
    Index nodes = 2;
    for (const Index face : this->Free)
    {
      this->NodeOfFace[at(face)] = nodes++;
    }
    const bool changed = this->renameIfCheaper(this->cheapestCut(nodes));
    this->listFreeFaces();
    return changed;
  }

private:
  static constexpr Index FirstNode = 0; ///< of the first chart's fixed triangles
  static constexpr Index SecondNode = 1;

  /// NoIndex for triangles of other charts.
  Index nodeOf(Index face) const
  {
    if (this->IsFixed[at(face)] == 0)
    {
      return this->NodeOfFace[at(face)];
    }
    const Index name = this->Names[at(face)];
    return name == this->First ? FirstNode : name == this->Second ? SecondNode : NoIndex;
  }

  /// Calls visit(face, other, cost) once for each edge over which the border may move.
  template <typename Visit>
  void forEachEdge(const Visit& visit) const
  {
    for (const Index face : this->Free)
    {
      forEachSmoothNeighbour(this->Target, this->Sharp, face,
        [&](Index other, Index edge)
        {
          if ((face < other || this->IsFixed[at(other)] != 0) && this->nodeOf(other) != NoIndex)
          {
            visit(face, other, this->cost(edge));
          }
        });
    }
  }

  /// Per length little where the surface folds nearly enough for a crease.
  double cost(Index edge) const
  {
    constexpr double MostSaved = 0.9;
    return this->Target.edgeLength(edge) * (1.0 - MostSaved * this->Sharp.relativeFold(edge));
  }

  std::vector<char> cheapestCut(Index nodes) const
  {
    MinimumCut cut(nodes);
    this->forEachEdge([&](Index face, Index other, double cost)
      { cut.addEdge(this->nodeOf(face), this->nodeOf(other), cost); });
    return cut.sourceSide(FirstNode, SecondNode);
  }

  /// Renames the free triangles by the side of a cut, unless that costs as much as the border.
  bool renameIfCheaper(const std::vector<char>& onFirst)
  {
    constexpr double Tolerance = 1e-9;
    double before = 0.0;
    double after = 0.0;
    this->forEachEdge(
      [&](Index face, Index other, double cost)
      {
        before += this->Names[at(face)] != this->Names[at(other)] ? cost : 0.0;
        after += onFirst[at(this->nodeOf(face))] != onFirst[at(this->nodeOf(other))] ? cost : 0.0;
      });
    if (!(after < (1.0 - Tolerance) * before))
    {
      return false;
    }
    for (const Index face : this->Free)
    {
      this->Names[at(face)] = onFirst[at(this->nodeOf(face))] != 0 ? this->First : this->Second;
    }
    return true;
  }

  void listFreeFaces()
  {
    this->FreeFaces[this->First].clear();
    this->FreeFaces[this->Second].clear();
    for (const Index face : this->Free)
    {
      this->FreeFaces[this->Names[at(face)]].push_back(face);
      this->NodeOfFace[at(face)] = NoIndex;
    }
  }

  const TargetTriangles& Target;
  const SharpEdges& Sharp;
  const std::vector<char>& IsFixed;
  std::vector<Index>& Names;
  std::map<Index, std::vector<Index>> FreeFaces; ///< by name
  Index First = NoIndex;                         ///< the names of the two charts
  Index Second = NoIndex;
  std::vector<Index> Free;       ///< triangles of both
  std::vector<Index> NodeOfFace; ///< of Free
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
