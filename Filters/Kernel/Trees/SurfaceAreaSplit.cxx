// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Trees/SurfaceAreaSplit.h"

#include <algorithm>
#include <limits>

namespace evolving
{

namespace
{

using Four = Eigen::Array4f;

/// The areas of the split box as linear functions: SA_L(t) / SA = end + t * rise,
/// SA_R(t) / SA = end + (1 - t) * rise.
struct AreaRatios
{
  float end = 0.0F;
  float rise = 0.0F;
};

AreaRatios areaRatios(const Vec3& sides, int axis)
{
  const Vec3 relative = sides / sides.maxCoeff();
  const double a = relative[(axis + 1) % 3];
  const double b = relative[(axis + 2) % 3];
  const double caps = a * b;
  const double walls = relative[axis] * (a + b);
  if (!(caps + walls > 0.0))
  {
    return { 0.0F, 1.0F }; // a segment: its halves cost by length
  }
  return { static_cast<float>(caps / (caps + walls)), static_cast<float>(walls / (caps + walls)) };
}

/// Counts the intervals on the left and on the right of four positions at once.
std::array<SplitSample, 4> countAt(
  const Four& positions, const std::vector<SplitInterval>& intervals)
{
  // Ones are added as floats: exact below 2^24 per block, blocks summed as doubles.
  constexpr std::size_t Block = std::size_t(1) << 23;
  Eigen::Array4d left = Eigen::Array4d::Zero();
  Eigen::Array4d right = Eigen::Array4d::Zero();
  for (std::size_t begin = 0; begin < intervals.size(); begin += Block)
  {
    const std::size_t end = std::min(intervals.size(), begin + Block);
    Four blockLeft = Four::Zero();
    Four blockRight = Four::Zero();
    for (std::size_t i = begin; i < end; ++i)
    {
      blockLeft += (Four::Constant(intervals[i].low) < positions).cast<float>();
      blockRight += (Four::Constant(intervals[i].high) > positions).cast<float>();
    }
    left += blockLeft.cast<double>();
    right += blockRight.cast<double>();
  }
  std::array<SplitSample, 4> samples;
  for (int k = 0; k < 4; ++k)
  {
    samples[static_cast<std::size_t>(k)] = { positions[k], static_cast<float>(left[k]),
      static_cast<float>(right[k]), 0.0F };
  }
  return samples;
}

/// Four positions at equal steps of C_L - C_R, which rises from -N to N: where it rises
/// fastest, they lie closest.
Four positionsOfFastestChange(const std::array<SplitSample, 6>& samples, float count)
{
  Four positions;
  for (int k = 0; k < 4; ++k)
  {
    const float wanted = count * (-1.0F + 2.0F * static_cast<float>(k + 1) / 5.0F);
    std::size_t segment = 0;
    const auto rising = [&samples](std::size_t i)
    { return samples[i].leftCount - samples[i].rightCount; };
    while (segment < 4 && rising(segment + 1) < wanted)
    {
      ++segment;
    }
    const float from = rising(segment);
    const float to = rising(segment + 1);
    const float fraction = to > from ? std::clamp((wanted - from) / (to - from), 0.0F, 1.0F) : 0.5F;
    positions[k] = samples[segment].position +
      fraction * (samples[segment + 1].position - samples[segment].position);
  }
  return positions;
}

SplitParabola parabolaThrough(
  const SplitSample& from, const SplitSample& to, const AreaRatios& area)
{
  SplitParabola parabola;
  parabola.from = from.position;
  parabola.to = to.position;
  const float length = to.position - from.position;
  const float leftSlope = length > 0.0F ? (to.leftCount - from.leftCount) / length : 0.0F;
  const float rightSlope = length > 0.0F ? (to.rightCount - from.rightCount) / length : 0.0F;
  const float left = from.leftCount - leftSlope * from.position;
  const float right = from.rightCount - rightSlope * from.position;
  // (left + leftSlope t)(end + rise t) + (right + rightSlope t)(end + rise (1 - t))
  const float whole = area.end + area.rise;
  parabola.coefficients = { area.rise * (leftSlope - rightSlope),
    left * area.rise + leftSlope * area.end - right * area.rise + rightSlope * whole,
    left * area.end + right * whole };
  return parabola;
}

} // namespace

float SplitParabola::at(float t) const
{
  return (this->coefficients[0] * t + this->coefficients[1]) * t + this->coefficients[2];
}

float SplitParabola::lowest() const
{
  if (this->coefficients[0] > 0.0F)
  {
    const float apex = -this->coefficients[1] / (2.0F * this->coefficients[0]);
    return std::clamp(apex, this->from, this->to);
  }
  return at(this->from) <= at(this->to) ? this->from : this->to;
}

SplitSearch searchSplit(const Vec3& sides, int axis, const std::vector<SplitInterval>& intervals)
{
  const AreaRatios area = areaRatios(sides, axis);
  const auto count = static_cast<float>(intervals.size());
  const auto first = countAt(Four(0.2F, 0.4F, 0.6F, 0.8F), intervals);
  const std::array<SplitSample, 6> coarse{ SplitSample{ 0.0F, 0.0F, count, 0.0F }, first[0],
    first[1], first[2], first[3], SplitSample{ 1.0F, count, 0.0F, 0.0F } };
  const auto second = countAt(positionsOfFastestChange(coarse, count), intervals);

  SplitSearch search;
  std::copy(coarse.begin(), coarse.end(), search.samples.begin());
  std::copy(second.begin(), second.end(), search.samples.begin() + 6);
  std::stable_sort(search.samples.begin(), search.samples.end(),
    [](const SplitSample& a, const SplitSample& b) { return a.position < b.position; });
  for (SplitSample& sample : search.samples)
  {
    sample.cost = sample.leftCount * (area.end + area.rise * sample.position) +
      sample.rightCount * (area.end + area.rise * (1.0F - sample.position));
  }
  search.cost = std::numeric_limits<float>::infinity();
  for (std::size_t k = 0; k < search.parabolas.size(); ++k)
  {
    search.parabolas[k] = parabolaThrough(search.samples[k], search.samples[k + 1], area);
    const float position = search.parabolas[k].lowest();
    const float cost = search.parabolas[k].at(position);
    if (position > 0.0F && position < 1.0F && cost < search.cost)
    {
      search.position = position;
      search.cost = cost;
    }
  }
  return search;
}

} // namespace evolving
