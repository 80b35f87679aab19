// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * Of which time a filter that makes times of its own takes its inputs. Private to the module.
 */

#ifndef InputStep_h
#define InputStep_h

class vtkDataObject;
class vtkInformation;
class vtkInformationVector;

/// The values of InputTime and InputTimeIndex.
struct InputStep
{
  enum
  {
    First = 0,
    Last = 1,
    Index = 2
  };

  int Which = Last;
  int Number = 0; ///< of the time step, from 0, for Index

  /**
   * Asks a temporal input for that step, so that a look at another time of the filter's own is no
   * new input. One that says no more than a range of times has a first and a last one.
   */
  void Request(vtkInformation* input) const;

  /// @throws evolving::InputError when a temporal input has no such step
  void Require(vtkInformation* input) const;

  /// Says in field data, InputTime, which time was taken; nothing for an input without times.
  static void Write(vtkInformation* input, vtkDataObject* output);
};

#endif
