// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkDistanceHierarchy.h"

#include "AbortFlag.h"
#include "DistributedInput.h"
#include "KernelBridge.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <cmath>
#include <limits>

vtkStandardNewMacro(vtkDistanceHierarchy);

namespace
{

constexpr int LargestDimension = 65536;
constexpr int SidesOfBox = 6;
/// Of a level: a box is some 450 bytes of output.
constexpr std::size_t MostBoxes = std::size_t(1) << 23;
constexpr int Leaves = -1;    ///< as a level
constexpr int AllLevels = -2; ///< as a level

//------------------------------------------------------------------------------
/// Collects boxes with what is known of each, and writes them as quads.
class BoxWriter
{
public:
  /// @param pointType of the coordinates: the input's, so that boxes far from the origin are exact
  explicit BoxWriter(int pointType)
  {
    this->Points->SetDataType(pointType);
    this->Level->SetName("Level");
    this->Triangles->SetName("NumberOfTriangles");
    this->Distance->SetName("Distance");
  }

  void Add(const evolving::Box& box, int level, int triangles, double distance)
  {
    // Corner b has the upper coordinate of axis a where bit a of b is set; seen from outside.
    static const vtkIdType sides[SidesOfBox][4] = { { 0, 4, 6, 2 }, { 1, 3, 7, 5 }, { 0, 1, 5, 4 },
      { 2, 6, 7, 3 }, { 0, 2, 3, 1 }, { 4, 5, 7, 6 } };
    vtkIdType corners[8];
    for (int b = 0; b < 8; ++b)
    {
      corners[b] =
        this->Points->InsertNextPoint(box.corner(static_cast<evolving::Box::CornerType>(b)).data());
    }
    for (const auto& side : sides)
    {
      const vtkIdType quad[4] = { corners[side[0]], corners[side[1]], corners[side[2]],
        corners[side[3]] };
      this->Quads->InsertNextCell(4, quad);
      this->Level->InsertNextValue(level);
      this->Triangles->InsertNextValue(triangles);
      this->Distance->InsertNextValue(distance);
    }
  }

  /// With the arrays that belong to the structure.
  void Write(vtkPolyData* output, bool isTree)
  {
    output->SetPoints(this->Points);
    output->SetPolys(this->Quads);
    output->GetCellData()->SetScalars(this->Level);
    output->GetCellData()->AddArray(
      isTree ? static_cast<vtkDataArray*>(this->Triangles) : this->Distance);
  }

private:
  vtkNew<vtkPoints> Points;
  vtkNew<vtkCellArray> Quads;
  vtkNew<vtkIntArray> Level;
  vtkNew<vtkIntArray> Triangles;
  vtkNew<vtkDoubleArray> Distance;
};

//------------------------------------------------------------------------------
/// The nodes of a level, or the leaves, or all nodes.
void AddTreeBoxes(const evolving::AABBTree& tree, int level, BoxWriter& boxes)
{
  const auto& nodes = tree.nodes();
  for (std::size_t i = 0; i < nodes.size(); ++i)
  {
    const int nodeLevel = tree.level(static_cast<evolving::Index>(i));
    const bool isWanted = level == Leaves ? nodes[i].isLeaf() : nodeLevel == level;
    if (level == AllLevels || isWanted)
    {
      boxes.Add(nodes[i].box, nodeLevel, nodes[i].isLeaf() ? nodes[i].triangleCount : 0, 0.0);
    }
  }
}

//------------------------------------------------------------------------------
/// The cells of a level, or the leaves, or the cells of all levels; distances are on leaves.
void AddOctreeBoxes(const evolving::DistanceOctree& octree, int level, BoxWriter& boxes)
{
  const int last = octree.depth();
  for (int l = 0; l < last; ++l)
  {
    if (level == AllLevels || level == l)
    {
      for (const auto& cell : octree.cells(l))
      {
        boxes.Add(octree.box(cell), l, 0, 0.0);
      }
    }
  }
  if (level < 0 || level == last)
  {
    for (const auto& leaf : octree.leaves())
    {
      boxes.Add(octree.box(leaf.cell), last, 0, std::sqrt(leaf.squaredDistance));
    }
  }
}

} // namespace

