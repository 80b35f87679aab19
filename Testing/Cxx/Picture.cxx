// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Picture.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkColorTransferFunction.h"
#include "vtkDataSet.h"
#include "vtkDataSetSurfaceFilter.h"
#include "vtkPNGWriter.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkRendererCollection.h"
#include "vtkTesting.h"
#include "vtkWindowToImageFilter.h"

namespace
{

/// VTK's usual limit for pictures without text.
constexpr double Threshold = 10.0;

} // namespace

//------------------------------------------------------------------------------
Picture::Picture(int width, int height, int views)
{
  this->Window->SetOffScreenRendering(1);
  this->Window->SetMultiSamples(0);
  this->Window->SetSize(width, height);
  for (int view = 0; view < views; ++view)
  {
    vtkNew<vtkRenderer> renderer;
    const double left = static_cast<double>(view) / views;
    renderer->SetViewport(left, 0.0, left + 1.0 / views, 1.0);
    renderer->SetBackground(1.0, 1.0, 1.0);
    this->Window->AddRenderer(renderer);
  }
}

//------------------------------------------------------------------------------
Picture::~Picture() = default;

//------------------------------------------------------------------------------
vtkRenderer* Picture::View(int view)
{
  return vtkRenderer::SafeDownCast(this->Window->GetRenderers()->GetItemAsObject(view));
}

//------------------------------------------------------------------------------
vtkActor* Picture::Add(vtkPolyData* surface, int view)
{
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(surface);
  mapper->ScalarVisibilityOff();
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  this->View(view)->AddActor(actor);
  return actor;
}

//------------------------------------------------------------------------------
vtkActor* Picture::AddSurface(vtkPolyData* surface, int view)
{
  vtkActor* actor = this->Add(surface, view);
  actor->GetProperty()->SetColor(0.55, 0.7, 0.85);
  actor->GetProperty()->SetInterpolationToFlat();
  return actor;
}

//------------------------------------------------------------------------------
vtkActor* Picture::AddEdges(vtkPolyData* surface, int view)
{
  vtkActor* actor = this->AddSurface(surface, view);
  actor->GetProperty()->EdgeVisibilityOn();
  actor->GetProperty()->SetEdgeColor(0.25, 0.35, 0.5);
  return actor;
}

//------------------------------------------------------------------------------
vtkActor* Picture::AddLines(vtkPolyData* surface, int view)
{
  vtkActor* actor = this->Add(surface, view);
  actor->GetProperty()->SetRepresentationToWireframe();
  actor->GetProperty()->LightingOff();
  actor->GetProperty()->SetColor(0.1, 0.1, 0.3);
  return actor;
}

//------------------------------------------------------------------------------
vtkActor* Picture::AddColours(vtkDataSet* data, double limit, int view)
{
  vtkNew<vtkDataSetSurfaceFilter> surface;
  surface->SetInputData(data);
  surface->Update();
  vtkNew<vtkColorTransferFunction> blueToRed;
  blueToRed->AddRGBPoint(-limit, 0.1, 0.2, 0.7);
  blueToRed->AddRGBPoint(0.0, 0.95, 0.95, 0.95);
  blueToRed->AddRGBPoint(limit, 0.7, 0.1, 0.1);
  vtkActor* actor = this->Add(surface->GetOutput(), view);
  actor->GetMapper()->ScalarVisibilityOn();
  actor->GetMapper()->InterpolateScalarsBeforeMappingOn();
  actor->GetMapper()->SetLookupTable(blueToRed);
  actor->GetProperty()->LightingOff();
  return actor;
}

//------------------------------------------------------------------------------
void Picture::LookFrom(double x, double y, double z, int view)
{
  vtkCamera* camera = this->View(view)->GetActiveCamera();
  camera->SetFocalPoint(0.0, 0.0, 0.0);
  camera->SetPosition(x, y, z);
  camera->SetViewUp(0.0, 1.0, 0.0);
  camera->ParallelProjectionOn();
  this->View(view)->ResetCamera();
  camera->Zoom(1.25);
}

//------------------------------------------------------------------------------
bool Picture::Matches(const std::string& baseline, const std::string& picture)
{
  this->Window->Render();
  vtkNew<vtkWindowToImageFilter> pixels;
  pixels->SetInput(this->Window);
  pixels->ReadFrontBufferOff();
  const std::string folder = EVOLVINGSURFACES_PICTURE_DIR;
  vtkNew<vtkPNGWriter> writer;
  writer->SetFileName((folder + "/" + picture + ".png").c_str());
  writer->SetInputConnection(pixels->GetOutputPort());
  writer->Write();
  vtkNew<vtkTesting> testing;
  // VTK names what it writes after the baseline, whatever the picture is: into a folder of its own.
  const std::string compared = folder + "/Compared";
  const std::string valid = std::string(EVOLVINGSURFACES_BASELINE_DIR) + "/" + baseline + ".png";
  for (const char* argument : { "-T", compared.c_str(), "-V", valid.c_str() })
  {
    testing->AddArgument(argument);
  }
  return testing->RegressionTest(pixels, Threshold) == vtkTesting::PASSED;
}
