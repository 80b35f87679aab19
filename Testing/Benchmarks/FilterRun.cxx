// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "FilterRun.h"

#include "vtkAlgorithm.h"
#include "vtkCallbackCommand.h"
#include "vtkExecutive.h"
#include "vtkNew.h"
#include "vtkSMPTools.h"

namespace benchmark
{

namespace
{

void keepMessage(vtkObject*, unsigned long, void* message, void* text)
{
  *static_cast<std::string*>(message) = static_cast<const char*>(text);
}

/// The pipeline only adds that the algorithm failed.
void dropMessage(vtkObject*, unsigned long, void*, void*) {}

/// "ERROR: In <file>, line <n>\n<class> (<address>): <sentence>\n\n"
std::string sentenceOf(const std::string& message)
{
  const std::size_t object = message.find("): ");
  const std::string text = object == std::string::npos ? message : message.substr(object + 3);
  return text.substr(0, text.find('\n'));
}

} // namespace

FilterRun runFilter(vtkAlgorithm* filter, const Arguments& arguments)
{
  FilterRun run;
  std::string message;
  vtkNew<vtkCallbackCommand> keep;
  keep->SetCallback(keepMessage);
  keep->SetClientData(&message);
  vtkNew<vtkCallbackCommand> drop;
  drop->SetCallback(dropMessage);
  const unsigned long kept = filter->AddObserver(vtkCommand::ErrorEvent, keep);
  const unsigned long dropped = filter->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, drop);
  const auto update = [&]
  {
    filter->Modified();
    filter->Update();
  };
  // The filters keep a backend that is not the sequential one.
  vtkSMPTools::LocalScope(vtkSMPTools::Config{ arguments.threads, "STDThread", false },
    [&]() { run.time = medianOf(arguments.runs, update); });
  filter->RemoveObserver(kept);
  filter->GetExecutive()->RemoveObserver(dropped);
  run.error = sentenceOf(message);
  return run;
}

} // namespace benchmark
