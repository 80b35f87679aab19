// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ShrinkWrap/WrapLooks.h"

#include "Crossings/OuterSurface.h"
#include "Crossings/SolidSheets.h"
#include "Mesh/SeamWelding.h"
#include "Mesh/TopologySummary.h"
#include "Mesh/TriangleView.h"
#include "ShrinkWrap/WantedGenus.h"
#include "ShrinkWrap/WrapResolution.h"

#include <utility>

namespace evolving
{

namespace
{

/// Are the holes and handles of the target those of the start?
bool showsGenus(const WrapView& view, std::optional<Index> wanted)
{
  if (!wanted)
  {
    return true;
  }
  const TopologySummary topology = summarizeTopology(view.region().boundary());
  return topology.components == 1 && topology.genus() == *wanted;
}

class Looks
{
public:
  Looks(const SurfaceMesh& mesh, const ShrinkWrapOptions& options, const WrapTuning& tuning,
    const Execution& execution)
    : Model(mesh)
    , Options(options)
    , Tuning(tuning)
    , Run(execution)
  {
  }

  SeenTarget run()
  {
    if (this->Model.faceCount() == 0)
    {
      this->look(firstResolution(this->Options), this->Run.phase(0.0, 0.5));
      this->lookAgain(neededForPoints(this->Options, *this->Seen.view));
      return std::move(this->Seen);
    }
    this->unite(this->Run.phase(0.0, 0.1));
    this->look(firstResolution(this->Options), this->Run.phase(0.1, 0.4));
    if (this->makeSheetsSolid(this->Run.phase(0.4, 0.4)))
    {
      this->unite(this->Run.phase(0.4, 0.4));
      this->look(firstResolution(this->Options), this->Run.phase(0.4, 0.5));
    }
    this->lookAgain(this->needed());
    this->lookForHoles();
    return std::move(this->Seen);
  }

private:
  void look(const WrapResolution& resolution, const Execution& now)
  {
    this->Tried = resolution;
    this->Seen.view.reset(); // before the grids of the next one need its memory
    this->Seen.view =
      std::make_unique<WrapView>(this->Model, this->Options, resolution, this->Tuning, now);
  }

  void lookAgain(const std::optional<WrapResolution>& resolution)
  {
    if (resolution)
    {
      this->look(*resolution, this->Run.phase(0.5, 1.0));
    }
  }

  void lookForHoles()
  {
    std::optional<WrapResolution> finer;
    while (!showsGenus(*this->Seen.view, this->Seen.wantedGenus) &&
      (finer = finerResolution(this->Options, this->Tried, *this->Seen.view)))
    {
      this->look(*finer, this->Run.phase(1.0, 1.0));
    }
  }

  /// Parts that run through each other become one.
  void unite(const Execution& now)
  {
    const SurfaceMesh welded =
      weldSeams(weldCoincidentPoints(this->Model), roundingOf(this->Model));
    std::optional<SurfaceMesh> united = outerSurface(welded, now, &this->IsTangled);
    this->IsUnited = united.has_value();
    if (united)
    {
      this->Model = std::move(*united);
    }
  }

  /// Walls around sheets have no creases to keep; solids have, where elements beside their rims may
  /// be small enough.
  bool makeSheetsSolid(const Execution& now)
  {
    const WrapTarget& target = *this->Seen.view->target();
    const WrapReference& reference = *this->Seen.view->reference();
    if (!reference.hasSheets() || reference.hasOffset() || !mayVarySizes(this->Options))
    {
      return false;
    }
    const std::optional<WrapResolution> needed =
      neededResolution(this->Options, *this->Seen.view, now);
    const double edge = needed ? needed->edgeLength : target.edgeLength;
    std::optional<SurfaceMesh> solids = solidSheets(
      target.surface, [&reference](const Vec3& p) { return reference.isAtSheet(p); },
      target.wallFor(edge), now);
    if (solids)
    {
      this->Model = std::move(*solids);
    }
    return solids.has_value();
  }

  std::optional<WrapResolution> needed()
  {
    const Execution now = this->Run.phase(0.5, 0.5);
    if (!this->IsUnited)
    {
      this->Seen.wantedGenus = genusToKeep(this->Seen.view->target()->surface, this->Options, now);
    }
    const bool isClosed = summarizeTopology(this->Seen.view->target()->surface).isClosed();
    return neededResolution(this->Options, *this->Seen.view, now, isClosed && !this->IsTangled);
  }

  SurfaceMesh Model;
  bool IsUnited = false;
  bool IsTangled = false; ///< parts run through each other and could not be united
  const ShrinkWrapOptions& Options;
  const WrapTuning& Tuning;
  const Execution& Run;
  WrapResolution Tried;
  SeenTarget Seen;
};

} // namespace

SeenTarget lookAsNeeded(const SurfaceMesh& mesh, const ShrinkWrapOptions& options,
  const WrapTuning& tuning, const Execution& execution)
{
  checkOptions(options);
  triangleView(mesh); // throws for what are no triangles
  return Looks(mesh, options, tuning, execution).run();
}

} // namespace evolving
