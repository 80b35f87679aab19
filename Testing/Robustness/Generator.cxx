// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Generator.h"

#include "BaseShapes.h"
#include "Defects.h"
#include "SpecialModels.h"

#include <Eigen/Geometry>

namespace robustness
{

namespace
{

Model begin(const BaseShape& shape, Random& random)
{
  Model model = shape.make(random);
  model.story.push_back(shape.name);
  return model;
}

/// Off the axes, where nothing is exact any more.
void rotate(Model& model, Random& random)
{
  const Eigen::AngleAxisd rotation(random.real(0.0, 3.0), random.direction());
  for (Vec3& point : model.points)
  {
    point = rotation * point;
  }
  model.story.push_back("rotated");
}

void spoil(Model& model, Random& random)
{
  const std::vector<const std::vector<Defect>*> kinds{ &faceDefects(), &partDefects(),
    &pointDefects() };
  const std::vector<int> counts{ 0, 0, 0, 1, 1, 1, 1, 2, 2, 3 };
  const int defects = random.pick(counts);
  for (int k = 0; k < defects; ++k)
  {
    const Defect& defect = random.pick(*random.pick(kinds));
    if (model.hasUsableFaces())
    {
      defect.make(model, random);
      model.story.push_back(defect.name);
    }
  }
}

} // namespace

Model makeModel(std::uint64_t seed)
{
  Random random(seed, Random::ForModel);
  Model model;
  if (random.chance(0.2))
  {
    model = begin(random.pick(specialModels()), random);
  }
  else
  {
    model = begin(random.pick(baseShapes()), random);
    if (random.chance(0.4))
    {
      rotate(model, random);
    }
    spoil(model, random);
  }
  transform(model, random);
  return model;
}

} // namespace robustness
