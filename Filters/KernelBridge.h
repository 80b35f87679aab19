// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * Where VTK meets the kernel: the only place that knows both worlds (KernelBridge.cxx runs the
 * kernel, KernelBridgeRead.cxx, KernelBridgeReadImage.cxx, KernelBridgeReadLabels.cxx,
 * KernelBridgeWrite.cxx and KernelBridgeWelding.cxx translate data, KernelBridgeHash.cxx tells
 * contents apart). Private to the module; it hands the kernel's headers on to the filters.
 */

#ifndef KernelBridge_h
#define KernelBridge_h

#include "Distance/DistanceGrid.h"
#include "Distance/FloatRange.h"
#include "Distance/SignedDistance.h"
#include "Distance/Sweeping/DistanceOctree.h"
#include "Errors.h"
#include "Evolution/FieldCheck.h"
#include "Evolution/ScalarImage.h"
#include "Evolution/StateSeries.h"
#include "Evolution/SurfaceFlow.h"
#include "Evolution/SurfaceRemesher.h"
#include "Evolution/UnreachedTarget.h"
#include "Evolution/ZeroLevel.h"
#include "Execution.h"
#include "LabelSurfaces/LabelNumbers.h"
#include "LabelSurfaces/LabelSurfaces.h"
#include "Mesh/FloatPoints.h"
#include "Mesh/PartWelding.h"
#include "Mesh/PolygonTriangulation.h"
#include "Mesh/SurfaceMesh.h"
#include "Mesh/TopologySummary.h"
#include "Operators/SpoiledElements.h"
#include "Redistribution/SurfaceRedistribution.h"
#include "Remeshing/SliverRemoval.h"
#include "ShrinkWrap/Shortcomings.h"
#include "ShrinkWrap/ShrinkWrap.h"
#include "ShrinkWrap/SurfaceReport.h"
#include "StartSurface/PrimitiveSurfaces.h"
#include "Trees/AABBTree.h"
#include "Trees/TrianglePlaces.h"

#include "vtkSmartPointer.h"

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

class vtkAlgorithm;
class vtkCellArray;
class vtkDataArray;
class vtkDataObject;
class vtkDataSet;
class vtkImageData;
class vtkInformation;
class vtkInformationVector;
class vtkPointSet;
class vtkPolyData;

