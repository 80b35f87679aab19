// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "FilterCase.h"

#include "OutputChecks.h"

#include "vtkAlgorithm.h"

namespace robustness
{

void FilterCase::update()
{
  this->filter()->Update();
}

std::string FilterCase::describe()
{
  return parametersOf(this->filter());
}

void FilterCase::requireNumbers()
{
  for (int port = 0; port < this->filter()->GetNumberOfOutputPorts(); ++port)
  {
    requireFinite(this->filter()->GetOutputDataObject(port));
  }
}

std::string FilterCase::whySurfaceIsRefused() const
{
  if (this->Input.isDamaged)
  {
    return "a face has point numbers out of range, or fewer than three corners";
  }
  if (this->Input.hasNaN)
  {
    return "a coordinate is not finite";
  }
  return this->Input.hasFaces || this->Input.model.points.empty() ? "" : "there are points alone";
}

const std::vector<FilterKind>& filterKinds()
{
  static const std::vector<FilterKind> kinds{ { "MeshSDF", 8, makeMeshSDFCase },
    { "SurfaceEvolution", 8, makeEvolutionCase },
    { "TangentialRedistribution", 3, makeRedistributionCase }, { "ShrinkWrap", 6, makeWrapCase },
    { "LabelSurfaces", 3, makeLabelCase }, { "DistanceHierarchy", 2, makeHierarchyCase },
    { "IcosphereSource", 1, makeSourceCase } };
  return kinds;
}

const FilterKind& filterKind(const std::string& name)
{
  std::string names;
  for (const FilterKind& kind : filterKinds())
  {
    if (name == kind.name)
    {
      return kind;
    }
    names += std::string(names.empty() ? "" : ", ") + kind.name;
  }
  throw std::invalid_argument("There is no filter '" + name + "'; expected one of " + names + ".");
}

const FilterKind& drawFilter(std::uint64_t seed)
{
  Random random(seed, Random::ForFilter);
  std::vector<const FilterKind*> lots;
  for (const FilterKind& kind : filterKinds())
  {
    lots.insert(lots.end(), static_cast<std::size_t>(kind.weight), &kind);
  }
  return *random.pick(lots);
}

} // namespace robustness
