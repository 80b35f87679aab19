// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "KernelBridge.h"

#include "vtkAlgorithm.h"
#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkExecutive.h"
#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkIdList.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkIntArray.h"
#include "vtkMatrix3x3.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkPolygon.h"
#include "vtkSMPTools.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkStringArray.h"
#include "vtkVersionMacros.h"

#include <vtksys/SystemInformation.hxx>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <iomanip>
#include <iterator>
#include <limits>
#include <map>
#include <new>
#include <sstream>
#include <type_traits>
#include <utility>

namespace KernelBridge
{

namespace
{

/// Starting VTK's threads costs as much as two or three tasks of the kernel's smallest size.
constexpr std::int64_t FewestParallelTasks = 4;

/// What a sample costs while distance and sign are computed, beyond the input.
constexpr vtkIdType BytesPerSample = 32;

//------------------------------------------------------------------------------
bool AbortRequested(vtkAlgorithm* filter)
{
#if VTK_VERSION_NUMBER >= 90220230111ULL
  return filter->CheckAbort();
#else
  return filter->GetAbortExecute() != 0;
#endif
}

//------------------------------------------------------------------------------
evolving::Execution ExecutionOf(vtkAlgorithm* filter)
{
  const auto parallelFor = [](std::int64_t count, const std::function<void(std::int64_t)>& task)
  {
    if (count < FewestParallelTasks)
    {
      for (std::int64_t i = 0; i < count; ++i)
      {
        task(i);
      }
      return;
    }
    vtkSMPTools::For(0, count, 1,
      [&task](vtkIdType begin, vtkIdType end)
      {
        for (vtkIdType i = begin; i < end; ++i)
        {
          task(i);
        }
      });
  };
  return evolving::Execution(
    parallelFor, [filter](double fraction) { filter->UpdateProgress(fraction); },
    [filter]() { return AbortRequested(filter); });
}

//------------------------------------------------------------------------------
/// Runs work on several threads also where VTK's default backend is the sequential one.
void WithThreads(const std::function<void()>& work)
{
  const bool sequential = std::strcmp(vtkSMPTools::GetBackend(), "Sequential") == 0;
  if (!sequential || std::getenv("VTK_SMP_BACKEND_IN_USE"))
  {
    work();
    return;
  }
  // A scope that is left by an exception would keep its backend, so none passes through.
  std::exception_ptr failure;
  vtkSMPTools::LocalScope(vtkSMPTools::Config{ 0, "STDThread", false },
    [&]()
    {
      try
      {
        work();
      }
      catch (...)
      {
        failure = std::current_exception();
      }
    });
  if (failure)
  {
    std::rethrow_exception(failure);
  }
}

//------------------------------------------------------------------------------
std::vector<evolving::Vec3> ReadPoints(vtkPointSet* input)
{
  const vtkIdType count = input->GetNumberOfPoints();
  if (count > std::numeric_limits<evolving::Index>::max())
  {
    std::ostringstream message;
    message << "The input has " << count << " points, at most "
            << std::numeric_limits<evolving::Index>::max()
            << " are supported; decimate it before this filter.";
    throw evolving::InputError(message.str());
  }
  std::vector<evolving::Vec3> points(static_cast<std::size_t>(count));
  for (vtkIdType i = 0; i < count; ++i)
  {
    input->GetPoint(i, points[static_cast<std::size_t>(i)].data());
  }
  return points;
}

//------------------------------------------------------------------------------
/// A point number as the kernel's type, checked before it is narrowed.
evolving::Index CheckedIndex(vtkIdType id, vtkPolyData* input)
{
  if (id < 0 || id >= input->GetNumberOfPoints())
  {
    std::ostringstream message;
    message << "A cell refers to point " << id << ", but there are only "
            << input->GetNumberOfPoints() << " points; the file is damaged, export it again.";
    throw evolving::InputError(message.str());
  }
  return static_cast<evolving::Index>(id);
}

//------------------------------------------------------------------------------
/// The cell ids of a polydata run over its vertices, lines, polygons and strips in this order.
void ReadPolygons(vtkPolyData* input, Surface& surface)
{
  vtkIdType cell = input->GetNumberOfVerts() + input->GetNumberOfLines();
  const auto cells = vtk::TakeSmartPointer(input->GetPolys()->NewIterator());
  for (cells->GoToFirstCell(); !cells->IsDoneWithTraversal(); cells->GoToNextCell(), ++cell)
  {
    vtkIdType size = 0;
    const vtkIdType* ids = nullptr;
    cells->GetCurrentCell(size, ids);
    std::vector<evolving::Index> corners;
    std::transform(ids, ids + size, std::back_inserter(corners),
      [input](vtkIdType id) { return CheckedIndex(id, input); });
    surface.mesh.addFace(corners);
    surface.cellOfFace.push_back(cell);
  }
}

//------------------------------------------------------------------------------
void ReadStrips(vtkPolyData* input, Surface& surface)
{
  vtkIdType cell =
    input->GetNumberOfVerts() + input->GetNumberOfLines() + input->GetNumberOfPolys();
  const auto strips = vtk::TakeSmartPointer(input->GetStrips()->NewIterator());
  for (strips->GoToFirstCell(); !strips->IsDoneWithTraversal(); strips->GoToNextCell(), ++cell)
  {
    vtkIdType size = 0;
    const vtkIdType* ids = nullptr;
    strips->GetCurrentCell(size, ids);
    for (vtkIdType i = 0; i + 2 < size; ++i)
    {
      // Every second triangle of a strip runs the other way.
      const vtkIdType odd = i % 2;
      surface.mesh.addFace({ CheckedIndex(ids[i], input), CheckedIndex(ids[i + 1 + odd], input),
        CheckedIndex(ids[i + 2 - odd], input) });
      surface.cellOfFace.push_back(cell);
    }
  }
}

//------------------------------------------------------------------------------
/// The corners (numbers inside the face) of the triangles of one polygon.
void TriangulateFace(const evolving::SurfaceMesh& mesh, evolving::Index face, vtkIdList* corners)
{
  const evolving::Index size = mesh.faceSize(face);
  vtkNew<vtkPolygon> polygon;
  polygon->Points->SetDataTypeToDouble();
  polygon->Points->SetNumberOfPoints(size);
  polygon->PointIds->SetNumberOfIds(size);
  for (evolving::Index k = 0; k < size; ++k)
  {
    polygon->Points->SetPoint(k, mesh.facePoint(face, k).data());
    polygon->PointIds->SetId(k, k);
  }
  if (polygon->Triangulate(corners) && corners->GetNumberOfIds() == 3 * (size - 2))
  {
    return;
  }
  // A polygon without area has no ears; a fan covers the same points.
  corners->Reset();
  for (evolving::Index k = 1; k + 1 < size; ++k)
  {
    corners->InsertNextId(0);
    corners->InsertNextId(k);
    corners->InsertNextId(k + 1);
  }
}

//------------------------------------------------------------------------------
Surface SplitIntoTriangles(const Surface& surface)
{
  Surface split;
  split.mesh.points = surface.mesh.points;
  vtkNew<vtkIdList> corners;
  for (evolving::Index face = 0; face < surface.mesh.faceCount(); ++face)
  {
    TriangulateFace(surface.mesh, face, corners);
    for (vtkIdType i = 0; i < corners->GetNumberOfIds(); i += 3)
    {
      const auto vertex = [&](vtkIdType k) {
        return surface.mesh.faceVertex(face, static_cast<evolving::Index>(corners->GetId(i + k)));
      };
      split.mesh.addFace({ vertex(0), vertex(1), vertex(2) });
      split.cellOfFace.push_back(surface.cellOfFace[static_cast<std::size_t>(face)]);
    }
  }
  return split;
}

//------------------------------------------------------------------------------
void ReplaceFieldArray(vtkDataObject* data, vtkAbstractArray* array)
{
  if (!data->GetFieldData())
  {
    data->SetFieldData(vtkNew<vtkFieldData>());
  }
  data->GetFieldData()->AddArray(array);
}

//------------------------------------------------------------------------------
/// FNV-1a over the bytes of an array's values.
void HashArray(vtkDataArray* array, std::uint64_t& hash)
{
  if (!array)
  {
    return;
  }
  for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
  {
    for (int c = 0; c < array->GetNumberOfComponents(); ++c)
    {
      std::uint64_t bits = 0;
      const double value = array->GetComponent(i, c);
      std::memcpy(&bits, &value, sizeof(bits));
      hash = (hash ^ bits) * 1099511628211ULL;
    }
  }
}

} // namespace

//------------------------------------------------------------------------------
Outcome Run(vtkAlgorithm* filter, const std::function<void(const evolving::Execution&)>& work)
{
  try
  {
    WithThreads([&]() { work(ExecutionOf(filter)); });
    return Outcome::Finished;
  }
  catch (const evolving::Cancelled&)
  {
    return Outcome::Cancelled;
  }
  catch (const std::bad_alloc&)
  {
    vtkErrorWithObjectMacro(
      filter, "The computation ran out of memory; use fewer samples or a smaller mesh.");
  }
  catch (const std::exception& error)
  {
    vtkErrorWithObjectMacro(filter, << error.what());
  }
  return Outcome::Failed;
}

//------------------------------------------------------------------------------
int RunToOutputs(vtkAlgorithm* filter, const std::vector<vtkDataObject*>& outputs,
  const std::function<void(const evolving::Execution&)>& work)
{
  const Outcome outcome = Run(filter, work);
  if (outcome != Outcome::Finished)
  {
    for (vtkDataObject* output : outputs)
    {
      output->Initialize();
    }
  }
  return outcome == Outcome::Failed ? 0 : 1;
}

//------------------------------------------------------------------------------
Surface ReadSurface(vtkPolyData* input)
{
  Surface surface;
  surface.mesh.points = ReadPoints(input);
  ReadPolygons(input, surface);
  ReadStrips(input, surface);
  evolving::validate(surface.mesh);
  return surface;
}

//------------------------------------------------------------------------------
Surface ReadTriangles(vtkPolyData* input)
{
  Surface surface = ReadSurface(input);
  return surface.mesh.hasOnlyTriangles() ? surface : SplitIntoTriangles(surface);
}

//------------------------------------------------------------------------------
WeldedSurface ReadWelded(vtkPolyData* input)
{
  const evolving::SurfaceMesh mesh = ReadSurface(input).mesh;
  WeldedSurface surface;
  std::vector<evolving::Index> oldVertex;
  surface.mesh = evolving::weldCoincidentPoints(mesh, &oldVertex);
  // Every point goes with the vertex that has its coordinates.
  const auto less = [](const evolving::Vec3& p, const evolving::Vec3& q)
  { return std::lexicographical_compare(p.begin(), p.end(), q.begin(), q.end()); };
  std::map<evolving::Vec3, evolving::Index, decltype(less)> vertexAt(less);
  for (evolving::Index v = 0; v < surface.mesh.vertexCount(); ++v)
  {
    vertexAt.emplace(surface.mesh.points[static_cast<std::size_t>(v)], v);
  }
  for (const evolving::Vec3& point : mesh.points)
  {
    const auto vertex = point.allFinite() ? vertexAt.find(point) : vertexAt.end();
    surface.vertexOfPoint.push_back(vertex == vertexAt.end() ? evolving::NoIndex : vertex->second);
  }
  return surface;
}

//------------------------------------------------------------------------------
void MoveWeldedPoints(
  const WeldedSurface& surface, const std::vector<evolving::Vec3>& points, vtkPolyData* output)
{
  vtkNew<vtkPoints> moved;
  moved->SetDataType(output->GetPoints()->GetDataType());
  moved->DeepCopy(output->GetPoints());
  for (std::size_t i = 0; i < surface.vertexOfPoint.size(); ++i)
  {
    const evolving::Index vertex = surface.vertexOfPoint[i];
    if (vertex != evolving::NoIndex)
    {
      moved->SetPoint(static_cast<vtkIdType>(i), points[static_cast<std::size_t>(vertex)].data());
    }
  }
  output->SetPoints(moved);
}

//------------------------------------------------------------------------------
evolving::FlowArrays Unweld(const WeldedSurface& surface, const evolving::FlowArrays& arrays)
{
  const auto spread = [&surface](const auto& values, const auto& zero)
  {
    using Values = std::decay_t<decltype(values)>;
    Values spreadValues;
    for (const evolving::Index vertex : surface.vertexOfPoint)
    {
      const bool has = vertex != evolving::NoIndex && !values.empty();
      spreadValues.push_back(has ? values[static_cast<std::size_t>(vertex)] : zero);
    }
    return spreadValues;
  };
  const evolving::Vec3 zero = evolving::Vec3::Zero();
  evolving::FlowArrays points;
  points.normal = spread(arrays.normal, zero);
  points.meanCurvature = spread(arrays.meanCurvature, 0.0);
  points.coVolume = spread(arrays.coVolume, 0.0);
  points.tangentialVelocity = spread(arrays.tangentialVelocity, zero);
  points.redistributionPotential = spread(arrays.redistributionPotential, 0.0);
  return points;
}

//------------------------------------------------------------------------------
void CopyWithoutTuples(vtkPolyData* input, vtkPolyData* output)
{
  output->Initialize();
  if (input)
  {
    output->GetPointData()->CopyAllocate(input->GetPointData());
    output->GetCellData()->CopyAllocate(input->GetCellData());
  }
}

//------------------------------------------------------------------------------
Surface ReadPointSet(vtkPolyData* input)
{
  const std::vector<evolving::Vec3> all = ReadPoints(input);
  Surface set;
  const auto add = [&](evolving::Index point, vtkIdType cell)
  {
    set.mesh.points.push_back(all[static_cast<std::size_t>(point)]);
    set.cellOfFace.push_back(cell);
  };
  const auto cells = vtk::TakeSmartPointer(input->GetVerts()->NewIterator());
  vtkIdType cell = 0;
  for (cells->GoToFirstCell(); !cells->IsDoneWithTraversal(); cells->GoToNextCell(), ++cell)
  {
    vtkIdType size = 0;
    const vtkIdType* ids = nullptr;
    cells->GetCurrentCell(size, ids);
    std::for_each(ids, ids + size, [&](vtkIdType id) { add(CheckedIndex(id, input), cell); });
  }
  if (input->GetNumberOfVerts() == 0)
  {
    for (evolving::Index point = 0; point < static_cast<evolving::Index>(all.size()); ++point)
    {
      add(point, point);
    }
  }
  evolving::validate(set.mesh);
  return set;
}

//------------------------------------------------------------------------------
bool HasFaces(vtkPolyData* input)
{
  return input->GetNumberOfPolys() + input->GetNumberOfStrips() > 0;
}

//------------------------------------------------------------------------------
evolving::ScalarImage ReadImage(vtkImageData* image)
{
  vtkDataArray* scalars = image->GetPointData()->GetScalars();
  if (!scalars)
  {
    throw evolving::InputError("The image on the second input has no active point scalars, "
                               "expected a distance or an intensity; choose one of its arrays.");
  }
  if (!image->GetDirectionMatrix()->IsIdentity())
  {
    throw evolving::InputError("The image on the second input is rotated (its direction matrix is "
                               "not the identity), expected one along the axes; resample it.");
  }
  evolving::DistanceGrid grid;
  image->GetOrigin(grid.origin.data());
  image->GetSpacing(grid.spacing.data());
  image->GetExtent(grid.extent.data());
  std::vector<float> values(static_cast<std::size_t>(scalars->GetNumberOfTuples()));
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    values[i] = static_cast<float>(scalars->GetComponent(static_cast<vtkIdType>(i), 0));
  }
  return evolving::ScalarImage(grid, std::move(values));
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> WritePolyData(const evolving::SurfaceMesh& mesh, int pointType)
{
  const auto output = vtkSmartPointer<vtkPolyData>::New();
  WritePoints(mesh.points, pointType, output);
  vtkNew<vtkCellArray> polygons;
  polygons->AllocateEstimate(mesh.faceCount(), 3);
  std::vector<vtkIdType> ids;
  for (evolving::Index face = 0; face < mesh.faceCount(); ++face)
  {
    ids.clear();
    for (evolving::Index k = 0; k < mesh.faceSize(face); ++k)
    {
      ids.push_back(mesh.faceVertex(face, k));
    }
    polygons->InsertNextCell(static_cast<vtkIdType>(ids.size()), ids.data());
  }
  output->SetPolys(polygons);
  return output;
}

//------------------------------------------------------------------------------
void WritePoints(const std::vector<evolving::Vec3>& points, int pointType, vtkPolyData* output)
{
  vtkNew<vtkPoints> written;
  written->SetDataType(pointType);
  written->SetNumberOfPoints(static_cast<vtkIdType>(points.size()));
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    written->SetPoint(static_cast<vtkIdType>(i), points[i].data());
  }
  output->SetPoints(written);
}

