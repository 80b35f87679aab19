// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * Smooth surfaces of the labels of an image.
 */

#ifndef EVOLVING_LABEL_SURFACES_H
#define EVOLVING_LABEL_SURFACES_H

#include "Execution.h"
#include "LabelSurfaces/MaterialGrid.h"
#include "Mesh/SurfaceMesh.h"
#include "Types.h"

#include <Eigen/Geometry>

#include <array>
#include <vector>

namespace evolving
{

struct LabelSurfacesOptions
{
  /// In voxels; waves of the voxels' stairs that are shorter than about six times it are smoothed
  /// away. 0: the voxels' faces.
  double smoothingLength = 2.0;
};

/// An image by the number of each voxel's label.
struct LabelImage
{
  std::array<Index, 3> sizes{};
  std::vector<Material> materials; ///< of all voxels, x fastest; Background, or from 1
  std::size_t labelCount = 0;
  /// From numbers of voxels, the first (0, 0, 0), to points. May mirror.
  Eigen::Affine3d toSpace = Eigen::Affine3d::Identity();
};

struct LabelSurfaces
{
  /// The closed surfaces of all labels, label 1 first, without common vertices.
  SurfaceMesh surfaces;
  std::vector<Material> labels; ///< of every face
  std::vector<Material> others; ///< what is at its other side
  /// Every interface once; where labels touch both have its very points.
  SurfaceMesh interfaces;
  std::vector<std::array<Material, 2>> sides; ///< of every face; it is seen from the second
  /// Of every label, label 1 first, with the points as they are; in units of space.
  std::vector<double> volumes;
  std::vector<double> voxelVolumes; ///< those of its voxels
  double largestVolumeError = 0.0;  ///< relative, but for the rounding of points
  bool pointsAreFloats = true; ///< all are rounded to floats; not where those could not hold them
};

/**
 * The faces between voxels are made one net of quads that all labels share, so that labels cannot
 * overlap nor leave gaps. It is smoothed (smoothNet), then its triangles get good elements where
 * sheets meet, each label the volume of its voxels, and what intersects goes back
 * (InterfaceFinish). All in units of voxels, so that voxels of any shape are treated alike. Where a
 * label runs out of the image its surface is flat and closed, in the plane of the outermost voxels'
 * faces.
 *
 * Every vertex is within half a voxel along each axis of the voxels' faces (NetLimits).
 *
 * Such nets are those of Gibson, *Constrained elastic surface nets* (1998), with a bending energy
 * in place of the elastic one, and volumes.
 *
 * @throws InputError, SolverError, Cancelled
 */
LabelSurfaces labelSurfaces(
  const LabelImage& image, const LabelSurfacesOptions& options, const Execution& execution = {});

} // namespace evolving

#endif
