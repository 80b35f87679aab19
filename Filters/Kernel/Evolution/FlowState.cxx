// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Evolution/FlowState.h"

namespace evolving
{

SurfaceMesh FlowState::mesh() const
{
  SurfaceMesh mesh = *this->origin;
  mesh.points = this->points;
  return mesh;
}

} // namespace evolving
