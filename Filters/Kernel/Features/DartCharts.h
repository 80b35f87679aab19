// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * Darts: creases that end inside a patch, so that it lies on both of their sides. They are
 * given two labels by cutting the patch into charts.
 */

#ifndef EVOLVING_DART_CHARTS_H
#define EVOLVING_DART_CHARTS_H

#include "Features/SharpEdges.h"
#include "Features/SurfacePatches.h"
#include "Features/TargetTriangles.h"

namespace evolving
{

/**
 * Labels such that the triangles at every sharp edge have different ones, also at those edges
 * whose sides belong to one patch. Patches without such edges keep one label.
 *
 * 1. The triangles on either side of the darts are seeds; those next to each other on one side
 *    of a dart, around its vertices, belong together. A crease with one side only (on a band
 *    with half a turn) is cut where its ends meet.
 * 2. Charts grow from all seeds at once (Dijkstra, over edges that are not sharp, slowly over
 *    folds), so that the border between two begins at the loose end and goes on straight ahead.
 *    They end so far away that no shorter border runs beyond; what is left there are charts, too.
 * 3. Charts are merged over their longest border first, as long as no dart loses its two
 *    labels.
 * 4. Borders are moved to where they are short and follow weaker folds (minimum cuts), outside a
 *    strip of a given width along the darts. So a crease that fades out is continued along what is
 *    left of it, one that ends close to another is continued to that, and a short one far from
 *    all others gets a strip beside it as its second label.
 *
 * Borders between labels that are not sharp are artificial. Every label is connected over edges
 * that are not sharp; they are numbered by smallest triangle.
 * @param width of the strips, in the target's unit
 */
TriangleLabels separatingLabels(const TargetTriangles& target, const SharpEdges& sharp,
  const TriangleLabels& patches, double width);

} // namespace evolving

#endif
