// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "OutputChecks.h"

#include "Verdict.h"

#include "DataChecks.h"

#include "vtkDataArray.h"
#include "vtkDataObject.h"
#include "vtkDataSet.h"
#include "vtkFieldData.h"
#include "vtkPointData.h"

#include <cmath>

namespace robustness
{

double fieldNumber(vtkDataObject* data, const char* name)
{
  vtkDataArray* array = data->GetFieldData()->GetArray(name);
  require(array && array->GetNumberOfValues() == 1, Fault::Misstated, "the field array ", name,
    " is not there, or has not one value");
  return array->GetTuple1(0);
}

vtkDataArray* pointArray(vtkDataSet* data, const char* name, int components)
{
  vtkDataArray* array = data->GetPointData()->GetArray(name);
  require(array && array->GetNumberOfComponents() == components &&
      array->GetNumberOfTuples() == data->GetNumberOfPoints(),
    Fault::Misstated, "the point array ", name, " is not there, or has another shape");
  return array;
}

void requireFinite(vtkDataObject* data)
{
  const testing::AssertionResult result = IsFinite(data);
  require(bool(result), Fault::NotFinite, result.message());
}

void requireStated(const std::string& name, double stated, double measured, double tolerance)
{
  require(std::abs(stated - measured) <= tolerance, Fault::Misstated, name, " is said to be ",
    stated, ", and is ", measured);
}

void requireUsableFaces(const Surface& surface)
{
  require(hasUsableFaces(surface), Fault::NotTriangles,
    "a face of the output has points that are not there, or fewer than three corners");
}

void requireClosed(const Topology& topology)
{
  require(topology.borderEdges == 0, Fault::Borders, topology.borderEdges, " border edges");
  require(topology.isManifold(), Fault::NotManifold, topology.crowdedEdges,
    " edges of several faces, ", topology.crowdedVertices, " vertices of several fans");
  require(topology.isOriented(), Fault::NotOriented, topology.turnedEdges,
    " edges between faces that face opposite ways");
}

void requireOutward(const Surface& surface)
{
  const double volume = smallestOuterVolume(surface);
  require(volume > 0.0, volume < 0.0 ? Fault::NotOriented : Fault::NoVolume,
    "a component has the volume ", volume, ", area ", areaOf(surface));
}

} // namespace robustness
