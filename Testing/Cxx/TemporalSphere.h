// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @class TemporalSphere
 * @brief a source with three time steps, as an animated file has them
 *
 * At time t in { 0, 1, 2 } it is an icosphere of radius 1 + t. It remembers what was asked of it.
 */

#ifndef TemporalSphere_h
#define TemporalSphere_h

#include "vtkPolyDataAlgorithm.h"

#include <vector>

class TemporalSphere : public vtkPolyDataAlgorithm
{
public:
  static TemporalSphere* New();
  vtkTypeMacro(TemporalSphere, vtkPolyDataAlgorithm);

  /// The times of all executions, in their order.
  std::vector<double> Asked;

protected:
  TemporalSphere();
  ~TemporalSphere() override = default;

  int RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  TemporalSphere(const TemporalSphere&) = delete;
  void operator=(const TemporalSphere&) = delete;
};

#endif