//------------------------------------------------------------------------------
bool AreValidBounds(const double bounds[6])
{
  return bounds[0] <= bounds[1] && bounds[2] <= bounds[3] && bounds[4] <= bounds[5];
}

//------------------------------------------------------------------------------
evolving::DistanceGrid MakeGrid(
  const evolving::Box& box, const int dimensions[3], const double bounds[6], double padding)
{
  const std::array<int, 3> samples = { dimensions[0], dimensions[1], dimensions[2] };
  if (!AreValidBounds(bounds))
  {
    return evolving::gridAround(box, samples, padding);
  }
  const evolving::Vec3 lower(bounds[0], bounds[2], bounds[4]);
  const evolving::Vec3 upper(bounds[1], bounds[3], bounds[5]);
  return evolving::gridOver(evolving::Box(lower, upper), samples);
}

//------------------------------------------------------------------------------
bool AssignClamped(const int wanted[3], int lower, int upper, int stored[3])
{
  bool changed = false;
  for (int axis = 0; axis < 3; ++axis)
  {
    const int value = std::clamp(wanted[axis], lower, upper);
    changed = changed || value != stored[axis];
    stored[axis] = value;
  }
  return changed;
}

//------------------------------------------------------------------------------
int PointType(vtkPointSet* input)
{
  const bool isDouble = input->GetPoints() && input->GetPoints()->GetDataType() == VTK_DOUBLE;
  return isDouble ? VTK_DOUBLE : VTK_FLOAT;
}

