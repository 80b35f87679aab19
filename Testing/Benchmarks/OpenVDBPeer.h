// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * OpenVDB's meshToVolume on the grid of an image, where OpenVDB is installed. Only benchmarks
 * link it.
 */

#ifndef BENCHMARK_OPENVDB_PEER_H
#define BENCHMARK_OPENVDB_PEER_H

#include "vtkImageData.h"
#include "vtkPolyData.h"

#include <memory>
#include <string>
#include <vector>

namespace benchmark
{

class OpenVDBPeer
{
public:
  /// "OpenVDB 10.0.1", or empty where the build has none; then no object can be made.
  static std::string version();

  /// Takes the triangles into the image's index space, where OpenVDB's voxels are its samples.
  OpenVDBPeer(vtkPolyData* triangles, vtkImageData* grid, int threads);
  ~OpenVDBPeer();

  /// meshToVolume with a band of so many voxels on both sides.
  void convert(float band);

  struct Field
  {
    std::vector<float> distance; ///< in cells; beyond the band the band's width, with a sign
    std::vector<char> inBand;
  };
  /// The samples of the last conversion.
  Field field() const;

private:
  struct Parts;
  std::unique_ptr<Parts> Own;
};

} // namespace benchmark

#endif
