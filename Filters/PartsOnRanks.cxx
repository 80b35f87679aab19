// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "PartsOnRanks.h"

#include "KernelBridge.h"

#include "vtkAppendPolyData.h"
#include "vtkCellData.h"
#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataObject.h"
#include "vtkDataSet.h"
#include "vtkDataSetAttributes.h"
#include "vtkFieldData.h"
#include "vtkMultiProcessController.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cstring>
#include <sstream>
#include <type_traits>

namespace
{

/// MPI counts bytes in an int, and connectivity may double in size on its way.
constexpr long long MostKibibytes = 1LL << 20;

//------------------------------------------------------------------------------
/// The part without the cells that another rank owns; in a whole nothing is a ghost.
vtkSmartPointer<vtkPolyData> OwnPart(vtkPolyData* mine)
{
  const auto part = vtkSmartPointer<vtkPolyData>::New();
  part->ShallowCopy(mine);
  part->RemoveGhostCells();
  part->GetPointData()->RemoveArray(vtkDataSetAttributes::GhostArrayName());
  part->GetCellData()->RemoveArray(vtkDataSetAttributes::GhostArrayName());
  return part;
}

} // namespace

//------------------------------------------------------------------------------
bool PartsOnRanks::Holding::IsTheSame(const Holding& other) const
{
  return this->Points == other.Points && this->Cells == other.Cells && this->Hash == other.Hash;
}

//------------------------------------------------------------------------------
PartsOnRanks::PartsOnRanks(vtkMultiProcessController* controller, vtkDataObject* mine)
  : Controller(controller)
  , Mine(vtkSmartPointer<vtkPolyData>::New())
  , Holdings(static_cast<std::size_t>(controller->GetNumberOfProcesses()))
{
  static_assert(std::is_trivially_copyable<Holding>::value, "a holding is sent as it is");
  constexpr std::size_t length = sizeof(Holding) / sizeof(long long);
  const Holding holding = Describe(mine);
  std::vector<long long> sent(length);
  std::vector<long long> received(length * this->Holdings.size());
  std::memcpy(sent.data(), &holding, sizeof(Holding));
  controller->AllGather(sent.data(), received.data(), static_cast<vtkIdType>(length));
  std::memcpy(this->Holdings.data(), received.data(), received.size() * sizeof(long long));
  // A copy, for the producer may make something else before the parts are gathered.
  if (auto* surface = vtkPolyData::SafeDownCast(mine))
  {
    this->Mine->ShallowCopy(surface);
  }
}

//------------------------------------------------------------------------------
PartsOnRanks::Holding PartsOnRanks::Describe(vtkDataObject* data)
{
  Holding holding;
  std::uint64_t hash = 0;
  const auto add = [&](vtkDataSet* leaf, unsigned int number)
  {
    holding.Points += leaf->GetNumberOfPoints();
    holding.Cells += leaf->GetNumberOfCells();
    hash = 31 * hash + (KernelBridge::ContentHash(leaf) ^ number);
  };
  if (auto* composite = vtkCompositeDataSet::SafeDownCast(data))
  {
    holding.What = Kind::Composite;
    const auto leaves = vtk::TakeSmartPointer(composite->NewIterator());
    for (leaves->InitTraversal(); !leaves->IsDoneWithTraversal(); leaves->GoToNextItem())
    {
      if (auto* leaf = vtkDataSet::SafeDownCast(leaves->GetCurrentDataObject()))
      {
        add(leaf, leaves->GetCurrentFlatIndex());
      }
    }
  }
  else if (auto* single = vtkDataSet::SafeDownCast(data))
  {
    holding.What = vtkPolyData::SafeDownCast(single) ? Kind::Surface : Kind::Other;
    add(single, 0);
  }
  holding.Kibibytes = data ? static_cast<long long>(data->GetActualMemorySize()) : 0;
  std::memcpy(&holding.Hash, &hash, sizeof(hash));
  return holding;
}

//------------------------------------------------------------------------------
bool PartsOnRanks::AreTheSame() const
{
  return std::all_of(this->Holdings.begin(), this->Holdings.end(),
    [this](const Holding& holding) { return holding.IsTheSame(this->Holdings.front()); });
}

//------------------------------------------------------------------------------
bool PartsOnRanks::AreSeveral() const
{
  return std::count_if(this->Holdings.begin(), this->Holdings.end(),
           [](const Holding& holding) { return holding.Points > 0; }) > 1;
}

//------------------------------------------------------------------------------
bool PartsOnRanks::Any(Kind kind) const
{
  return std::any_of(this->Holdings.begin(), this->Holdings.end(),
    [kind](const Holding& holding) { return holding.What == kind; });
}

//------------------------------------------------------------------------------
bool PartsOnRanks::AddsSomething(std::size_t rank) const
{
  const Holding& holding = this->Holdings[rank];
  const auto end = this->Holdings.begin() + static_cast<std::ptrdiff_t>(rank);
  return holding.Points > 0 &&
    std::none_of(this->Holdings.begin(), end,
      [&holding](const Holding& earlier) { return earlier.IsTheSame(holding); });
}

//------------------------------------------------------------------------------
std::string PartsOnRanks::WhyNotGathered() const
{
  long long kibibytes = 0;
  for (const Holding& holding : this->Holdings)
  {
    kibibytes += holding.Kibibytes;
  }
  std::ostringstream message;
  if (this->Any(Kind::Composite))
  {
    message << "The blocks of the input differ between the " << this->Holdings.size()
            << " ranks, expected the same blocks on each; apply Merge Blocks and Extract Surface "
               "before this filter, then the parts are gathered.";
  }
  else if (this->Any(Kind::Other))
  {
    message << "The image on the second input differs between the " << this->Holdings.size()
            << " ranks, expected the whole image on each; save it and open the file instead.";
  }
  else if (kibibytes > MostKibibytes)
  {
    message << "The input is spread over " << this->Holdings.size() << " ranks in parts of "
            << kibibytes << " KiB together, at most " << MostKibibytes
            << " KiB are gathered; decimate it before this filter.";
  }
  return message.str();
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> PartsOnRanks::Gather() const
{
  std::vector<vtkSmartPointer<vtkDataObject>> parts;
  if (!this->Controller->AllGather(OwnPart(this->Mine), parts))
  {
    return nullptr;
  }
  vtkNew<vtkAppendPolyData> append;
  vtkFieldData* fieldData = nullptr;
  for (std::size_t rank = 0; rank < parts.size() && rank < this->Holdings.size(); ++rank)
  {
    auto* part = vtkPolyData::SafeDownCast(parts[rank]);
    if (part && this->AddsSomething(rank))
    {
      append->AddInputData(part);
      fieldData = fieldData ? fieldData : part->GetFieldData();
    }
  }
  append->Update();
  const auto whole = vtkSmartPointer<vtkPolyData>::New();
  whole->ShallowCopy(append->GetOutput());
  if (fieldData)
  {
    whole->GetFieldData()->ShallowCopy(fieldData);
  }
  return whole;
}