//------------------------------------------------------------------------------
void AddPointArray(vtkDataSet* data, const char* name, const std::vector<double>& values)
{
  vtkNew<vtkDoubleArray> array;
  array->SetName(name);
  array->SetNumberOfTuples(static_cast<vtkIdType>(values.size()));
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    array->SetValue(static_cast<vtkIdType>(i), values[i]);
  }
  data->GetPointData()->AddArray(array);
}

//------------------------------------------------------------------------------
void AddPointArray(vtkDataSet* data, const char* name, const std::vector<evolving::Vec3>& values)
{
  vtkNew<vtkDoubleArray> array;
  array->SetName(name);
  array->SetNumberOfComponents(3);
  array->SetNumberOfTuples(static_cast<vtkIdType>(values.size()));
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    array->SetTypedTuple(static_cast<vtkIdType>(i), values[i].data());
  }
  data->GetPointData()->AddArray(array);
}

//------------------------------------------------------------------------------
void AddFieldValue(vtkDataObject* data, const char* name, double value)
{
  vtkNew<vtkDoubleArray> array;
  array->SetName(name);
  array->InsertNextValue(value);
  ReplaceFieldArray(data, array);
}

//------------------------------------------------------------------------------
void AddFieldValue(vtkDataObject* data, const char* name, int value)
{
  vtkNew<vtkIntArray> array;
  array->SetName(name);
  array->InsertNextValue(value);
  ReplaceFieldArray(data, array);
}

