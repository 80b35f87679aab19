// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "EvolutionOutput.h"

#include "vtkCellArray.h"
#include "vtkDoubleArray.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkTable.h"

#include <utility>

namespace
{

//------------------------------------------------------------------------------
void WritePointArrays(const evolving::StateArrays& arrays, bool hasField, vtkPolyData* output)
{
  if (hasField)
  {
    KernelBridge::AddPointArray(output, "SignedDistance", arrays.distance);
    KernelBridge::AddPointArray(output, "DistanceGradient", arrays.distanceGradient);
  }
  EvolutionArrays::WriteShapeArrays(arrays, output);
  KernelBridge::AddPointArray(output, "NormalVelocity", arrays.normalVelocity);
}

//------------------------------------------------------------------------------
void WriteFieldArrays(const evolving::FlowRecord& record, vtkPolyData* output)
{
  KernelBridge::AddFieldValue(output, "Iteration", record.iteration);
  KernelBridge::AddFieldValue(output, "Time", record.time);
  KernelBridge::AddFieldValue(output, "Area", record.area);
  KernelBridge::AddFieldValue(output, "Volume", record.volume);
  KernelBridge::AddFieldValue(output, "MeanDistance", record.meanDistance);
  KernelBridge::AddFieldValue(output, "MaxDistance", record.maxDistance);
  KernelBridge::AddFieldValue(output, "MinAngle", record.minAngle);
}

//------------------------------------------------------------------------------
template <typename Array, typename Value>
void AddColumn(vtkTable* table, const char* name, const std::vector<evolving::FlowRecord>& records,
  Value evolving::FlowRecord::*member)
{
  vtkNew<Array> column;
  column->SetName(name);
  column->SetNumberOfTuples(static_cast<vtkIdType>(records.size()));
  for (std::size_t row = 0; row < records.size(); ++row)
  {
    column->SetValue(static_cast<vtkIdType>(row), records[row].*member);
  }
  table->AddColumn(column);
}

//------------------------------------------------------------------------------
void WriteRecords(const std::vector<evolving::FlowRecord>& records, vtkTable* output)
{
  using Record = evolving::FlowRecord;
  output->Initialize();
  // Time first: a chart takes the first column as its x axis.
  AddColumn<vtkDoubleArray>(output, "Time", records, &Record::time);
  AddColumn<vtkIntArray>(output, "Iteration", records, &Record::iteration);
  AddColumn<vtkDoubleArray>(output, "Area", records, &Record::area);
  AddColumn<vtkDoubleArray>(output, "Volume", records, &Record::volume);
  AddColumn<vtkDoubleArray>(output, "MeanDistance", records, &Record::meanDistance);
  AddColumn<vtkDoubleArray>(output, "MaxDistance", records, &Record::maxDistance);
  AddColumn<vtkDoubleArray>(output, "MinAngle", records, &Record::minAngle);
  AddColumn<vtkIntArray>(output, "SolverIterations", records, &Record::solverIterations);
  AddColumn<vtkDoubleArray>(output, "Seconds", records, &Record::seconds);
}

} // namespace

//------------------------------------------------------------------------------
EvolutionOutput::EvolutionOutput(int pointType, bool hasField,
  evolving::StateSeries::MakeFlow makeFlow, const std::vector<int>& published,
  std::size_t memoryLimit, const evolving::Execution& execution, std::size_t flowBytes)
  : Type(pointType)
  , HasField(hasField)
  , Series(std::move(makeFlow), published, memoryLimit, execution, flowBytes,
      [this](const evolving::SurfaceFlow& flow) { this->Measure(flow); })
{
}

//------------------------------------------------------------------------------
void EvolutionOutput::Measure(const evolving::SurfaceFlow& flow)
{
  if (this->Type == VTK_FLOAT && !evolving::floatsHold(flow.mesh()))
  {
    this->UseDoubles();
  }
  if (this->Type == VTK_FLOAT)
  {
    // A last state may come twice, the second time tidied.
    this->RoundedRecords.resize(static_cast<std::size_t>(flow.record().iteration));
    this->RoundedRecords.push_back(flow.recordAt(evolving::roundedToFloats(flow.mesh().points)));
  }
}