//------------------------------------------------------------------------------
vtkDistanceHierarchy::vtkDistanceHierarchy()
  : WholeInput(std::make_unique<DistributedInput>())
{
}

//------------------------------------------------------------------------------
vtkDistanceHierarchy::~vtkDistanceHierarchy() = default;

//------------------------------------------------------------------------------
void vtkDistanceHierarchy::SetSampleDimensions(int x, int y, int z)
{
  const int dimensions[3] = { x, y, z };
  this->SetSampleDimensions(dimensions);
}

//------------------------------------------------------------------------------
void vtkDistanceHierarchy::SetSampleDimensions(const int dimensions[3])
{
  if (KernelBridge::AssignClamped(dimensions, 1, LargestDimension, this->SampleDimensions))
  {
    this->Modified();
  }
}

//------------------------------------------------------------------------------
int vtkDistanceHierarchy::ModifyRequest(vtkInformation* request, int when)
{
  AbortFlag::Keep(this, request, when);
  this->WholeInput->Exchange(this, request, when);
  return this->Superclass::ModifyRequest(request, when);
}

//------------------------------------------------------------------------------
int vtkDistanceHierarchy::RequestUpdateExtent(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector*)
{
  this->WholeInput->RequestSurface(inputVector[0]->GetInformationObject(0));
  return 1;
}

//------------------------------------------------------------------------------
int vtkDistanceHierarchy::RequestData(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  if (this->WholeInput->IsRefused())
  {
    return 0;
  }
  vtkPolyData* input = this->WholeInput->Surface(inputVector[0]);
  vtkPolyData* output = vtkPolyData::GetData(outputVector);
  BoxWriter boxes(KernelBridge::PointType(input));
  if (!KernelBridge::WritesGeometry(request, outputVector))
  {
    boxes.Write(output, this->Structure == AABB_TREE);
    return 1;
  }
  if (!input || !KernelBridge::HasFaces(input))
  {
    return KernelBridge::RefuseUnlessEmpty(this, input);
  }
  return KernelBridge::RunToOutputs(this, { output },
    [&](const evolving::Execution& execution)
    {
      const evolving::SurfaceMesh mesh =
        KernelBridge::ReadTriangles(input, execution.phase(0.0, 0.0)).mesh;
      const evolving::AABBTree tree(mesh, execution.phase(0.0, 0.5));
      if (this->Structure == AABB_TREE)
      {
        AddTreeBoxes(tree, this->Level, boxes);
      }
      else
      {
        const evolving::DistanceGrid grid = KernelBridge::MakeGrid(
          evolving::boundingBox(mesh), this->SampleDimensions, this->ModelBounds, this->Padding);
        const evolving::DistanceOctree octree(
          tree, grid, execution.phase(0.5, 1.0), std::numeric_limits<int>::max(), MostBoxes);
        AddOctreeBoxes(octree, this->Level, boxes);
      }
      boxes.Write(output, this->Structure == AABB_TREE);
    });
}

//------------------------------------------------------------------------------
void vtkDistanceHierarchy::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  const int* n = this->SampleDimensions;
  const double* b = this->ModelBounds;
  os << indent << "Structure: " << this->Structure << "\n";
  os << indent << "Level: " << this->Level << "\n";
  os << indent << "SampleDimensions: " << n[0] << " " << n[1] << " " << n[2] << "\n";
  os << indent << "Padding: " << this->Padding << "\n";
  os << indent << "ModelBounds: " << b[0] << " " << b[1] << " " << b[2] << " " << b[3] << " "
     << b[4] << " " << b[5] << "\n";
}
