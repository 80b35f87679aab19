// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * Label images of shapes that are known.
 */

#ifndef EVOLVING_TESTING_LABEL_IMAGES_H
#define EVOLVING_TESTING_LABEL_IMAGES_H

#include "LabelSurfaces/LabelSurfaces.h"
#include "Types.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <random>
#include <string>
#include <vector>

namespace evolving::testing_labels
{

/// The image of a function of voxels' middles.
inline LabelImage labelsOf(
  const std::array<Index, 3>& sizes, const std::function<int(const Vec3&)>& label)
{
  LabelImage image;
  image.sizes = sizes;
  for (Index k = 0; k < sizes[2]; ++k)
  {
    for (Index j = 0; j < sizes[1]; ++j)
    {
      for (Index i = 0; i < sizes[0]; ++i)
      {
        const int value = label(Vec3(i, j, k));
        image.materials.push_back(static_cast<Material>(value));
        image.labelCount = std::max(image.labelCount, static_cast<std::size_t>(value));
      }
    }
  }
  return image;
}

inline LabelImage labelsOf(Index size, const std::function<int(const Vec3&)>& label)
{
  return labelsOf({ size, size, size }, label);
}

/// A place that no voxel is at.
inline Vec3 offCentre(Index size)
{
  return Vec3(0.5 * size - 0.7, 0.5 * size - 0.4, 0.5 * size - 0.8);
}

inline LabelImage ball(Index size, double radius)
{
  return labelsOf(
    size, [=](const Vec3& p) { return (p - offCentre(size)).norm() < radius ? 1 : 0; });
}

/// A ball of two labels, cut by a plane that no axis is in.
inline const Vec3 CutNormal = Vec3(0.48, 0.6, 0.64);
inline LabelImage cutBall(Index size, double radius)
{
  return labelsOf(size,
    [=](const Vec3& p)
    {
      const Vec3 d = p - offCentre(size);
      return d.norm() >= radius ? 0 : d.dot(CutNormal) < 1.0 ? 1 : 2;
    });
}

/// Three sectors of a ball that meet along a line.
inline LabelImage sectors(Index size, double radius)
{
  return labelsOf(size,
    [=](const Vec3& p)
    {
      const Vec3 d = p - offCentre(size);
      const double angle = std::atan2(0.9 * d.y() + 0.3 * d.z(), d.x()) + M_PI;
      return d.norm() >= radius ? 0 : 1 + std::min(2, static_cast<int>(1.5 * angle / M_PI));
    });
}

inline LabelImage ballInBall(Index size, double outer, double inner)
{
  return labelsOf(size,
    [=](const Vec3& p)
    {
      const double distance = (p - offCentre(size)).norm();
      return distance < inner ? 2 : distance < outer ? 1 : 0;
    });
}

/// Cubes of four voxels, of four labels in turn.
inline LabelImage checker()
{
  return labelsOf(12,
    [](const Vec3& p)
    {
      const Eigen::Vector3i cube = (p / 4.0).cast<int>();
      return 1 + cube.sum() % 2 + 2 * (cube[0] % 2);
    });
}

inline LabelImage randomLabels(Index size, int count, unsigned seed)
{
  std::mt19937 generator(seed);
  return labelsOf(size,
    [&](const Vec3&) { return static_cast<int>(generator() % static_cast<unsigned>(count + 1)); });
}

inline LabelImage noise(Index size, double part, unsigned seed)
{
  std::mt19937 generator(seed);
  return labelsOf(size,
    [&](const Vec3&) {
      return static_cast<double>(generator()) < part * static_cast<double>(generator.max()) ? 1 : 0;
    });
}

inline LabelImage voxels(Index size, const std::vector<std::array<int, 3>>& all)
{
  return labelsOf(size,
    [&](const Vec3& p)
    {
      return std::any_of(all.begin(), all.end(),
               [&](const std::array<int, 3>& voxel)
               { return p == Vec3(voxel[0], voxel[1], voxel[2]); })
        ? 1
        : 0;
    });
}

struct NamedImage
{
  std::string name;
  LabelImage image;
};

/// Of every kind of place where labels can meet.
inline std::vector<NamedImage> allKinds()
{
  return { { "ball", ball(24, 9.0) }, { "cut ball", cutBall(24, 9.0) },
    { "sectors", sectors(24, 9.0) }, { "ball in ball", ballInBall(24, 9.0, 4.0) },
    { "checker", checker() }, { "one voxel", voxels(3, { { 1, 1, 1 } }) },
    { "by an edge", voxels(4, { { 1, 1, 1 }, { 2, 2, 1 } }) },
    { "by a corner", voxels(4, { { 1, 1, 1 }, { 2, 2, 2 } }) },
    // Each label joins itself around an edge that it also touches itself along: twice, so that
    // both ends of that edge are one vertex each.
    { "pinched edge",
      voxels(5,
        { { 1, 1, 2 }, { 2, 2, 2 }, { 1, 1, 1 }, { 2, 1, 1 }, { 2, 2, 1 }, { 1, 1, 3 }, { 2, 1, 3 },
          { 2, 2, 3 } }) },
    { "random 1", randomLabels(9, 4, 1) }, { "random 2", randomLabels(9, 2, 2) },
    { "random 3", randomLabels(8, 40, 3) }, { "noise 1", noise(10, 0.3, 4) },
    { "noise 2", noise(10, 0.7, 5) }, { "full", labelsOf(3, [](const Vec3&) { return 1; }) } };
}

} // namespace evolving::testing_labels

#endif