namespace KernelBridge
{

/// A kernel mesh, and where its faces and vertices came from.
struct Surface
{
  evolving::SurfaceMesh mesh;
  std::vector<vtkIdType> cellOfFace;
  std::vector<vtkIdType> pointOfVertex; ///< of a point set; those of a surface are the points
};

/// What execution by Run() came to.
enum class Outcome
{
  Finished,
  Cancelled,
  Failed
};

/**
 * Calls work with the filter's threads, progress and abort flag. An exception of the kernel
 * becomes one vtkErrorMacro sentence of the filter. Threads are VTK's; where VTK's default
 * backend is the sequential one and the user has not asked for that, STDThread is used.
 */
Outcome Run(vtkAlgorithm* filter, const std::function<void(const evolving::Execution&)>& work);

/// As Run(), for a RequestData that writes `outputs` only when finished: they stay initialised.
int RunToOutputs(vtkAlgorithm* filter, const std::vector<vtkDataObject*>& outputs,
  const std::function<void(const evolving::Execution&)>& work);

/**
 * The polygons and strips of a polydata as they are; strips become triangles.
 * @throws evolving::InputError for corners out of range or coordinates that are not finite
 */
Surface ReadSurface(vtkPolyData* input);

/// A surface whose points with equal coordinates are one, and who they were.
struct WeldedSurface
{
  evolving::SurfaceMesh mesh;
  /// For every point of the input the vertex of the mesh; NoIndex where no face uses it.
  std::vector<evolving::Index> vertexOfPoint;
};

/// As ReadSurface(), with coincident points joined, but for those of parts that are closed as they
/// are; faces that lose an edge by it are left out.
WeldedSurface ReadWelded(vtkPolyData* input);

/// New points, of that type, for a copy of the input: each moves with its vertex, unused ones stay.
void MoveWeldedPoints(const WeldedSurface& surface, const std::vector<evolving::Vec3>& points,
  int pointType, vtkPolyData* output);

/// The arrays of the welded vertices as arrays of the input's points, zero for unused ones.
evolving::StateArrays Unweld(const WeldedSurface& surface, const evolving::StateArrays& arrays);

/// The input's arrays with no tuples, and no geometry: what ranks but the first write.
void CopyWithoutTuples(vtkPolyData* input, vtkPolyData* output);

/// As ReadSurface(), polygons split into triangles (by ear clipping, so concave ones are right).
/// @throws evolving::Cancelled
Surface ReadTriangles(vtkPolyData* input, const evolving::Execution& execution);

/// Triangles or, of an input without faces, points.
struct UsableMesh
{
  evolving::SurfaceMesh mesh;
  std::vector<vtkIdType> cellOfFace;    ///< of every triangle; of every vertex of a point set
  std::vector<vtkIdType> pointOfVertex; ///< of every vertex, the input's point
  /// One sentence that counts the faces and points that cannot be used; empty when all can.
  std::string leftOut;
};

/**
 * As ReadTriangles() or ReadPointSet(), without faces of fewer than three corners, and without
 * faces and points whose coordinates are not finite.
 * @throws evolving::InputError for corners out of range, or when nothing is left
 * @throws evolving::Cancelled
 */
UsableMesh ReadUsable(vtkPolyData* input, const evolving::Execution& execution);

/**
 * The points that vertex cells use, or all points when there is none; then \p cellOfFace is, for
 * each of them, the vertex cell, or the number of the point.
 */
Surface ReadPointSet(vtkPolyData* input);

/// The numbers that `numbers` points at in `all`.
std::vector<vtkIdType> Chosen(
  const std::vector<vtkIdType>& all, const std::vector<evolving::Index>& numbers);

/// Has the polydata polygons or strips? Otherwise it is a point set.
bool HasFaces(vtkPolyData* input);

/**
 * The image's active point scalars (ImageArray sees to it that there are some, of one component),
 * turned as its direction matrix says.
 * @throws evolving::InputError for too few of them, with spacings that are not positive, a
 * direction matrix that is neither a rotation nor a reflection, or values that are not finite
 */
evolving::ScalarImage ReadImage(vtkImageData* image);

/**
 * From numbers of samples, the first of the image (0, 0, 0), to points.
 * @throws evolving::InputError for a direction matrix that is neither a rotation nor a reflection
 */
Eigen::Affine3d ReadIndexToSpace(vtkImageData* image);

/// An image of labels, and the labels by their numbers in it, the first for number 1.
struct Labels
{
  evolving::LabelImage image;
  std::vector<double> values;
};

/**
 * The image's active point scalars as labels; samples are the middles of voxels.
 * @throws evolving::InputError for what are no labels, or spacings that are not positive
 * @throws evolving::Cancelled
 */
Labels ReadLabels(
  vtkImageData* image, const evolving::LabelChoice& choice, const evolving::Execution& execution);

/// A polydata of the mesh's points (as `pointType`, VTK_FLOAT or VTK_DOUBLE) and polygons.
vtkSmartPointer<vtkPolyData> WritePolyData(const evolving::SurfaceMesh& mesh, int pointType);

/// The mesh's polygons alone.
vtkSmartPointer<vtkCellArray> WritePolygons(const evolving::SurfaceMesh& mesh);

/// Says that points are double where the input's are float, because those could not hold them.
void WarnOfDoubles(vtkAlgorithm* filter);

/// The points alone, for a polydata that shares its polygons with others.
void WritePoints(const std::vector<evolving::Vec3>& points, int pointType, vtkPolyData* output);

///@{
/**
 * SampleDimensions, ModelBounds and Padding of the filters that sample. Bounds that end before
 * they begin along all three axes, as VTK's uninitialised ones, stand for the padded box with cubic
 * cells; others are the grid's as they are.
 * @throws evolving::InputError for bounds that are no box, and a padding that is no number
 */
bool IsAutomatic(const double bounds[6]);
evolving::DistanceGrid MakeGrid(
  const evolving::Box& box, const int dimensions[3], const double bounds[6], double padding);
///@}

/// Stores the wanted numbers, each within the limits; true when that changed one.
bool AssignClamped(const int wanted[3], int lower, int upper, int stored[3]);

/// VTK_DOUBLE when the input's points are double, otherwise VTK_FLOAT.
int PointType(vtkPointSet* input);

///@{
/// Adds a named point array, as ResultArrays does.
void AddPointArray(vtkDataSet* data, const char* name, const std::vector<double>& values);
void AddPointArray(vtkDataSet* data, const char* name, const std::vector<evolving::Vec3>& values);
///@}

///@{
/// Adds a named field array of one value, as ResultArrays does.
void AddFieldValue(vtkDataObject* data, const char* name, double value);
void AddFieldValue(vtkDataObject* data, const char* name, int value);
void AddFieldValue(vtkDataObject* data, const char* name, const std::string& value);
void AddFieldStrings(vtkDataObject* data, const char* name, const std::vector<std::string>& values);
///@}

///@{
/**
 * The piece that an update asks for: the whole (which rank asks for what is DistributedInput's
 * matter), and whether it is to be written: only piece 0 has geometry.
 */
void RequestWholeInput(vtkInformation* inputRequest);
void RequestWholeImage(vtkInformation* inputRequest);
bool WritesGeometry(vtkInformation* request, vtkInformationVector* outputVector);
///@}

/// For an input without faces: 1 when it is empty altogether, otherwise an error and 0.
int RefuseUnlessEmpty(vtkAlgorithm* filter, vtkPolyData* input);

/**
 * @throws evolving::InputError, with the number of bytes, when a grid of so many samples would not
 * fit in the memory of this machine.
 */
void RequireMemory(
  evolving::GridIndex samples, const evolving::SignedDistanceOptions& options = {});

/// The same for a computation of so many bytes for each sample, with what to do instead.
void RequireMemory(evolving::GridIndex samples, int bytesPerSample, const char* advice);

/// A number that changes when points, their type, cells, image samples or their layout change: all
/// of a data set that the filters' outputs depend on.
std::uint64_t ContentHash(vtkDataSet* data);

} // namespace KernelBridge

#endif
