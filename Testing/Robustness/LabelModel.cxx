// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "LabelModel.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkPointData.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace robustness
{

namespace
{

using Labels = std::function<int(const Vec3&)>;

/// Three numbers, in order: the arguments of a call have none.
template <class Draw>
Vec3 drawn(const Draw& draw)
{
  Vec3 vector;
  for (int axis = 0; axis < 3; ++axis)
  {
    vector[axis] = draw();
  }
  return vector;
}

/// The nearest of some places, within a ball.
Labels cells(Random& random, const Vec3& sizes, int count)
{
  std::vector<Vec3> seeds;
  for (int i = 0; i < count; ++i)
  {
    seeds.emplace_back(drawn([&]() { return random.real(0.0, 1.0); }).cwiseProduct(sizes));
  }
  const double radius = random.real(0.3, 1.0) * sizes.maxCoeff();
  return [=](const Vec3& p)
  {
    const auto nearer = [&p](const Vec3& a, const Vec3& b)
    { return (a - p).squaredNorm() < (b - p).squaredNorm(); };
    const auto nearest = std::min_element(seeds.begin(), seeds.end(), nearer);
    return (p - 0.5 * sizes).norm() < radius ? int(nearest - seeds.begin()) + 1 : 0;
  };
}

/// One in another.
Labels shells(Random& random, const Vec3& sizes, int count)
{
  const Vec3 centre = random.real(0.3, 0.7) * sizes;
  const double step = random.real(0.6, 3.0);
  return [=](const Vec3& p) { return std::max(0, count - int((p - centre).norm() / step)); };
}

/// Threads and sheets of one voxel, which cross.
Labels bars(Random& random, const Vec3& sizes, int count)
{
  std::vector<Vec3> lowest;
  std::vector<Vec3> highest;
  for (int i = 0; i < count; ++i)
  {
    Vec3 first;
    Vec3 last;
    for (int axis = 0; axis < 3; ++axis)
    {
      first[axis] = random.integer(0, int(sizes[axis]) - 1);
      last[axis] = random.chance(0.5) ? first[axis] : random.integer(0, int(sizes[axis]) - 1);
    }
    lowest.emplace_back(first.cwiseMin(last));
    highest.emplace_back(first.cwiseMax(last));
  }
  return [=](const Vec3& p)
  {
    for (std::size_t i = 0; i < lowest.size(); ++i)
    {
      if ((p.array() >= lowest[i].array()).all() && (p.array() <= highest[i].array()).all())
      {
        return int(i) + 1;
      }
    }
    return 0;
  };
}

Labels noise(Random& random, int count)
{
  const double part = random.real(0.02, 0.98);
  return [&random, part, count](const Vec3&)
  { return random.chance(part) ? random.integer(1, count) : 0; };
}

void place(Random& random, vtkImageData* image)
{
  const double spacing = random.chance(0.5) ? 1.0 : random.logarithmic(1e-4, 1e3);
  const Vec3 sides =
    drawn([&]() { return spacing * (random.chance(0.6) ? 1.0 : random.real(0.3, 3.0)); });
  image->SetSpacing(sides.data());
  const double far = random.chance(0.6) ? 0.0 : random.logarithmic(1.0, 1e7) * spacing;
  image->SetOrigin((far * random.direction()).eval().data());
  if (random.chance(0.3))
  {
    const Vec3 signs = drawn([&]() { return random.chance(0.5) ? 1.0 : -1.0; });
    image->SetDirectionMatrix(0.0, signs.x(), 0.0, signs.y(), 0.0, 0.0, 0.0, 0.0, signs.z());
  }
}

void spoil(Random& random, LabelModel& model)
{
  vtkDataArray* scalars = model.image->GetPointData()->GetScalars();
  const bool canHold = scalars->GetDataType() == VTK_DOUBLE;
  const auto voxel = vtkIdType(random.index(std::size_t(scalars->GetNumberOfTuples())));
  if (canHold && random.chance(0.3))
  {
    model.hasNaN = random.chance(0.5);
    model.hasFraction = !model.hasNaN;
    scalars->SetTuple1(voxel, model.hasNaN ? std::numeric_limits<double>::quiet_NaN() : 1.5);
    model.story += ", with one value that is no label";
  }
}

} // namespace

double LabelModel::voxelVolume() const
{
  const double* spacing = this->image->GetSpacing();
  return spacing[0] * spacing[1] * spacing[2];
}

Vec3 LabelModel::inVoxels(const Vec3& place) const
{
  Vec3 index;
  this->image->TransformPhysicalPointToContinuousIndex(place.data(), index.data());
  return index;
}

double LabelModel::distanceToFaces(double label, const Vec3& place) const
{
  int sizes[3];
  this->image->GetDimensions(sizes);
  const auto isOne = [&](const std::array<int, 3>& v)
  {
    const bool isInside =
      v[0] >= 0 && v[1] >= 0 && v[2] >= 0 && v[0] < sizes[0] && v[1] < sizes[1] && v[2] < sizes[2];
    return isInside &&
      this->values[std::size_t(v[0] + sizes[0] * (v[1] + std::int64_t(sizes[1]) * v[2]))] == label;
  };
  double least = std::numeric_limits<double>::infinity();
  constexpr int Reach = 2;
  const std::array<int, 3> near = { int(std::lround(place.x())), int(std::lround(place.y())),
    int(std::lround(place.z())) };
  for (int b = 0; b < (2 * Reach + 1) * (2 * Reach + 1) * (2 * Reach + 1); ++b)
  {
    const int side = 2 * Reach + 1;
    const std::array<int, 3> voxel = { near[0] + b % side - Reach,
      near[1] + b / side % side - Reach, near[2] + b / side / side - Reach };
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      std::array<int, 3> next = voxel;
      ++next[axis];
      if (isOne(voxel) != isOne(next))
      {
        Vec3 half = Vec3::Constant(0.5);
        half[int(axis)] = 0.0;
        const Vec3 middle = Vec3(voxel[0], voxel[1], voxel[2]) + 0.5 * Vec3::Unit(int(axis));
        least = std::min(least, ((place - middle).cwiseAbs() - half).cwiseMax(0.0).norm());
      }
    }
  }
  return least;
}

