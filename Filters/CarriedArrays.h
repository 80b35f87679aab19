// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * Which arrays of an input an output has, too. Private to the module.
 */

#ifndef CarriedArrays_h
#define CarriedArrays_h

#include "vtkSmartPointer.h"

#include <string>

class vtkAlgorithm;
class vtkDataSetAttributes;
class vtkPolyData;

/**
 * Point and cell data are carried with the roles they have, active scalars say. Not carried are
 * - results of an earlier filter of this module, which are of the surface that was its output;
 * - normals and tangents, which are not those of a surface that has moved;
 * - arrays with fewer values than there are points or cells; MisfitWarning says so.
 */
namespace CarriedArrays
{

using Attributes = vtkSmartPointer<vtkDataSetAttributes>;

Attributes OfPoints(vtkPolyData* input);
Attributes OfCells(vtkPolyData* input);
/// Is there any of both?
bool HasAny(vtkPolyData* input);

/// Without ids (global, pedigree) and ghost types: they mean points and cells that are there no
/// longer, or several times.
Attributes WithoutIdentity(vtkDataSetAttributes* data);

///@{
/**
 * Arrays with something between two values: numbers of type float or double, and colors (unsigned
 * char of three or four components); and all others: labels, numbers of something, bits, strings.
 */
Attributes Continuous(vtkDataSetAttributes* data);
Attributes Discrete(vtkDataSetAttributes* data);
///@}

/// For an output that has the input's arrays and its points elsewhere: removes normals, tangents.
void RemoveNormals(vtkPolyData* output);

/// Makes the array Normals of a moved surface the active one where the input has some.
void RenewNormals(vtkPolyData* input, vtkPolyData* output);

} // namespace CarriedArrays

/// Warns of arrays that are too short, once and not with every time step.
class MisfitWarning
{
public:
  void Say(vtkAlgorithm* filter, vtkPolyData* input);

private:
  std::string Said;
};

#endif
