# SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
# SPDX-License-Identifier: BSD-3-Clause
"""Pictures of the figures: panels in rows, each with a caption, drawn offscreen into a PNG or JPEG.

    save([Panel([surface(reader)], "input"), Panel([surface(filter)], "output")])
"""

import sys
from math import ceil
from pathlib import Path

import vtkmodules.vtkRenderingFreeType  # noqa: F401  (what vtkRenderingCore draws text with)
import vtkmodules.vtkRenderingOpenGL2  # noqa: F401  (and everything else)
import vtkmodules.vtkRenderingVolumeOpenGL2  # noqa: F401  (and volumes)
from vtkmodules.vtkCommonDataModel import vtkBoundingBox
from vtkmodules.vtkImagingCore import vtkImageShiftScale, vtkImageShrink3D
from vtkmodules.vtkImagingMath import vtkImageMaskBits
from vtkmodules.vtkIOImage import vtkJPEGWriter, vtkPNGWriter
from vtkmodules.vtkRenderingCore import (vtkLight, vtkRenderer, vtkRenderWindow, vtkTextActor,
                                         vtkWindowToImageFilter)

FINE = 2                                         # drawn so much larger, then averaged: fine edges
MARGIN, LINE, BAR = 10, 24, 64                   # pixels: around text, a line of it, a scalar bar
SHADES = 0xF8                                    # the bits of a colour that are kept
GAP = 4                                          # left and right of a panel


class Panel:
    """Props seen from a direction, a caption of one or more lines, perhaps a scalar bar.

    zoom > 1 comes closer, to the middle or to a point `center`."""

    def __init__(self, props, caption="", bar=None, direction=(0.35, 0.3, 1.0), up=(0.0, 1.0, 0.0),
                 zoom=1.0, center=None):
        self.props, self.caption, self.bar = props, caption, bar
        self.direction, self.up, self.zoom, self.center = direction, up, zoom, center

    def text_height(self):
        lines = len(self.caption.splitlines())
        return lines * LINE + (BAR if self.bar else 0) + MARGIN


def same_bounds(panels):
    """The box around what all panels show: the frame when they are to have the same scale."""
    box = vtkBoundingBox()
    for panel in panels:
        for prop in panel.props:
            box.AddBounds(prop.GetBounds())
    bounds = [0.0] * 6
    box.GetBounds(bounds)
    return bounds


def light(renderer):
    """A key light from above left, weak ones from right and below; they move with the camera."""
    renderer.AutomaticLightCreationOff()
    renderer.SetLightFollowCamera(True)
    for position, intensity in (((-0.5, 0.8, 1.0), 0.8), ((0.9, 0.1, 0.8), 0.35),
                                ((0.0, -0.9, 0.6), 0.25)):
        lamp = vtkLight()
        lamp.SetLightTypeToCameraLight()
        lamp.SetPosition(position)
        lamp.SetIntensity(intensity)
        renderer.AddLight(lamp)


def aim(renderer, panel, bounds):
    camera = renderer.GetActiveCamera()
    camera.ParallelProjectionOn()
    camera.SetFocalPoint(0.0, 0.0, 0.0)
    camera.SetPosition(panel.direction)
    camera.SetViewUp(panel.up)
    renderer.ResetCamera(bounds) if bounds else renderer.ResetCamera()
    if panel.center:
        shift = [c - f for c, f in zip(panel.center, camera.GetFocalPoint())]
        camera.SetPosition([p + s for p, s in zip(camera.GetPosition(), shift)])
        camera.SetFocalPoint(panel.center)
    camera.Zoom(1.3 * panel.zoom)                # ResetCamera leaves room for the whole sphere
    renderer.ResetCameraClippingRange(bounds) if bounds else renderer.ResetCameraClippingRange()


def view_of(panel, viewport, bounds):
    renderer = vtkRenderer()
    renderer.SetViewport(viewport)
    renderer.SetLayer(1)
    light(renderer)
    for prop in panel.props:
        renderer.AddViewProp(prop)
    aim(renderer, panel, bounds)
    return renderer


