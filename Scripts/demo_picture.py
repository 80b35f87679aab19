# SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
# SPDX-License-Identifier: BSD-3-Clause
"""The picture of demo.py: surfaces side by side, coloured by their distance from the target."""
import vtkmodules.vtkInteractionStyle  # noqa: F401
import vtkmodules.vtkRenderingOpenGL2  # noqa: F401
from vtkmodules.vtkCommonDataModel import vtkBoundingBox
from vtkmodules.vtkCommonTransforms import vtkTransform
from vtkmodules.vtkFiltersGeneral import vtkTransformPolyDataFilter, vtkVertexGlyphFilter
from vtkmodules.vtkImagingCore import vtkImageShrink3D
from vtkmodules.vtkIOImage import vtkPNGWriter
from vtkmodules.vtkRenderingAnnotation import vtkScalarBarActor
from vtkmodules.vtkRenderingCore import (
    vtkActor, vtkCamera, vtkColorTransferFunction, vtkLightKit, vtkPolyDataMapper, vtkRenderer,
    vtkRenderWindow, vtkTextActor, vtkWindowToImageFilter)

WIDTH, HEIGHT = 1800, 640
OVERSAMPLING = 2  # drawn larger and averaged down: finer edges than a line of one pixel
BAR_SHARE, TITLE_SHARE = 0.16, 0.08  # of the height, below the panels
VIEW_DIRECTION = (0.35, 0.30, 1.0)  # y up, from the front, a little from the right and above
INK = (0.15, 0.15, 0.18)
ARRAY = "SignedDistance"


def distance_colors(surfaces):
    """Cool to warm about zero (Moreland 2009), symmetric, over the distances of all surfaces."""
    largest = 0.0
    for surface in surfaces:
        array = surface.GetPointData().GetArray(ARRAY)
        if array:
            largest = max(largest, *(abs(value) for value in array.GetRange()))
    largest = largest or 1.0
    colors = vtkColorTransferFunction()
    colors.SetColorSpaceToDiverging()
    colors.AddRGBPoint(-largest, 0.230, 0.299, 0.754)
    colors.AddRGBPoint(0.0, 0.865, 0.865, 0.865)
    colors.AddRGBPoint(largest, 0.706, 0.016, 0.150)
    return colors


def with_vertices(points):
    """A mapper draws cells only: points without cells become vertices."""
    vertices = vtkVertexGlyphFilter()
    vertices.SetInputData(points)
    vertices.Update()
    return vertices.GetOutput()


def surface_actor(surface, colors):
    mapper = vtkPolyDataMapper()
    mapper.SetInputData(surface if surface.GetNumberOfCells() else with_vertices(surface))
    if colors and surface.GetPointData().GetArray(ARRAY):
        mapper.SetScalarModeToUsePointFieldData()
        mapper.SelectColorArray(ARRAY)
        mapper.SetLookupTable(colors)
        mapper.InterpolateScalarsBeforeMappingOn()
    else:
        mapper.ScalarVisibilityOff()
    actor = vtkActor()
    actor.SetMapper(mapper)
    look = actor.GetProperty()
    look.SetColor(0.80, 0.78, 0.74)
    look.SetInterpolationToFlat()
    look.EdgeVisibilityOn()
    look.SetEdgeColor(0.38, 0.38, 0.42)
    look.SetLineWidth(1.0)
    look.SetPointSize(2.0 * OVERSAMPLING)
    return actor


def label(text, size, x, y):
    actor = vtkTextActor()
    actor.SetInput(text)
    actor.GetPositionCoordinate().SetCoordinateSystemToNormalizedViewport()
    actor.SetPosition(x, y)
    style = actor.GetTextProperty()
    style.SetFontSize(size * OVERSAMPLING)
    style.SetColor(INK)
    style.SetJustificationToCentered()
    return actor


