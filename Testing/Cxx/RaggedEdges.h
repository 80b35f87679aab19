// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * How far the sharp edges of a surface are from being lines.
 */

#ifndef RaggedEdges_h
#define RaggedEdges_h

class vtkPolyData;

/// The length of the edges where two triangles meet at more than 30 degrees.
double SharpLengthOf(vtkPolyData* surface);

/**
 * The part of that length in edges that continue nowhere: at one of its ends every other sharp edge
 * turns off by more than 40 degrees. The teeth of a saw do, and single folds. At corners of the
 * target, where its own edges end or turn, they may, but where its parts cross there are others:
 * of an assembly the length is never quite 0.
 */
double RaggedLengthOf(vtkPolyData* surface, vtkPolyData* target);

#endif