//------------------------------------------------------------------------------
void AddFieldValue(vtkDataObject* data, const char* name, const std::string& value)
{
  vtkNew<vtkStringArray> array;
  array->SetName(name);
  array->InsertNextValue(value);
  ReplaceFieldArray(data, array);
}

//------------------------------------------------------------------------------
void RequestWholeInput(vtkInformation* inputRequest)
{
  // VTK hands the extent of an image behind this filter on, through polydata, to images before it.
  inputRequest->Remove(vtkStreamingDemandDrivenPipeline::UPDATE_EXTENT());
  inputRequest->Set(vtkStreamingDemandDrivenPipeline::UPDATE_PIECE_NUMBER(), 0);
  inputRequest->Set(vtkStreamingDemandDrivenPipeline::UPDATE_NUMBER_OF_PIECES(), 1);
  inputRequest->Set(vtkStreamingDemandDrivenPipeline::UPDATE_NUMBER_OF_GHOST_LEVELS(), 0);
}

//------------------------------------------------------------------------------
void RequestWholeImage(vtkInformation* inputRequest)
{
  RequestWholeInput(inputRequest);
  if (inputRequest->Has(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT()))
  {
    int extent[6];
    inputRequest->Get(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), extent);
    inputRequest->Set(vtkStreamingDemandDrivenPipeline::UPDATE_EXTENT(), extent, 6);
  }
}

