// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "LabelSurfaces/MaterialGrid.h"

#include <algorithm>

namespace evolving
{

MaterialGrid::MaterialGrid(
  const std::array<Index, 3>& sizes, const std::vector<Material>& materials)
  : Sizes(sizes)
{
  this->Strides = { 1, sizes[0] + 2, static_cast<GridIndex>(sizes[0] + 2) * (sizes[1] + 2) };
  this->Materials.assign(at(this->Strides[2] * (sizes[2] + 2)), OutsideImage);
  auto row = materials.begin();
  for (Index k = 0; k < sizes[2]; ++k)
  {
    for (Index j = 0; j < sizes[1]; ++j)
    {
      std::copy_n(row, sizes[0], this->Materials.begin() + this->voxel(0, j, k));
      row += sizes[0];
    }
  }
}

Octants MaterialGrid::around(const std::array<Index, 3>& corner) const
{
  const GridIndex first = this->voxel(corner[0] - 1, corner[1] - 1, corner[2] - 1);
  Octants octants{};
  for (GridIndex b = 0; b < 8; ++b)
  {
    octants[at(b)] = this->Materials[at(first + (b & 1) * this->Strides[0] +
      (b >> 1 & 1) * this->Strides[1] + (b >> 2) * this->Strides[2])];
  }
  return octants;
}

} // namespace evolving
