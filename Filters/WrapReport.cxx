// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "WrapReport.h"

#include "EvolutionOutput.h"

#include "vtkPolyData.h"

namespace
{

//------------------------------------------------------------------------------
/// Has a surface faults that the same surface without rounding has not?
bool IsSpoiled(
  const evolving::SurfaceReport& rounded, const evolving::SurfaceReport& exact, double edgeLength)
{
  return rounded.selfIntersections > exact.selfIntersections ||
    evolving::shortcomings(rounded, edgeLength).size() >
    evolving::shortcomings(exact, edgeLength).size();
}

} // namespace

namespace WrapReport
{

//------------------------------------------------------------------------------
evolving::SurfaceReport Examine(const evolving::SurfaceMesh& result,
  const evolving::ShrinkWrapProblem& problem, EvolutionOutput& series,
  const evolving::Execution& execution)
{
  if (series.PointType() == VTK_FLOAT)
  {
    evolving::SurfaceMesh rounded = result;
    rounded.points = evolving::roundedToFloats(result.points);
    const auto report = evolving::examineWrap(rounded, problem, execution.phase(0.0, 0.5));
    if (evolving::shortcomings(report, problem.edgeLength).empty())
    {
      return report;
    }
    auto exact = evolving::measureWrap(result, problem, execution.phase(0.5, 1.0));
    exact.lost = report.lost; // the elements are the same
    if (!IsSpoiled(report, exact, problem.edgeLength))
    {
      return report;
    }
    series.UseDoubles();
    return exact;
  }
  return evolving::examineWrap(result, problem, execution);
}

//------------------------------------------------------------------------------
void Write(const evolving::SurfaceReport& report, const std::vector<std::string>& shortcomings,
  vtkPolyData* output)
{
  KernelBridge::AddFieldValue(output, "IsClosed", report.isClosed ? 1 : 0);
  KernelBridge::AddFieldValue(output, "IsManifold", report.isManifold ? 1 : 0);
  KernelBridge::AddFieldValue(output, "SelfIntersections", report.selfIntersections);
  KernelBridge::AddFieldValue(output, "Genus", report.genus);
  KernelBridge::AddFieldValue(output, "MinAngle", report.minAngle);
  KernelBridge::AddFieldValue(output, "MaxDistance", report.maxDistance);
  if (!shortcomings.empty())
  {
    KernelBridge::AddFieldStrings(output, "Shortcomings", shortcomings);
  }
}

} // namespace WrapReport
