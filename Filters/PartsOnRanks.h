// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * What every rank of a parallel run holds of one data object, and how a whole is made of it.
 * Private to the module.
 */

#ifndef PartsOnRanks_h
#define PartsOnRanks_h

#include "vtkSmartPointer.h"

#include <string>
#include <vector>

class vtkDataObject;
class vtkMultiProcessController;
class vtkPolyData;

/// Making one and Gather() are collective: every rank of the controller must do it.
class PartsOnRanks
{
public:
  /// Tells the other ranks what this one holds: a surface, an image, a composite, or null.
  PartsOnRanks(vtkMultiProcessController* controller, vtkDataObject* mine);

  bool AreTheSame() const;
  /// Have several ranks something?
  bool AreSeveral() const;
  bool HasBlocks() const { return this->Any(Kind::Composite); }

  /// The sentence that refuses parts that cannot be gathered; empty for parts that can.
  std::string WhyNotGathered() const;

  /**
   * The parts one after the other, in the order of ranks, with the point and cell data they share.
   * Ghost cells are left out, and so is a part that an earlier rank has too. Null when the
   * controller fails.
   */
  vtkSmartPointer<vtkPolyData> Gather() const;

private:
  enum class Kind : long long
  {
    Surface,
    Composite,
    Other
  };

  /// One rank's part in numbers; what is sent, so it has no other type inside.
  struct Holding
  {
    long long Points = 0;
    long long Cells = 0;
    long long Hash = 0;
    long long Kibibytes = 0;
    Kind What = Kind::Surface;

    bool IsTheSame(const Holding& other) const;
  };

  static Holding Describe(vtkDataObject* data);
  bool Any(Kind kind) const;
  /// Has the rank something that no rank before it has?
  bool AddsSomething(std::size_t rank) const;

  vtkMultiProcessController* Controller;
  vtkSmartPointer<vtkPolyData> Mine;
  std::vector<Holding> Holdings;
};

#endif
