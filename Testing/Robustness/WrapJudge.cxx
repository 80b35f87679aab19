// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "EvolutionJudge.h"

#include "DistanceReference.h"
#include "OutputChecks.h"
#include "Verdict.h"

#include "vtkFieldData.h"
#include "vtkPolyData.h"
#include "vtkStringArray.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace robustness
{

namespace
{

/// More pairs than this take the judge too long: all but a few results have fewer faces.
constexpr std::size_t MostFaces = 60000;

void judgeReport(const Surface& surface, const Topology& topology, vtkPolyData* result)
{
  requireStated("IsClosed", fieldNumber(result, "IsClosed"), topology.isClosed() ? 1 : 0, 0.0);
  requireStated("IsManifold", fieldNumber(result, "IsManifold"),
    topology.isManifold() && topology.isOriented() ? 1 : 0, 0.0);
  requireStated("Genus", fieldNumber(result, "Genus"), double(topology.genus()), 0.0);
  if (surface.faces.size() <= MostFaces)
  {
    requireStated("SelfIntersections", fieldNumber(result, "SelfIntersections"),
      double(intersectionsOf(surface)), 0.0);
  }
}

/// The largest distance of the result's points from the target, over some of them.
double farthestOf(const Subject& target, const Surface& surface, bool& isOfAll)
{
  constexpr std::size_t MostEvaluations = 4000000;
  const DistanceReference reference(target.data);
  const std::size_t step = 1 + surface.points.size() * reference.size() / MostEvaluations;
  isOfAll = step == 1 && !reference.isLoose();
  double farthest = 0.0;
  for (std::size_t i = 0; i < surface.points.size(); i += step)
  {
    farthest = std::max(farthest, reference(surface.points[i]).lower);
  }
  return farthest;
}

/// How far points are from a good target, which has no holes to be filled. Of a result with
/// shortcomings little is known: what is thinner than a triangle has become a wall.
void judgeDeviation(const Subject& target, const Surface& surface, vtkPolyData* result)
{
  bool isOfAll = false;
  const double farthest = farthestOf(target, surface, isOfAll);
  constexpr double Far = 0.25;
  require(farthest <= Far * target.radius, Fault::TooFar, "a point is ", farthest,
    " away from a good target of radius ", target.radius, ", without a word");
  constexpr double Rounding = 1e-5;
  const double stated = fieldNumber(result, "MaxDistance");
  requireStated("MaxDistance", stated, isOfAll ? farthest : std::max(stated, farthest),
    Rounding * target.radius);
}

/// A result with another volume than a good target must say so.
void judgeVolume(const Subject& target, const Surface& surface)
{
  Surface solid;
  solid.points = target.model.points;
  for (const Triangle& t : target.model.solid)
  {
    solid.faces.emplace_back(t.begin(), t.end());
  }
  const double wanted = volumeOf(solid, middleOf(solid));
  const double volume = volumeOf(surface, middleOf(surface));
  constexpr double Share = 0.5;
  require(std::abs(volume - wanted) <= Share * wanted, Fault::TooFar, "the volume is ", volume,
    ", that of the target ", wanted, ", without a word");
}

std::vector<std::string> shortcomingsOf(vtkPolyData* result)
{
  std::vector<std::string> sentences;
  auto* said =
    vtkStringArray::SafeDownCast(result->GetFieldData()->GetAbstractArray("Shortcomings"));
  for (vtkIdType i = 0; said && i < said->GetNumberOfValues(); ++i)
  {
    sentences.push_back(said->GetValue(i));
  }
  return sentences;
}

} // namespace

void judgeWrap(const Subject& target, bool liesOnTarget, std::size_t warnings, vtkPolyData* result)
{
  const Surface surface = surfaceOf(result);
  requireUsableFaces(surface);
  require(!surface.faces.empty(), Fault::Nothing, "the result has no faces");
  require(std::all_of(surface.faces.begin(), surface.faces.end(),
            [](const Cell& face) { return face.size() == 3; }),
    Fault::NotTriangles, "a face of the result is not a triangle");
  const Topology topology = topologyOf(surface);
  judgeReport(surface, topology, result);
  judgeMeasures(surface, topology, result);
  requireClosed(topology);
  const std::vector<std::string> sentences = shortcomingsOf(result);
  const std::size_t said = sentences.size();
  const auto isOfVolumes = [](const std::string& sentence)
  { return sentence.find("enclose no volume") != std::string::npos; };
  if (std::none_of(sentences.begin(), sentences.end(), isOfVolumes))
  {
    requireOutward(surface);
  }
  require(warnings >= said, Fault::Misstated, said, " Shortcomings, but ", warnings, " warnings");
  if (liesOnTarget && said == 0 && target.isSolid())
  {
    judgeDeviation(target, surface, result);
    judgeVolume(target, surface);
  }
}

} // namespace robustness
