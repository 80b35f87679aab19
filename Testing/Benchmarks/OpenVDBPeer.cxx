// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "OpenVDBPeer.h"

#include "vtkCellArray.h"

#include <openvdb/openvdb.h>
#include <openvdb/tools/MeshToVolume.h>
#include <tbb/global_control.h>

namespace benchmark
{

struct OpenVDBPeer::Parts
{
  explicit Parts(int threads)
    : Threads(tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(threads))
  {
  }

  tbb::global_control Threads;
  int Dimensions[3] = { 0, 0, 0 };
  std::vector<openvdb::Vec3s> Points;
  std::vector<openvdb::Vec3I> Triangles;
  openvdb::FloatGrid::Ptr Grid;
};

std::string OpenVDBPeer::version()
{
  return std::string("OpenVDB ") + openvdb::getLibraryVersionString();
}

OpenVDBPeer::OpenVDBPeer(vtkPolyData* triangles, vtkImageData* grid, int threads)
  : Own(std::make_unique<Parts>(threads))
{
  openvdb::initialize();
  const double* origin = grid->GetOrigin();
  const double h = grid->GetSpacing()[0];
  grid->GetDimensions(this->Own->Dimensions);
  for (vtkIdType p = 0; p < triangles->GetNumberOfPoints(); ++p)
  {
    double x[3];
    triangles->GetPoint(p, x);
    this->Own->Points.emplace_back(static_cast<float>((x[0] - origin[0]) / h),
      static_cast<float>((x[1] - origin[1]) / h), static_cast<float>((x[2] - origin[2]) / h));
  }
  for (vtkIdType c = 0; c < triangles->GetNumberOfPolys(); ++c)
  {
    vtkIdType size = 0;
    const vtkIdType* corners = nullptr;
    triangles->GetPolys()->GetCellAtId(c, size, corners);
    this->Own->Triangles.emplace_back(static_cast<openvdb::Index32>(corners[0]),
      static_cast<openvdb::Index32>(corners[1]), static_cast<openvdb::Index32>(corners[2]));
  }
}

OpenVDBPeer::~OpenVDBPeer() = default;

void OpenVDBPeer::convert(float band)
{
  const openvdb::tools::QuadAndTriangleDataAdapter<openvdb::Vec3s, openvdb::Vec3I> mesh(
    this->Own->Points, this->Own->Triangles);
  const auto indexSpace = openvdb::math::Transform::createLinearTransform(1.0);
  this->Own->Grid = openvdb::tools::meshToVolume<openvdb::FloatGrid>(mesh, *indexSpace, band, band);
}

OpenVDBPeer::Field OpenVDBPeer::field() const
{
  Field field;
  const int* n = this->Own->Dimensions;
  auto samples = this->Own->Grid->getConstAccessor();
  for (int k = 0; k < n[2]; ++k)
  {
    for (int j = 0; j < n[1]; ++j)
    {
      for (int i = 0; i < n[0]; ++i)
      {
        float distance = 0.0F;
        field.inBand.push_back(samples.probeValue(openvdb::Coord(i, j, k), distance) ? 1 : 0);
        field.distance.push_back(distance);
      }
    }
  }
  return field;
}

} // namespace benchmark
