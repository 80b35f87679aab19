// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Remeshing/SurfaceFit.h"

#include "Algebra/ConjugateGradients.h"
#include "Mesh/Orthogonal.h"
#include "ParallelLoops.h"
#include "Remeshing/InversionFreeMove.h"
#include "Remeshing/NormalEquations.h"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

namespace evolving
{

namespace
{

/// No vertex moves farther than this fraction of its size at once. Half of what keeps neighbours
/// from passing each other: the planes that distances are measured to are those of before.
constexpr double LongestMove = 0.25;
/// A pull towards staying, relative to the data: where the samples say nothing it decides.
constexpr double Inertia = 1e-3;
/// Of the moves, of a quarter of a size at most, which are found anew in the next iteration.
constexpr double SolverTolerance = 1e-4;

using Mat3 = Eigen::Matrix3d;
using Vec9 = Eigen::Matrix<double, 9, 1>;

class Fit
{
public:
  Fit(EditableSurface& surface, const ReferenceSurface& reference, double tangentialInertia,
    const Execution& execution)
    : Surface(surface)
    , Reference(reference)
    , Run(execution)
    , TangentialInertia(tangentialInertia)
    , Directions(std::isfinite(tangentialInertia) ? 3 : 1)
    , Frames(at(surface.vertexSlots()), Mat3::Zero())
    , Unknown(at(surface.vertexSlots()), NoIndex)
  {
    for (Index v = 0; v < surface.vertexSlots(); ++v)
    {
      if (surface.hasVertex(v) && !surface.isPinned(v) && surface.featureEdges(v) == 0)
      {
        this->Unknown[at(v)] = this->Unknowns;
        this->Unknowns += this->Directions;
      }
    }
    this->Equations.emplace(surface, this->Unknown, this->Directions);
  }

  void iterate(double damping)
  {
    this->updateFrames();
    std::vector<FaceTerms> terms(at(this->Surface.faceSlots()));
    this->Run.forRange(this->Surface.faceSlots(), Execution::MeshGrain,
      [&](std::int64_t begin, std::int64_t end)
      {
        for (Index f = static_cast<Index>(begin); f < static_cast<Index>(end); ++f)
        {
          terms[at(f)] = this->termsOf(f);
        }
      });
    this->move(this->solve(terms), damping);
  }

private:
  /// The columns are the normal and two tangents; an orthogonal matrix.
  void updateFrames()
  {
    forEachIndex(this->Run, this->Surface.vertexSlots(),
      [this](Index v)
      {
        if (this->Unknown[at(v)] != NoIndex)
        {
          const Vec3 normal = this->Surface.normal(v);
          Mat3& frame = this->Frames[at(v)];
          frame.col(0) = normal;
          frame.col(1) = orthogonalTo(normal).stableNormalized();
          frame.col(2) = normal.cross(Vec3(frame.col(1)));
        }
      });
  }

  FaceTerms termsOf(Index f) const
  {
    FaceTerms terms;
    if (!this->Surface.hasFace(f))
    {
      return terms;
    }
    const Vec3 doubleArea = this->Surface.doubleArea(f);
    const Vec3 facing = doubleArea.stableNormalized();
    Index guess = this->Surface.guess(this->Surface.from(3 * f));
    for (std::size_t i = 0; i < FitPlaces.size(); ++i)
    {
      const std::array<double, 3>& b = FitPlaces[i];
      Vec3 point = Vec3::Zero();
      for (Index k = 0; k < 3; ++k)
      {
        point += b[at(k)] * this->Surface.corner(f, k);
      }
      const ReferenceSurface::Foot foot =
        this->Reference.onSurface(point, facing, this->Surface.label(f), guess);
      guess = foot.triangle;
      const double weight =
        FitWeights[i] * doubleArea.norm() * std::max(0.0, foot.normal.dot(facing));
      Vec9 slope;
      for (Index k = 0; k < 3; ++k)
      {
        const Mat3& frame = this->Frames[at(this->Surface.from(3 * f + k))];
        slope.segment<3>(3 * k) = b[at(k)] * frame.transpose() * foot.normal;
      }
      terms.matrix += weight * slope * slope.transpose();
      terms.rightSide -= weight * (point - foot.point).dot(foot.normal) * slope;
    }
    if (this->Directions == 3)
    {
      const double cost = this->TangentialInertia * doubleArea.norm();
      terms.matrix.diagonal() += cost * (Vec9() << 0, 1, 1, 0, 1, 1, 0, 1, 1).finished();
    }
    return terms;
  }

  std::vector<double> solve(const std::vector<FaceTerms>& terms)
  {
    this->Equations->assemble(terms, this->Run);
    SparseMatrix& matrix = this->Equations->matrix();
    const double inertia = Inertia * matrix.diagonal().sum() / std::max(1, this->Unknowns);
    for (Index i = 0; i < this->Unknowns; ++i)
    {
      matrix.coeffRef(i, i) += inertia;
    }
    SolverLimits limits;
    limits.tolerance = SolverTolerance;
    return approximateSolution(
      matrix, this->Equations->rightSide(), limits, this->Run.phase(0.0, 0.0));
  }

  void move(const std::vector<double>& moves, double damping)
  {
    std::vector<Vec3> points(at(this->Surface.vertexSlots()));
    for (Index v = 0; v < this->Surface.vertexSlots(); ++v)
    {
      points[at(v)] = this->Surface.point(v);
      const Index first = this->Unknown[at(v)];
      if (first != NoIndex)
      {
        Vec3 way = damping * this->Frames[at(v)].leftCols(this->Directions) *
          Eigen::Map<const Eigen::VectorXd>(moves.data() + first, this->Directions);
        const double longest = LongestMove * this->Surface.size(v);
        points[at(v)] += way * std::min(1.0, longest / std::max(way.norm(), longest));
      }
    }
    moveWithoutInversion(this->Surface, points, this->Run);
  }

  EditableSurface& Surface;
  const ReferenceSurface& Reference;
  const Execution& Run;
  double TangentialInertia;
  Index Directions; ///< in which a vertex may move
  std::vector<Mat3> Frames;
  std::vector<Index> Unknown; ///< of every vertex the first
  Index Unknowns = 0;
  std::optional<NormalEquations> Equations;
};

} // namespace

void fitToReference(EditableSurface& surface, const ReferenceSurface& reference,
  const FitOptions& options, const Execution& execution)
{
  Fit fit(surface, reference, options.tangentialInertia, execution);
  for (int i = 0; i < options.iterations; ++i)
  {
    execution.report(static_cast<double>(i) / options.iterations);
    fit.iterate(options.damping);
  }
}

} // namespace evolving
