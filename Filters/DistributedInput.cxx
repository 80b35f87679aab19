// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "DistributedInput.h"

#include "KernelBridge.h"
#include "PartsOnRanks.h"

#include "vtkAlgorithm.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDataObject.h"
#include "vtkDemandDrivenPipeline.h"
#include "vtkExecutive.h"
#include "vtkInformation.h"
#include "vtkInformationExecutivePortKey.h"
#include "vtkInformationVector.h"
#include "vtkMultiProcessController.h"
#include "vtkPolyData.h"
#include "vtkStreamingDemandDrivenPipeline.h"

namespace
{

//------------------------------------------------------------------------------
vtkDataObject* InputOf(vtkAlgorithm* filter, int port)
{
  vtkInformation* input = filter->GetExecutive()->GetInputInformation(port, 0);
  return input ? vtkDataObject::GetData(input) : nullptr;
}

//------------------------------------------------------------------------------
/// Do the sources of this output make any piece, and so the whole too, on every rank?
bool MakesPieces(vtkAlgorithm* algorithm, int port)
{
  bool makesPieces = true;
  bool isSource = true;
  for (int i = 0; i < algorithm->GetNumberOfInputPorts(); ++i)
  {
    for (int j = 0; j < algorithm->GetNumberOfInputConnections(i); ++j)
    {
      int inputPort = 0;
      vtkAlgorithm* producer = algorithm->GetInputAlgorithm(i, j, inputPort);
      makesPieces = makesPieces && MakesPieces(producer, inputPort);
      isSource = false;
    }
  }
  vtkInformation* output = algorithm->GetOutputInformation(port);
  return isSource ? output->Has(vtkAlgorithm::CAN_HANDLE_PIECE_REQUEST()) ||
      output->Has(vtkAlgorithm::CAN_PRODUCE_SUB_EXTENT())
                  : makesPieces;
}

//------------------------------------------------------------------------------
bool CanBeWhole(vtkAlgorithm* filter)
{
  int port = 0;
  vtkAlgorithm* producer = filter->GetInputAlgorithm(0, 0, port);
  return MakesPieces(producer, port);
}

//------------------------------------------------------------------------------
void UpdateWhole(vtkAlgorithm* filter)
{
  int port = 0;
  vtkAlgorithm* producer = filter->GetInputAlgorithm(0, 0, port);
  KernelBridge::RequestWholeInput(filter->GetExecutive()->GetInputInformation(0, 0));
  producer->Update(port);
}

} // namespace

//------------------------------------------------------------------------------
bool DistributedInput::Origin::operator==(const Origin& other) const
{
  return this->Producer == other.Producer && this->Port == other.Port &&
    this->PipelineTime == other.PipelineTime && this->TimeStep == other.TimeStep;
}

//------------------------------------------------------------------------------
DistributedInput::Origin DistributedInput::OriginOf(vtkInformation* input)
{
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  Origin origin;
  vtkExecutive::PRODUCER()->Get(input, origin.Producer, origin.Port);
  if (auto* pipeline = vtkDemandDrivenPipeline::SafeDownCast(origin.Producer))
  {
    origin.PipelineTime = pipeline->GetPipelineMTime();
  }
  // Producers that know no time do not execute again for another one.
  const bool isTemporal = input->Has(Pipeline::TIME_STEPS()) || input->Has(Pipeline::TIME_RANGE());
  if (isTemporal && input->Has(Pipeline::UPDATE_TIME_STEP()))
  {
    origin.TimeStep = input->Get(Pipeline::UPDATE_TIME_STEP());
  }
  return origin;
}

//------------------------------------------------------------------------------
void DistributedInput::RequestSurface(vtkInformation* input) const
{
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  KernelBridge::RequestWholeInput(input);
  auto* controller = vtkMultiProcessController::GetGlobalController();
  const bool isKnownWhole =
    this->AsksForWhole && !this->Known.empty() && this->Known.front() == OriginOf(input);
  if (controller && !isKnownWhole)
  {
    input->Set(Pipeline::UPDATE_PIECE_NUMBER(), controller->GetLocalProcessId());
    input->Set(Pipeline::UPDATE_NUMBER_OF_PIECES(), controller->GetNumberOfProcesses());
  }
}

//------------------------------------------------------------------------------
void DistributedInput::Exchange(vtkAlgorithm* filter, vtkInformation* request, int when)
{
  auto* controller = vtkMultiProcessController::GetGlobalController();
  const bool hasInputs =
    when == vtkExecutive::AfterForward && request->Has(vtkDemandDrivenPipeline::REQUEST_DATA());
  if (!hasInputs || !controller || controller->GetNumberOfProcesses() < 2)
  {
    return;
  }
  std::vector<Origin> origins;
  for (int port = 0; port < filter->GetNumberOfInputPorts(); ++port)
  {
    vtkInformation* input = filter->GetExecutive()->GetInputInformation(port, 0);
    origins.push_back(input ? OriginOf(input) : Origin());
  }
  if (!(origins == this->Known))
  {
    this->Known = origins;
    this->Compare(controller, filter);
  }
  if (this->IsRefused())
  {
    vtkErrorWithObjectMacro(filter, << this->Refusal);
  }
}

//------------------------------------------------------------------------------
void DistributedInput::Compare(vtkMultiProcessController* controller, vtkAlgorithm* filter)
{
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  vtkInformation* surface = filter->GetExecutive()->GetInputInformation(0, 0);
  this->AsksForWhole = surface && surface->Get(Pipeline::UPDATE_NUMBER_OF_PIECES()) == 1;
  this->Gathered = nullptr;
  this->Refusal.clear();
  for (int port = 1; port < filter->GetNumberOfInputPorts(); ++port)
  {
    const PartsOnRanks fields(controller, InputOf(filter, port));
    if (!fields.AreTheSame())
    {
      this->Refusal = fields.WhyNotGathered();
    }
  }
  const PartsOnRanks pieces(controller, InputOf(filter, 0));
  if (pieces.AreTheSame() || this->IsRefused())
  {
    return;
  }
  this->AsksForWhole = false;
  if (pieces.HasBlocks() || (pieces.AreSeveral() && CanBeWhole(filter)))
  {
    UpdateWhole(filter);
    this->AsksForWhole = PartsOnRanks(controller, InputOf(filter, 0)).AreTheSame();
  }
  if (!this->AsksForWhole)
  {
    this->Gather(pieces);
  }
}

//------------------------------------------------------------------------------
void DistributedInput::Gather(const PartsOnRanks& parts)
{
  this->Refusal = parts.WhyNotGathered();
  if (this->IsRefused())
  {
    return;
  }
  // The last exchange: it may fail on one rank alone, and no other may then wait for that rank.
  this->Gathered = parts.Gather();
  if (!this->Gathered)
  {
    this->Refusal = "The parts of the input could not be sent to all ranks, expected a working "
                    "communicator; run this filter on one rank.";
  }
}

//------------------------------------------------------------------------------
vtkPolyData* DistributedInput::Surface(vtkInformationVector* inputVector) const
{
  return this->Gathered ? this->Gathered.Get() : vtkPolyData::GetData(inputVector);
}

//------------------------------------------------------------------------------
void DistributedInput::NameCells(std::vector<vtkIdType>& cells) const
{
  vtkDataArray* ids = this->Gathered ? this->Gathered->GetCellData()->GetGlobalIds() : nullptr;
  if (!ids)
  {
    return;
  }
  for (vtkIdType& cell : cells)
  {
    cell = static_cast<vtkIdType>(ids->GetComponent(cell, 0));
  }
}
