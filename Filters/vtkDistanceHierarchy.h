// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @class vtkDistanceHierarchy
 * @brief the boxes of the search structures behind vtkMeshSDF, to look at
 *
 * vtkDistanceHierarchy makes the boxes of the AABB tree (figure 5.2 of the thesis) or of the octree
 * (figure 5.4) of a surface, six quads each. Cell arrays: `Level` (int, 0 is the root),
 * `NumberOfTriangles` (int; AABB tree: triangles in the leaf, 0 for inner nodes), `Distance`
 * (double; octree: distance at the centroid of a leaf, 0 for larger cells).
 *
 * @sa vtkMeshSDF
 */

#ifndef vtkDistanceHierarchy_h
#define vtkDistanceHierarchy_h

#include "vtkEvolvingSurfacesFiltersModule.h" // For export macro
#include "vtkPolyDataAlgorithm.h"

#include <memory> // For std::unique_ptr

class DistributedInput;

class VTKEVOLVINGSURFACESFILTERS_EXPORT vtkDistanceHierarchy : public vtkPolyDataAlgorithm
{
public:
  static vtkDistanceHierarchy* New();
  vtkTypeMacro(vtkDistanceHierarchy, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// Values of Structure.
  enum
  {
    AABB_TREE = 0,
    OCTREE = 1
  };

  ///@{
  /**
   * Which structure's boxes to make. The default is AABB_TREE.
   */
  vtkSetClampMacro(Structure, int, AABB_TREE, OCTREE);
  vtkGetMacro(Structure, int);
  void SetStructureToAABBTree() { this->SetStructure(AABB_TREE); }
  void SetStructureToOctree() { this->SetStructure(OCTREE); }
  ///@}

  ///@{
  /**
   * The level whose boxes are made, 0 being the root; -1, the default, makes the leaves, -2 the
   * boxes of all levels. The range is -2 to 64.
   */
  vtkSetClampMacro(Level, int, -2, 64);
  vtkGetMacro(Level, int);
  ///@}

  ///@{
  /**
   * As in vtkMeshSDF: the octree's smallest cells are those of this grid. The default is 128 x 128
   * x 128, the range 1 to 65536 an axis. More than 8 million boxes of a level are an error.
   */
  void SetSampleDimensions(int x, int y, int z);
  void SetSampleDimensions(const int dimensions[3]);
  vtkGetVector3Macro(SampleDimensions, int);
  ///@}

  ///@{
  /**
   * As in vtkMeshSDF. The default is 0.1, the range 0 to 100.
   */
  vtkSetClampMacro(Padding, double, 0.0, 100.0);
  vtkGetMacro(Padding, double);
  ///@}

  ///@{
  /**
   * As in vtkMeshSDF; when x0 > x1, y0 > y1 and z0 > z1 (the default) the input's bounds and
   * Padding.
   */
  vtkSetVector6Macro(ModelBounds, double);
  vtkGetVector6Macro(ModelBounds, double);
  ///@}

protected:
  vtkDistanceHierarchy();
  ~vtkDistanceHierarchy() override;

  int ModifyRequest(vtkInformation* request, int when) override;
  int RequestUpdateExtent(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkDistanceHierarchy(const vtkDistanceHierarchy&) = delete;
  void operator=(const vtkDistanceHierarchy&) = delete;

  int Structure = AABB_TREE;
  int Level = -1;
  int SampleDimensions[3] = { 128, 128, 128 };
  double Padding = 0.1;
  double ModelBounds[6] = { 1.0, -1.0, 1.0, -1.0, 1.0, -1.0 };

  std::unique_ptr<DistributedInput> WholeInput;
};

#endif
