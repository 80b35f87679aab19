// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * The named arrays that the filters compute, beside those of a user. Private to the module.
 */

#ifndef ResultArrays_h
#define ResultArrays_h

class vtkAbstractArray;
class vtkFieldData;

/**
 * Names of results are frozen, and inputs may have arrays of the same name. A result that a filter
 * of this module computed before gives way to the new one; an array of anyone else stays, under its
 * name with "_input" at its end. To be told apart, results carry an information key of VTK's, which
 * it hands on with copies of an array, and writes to XML files.
 */
namespace ResultArrays
{

/// Adds a result; an array of another origin that has its name keeps its values and its role.
void Add(vtkFieldData* data, vtkAbstractArray* result);

/// Was it computed by a filter of this module?
bool IsResult(vtkAbstractArray* array);

/// Removes all that were.
void Remove(vtkFieldData* data);

} // namespace ResultArrays

#endif
