// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Remeshing/NormalEquations.h"

#include "Remeshing/RemeshingShapes.h"
#include "Shapes/Polyhedra.h"
#include "ThreadedExecution.h"

#include <gtest/gtest.h>

#include <random>
#include <vector>

namespace
{

using namespace evolving;

/// Symmetric terms, different on every face.
std::vector<FaceTerms> someTerms(Index faces)
{
  std::mt19937 random(7);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  std::vector<FaceTerms> terms(static_cast<std::size_t>(faces));
  for (FaceTerms& t : terms)
  {
    t.matrix = t.matrix.unaryExpr([&](double) { return uniform(random); });
    t.matrix = (t.matrix * t.matrix.transpose()).eval();
    t.rightSide = t.rightSide.unaryExpr([&](double) { return uniform(random); });
  }
  return terms;
}

/// Every third vertex has none.
std::vector<Index> someUnknowns(const EditableSurface& surface, Index perVertex)
{
  std::vector<Index> unknowns;
  Index next = 0;
  for (Index v = 0; v < surface.vertexSlots(); ++v)
  {
    unknowns.push_back(v % 3 == 0 ? NoIndex : next);
    next += v % 3 == 0 ? 0 : perVertex;
  }
  return unknowns;
}

SurfaceMesh cube()
{
  return shapes::triangleBox(3, Vec3(1.0, 1.0, 1.0));
}

SurfaceMesh boxWithHole()
{
  SurfaceMesh open;
  const SurfaceMesh closed = cube();
  open.points = closed.points;
  for (Index f = 2; f < closed.faceCount(); ++f)
  {
    open.addFace({ closed.faceVertex(f, 0), closed.faceVertex(f, 1), closed.faceVertex(f, 2) });
  }
  return open;
}

class NormalEquationsOf : public testing::TestWithParam<Index>
{
};

TEST_P(NormalEquationsOf, FacesAreTheirSum)
{
  const Index perVertex = GetParam();
  for (const SurfaceMesh& mesh : { cube(), boxWithHole() })
  {
    const EditableSurface surface = shapes::sized(mesh, 0.5);
    const auto unknowns = someUnknowns(surface, perVertex);
    const auto terms = someTerms(surface.faceSlots());
    NormalEquations equations(surface, unknowns, perVertex);
    equations.assemble(terms, threadedExecution(3, 1));

    const auto size = static_cast<Eigen::Index>(equations.rightSide().size());
    Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(size, size);
    Eigen::VectorXd rightSide = Eigen::VectorXd::Zero(size);
    for (Index f = 0; f < surface.faceSlots(); ++f)
    {
      const FaceTerms& t = terms[static_cast<std::size_t>(f)];
      const auto unknownOf = [&](Index i)
      {
        const Index first = unknowns[static_cast<std::size_t>(surface.from(3 * f + i / 3))];
        return first == NoIndex || i % 3 >= perVertex ? NoIndex : first + i % 3;
      };
      for (Index i = 0; i < 9; ++i)
      {
        const Index row = unknownOf(i);
        for (Index j = 0; row != NoIndex && j < 9; ++j)
        {
          const Index column = unknownOf(j);
          if (column != NoIndex)
          {
            matrix(row, column) += t.matrix(i, j);
          }
        }
        if (row != NoIndex)
        {
          rightSide[row] += t.rightSide[i];
        }
      }
    }
    ASSERT_GT(size, 0);
    EXPECT_LT((Eigen::MatrixXd(equations.matrix()) - matrix).cwiseAbs().maxCoeff(), 1e-12);
    const Eigen::Map<const Eigen::VectorXd> assembled(
      equations.rightSide().data(), rightSide.size());
    EXPECT_LT((assembled - rightSide).cwiseAbs().maxCoeff(), 1e-12);

    equations.assemble(terms, {}); // anew, not on top
    EXPECT_LT((Eigen::MatrixXd(equations.matrix()) - matrix).cwiseAbs().maxCoeff(), 1e-12);
  }
}

INSTANTIATE_TEST_SUITE_P(Unknowns, NormalEquationsOf, testing::Values(1, 2, 3));

TEST(NormalEquations, AreEmptyWithoutUnknowns)
{
  const EditableSurface surface = shapes::sized(cube(), 0.5);
  const std::vector<Index> none(static_cast<std::size_t>(surface.vertexSlots()), NoIndex);
  NormalEquations equations(surface, none, 3);
  equations.assemble(someTerms(surface.faceSlots()), {});
  EXPECT_EQ(equations.matrix().rows(), 0);
  EXPECT_EQ(equations.rightSide().size(), 0);
}

} // namespace
