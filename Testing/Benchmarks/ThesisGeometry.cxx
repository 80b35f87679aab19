// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ThesisGeometry.h"

#include "Mesh/MeshTopology.h"

namespace benchmark
{

namespace
{

using evolving::Index;
using evolving::Vec3;

/// (4.21): of the angle at `corner`, between the edges to a and b.
double cotangent(const Vec3& corner, const Vec3& a, const Vec3& b)
{
  const Vec3 u = a - corner;
  const Vec3 v = b - corner;
  return u.dot(v) / u.cross(v).norm();
}

/// A vertex and its ring, p = 1, ..., m.
struct Ring
{
  Vec3 F_i;
  std::vector<Vec3> F_p;

  Ring(const std::vector<Index>& ring, Index i, const Eigen::MatrixX3d& F)
    : F_i(F.row(i))
  {
    for (const Index p : ring)
    {
      this->F_p.emplace_back(F.row(p));
    }
  }

  int size() const { return static_cast<int>(this->F_p.size()); }

  /// (cot theta_(i,p-1,1) + cot theta_(i,p,2)) / 2
  double weight(int p) const
  {
    const Vec3& F_ip = around(this->F_p, p);
    return 0.5 *
      (cotangent(around(this->F_p, p - 1), this->F_i, F_ip) +
        cotangent(around(this->F_p, p + 1), this->F_i, F_ip));
  }

  /// (4.22), (4.23)
  double coVolume() const
  {
    double mu = 0.0;
    for (int p = 0; p < this->size(); ++p)
    {
      const Vec3 M_1 = 0.5 * (around(this->F_p, p) + this->F_i);
      const Vec3 M_2 = 0.5 * (around(this->F_p, p + 1) + this->F_i);
      const Vec3 B = (this->F_i + around(this->F_p, p) + around(this->F_p, p + 1)) / 3.0;
      mu += 0.5 *
        ((M_1 - this->F_i).cross(B - this->F_i).norm() +
          (B - this->F_i).cross(M_2 - this->F_i).norm());
    }
    return mu;
  }
};

} // namespace

Rings ringsOf(const evolving::SurfaceMesh& mesh)
{
  const evolving::MeshTopology topology(mesh);
  Rings rings;
  for (Index i = 0; i < mesh.vertexCount(); ++i)
  {
    const auto ring = topology.ringVertices(i);
    rings.emplace_back(ring.begin(), ring.end());
  }
  return rings;
}

ThesisGeometry thesisGeometry(const Rings& rings, const Eigen::MatrixX3d& F)
{
  ThesisGeometry geometry;
  geometry.mu.resize(F.rows());
  geometry.h.resize(F.rows(), 3);
  geometry.L.reserve(7 * rings.size()); // six neighbours on average
  for (Index i = 0; i < static_cast<Index>(F.rows()); ++i)
  {
    const std::vector<Index>& neighbours = rings[static_cast<std::size_t>(i)];
    const Ring ring(neighbours, i, F);
    Vec3 integral = Vec3::Zero();
    double sum = 0.0;
    for (int p = 0; p < ring.size(); ++p)
    {
      const double w = ring.weight(p);
      geometry.L.emplace_back(i, around(neighbours, p), -w);
      integral += w * (around(ring.F_p, p) - ring.F_i);
      sum += w;
    }
    geometry.L.emplace_back(i, i, sum);
    geometry.mu[i] = ring.coVolume();
    geometry.h.row(i) = integral.transpose() / geometry.mu[i];
  }
  return geometry;
}

} // namespace benchmark
