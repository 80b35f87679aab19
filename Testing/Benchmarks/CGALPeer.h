// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * CGAL's alpha_wrap_3 and isotropic_remeshing, where CGAL is installed. They are under the GPL:
 * only a benchmark links them.
 */

#ifndef BENCHMARK_CGAL_PEER_H
#define BENCHMARK_CGAL_PEER_H

#include "Mesh/SurfaceMesh.h"

#include <memory>
#include <string>

namespace benchmark
{

/// Its calls throw std::exception where CGAL does.
class CGALPeer
{
public:
  /// "CGAL 5.5.1", or empty where the build has none; then no object can be made.
  static std::string version();

  /// @param input welded triangles, or points alone
  explicit CGALPeer(const evolving::SurfaceMesh& input);
  ~CGALPeer();

  /// Triangles that are a manifold mesh with one orientation: what remesh() needs.
  bool canRemesh() const;

  /// alpha_wrap_3 of the triangles or points.
  void wrap(double alpha, double offset);
  /**
   * isotropic_remeshing of the mesh, three iterations as in CGAL's examples.
   * @param featureAngle edges sharper than that, in degrees, stay edges; 0: none does
   */
  void remesh(double edgeLength, double featureAngle);

  /// Of the last call.
  evolving::SurfaceMesh result() const;

private:
  struct Parts;
  std::unique_ptr<Parts> Own;
};

} // namespace benchmark

#endif
