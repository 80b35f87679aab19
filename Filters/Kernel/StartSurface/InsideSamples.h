// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * Which samples of a scalar field count as inside an iso-surface.
 */

#ifndef EVOLVING_INSIDE_SAMPLES_H
#define EVOLVING_INSIDE_SAMPLES_H

#include "Distance/DistanceGrid.h"
#include "Execution.h"
#include "Types.h"

#include <array>
#include <vector>

namespace evolving
{

/**
 * Samples as inside or outside, with a layer of outside samples all round, so that no inside
 * region touches the border and every surface between the two is closed.
 *
 * Samples are named by one number over the grid including that layer; cell c has its lowest
 * corner at sample c. Inside means below the iso-value at first; algorithms that close or repair
 * the region turn more samples inside.
 */
class InsideSamples
{
public:
  /**
   * @param field one value per sample of the grid, x fastest; it must outlive this object
   * @throws InputError when the field's length is not the grid's, or a value is not finite
   * @throws Cancelled
   */
  InsideSamples(const DistanceGrid& grid, const std::vector<float>& field, double isoValue,
    const Execution& execution = {});

  /// Samples along an axis, the outer layer included; one more than cells.
  int size(int axis) const { return this->Sizes[static_cast<std::size_t>(axis)]; }
  GridIndex sampleCount() const { return static_cast<GridIndex>(this->Inside.size()); }
  /// From a sample to the next one along an axis.
  GridIndex stride(int axis) const { return this->Strides[static_cast<std::size_t>(axis)]; }
  GridIndex sample(int i, int j, int k) const
  {
    return i + this->Strides[1] * j + this->Strides[2] * k;
  }
  /// The lattice coordinates of a sample; the grid's own samples begin at (1, 1, 1).
  std::array<int, 3> lattice(GridIndex sample) const;

  bool isInside(GridIndex sample) const { return this->Inside[at(sample)] != 0; }
  void setInside(GridIndex sample) { this->Inside[at(sample)] = 1; }
  /// A sample's value less the iso-value; infinite in the outer layer.
  double valueAboveIso(GridIndex sample) const;

  /// Bit b is set when the cell's corner (b & 1, b >> 1 & 1, b >> 2) is inside.
  unsigned cornersOfCell(GridIndex cell) const
  {
    unsigned corners = 0;
    for (unsigned b = 0; b < 8; ++b)
    {
      corners |= static_cast<unsigned>(this->Inside[at(cell + this->CornerOffsets[b])]) << b;
    }
    return corners;
  }
  /// From a cell's number to its corner b.
  GridIndex cornerOffset(unsigned b) const { return this->CornerOffsets[b]; }

private:
  void markBelow(const Execution& execution);

  std::array<int, 3> Sizes{};
  std::array<GridIndex, 3> Strides{};
  std::array<GridIndex, 8> CornerOffsets{};
  const std::vector<float>& Field;
  double IsoValue;
  std::vector<unsigned char> Inside;
};

/**
 * Turns inside every outside sample that no chain of neighbours (along the axes) joins to the
 * outer layer: cavities vanish, and with them everything that floats in them.
 * @return the number of samples turned
 */
GridIndex fillCavities(InsideSamples& samples, const Execution& execution = {});

} // namespace evolving

#endif