//------------------------------------------------------------------------------
vtkCellArray* EvolutionOutput::PolygonsOf(
  const std::shared_ptr<const evolving::SurfaceMesh>& origin)
{
  // A state that was computed again has an equal origin, but not the same.
  const auto& written = this->WrittenOrigin;
  if (!written || (written != origin && !evolving::haveEqualFaces(*written, *origin)))
  {
    this->Polygons = KernelBridge::WritePolygons(*origin);
  }
  this->WrittenOrigin = origin;
  return this->Polygons;
}

//------------------------------------------------------------------------------
void EvolutionOutput::WriteState(std::size_t i, vtkPolyData* output,
  const evolving::Execution& execution, const WriteData& writeData)
{
  const auto state = this->Series.state(i, execution);
  output->Initialize();
  output->SetPolys(this->PolygonsOf(state->origin));
  KernelBridge::WritePoints(state->points, this->Type, output);
  if (writeData)
  {
    writeData(*state);
  }
  WritePointArrays(state->arrays, this->HasField, output);
  const auto iteration = static_cast<std::size_t>(state->record.iteration);
  WriteFieldArrays(
    this->Type == VTK_FLOAT ? this->RoundedRecords[iteration] : state->record, output);
  if (!this->Series.stopReason().empty())
  {
    KernelBridge::AddFieldValue(output, "Stopped", this->Series.lastIteration());
  }
  if (const int steps = this->Series.stepsWithoutRedistribution())
  {
    KernelBridge::AddFieldValue(output, "StepsWithoutRedistribution", steps);
  }
  if (const auto& time = this->Series.extinctionTime())
  {
    KernelBridge::AddFieldValue(output, "ExtinctionTime", *time);
  }
}

//------------------------------------------------------------------------------
std::shared_ptr<const evolving::FlowState> EvolutionOutput::LastState(
  const evolving::Execution& execution)
{
  return this->Series.state(this->Series.iterations().size() - 1, execution);
}

//------------------------------------------------------------------------------
evolving::SurfaceMesh EvolutionOutput::Mesh(std::size_t i, const evolving::Execution& execution)
{
  return this->Series.state(i, execution)->mesh();
}

//------------------------------------------------------------------------------
void EvolutionOutput::WriteHistory(vtkTable* output) const
{
  std::vector<evolving::FlowRecord> records = this->Series.history();
  if (this->Type == VTK_FLOAT)
  {
    records.assign(this->RoundedRecords.begin(),
      this->RoundedRecords.begin() + static_cast<std::ptrdiff_t>(records.size()));
    for (std::size_t row = 0; row < records.size(); ++row)
    {
      records[row].seconds = this->Series.history()[row].seconds;
    }
  }
  WriteRecords(records, output);
}

namespace EvolutionArrays
{

//------------------------------------------------------------------------------
void WriteShapeArrays(const evolving::StateArrays& arrays, vtkPolyData* output)
{
  KernelBridge::AddPointArray(output, "Normals", arrays.normal);
  KernelBridge::AddPointArray(output, "MeanCurvature", arrays.meanCurvature);
  KernelBridge::AddPointArray(output, "CoVolume", arrays.coVolume);
  KernelBridge::AddPointArray(output, "TangentialVelocity", arrays.tangentialVelocity);
  KernelBridge::AddPointArray(output, "RedistributionPotential", arrays.redistributionPotential);
}

//------------------------------------------------------------------------------
void WriteEmpty(vtkPolyData* output, bool hasField, const std::function<void()>& writeData)
{
  output->ShallowCopy(KernelBridge::WritePolyData({}, VTK_FLOAT));
  writeData();
  WritePointArrays({}, hasField, output);
}

//------------------------------------------------------------------------------
void WriteEmptyHistory(vtkTable* output)
{
  WriteRecords({}, output);
}

} // namespace EvolutionArrays
