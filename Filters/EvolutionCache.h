// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * A solved evolution, kept from one update of a filter to the next. Private to the module.
 */

#ifndef EvolutionCache_h
#define EvolutionCache_h

#include "ContentStamp.h"
#include "EvolutionOutput.h"

#include <memory>
#include <vector>

class vtkDataSet;

/**
 * The last solve, and what it was a solve of.
 * @tparam Parameters all that the solve depends on beside its inputs, with an operator== that
 * looks at every member
 */
template <typename Parameters>
struct EvolutionCache
{
  std::unique_ptr<EvolutionOutput> Series;

  /// Forgets the series unless it is the one of these inputs (null for none) and parameters.
  void Check(const std::vector<vtkDataSet*>& inputs, const Parameters& parameters)
  {
    bool isAnother = !(parameters == this->Used);
    this->Inputs.resize(inputs.size());
    for (std::size_t i = 0; i < inputs.size(); ++i)
    {
      // Every stamp looks, also after a change.
      isAnother = this->Inputs[i].Update(inputs[i]) || isAnother;
    }
    this->Used = parameters;
    if (isAnother)
    {
      this->Series.reset();
    }
  }

private:
  std::vector<ContentStamp> Inputs;
  Parameters Used;
};

#endif