LabelModel drawLabels(Random& random, bool isOdd)
{
  LabelModel model;
  model.image = vtkSmartPointer<vtkImageData>::New();
  const int most = random.chance(0.8) ? 12 : 20;
  const bool isSlice = isOdd && random.chance(0.1);
  Vec3 sizes = drawn([&]() { return double(random.integer(2, most)); });
  sizes.z() = isSlice ? 1.0 : sizes.z();
  model.image->SetDimensions(int(sizes.x()), int(sizes.y()), int(sizes.z()));
  place(random, model.image);
  model.image->AllocateScalars(
    random.pick(std::vector<int>{ VTK_UNSIGNED_CHAR, VTK_SHORT, VTK_INT, VTK_DOUBLE }), 1);
  const int count = random.integer(1, 6);
  const int kind = random.integer(0, 3);
  const Labels labels = kind == 0 ? cells(random, sizes, count)
    : kind == 1                   ? shells(random, sizes, count)
    : kind == 2                   ? bars(random, sizes, count)
                                  : noise(random, count);
  static const char* const names[] = { "cells", "shells", "bars", "noise" };
  model.story = std::to_string(count) + " " + names[kind] + " in " +
    std::to_string(int(sizes.x())) + " x " + std::to_string(int(sizes.y())) + " x " +
    std::to_string(int(sizes.z())) + " voxels";
  vtkDataArray* scalars = model.image->GetPointData()->GetScalars();
  const double speckles = random.chance(0.3) ? 0.03 : 0.0;
  for (vtkIdType i = 0; i < scalars->GetNumberOfTuples(); ++i)
  {
    const Vec3 voxel(double(i % int(sizes.x())), double(i / int(sizes.x()) % int(sizes.y())),
      double(i / int(sizes.x()) / int(sizes.y())));
    const int own = labels(voxel);
    scalars->SetTuple1(i, random.chance(speckles) ? random.integer(0, count) : own);
  }
  if (isOdd)
  {
    spoil(random, model);
  }
  for (vtkIdType i = 0; i < scalars->GetNumberOfTuples(); ++i)
  {
    model.values.push_back(scalars->GetTuple1(i));
  }
  return model;
}

} // namespace robustness