def view_of(surfaces, aspect):
    """A camera that shows all surfaces, however far apart, as large as fits."""
    camera = vtkCamera()
    camera.ParallelProjectionOn()
    camera.SetFocalPoint(0.0, 0.0, 0.0)
    camera.SetPosition(VIEW_DIRECTION)
    camera.SetViewUp(0.0, 1.0, 0.0)
    seen = vtkTransform()
    seen.SetMatrix(camera.GetViewTransformMatrix())
    box = vtkBoundingBox()
    for surface in surfaces:
        turned = vtkTransformPolyDataFilter()
        turned.SetTransform(seen)
        turned.SetInputData(surface)
        turned.Update()
        box.AddBounds(turned.GetOutput().GetBounds())
    center = [0.0, 0.0, 0.0]
    box.GetCenter(center)
    center = seen.GetLinearInverse().TransformPoint(center)
    camera.SetFocalPoint(center)
    camera.SetPosition([c + d * box.GetMaxLength() for c, d in zip(center, VIEW_DIRECTION)])
    camera.SetParallelScale(0.53 * max(box.GetLength(1), box.GetLength(0) / aspect))
    return camera


def panel(actor, camera, viewport):
    renderer = vtkRenderer()
    renderer.SetViewport(viewport)
    renderer.SetBackground(1.0, 1.0, 1.0)
    renderer.AddActor(actor)
    lights = vtkLightKit()
    lights.SetKeyLightIntensity(0.85)
    lights.AddLightsToRenderer(renderer)
    renderer.GetActiveCamera().DeepCopy(camera)
    renderer.ResetCameraClippingRange()
    return renderer


def legend(titles, colors):
    """The strip below the panels: their titles and the colours' scale."""
    bar = vtkScalarBarActor()
    bar.SetLookupTable(colors)
    bar.SetOrientationToHorizontal()
    bar.SetNumberOfLabels(5)
    bar.SetLabelFormat("%.2g")
    bar.UnconstrainedFontSizeOn()
    bar.SetPosition(0.30, 0.04)
    bar.SetWidth(0.40)
    bar.SetHeight(0.36)
    bar.SetBarRatio(0.42)
    style = bar.GetLabelTextProperty()
    style.SetColor(INK)
    style.SetFontSize(17 * OVERSAMPLING)
    style.BoldOff()
    style.ItalicOff()
    style.ShadowOff()
    renderer = vtkRenderer()
    renderer.SetViewport(0.0, 0.0, 1.0, BAR_SHARE + TITLE_SHARE)
    renderer.SetBackground(1.0, 1.0, 1.0)
    renderer.AddActor(bar)
    renderer.AddActor(label("signed distance from the input", 17, 0.5, 0.46))
    for i, title in enumerate(titles):
        renderer.AddActor(label(title, 22, (i + 0.5) / len(titles), 0.78))
    return renderer


def write_picture(panels, path):
    """Draws panels, each (title, surface, coloured by distance?), from left to right."""
    bottom = BAR_SHARE + TITLE_SHARE
    surfaces = [surface for _, surface, _ in panels]
    camera = view_of(surfaces, WIDTH / len(panels) / (HEIGHT * (1.0 - bottom)))
    colors = distance_colors([surface for _, surface, colored in panels if colored])
    window = vtkRenderWindow()
    window.SetOffScreenRendering(1)
    window.SetMultiSamples(8)
    window.SetSize(WIDTH * OVERSAMPLING, HEIGHT * OVERSAMPLING)
    for i, (_, surface, colored) in enumerate(panels):
        viewport = (i / len(panels), bottom, (i + 1) / len(panels), 1.0)
        actor = surface_actor(surface, colors if colored else None)
        window.AddRenderer(panel(actor, camera, viewport))
    window.AddRenderer(legend([title for title, _, _ in panels], colors))
    window.Render()
    grab = vtkWindowToImageFilter()
    grab.SetInput(window)
    grab.ReadFrontBufferOff()
    shrink = vtkImageShrink3D()
    shrink.SetInputConnection(grab.GetOutputPort())
    shrink.SetShrinkFactors(OVERSAMPLING, OVERSAMPLING, 1)
    shrink.AveragingOn()
    writer = vtkPNGWriter()
    writer.SetInputConnection(shrink.GetOutputPort())
    # libpng would print write errors by itself.
    writer.WriteToMemoryOn()
    writer.Write()
    with open(path, "wb") as file:
        file.write(memoryview(writer.GetResult()))
