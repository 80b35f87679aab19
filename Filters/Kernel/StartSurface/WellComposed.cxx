// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "StartSurface/WellComposed.h"

#include <array>
#include <limits>
#include <vector>

namespace evolving
{

namespace
{

/// The corners of a cell's six faces as bit sets, and their two diagonals.
constexpr std::array<unsigned, 6> FaceCorners = { 0x55, 0xaa, 0x33, 0xcc, 0x0f, 0xf0 };
constexpr std::array<unsigned, 6> FaceDiagonals = { 0x41, 0x82, 0x21, 0x84, 0x09, 0x90 };
/// The four pairs of corners that are opposite in the cell.
constexpr std::array<unsigned, 4> CellDiagonals = { 0x81, 0x42, 0x24, 0x18 };

/// The outside corners any of which settles, or helps to settle, an ambiguous cell; else 0.
unsigned cornersToTurn(unsigned corners)
{
  unsigned candidates = 0;
  for (std::size_t face = 0; face < FaceCorners.size(); ++face)
  {
    const unsigned inside = corners & FaceCorners[face];
    if (inside == FaceDiagonals[face] || inside == (FaceCorners[face] ^ FaceDiagonals[face]))
    {
      candidates |= FaceCorners[face] ^ inside;
    }
  }
  for (const unsigned diagonal : CellDiagonals)
  {
    if (corners == diagonal || corners == (0xffU ^ diagonal))
    {
      candidates |= 0xffU ^ corners;
    }
  }
  return candidates;
}

std::array<unsigned char, 256> tabulateCandidates()
{
  std::array<unsigned char, 256> table{};
  for (unsigned corners = 0; corners < 256; ++corners)
  {
    table[corners] = static_cast<unsigned char>(cornersToTurn(corners));
  }
  return table;
}

unsigned candidatesOf(unsigned corners)
{
  static const std::array<unsigned char, 256> Table = tabulateCandidates();
  return Table[corners];
}

GridIndex smallestCandidate(const InsideSamples& samples, GridIndex cell, unsigned candidates)
{
  GridIndex best = cell;
  double smallest = std::numeric_limits<double>::infinity();
  for (unsigned b = 0; b < 8; ++b)
  {
    const GridIndex sample = cell + samples.cornerOffset(b);
    if ((candidates >> b & 1U) != 0 && samples.valueAboveIso(sample) < smallest)
    {
      smallest = samples.valueAboveIso(sample);
      best = sample;
    }
  }
  return best;
}

/// Settles a cell and, in turn, the cells that become ambiguous by it.
GridIndex settle(InsideSamples& samples, GridIndex first)
{
  GridIndex turned = 0;
  std::vector<GridIndex> pending{ first };
  while (!pending.empty())
  {
    const GridIndex cell = pending.back();
    const unsigned candidates = candidatesOf(samples.cornersOfCell(cell));
    if (candidates == 0)
    {
      pending.pop_back();
      continue;
    }
    const GridIndex sample = smallestCandidate(samples, cell, candidates);
    samples.setInside(sample);
    ++turned;
    for (unsigned b = 0; b < 8; ++b)
    {
      pending.push_back(sample - samples.cornerOffset(b));
    }
  }
  return turned;
}

} // namespace

bool isAmbiguousCell(unsigned corners)
{
  return candidatesOf(corners) != 0;
}

GridIndex makeWellComposed(InsideSamples& samples, const Execution& execution)
{
  GridIndex turned = 0;
  for (int k = 0; k + 1 < samples.size(2); ++k)
  {
    execution.report(static_cast<double>(k) / samples.size(2));
    for (int j = 0; j + 1 < samples.size(1); ++j)
    {
      for (int i = 0; i + 1 < samples.size(0); ++i)
      {
        const GridIndex cell = samples.sample(i, j, k);
        if (isAmbiguousCell(samples.cornersOfCell(cell)))
        {
          turned += settle(samples, cell);
        }
      }
    }
  }
  return turned;
}

} // namespace evolving
