// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

// What the filters look like. VTK's comparison does not see moderate changes of geometry: every
// picture has a number beside it, and one comparison must fail.

#include "ChangedSurfaces.h"
#include "DataChecks.h"
#include "Picture.h"
#include "SampleSurfaces.h"
#include "SurfaceMeasures.h"

#include "vtkDataArray.h"
#include "vtkDistanceHierarchy.h"
#include "vtkFlyingEdges3D.h"
#include "vtkImageData.h"
#include "vtkLabelSurfaces.h"
#include "vtkMeshSDF.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkShrinkWrap.h"
#include "vtkSurfaceEvolution.h"
#include "vtkTangentialRedistribution.h"
#include "vtkUnsignedCharArray.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace
{

//------------------------------------------------------------------------------
vtkSmartPointer<vtkImageData> DistanceOf(vtkPolyData* surface, int nx, int ny, int nz)
{
  vtkNew<vtkMeshSDF> distance;
  distance->SetInputData(surface);
  distance->SetSampleDimensions(nx, ny, nz);
  distance->Update();
  return distance->GetOutput();
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> ContourOf(vtkImageData* image, double value)
{
  vtkNew<vtkFlyingEdges3D> contour;
  contour->SetInputData(image);
  contour->SetValue(0, value);
  contour->ComputeNormalsOff();
  contour->Update();
  return contour->GetOutput();
}

//------------------------------------------------------------------------------
/// A sphere that encloses the surface, 2562 points.
vtkSmartPointer<vtkPolyData> SphereAround(vtkPolyData* surface)
{
  double center[3];
  surface->GetCenter(center);
  return Sample::Icosphere(4, 0.55 * surface->GetLength(), { center[0], center[1], center[2] });
}

//------------------------------------------------------------------------------
TEST(Images, DistanceSlice)
{
  const auto bunny = Sample::Read("bunny.ply");
  const auto slice = DistanceOf(bunny, 200, 200, 1);
  vtkDataArray* distance = slice->GetPointData()->GetScalars();
  Picture picture;
  picture.AddColours(slice, -distance->GetRange()[0]);
  picture.LookFrom(0.0, 0.0, 1.0);
  EXPECT_TRUE(picture.Matches("DistanceSlice"));
  // The part of the slice that is inside.
  vtkIdType inside = 0;
  for (vtkIdType i = 0; i < distance->GetNumberOfTuples(); ++i)
  {
    inside += distance->GetTuple1(i) < 0.0;
  }
  EXPECT_NEAR(static_cast<double>(inside) / 40000.0, 0.34, 0.01);
}

//------------------------------------------------------------------------------
TEST(Images, ZeroContour)
{
  const auto bunny = Sample::Read("bunny.ply");
  const auto image = DistanceOf(bunny, 64, 64, 64);
  const auto contour = ContourOf(image, 0.0);
  Picture picture;
  picture.AddSurface(contour);
  picture.LookFrom(0.2, 0.3, 1.0);
  EXPECT_TRUE(picture.Matches("ZeroContour"));
  EXPECT_LT(LargestDistance(contour, bunny), 0.5 * image->GetSpacing()[0]);
  // vtkFlyingEdges3D turns its triangles inwards.
  EXPECT_NEAR(VolumeOf(contour), -VolumeOf(bunny), 0.02 * VolumeOf(bunny));
}

//------------------------------------------------------------------------------
TEST(Images, EvolutionAtThreeTimes)
{
  const auto bunny = Sample::Read("bunny.ply");
  vtkNew<vtkSurfaceEvolution> evolution;
  evolution->SetInputData(0, SphereAround(bunny));
  evolution->SetInputData(1, DistanceOf(bunny, 48, 48, 48));
  evolution->SetNumberOfSteps(60);
  evolution->SetTimeStep(0.05);
  evolution->SetVolumeRedistribution(5.0);
  Picture picture(600, 200, 3);
  std::array<double, 3> meanDistance{};
  for (int view = 0; view < 3; ++view)
  {
    evolution->UpdateTimeStep(
      std::array<double, 3>{ 0.0, 0.75, 3.0 }[static_cast<std::size_t>(view)]);
    vtkNew<vtkPolyData> state;
    state->ShallowCopy(evolution->GetOutput());
    picture.AddEdges(state, view);
    picture.LookFrom(0.2, 0.3, 1.0, view);
    meanDistance[static_cast<std::size_t>(view)] = FieldValue(state, "MeanDistance");
  }
  EXPECT_TRUE(picture.Matches("EvolutionAtThreeTimes"));
  EXPECT_LT(meanDistance[1], 0.6 * meanDistance[0]);
  EXPECT_LT(meanDistance[2], 0.2 * meanDistance[0]);
}

//------------------------------------------------------------------------------
TEST(Images, RedistributedWireframe)
{
  const auto uneven = Sample::Mapped(Sample::Icosphere(3), Sample::TowardsThePole);
  vtkNew<vtkTangentialRedistribution> filter;
  filter->SetInputData(uneven);
  filter->SetNumberOfSteps(200);
  filter->Update();
  Picture picture(400, 200, 2);
  picture.AddEdges(uneven, 0);
  picture.AddEdges(filter->GetOutput(), 1);
  picture.LookFrom(0.0, 1.0, 1.0, 0);
  picture.LookFrom(0.0, 1.0, 1.0, 1);
  EXPECT_TRUE(picture.Matches("RedistributedWireframe"));
  EXPECT_GT(SmallestAngleOf(filter->GetOutput()), 40.0);
  EXPECT_LT(LargestDistance(filter->GetOutput(), uneven), 1e-9);
}

//------------------------------------------------------------------------------
TEST(Images, WrappedBunny)
{
  const auto bunny = Sample::Read("bunny.ply");
  vtkNew<vtkShrinkWrap> wrap;
  wrap->SetInputData(bunny);
  wrap->SetSampleDimensions(64, 64, 64);
  wrap->SetTargetEdgeLength(std::sqrt(AreaOf(bunny) / 2000.0));
  wrap->Update();
  Picture picture;
  picture.AddEdges(wrap->GetOutput());
  picture.LookFrom(0.2, 0.3, 1.0);
  EXPECT_TRUE(picture.Matches("WrappedBunny"));
  EXPECT_EQ(CountBadEdges(wrap->GetOutput()), 0);
  EXPECT_EQ(EulerCharacteristic(wrap->GetOutput()), 2);
  EXPECT_LT(LargestDistance(wrap->GetOutput(), bunny), 0.02 * bunny->GetLength());
}

//------------------------------------------------------------------------------
/// Both halves of a torus of the radii 11 and 5, lying askew, in voxels of size 1.
vtkSmartPointer<vtkImageData> HalvesOfATorus()
{
  const auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(36, 36, 36);
  vtkNew<vtkUnsignedCharArray> labels;
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    double p[3];
    image->GetPoint(i, p);
    const double x = p[0] - 17.4;
    const double u = 0.8 * (p[1] - 17.6) - 0.6 * (p[2] - 17.3);
    const double w = 0.6 * (p[1] - 17.6) + 0.8 * (p[2] - 17.3);
    const bool isInside = std::hypot(std::hypot(x, u) - 11.0, w) < 5.0;
    labels->InsertNextValue(static_cast<unsigned char>(!isInside ? 0 : x < 0.3 * u ? 1 : 2));
  }
  image->GetPointData()->SetScalars(labels);
  return image;
}

//------------------------------------------------------------------------------
TEST(Images, SurfacesOfLabels)
{
  vtkNew<vtkLabelSurfaces> filter;
  filter->SetInputData(HalvesOfATorus());
  Picture picture(600, 300, 2);
  std::array<double, 2> area{};
  for (int view = 0; view < 2; ++view)
  {
    filter->SetSmoothingLength(view == 0 ? 0.0 : 2.0);
    filter->Update();
    vtkNew<vtkPolyData> surfaces;
    surfaces->ShallowCopy(filter->GetOutput());
    picture.AddEdges(surfaces, view);
    picture.LookFrom(0.2, 0.3, 1.0, view);
    area[static_cast<std::size_t>(view)] = AreaOf(surfaces);
    EXPECT_EQ(CountBadEdges(surfaces), 0);
  }
  EXPECT_TRUE(picture.Matches("SurfacesOfLabels"));
  // Of the torus, and twice the two discs where it is cut.
  const double exact = 4.0 * M_PI * M_PI * 11.0 * 5.0 + 4.0 * M_PI * 25.0;
  EXPECT_NEAR(area[1], exact, 0.02 * exact);
  EXPECT_GT(area[0], 1.3 * exact);
}

//------------------------------------------------------------------------------
TEST(Images, HierarchyBoxes)
{
  const auto torus = Sample::Read("torus.ply");
  vtkNew<vtkDistanceHierarchy> hierarchy;
  hierarchy->SetInputData(torus);
  hierarchy->SetSampleDimensions(32, 32, 32);
  Picture picture(600, 300, 2);
  const int structures[2] = { vtkDistanceHierarchy::AABB_TREE, vtkDistanceHierarchy::OCTREE };
  for (int view = 0; view < 2; ++view)
  {
    hierarchy->SetStructure(structures[view]);
    hierarchy->SetLevel(view == 0 ? 5 : 4);
    hierarchy->Update();
    vtkNew<vtkPolyData> boxes;
    boxes->ShallowCopy(hierarchy->GetOutput());
    picture.AddLines(boxes, view);
    picture.AddSurface(torus, view);
    picture.LookFrom(0.5, -1.0, 1.5, view);
    // The boxes have more volume than the tube and less than the whole box.
    EXPECT_GT(VolumeOf(boxes), 3.2);
    EXPECT_LT(VolumeOf(boxes), 6.3);
  }
  EXPECT_TRUE(picture.Matches("HierarchyBoxes"));
}

//------------------------------------------------------------------------------
TEST(Images, ControlAThickerBunnyIsNotTheZeroContour)
{
  // The comparison sees three cells further out, and not a quarter of a cell.
  const auto image = DistanceOf(Sample::Read("bunny.ply"), 64, 64, 64);
  const auto matches = [&](double cells, const char* picture)
  {
    Picture shown;
    shown.AddSurface(ContourOf(image, cells * image->GetSpacing()[0]));
    shown.LookFrom(0.2, 0.3, 1.0);
    return shown.Matches("ZeroContour", picture);
  };
  EXPECT_TRUE(matches(0.0, "ControlSame")) << "the baseline must be there";
  EXPECT_TRUE(matches(0.25, "ControlNearlySame"));
  EXPECT_FALSE(matches(3.0, "ControlThicker"));
}

} // namespace
