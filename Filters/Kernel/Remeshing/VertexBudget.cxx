// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Remeshing/VertexBudget.h"

#include "Errors.h"
#include "Remeshing/SizingField.h"

#include <cmath>
#include <sstream>

namespace evolving
{

void requireFewVertices(const EditableSurface& surface, double edgeLength, double most)
{
  const double vertices = expectedVertices(surface);
  if (!(vertices > most))
  {
    return;
  }
  constexpr double Margin = 1.1; // so that what is proposed passes
  std::ostringstream message;
  message << "Triangles with edges of " << edgeLength << " would be about " << 2.0 * vertices
          << ", expected at most " << 2.0 * most << "; set TargetEdgeLength to at least "
          << Margin * edgeLength * std::sqrt(vertices / most) << ".";
  throw InputError(message.str());
}

} // namespace evolving
