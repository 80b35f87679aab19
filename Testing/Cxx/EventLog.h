// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * What a filter said while it ran: its errors and warnings as sentences, and its progress.
 */

#ifndef EventLog_h
#define EventLog_h

#include "vtkSmartPointer.h"

#include <functional>
#include <string>
#include <vector>

class vtkAlgorithm;
class vtkCallbackCommand;

/**
 * Listens to a filter from its making to its end. The filter's own events are kept; those of its
 * executive, the trailer that VTK adds to every error, are only kept off the terminal.
 */
class EventLog
{
public:
  explicit EventLog(vtkAlgorithm* filter);
  ~EventLog();
  EventLog(const EventLog&) = delete;
  EventLog& operator=(const EventLog&) = delete;

  std::vector<std::string> Errors;
  std::vector<std::string> Warnings;
  std::vector<double> Progress;
  /// Errors and warnings of other objects, which a user would see too.
  std::vector<std::string> Others;

  /// Called after every progress event with its fraction.
  std::function<void(double)> OnProgress;

  void Clear();

private:
  vtkSmartPointer<vtkAlgorithm> Filter;
  vtkSmartPointer<vtkCallbackCommand> OfFilter;
  vtkSmartPointer<vtkCallbackCommand> OfExecutive;
  vtkSmartPointer<vtkCallbackCommand> OfOthers;
};

#endif
