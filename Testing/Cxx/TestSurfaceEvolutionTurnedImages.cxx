// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

// vtkSurfaceEvolution: images with a direction matrix, as medical ones have.

#include "ChangedSurfaces.h"
#include "DataChecks.h"
#include "EventLog.h"
#include "FlowSetups.h"
#include "SampleSurfaces.h"
#include "SurfaceMeasures.h"

#include "vtkDoubleArray.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkSurfaceEvolution.h"

#include <gtest/gtest.h>

#include <cmath>

namespace
{

using Image = vtkSmartPointer<vtkImageData>;

//------------------------------------------------------------------------------
/// The distances to an egg off the middle, so that no turn leaves them as they were.
Image Egg()
{
  const Image image = Sample::SphereImage(25, 2.0, 1.0);
  vtkNew<vtkDoubleArray> distance;
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    const double* p = image->GetPoint(i);
    distance->InsertNextValue(std::hypot(p[0] - 0.1, 1.2 * p[1], 0.9 * p[2] + 0.1) - 0.9);
  }
  image->GetPointData()->SetScalars(distance);
  return image;
}

//------------------------------------------------------------------------------
/// The evolution of a surface onto an image.
void Evolve(vtkSurfaceEvolution* filter, vtkPolyData* start, vtkImageData* image, int mode)
{
  EventLog log(filter);
  SetUpAttraction(filter, start);
  filter->SetInputData(1, image);
  filter->SetFieldMode(mode);
  filter->SetEdgeSharpness(mode == vtkSurfaceEvolution::IMAGE ? 1.0 : 0.0);
  filter->SetNumberOfSteps(10);
  filter->Update();
  EXPECT_TRUE(log.Errors.empty()) << log.Errors.front();
}

//------------------------------------------------------------------------------
/// (x, y, z) to (-y, x, z) about the image's origin (-2, -2, -2): exact in floating point.
Sample::Point QuarterTurn(const Sample::Point& p)
{
  return { -2.0 - (p[1] + 2.0), -2.0 + (p[0] + 2.0), p[2] };
}

//------------------------------------------------------------------------------
TEST(TurnedImage, ItsDirectionMatrixTurnsTheResult)
{
  for (const int mode : { vtkSurfaceEvolution::DISTANCE_FIELD, vtkSurfaceEvolution::IMAGE })
  {
    const auto start = Sample::Icosphere(2, 1.5);
    vtkNew<vtkSurfaceEvolution> straight;
    Evolve(straight, start, Egg(), mode);
    const Image image = Egg();
    image->SetDirectionMatrix(0, -1, 0, 1, 0, 0, 0, 0, 1);
    vtkNew<vtkSurfaceEvolution> turned;
    Evolve(turned, Sample::Mapped(start, QuarterTurn), image, mode);
    EXPECT_TRUE(
      SameSurface(turned->GetOutput(), Sample::Mapped(straight->GetOutput(), QuarterTurn), 1e-5));
    EXPECT_NEAR(FieldValue(turned->GetOutput(), "MeanDistance"),
      FieldValue(straight->GetOutput(), "MeanDistance"), 1e-5);
    EXPECT_FALSE(SameSurface(straight->GetOutput(), start, 0.01)); // something happened
  }
}

//------------------------------------------------------------------------------
TEST(TurnedImage, NoiseInTheIdentityChangesNothing)
{
  const auto start = Sample::Icosphere(2, 1.5);
  vtkNew<vtkSurfaceEvolution> straight;
  Evolve(straight, start, Egg(), vtkSurfaceEvolution::DISTANCE_FIELD);
  const Image image = Egg();
  image->SetDirectionMatrix(1, 1e-16, 0, -1e-16, 1, 0, 0, 0, 1);
  vtkNew<vtkSurfaceEvolution> noisy;
  Evolve(noisy, start, image, vtkSurfaceEvolution::DISTANCE_FIELD);
  EXPECT_TRUE(SameSurface(straight->GetOutput(), noisy->GetOutput(), 0.0));
}

} // namespace