//------------------------------------------------------------------------------
bool WritesGeometry(vtkInformation* request, vtkInformationVector* outputVector)
{
  // An update names the piece on the port it came from; the other ports keep an older one.
  const auto fromPort = vtkExecutive::FROM_OUTPUT_PORT();
  const int port = request->Has(fromPort) ? std::max(0, request->Get(fromPort)) : 0;
  vtkInformation* output = outputVector->GetInformationObject(port);
  const auto piece = vtkStreamingDemandDrivenPipeline::UPDATE_PIECE_NUMBER();
  return !output->Has(piece) || output->Get(piece) == 0;
}

//------------------------------------------------------------------------------
int RefuseUnlessEmpty(vtkAlgorithm* filter, vtkPolyData* input)
{
  if (!input || input->GetNumberOfPoints() == 0)
  {
    return 1;
  }
  vtkErrorWithObjectMacro(filter,
    << "The input has " << input->GetNumberOfPoints()
    << " points but no polygons, expected a surface; use Shrink Wrap, which takes points too.");
  return 0;
}

//------------------------------------------------------------------------------
void RequireMemory(evolving::GridIndex samples)
{
  vtksys::SystemInformation system;
  const double available = 1024.0 * static_cast<double>(system.GetHostMemoryTotal());
  const double needed = static_cast<double>(BytesPerSample) * static_cast<double>(samples);
  if (needed > available)
  {
    std::ostringstream message;
    message << std::fixed << std::setprecision(0) << "A grid of " << samples << " samples needs "
            << needed << " bytes, but this machine has " << available
            << "; lower SampleDimensions, or ask for a part of the grid at a time.";
    throw evolving::InputError(message.str());
  }
}

//------------------------------------------------------------------------------
std::uint64_t ContentHash(vtkDataSet* data)
{
  std::uint64_t hash = 14695981039346656037ULL;
  if (auto* image = vtkImageData::SafeDownCast(data))
  {
    vtkNew<vtkDoubleArray> layout;
    for (int axis = 0; axis < 3; ++axis)
    {
      layout->InsertNextValue(image->GetOrigin()[axis]);
      layout->InsertNextValue(image->GetSpacing()[axis]);
      layout->InsertNextValue(image->GetExtent()[2 * axis]);
      layout->InsertNextValue(image->GetExtent()[2 * axis + 1]);
    }
    HashArray(layout, hash);
    HashArray(image->GetPointData()->GetScalars(), hash);
  }
  if (auto* surface = vtkPolyData::SafeDownCast(data))
  {
    HashArray(surface->GetPoints() ? surface->GetPoints()->GetData() : nullptr, hash);
    for (vtkCellArray* cells : { surface->GetVerts(), surface->GetPolys(), surface->GetStrips() })
    {
      HashArray(cells->GetOffsetsArray(), hash);
      HashArray(cells->GetConnectivityArray(), hash);
    }
  }
  return hash;
}

} // namespace KernelBridge
