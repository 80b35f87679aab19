// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

// Edges that are long beside the model: refused or said, with a length that helps.

#include "Checks/Refusal.h"
#include "Checks/SurfaceMeasures.h"
#include "Errors.h"
#include "Remeshing/RemeshingShapes.h"
#include "Shapes/MeshVariants.h"
#include "Shapes/Polyhedra.h"
#include "Shapes/Sheets.h"
#include "Shapes/Tubes.h"
#include "ShrinkWrap/Shortcomings.h"
#include "ShrinkWrap/WrapRuns.h"
#include "StartSurface/PrimitiveSurfaces.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <string>
#include <vector>

namespace
{

using namespace evolving;

struct Model
{
  const char* name;
  SurfaceMesh mesh;
};

std::vector<Model> models()
{
  const SurfaceMesh ball = icosphere(3);
  return { { "ball", ball }, { "cube", shapes::triangleBox(4, Vec3::Ones()) },
    { "sheet", shapes::sheet(8, true) }, { "bar", shapes::triangleBox(4, Vec3(1.0, 0.1, 0.1)) },
    { "plate", shapes::triangleBox(4, Vec3(1.0, 1.0, 0.05)) },
    { "torus", shapes::torus(32, 16, 1.0, 0.4) },
    { "two balls", shapes::merged(ball, shapes::transformed(ball, 1.0, 10.0 * Vec3::UnitX())) } };
}

/// What became of a model with edges of a length.
struct Outcome
{
  SurfaceMesh surface; ///< empty when refused
  std::string words;   ///< the refusal, or what was said of the result
};

Outcome wrapped(const SurfaceMesh& mesh, double edgeLength)
{
  try
  {
    const ShrinkWrapProblem problem = prepareShrinkWrap(mesh, wraps::quick(edgeLength));
    Outcome outcome;
    outcome.surface = wraps::run(problem);
    const SurfaceReport report = examineWrap(outcome.surface, problem);
    for (const std::string& sentence : shortcomings(report, edgeLength))
    {
      outcome.words += sentence;
    }
    return outcome;
  }
  catch (const InputError& error)
  {
    return { {}, error.what() };
  }
}

/// Has the result the model's size and place everywhere, to a tenth of its diagonal?
bool showsShape(const SurfaceMesh& surface, const SurfaceMesh& mesh)
{
  const double size = boundingBox(mesh).diagonal().norm();
  return surface.faceCount() > 0 && signedVolume(surface) > 0.0 &&
    checks::hausdorff(surface, mesh, 0.02 * size) < 0.1 * size;
}

/// The number that a sentence advises, the smallest where there are several; 0 without any.
double advisedLength(const std::string& words)
{
  double smallest = 0.0;
  for (const std::string before : { ", use ", "; set " })
  {
    for (std::size_t at = words.find(before); at != std::string::npos; at = words.find(before, at))
    {
      at += before.size();
      const bool isNumber = words.find_first_of("0123456789", at) == at;
      const double length = isNumber ? std::stod(words.substr(at)) : 0.0;
      smallest = isNumber && (smallest == 0.0 || length < smallest) ? length : smallest;
    }
  }
  return smallest;
}

TEST(CoarseWraps, HaveTheModelsShapeOrSaySo)
{
  for (const Model& model : models())
  {
    const double size = boundingBox(model.mesh).diagonal().norm();
    for (const double part : { 300.0, 0.6, 0.4, 0.3, 0.2, 0.15, 0.1 })
    {
      SCOPED_TRACE(std::string(model.name) + " with edges of " + std::to_string(part));
      const Outcome outcome = wrapped(model.mesh, part * size);
      const bool isSaid = outcome.words.find("TargetEdgeLength") != std::string::npos;
      EXPECT_TRUE(isSaid || showsShape(outcome.surface, model.mesh))
        << model.name << " with edges of " << part << " diagonals: " << outcome.words;
    }
  }
}

TEST(CoarseWraps, AdviseALengthThatHelps)
{
  for (const Model& model : models())
  {
    const double size = boundingBox(model.mesh).diagonal().norm();
    for (const double part : { 300.0, 0.4, 0.2 })
    {
      const Outcome outcome = wrapped(model.mesh, part * size);
      const double advised = advisedLength(outcome.words);
      if (advised > 0.0)
      {
        const Outcome better = wrapped(model.mesh, advised);
        EXPECT_LT(advised, part * size);
        EXPECT_TRUE(showsShape(better.surface, model.mesh)) << model.name << ' ' << part;
        EXPECT_EQ(better.words.find("too long"), std::string::npos)
          << model.name << ' ' << part << ": " << better.words;
      }
      else
      {
        EXPECT_TRUE(showsShape(outcome.surface, model.mesh)) << model.name << ' ' << part;
      }
    }
  }
}

TEST(CoarseWraps, AreRefusedBeyondTheLengthThatIsNamed)
{
  const SurfaceMesh ball = icosphere(3);
  const double size = boundingBox(ball).diagonal().norm();
  const std::string sentence =
    checks::refusalOf([&] { prepareShrinkWrap(ball, wraps::quick(size)); });
  const std::string before = "expected at most ";
  ASSERT_NE(sentence.find(before), std::string::npos) << sentence;
  const double longest = std::stod(sentence.substr(sentence.find(before) + before.size()));
  EXPECT_THROW(prepareShrinkWrap(ball, wraps::quick(1.02 * longest)), InputError);
  EXPECT_NO_THROW(prepareShrinkWrap(ball, wraps::quick(0.98 * longest)));
  // An offset makes the result larger.
  ShrinkWrapOptions options = wraps::quick(1.2 * longest);
  options.offsetDistance = 1.0;
  EXPECT_NO_THROW(prepareShrinkWrap(ball, options));
}

} // namespace
