// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * The input of a filter in a run of several ranks: from what each of them holds to the whole
 * surface on all of them. Private to the module.
 */

#ifndef DistributedInput_h
#define DistributedInput_h

#include "vtkSmartPointer.h"
#include "vtkType.h"

#include <string>
#include <vector>

class PartsOnRanks;
class vtkAlgorithm;
class vtkExecutive;
class vtkInformation;
class vtkInformationVector;
class vtkMultiProcessController;
class vtkPolyData;

/**
 * Every rank asks for its own piece, which is what ParaView has computed to draw it: asked for the
 * whole, a reader would give it on all ranks from then on, to be drawn as often, and a filter that
 * spreads data would spread all these copies. Then the ranks compare what they hold:
 * - the same: it is the whole already;
 * - parts of a surface whose sources all can make pieces: each rank asks for the whole, which has
 *   no seams and is what a serial run gets;
 * - other parts of a surface: they are gathered on every rank;
 * - anything else is refused.
 * Without a controller, or with one of a single process, the input is handed on.
 */
class DistributedInput
{
public:
  /// The request that RequestUpdateExtent() makes to the surface's producer, when the time is set.
  void RequestSurface(vtkInformation* input) const;

  /**
   * To be called from the filter's ModifyRequest(), which every rank passes once per update, its
   * inputs up to date, be they empty, composite or failed (RequestData() is called for every block
   * of a composite, and not at all after a failure). Talks to the other ranks only when the
   * pipeline before the filter has changed: that is the same on all of them, while one may execute
   * again alone, for a larger part of a grid.
   */
  void Exchange(vtkAlgorithm* filter, vtkInformation* request, int when);

  /// True when the ranks hold different data that cannot be gathered; Exchange() has said so.
  bool IsRefused() const { return !this->Refusal.empty(); }

  /// The whole surface: the gathered one, or the input as it is.
  vtkPolyData* Surface(vtkInformationVector* inputVector) const;

  /**
   * Turns cell numbers of Surface() into what a user knows: after gathering the cells' global ids,
   * where they have some.
   */
  void NameCells(std::vector<vtkIdType>& cells) const;

private:
  /// Where an input came from: changes on all ranks or on none.
  struct Origin
  {
    vtkExecutive* Producer = nullptr;
    int Port = 0; ///< of the producer
    vtkMTimeType PipelineTime = 0;
    double TimeStep = 0.0;

    bool operator==(const Origin& other) const;
  };

  static Origin OriginOf(vtkInformation* input);
  void Compare(vtkMultiProcessController* controller, vtkAlgorithm* filter);
  void Gather(const PartsOnRanks& parts);

  std::vector<Origin> Known;
  bool AsksForWhole = false;
  vtkSmartPointer<vtkPolyData> Gathered;
  std::string Refusal;
};

#endif
