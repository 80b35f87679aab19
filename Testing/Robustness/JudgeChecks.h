// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * What the tests of the judges share: right outputs, and how to spoil them.
 */

#ifndef ROBUSTNESS_JUDGE_CHECKS_H
#define ROBUSTNESS_JUDGE_CHECKS_H

#include "Subject.h"
#include "Verdict.h"

#include <functional>

class vtkDataObject;
class vtkPolyData;

namespace robustness
{

/// What a judge finds; None when it finds nothing.
Fault faultOf(const std::function<void()>& judge);

/// A unit icosphere.
Subject ball();

/// Says something else in a field array of one value.
void setField(vtkDataObject* data, const char* name, double value);

/// Gives a face other corners; one without any goes.
void setFace(vtkPolyData* data, vtkIdType face, const std::function<void(Cell&)>& change);

} // namespace robustness

#endif
