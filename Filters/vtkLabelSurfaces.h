// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @class vtkLabelSurfaces
 * @brief smooth surfaces of the labels of an image, that neither overlap nor leave gaps
 *
 * vtkLabelSurfaces makes a closed surface of every label of a segmented image, such as the label
 * maps of 3D Slicer and ITK-SNAP, without the stairs of the voxels.
 *
 * The faces between voxels of different labels are one net that all labels share; its points move
 * until interfaces are bent as little as can be, and the curves where three labels meet lie where
 * the interfaces lead to. So where two labels touch both have the very same points and triangles,
 * seen from opposite sides. Every point stays within half a voxel, along each axis, of the voxels'
 * faces, and within 0.85 of a voxel of those of each label that it belongs to; parts of one voxel
 * keep half of their thickness at least; and every label keeps the volume of its voxels, to
 * rounding in nearly all images (`Volume` beside `VoxelVolume` says how near).
 *
 * The first output has the surfaces of all labels, one after another. Each is a closed, oriented
 * manifold that points outwards, without common points with others: a threshold of the cell array
 * `Label` gives one of them whole. vtkSurfaceEvolution takes all of them at once, though they
 * touch, and each keeps its own volume there; filters that join all coincident points, such as
 * vtkCleanPolyData, would join labels that touch. The cell array `NeighborLabel` is the label at
 * the other side of each triangle, the background also where the image ends. Voxels of a label hang
 * together by faces; where they meet by an edge or a corner alone, the surface passes twice, with
 * points that coincide. A single voxel that differs from all around it stays, as a pit or a bump. A
 * label that runs out of the image ends in the plane of the outermost voxels' faces, with a sharp
 * edge. The field arrays `LabelValue`, `Volume` and `VoxelVolume` have a value for each label.
 *
 * The second output has every interface once, with the two labels of each triangle as the cell
 * array `BoundaryLabels`, as vtkSurfaceNets3D has them: the triangle is seen from the second.
 *
 * Samples of point data are the middles of voxels, and cells are voxels themselves. All is done in
 * units of voxels, so spacings may differ along the axes; a direction matrix turns or mirrors the
 * result. The array is chosen by SetInputArrayToProcess(0, 0, 0, association, name).
 *
 * Such nets are those of Gibson, *Constrained elastic surface nets*, MICCAI 1998, here with a
 * bending energy, held volumes and, along curves, other elements than the voxels have.
 *
 * @sa vtkSurfaceEvolution vtkShrinkWrap
 */

#ifndef vtkLabelSurfaces_h
#define vtkLabelSurfaces_h

#include "vtkEvolvingSurfacesFiltersModule.h" // For export macro
#include "vtkPolyDataAlgorithm.h"

#include <memory> // For std::unique_ptr
#include <vector> // For std::vector

class ImageArray;

class VTKEVOLVINGSURFACESFILTERS_EXPORT vtkLabelSurfaces : public vtkPolyDataAlgorithm
{
public:
  static vtkLabelSurfaces* New();
  vtkTypeMacro(vtkLabelSurfaces, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The labels to make surfaces of; all others count as background. The default, none, stands for
   * all but BackgroundLabel. Adding one that is there already changes nothing; a number out of
   * range gives 0.
   */
  void AddLabel(double label);
  void RemoveAllLabels();
  int GetNumberOfLabels() const { return static_cast<int>(this->Labels.size()); }
  double GetLabel(int number) const;
  ///@}

  ///@{
  /**
   * The label that has no surface of its own. The default is 0, the range that of whole numbers in
   * doubles.
   */
  vtkSetClampMacro(BackgroundLabel, double, -9007199254740992.0, 9007199254740992.0);
  vtkGetMacro(BackgroundLabel, double);
  ///@}

  ///@{
  /**
   * How far stairs are smoothed away, in voxels: waves up to about six times as long go. 0 gives
   * the voxels' faces as they are. The default is 2, which takes the stairs of smooth shapes away
   * and leaves what is larger than some voxels where it is; the range 0 to 10.
   */
  vtkSetClampMacro(SmoothingLength, double, 0.0, 10.0);
  vtkGetMacro(SmoothingLength, double);
  ///@}

protected:
  vtkLabelSurfaces();
  ~vtkLabelSurfaces() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int ModifyRequest(vtkInformation* request, int when) override;
  int RequestUpdateExtent(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkLabelSurfaces(const vtkLabelSurfaces&) = delete;
  void operator=(const vtkLabelSurfaces&) = delete;

  std::vector<double> Labels;
  double BackgroundLabel = 0.0;
  double SmoothingLength = 2.0;

  std::unique_ptr<ImageArray> LabelArray;
};

#endif