def write_text(overlay, text, x, y, size=18):
    """Text whose first line is centred below a point, in pixels."""
    actor = vtkTextActor()
    actor.SetInput(text)
    look = actor.GetTextProperty()
    look.SetColor(0.0, 0.0, 0.0)
    look.SetFontSize(size * FINE)
    look.SetJustificationToCentered()
    look.SetVerticalJustificationToTop()
    look.SetLineSpacing(1.1)
    actor.SetPosition(x * FINE, y * FINE)
    overlay.AddViewProp(actor)


def place_bar(overlay, bar, left, bottom, width, size):
    """A scalar bar with its title above it: its own would run into its labels."""
    write_text(overlay, bar.GetTitle(), left + 0.5 * width, bottom + BAR - 4, 16)
    bar.SetTitle("")
    bar.GetPositionCoordinate().SetCoordinateSystemToNormalizedViewport()
    bar.SetPosition(left / size[0], bottom / size[1])
    bar.SetWidth(width / size[0])
    bar.SetHeight((BAR - 28) / size[1])
    bar.GetLabelTextProperty().SetFontSize(14 * FINE)
    overlay.AddViewProp(bar)


def sheet_of(window):
    """White paper below everything and, above everything, a layer for text; returns the latter."""
    window.SetNumberOfLayers(3)
    for layer in (0, 2):
        renderer = vtkRenderer()
        renderer.SetLayer(layer)
        renderer.SetBackground(1.0, 1.0, 1.0)
        window.AddRenderer(renderer)
    return renderer


def write(window, path):
    picture = vtkWindowToImageFilter()
    picture.SetInput(window)
    picture.ReadFrontBufferOff()
    smaller = vtkImageShrink3D()
    smaller.SetInputConnection(picture.GetOutputPort())
    smaller.SetShrinkFactors(FINE, FINE, 1)
    smaller.AveragingOn()
    coarser = vtkImageMaskBits()                 # 32 shades of each colour: half the file
    coarser.SetInputConnection(smaller.GetOutputPort())
    coarser.SetMasks(SHADES, SHADES, SHADES, SHADES)
    brighter = vtkImageShiftScale()              # white is white again
    brighter.SetInputConnection(coarser.GetOutputPort())
    brighter.SetScale(255.0 / SHADES)
    brighter.ClampOverflowOn()
    brighter.SetOutputScalarTypeToUnsignedChar()
    if str(path).endswith(".jpg"):               # smaller where there are thousands of edges
        writer = vtkJPEGWriter()
        writer.SetQuality(80)
    else:
        writer = vtkPNGWriter()
        writer.SetCompressionLevel(9)
    writer.SetFileName(str(path))
    writer.SetInputConnection(brighter.GetOutputPort())
    writer.Write()
    if writer.GetErrorCode():
        sys.exit(f"cannot write {path}")


def path_asked_for():
    """The script's first argument, else <script>.png in the current folder."""
    return sys.argv[1] if len(sys.argv) > 1 else Path(sys.argv[0]).stem + ".png"


def save(panels, path=None, columns=None, width=1200, height=400, same_scale=False, bar=None):
    """Draws panels side by side (in rows of `columns`) and writes the picture.

    height: of a row without its captions. same_scale: one frame for all panels, so that sizes
    compare and, with the same direction, one camera. bar: one scalar bar below all panels."""
    columns = columns or len(panels)
    rows = ceil(len(panels) / columns)
    row_height = height + max(panel.text_height() for panel in panels)
    foot = BAR + MARGIN if bar else 0
    size = (width, rows * row_height + foot)
    window = vtkRenderWindow()
    window.SetOffScreenRendering(True)
    window.SetMultiSamples(4)
    window.SetSize(FINE * size[0], FINE * size[1])
    overlay = sheet_of(window)
    bounds = same_bounds(panels) if same_scale else None
    step = width / columns
    for i, panel in enumerate(panels):
        left, top = i % columns * step, size[1] - i // columns * row_height
        low = top - height
        window.AddRenderer(view_of(panel, ((left + GAP) / width, low / size[1],
                                           (left + step - GAP) / width, top / size[1]), bounds))
        write_text(overlay, panel.caption, left + 0.5 * step, low - 5)
        if panel.bar:
            under = low - LINE * len(panel.caption.splitlines()) - BAR
            place_bar(overlay, panel.bar, left + 0.15 * step, under, 0.7 * step, size)
    if bar:
        place_bar(overlay, bar, 0.3 * width, 0.5 * MARGIN, 0.4 * width, size)
    write(window, path or path_asked_for())
