// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "EventLog.h"

#include "vtkAlgorithm.h"
#include "vtkCallbackCommand.h"
#include "vtkExecutive.h"
#include "vtkOutputWindow.h"

namespace
{

//------------------------------------------------------------------------------
/// Without VTK's "ERROR: In file, line 1\nvtkClass (0x1234): " and the line ends after it.
std::string SentenceOf(const void* message)
{
  std::string text = static_cast<const char*>(message);
  const std::size_t prefix = text.find("): ");
  text.erase(0, prefix == std::string::npos ? 0 : prefix + 3);
  text.erase(text.find_last_not_of("\n\r ") + 1);
  return text;
}

//------------------------------------------------------------------------------
void Record(vtkObject*, unsigned long event, void* client, void* data)
{
  auto* log = static_cast<EventLog*>(client);
  if (event == vtkCommand::ErrorEvent)
  {
    log->Errors.push_back(SentenceOf(data));
  }
  else if (event == vtkCommand::WarningEvent)
  {
    log->Warnings.push_back(SentenceOf(data));
  }
  else
  {
    log->Progress.push_back(*static_cast<double*>(data));
    if (log->OnProgress)
    {
      log->OnProgress(log->Progress.back());
    }
  }
}

//------------------------------------------------------------------------------
void RecordOther(vtkObject*, unsigned long, void* client, void* data)
{
  static_cast<EventLog*>(client)->Others.emplace_back(static_cast<const char*>(data));
}

} // namespace

//------------------------------------------------------------------------------
EventLog::EventLog(vtkAlgorithm* filter)
  : Filter(filter)
  , OfFilter(vtkSmartPointer<vtkCallbackCommand>::New())
  , OfExecutive(vtkSmartPointer<vtkCallbackCommand>::New())
  , OfOthers(vtkSmartPointer<vtkCallbackCommand>::New())
{
  this->OfFilter->SetClientData(this);
  this->OfFilter->SetCallback(Record);
  for (const auto event :
    { vtkCommand::ErrorEvent, vtkCommand::WarningEvent, vtkCommand::ProgressEvent })
  {
    filter->AddObserver(event, this->OfFilter);
  }
  filter->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, this->OfExecutive);
  this->OfOthers->SetClientData(this);
  this->OfOthers->SetCallback(RecordOther);
  vtkOutputWindow::GetInstance()->AddObserver(vtkCommand::ErrorEvent, this->OfOthers);
  vtkOutputWindow::GetInstance()->AddObserver(vtkCommand::WarningEvent, this->OfOthers);
}

//------------------------------------------------------------------------------
EventLog::~EventLog()
{
  this->Filter->RemoveObserver(this->OfFilter);
  this->Filter->GetExecutive()->RemoveObserver(this->OfExecutive);
  vtkOutputWindow::GetInstance()->RemoveObserver(this->OfOthers);
}

//------------------------------------------------------------------------------
void EventLog::Clear()
{
  this->Errors.clear();
  this->Warnings.clear();
  this->Progress.clear();
  this->Others.clear();
}
