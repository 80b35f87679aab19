# SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
# SPDX-License-Identifier: BSD-3-Clause
"""What a panel shows: surfaces, lines, arrows, dots, volumes and slices, and the colours for them.

A source is an algorithm or a data set.
"""

from vtkmodules.vtkCommonDataModel import vtkPiecewiseFunction
from vtkmodules.vtkCommonExecutionModel import vtkStreamingDemandDrivenPipeline
from vtkmodules.vtkFiltersCore import vtkFeatureEdges, vtkGlyph3D
from vtkmodules.vtkFiltersGeometry import vtkImageDataGeometryFilter
from vtkmodules.vtkFiltersSources import vtkArrowSource, vtkSphereSource
from vtkmodules.vtkImagingCore import vtkExtractVOI
from vtkmodules.vtkRenderingAnnotation import vtkScalarBarActor
from vtkmodules.vtkRenderingCore import (vtkActor, vtkColorTransferFunction, vtkPolyDataMapper,
                                         vtkVolume)
from vtkmodules.vtkRenderingVolume import vtkFixedPointVolumeRayCastMapper

IVORY, SLATE, EDGE = (0.93, 0.89, 0.80), (0.20, 0.26, 0.36), (0.36, 0.40, 0.46)
BLUE, RED = (0.23, 0.38, 0.70), (0.75, 0.22, 0.17)
VIRIDIS = ((0.267, 0.005, 0.329), (0.283, 0.141, 0.458), (0.254, 0.265, 0.530),
           (0.207, 0.372, 0.553), (0.164, 0.471, 0.558), (0.128, 0.567, 0.551),
           (0.135, 0.659, 0.518), (0.267, 0.749, 0.441), (0.478, 0.821, 0.318),
           (0.741, 0.873, 0.150), (0.993, 0.906, 0.144))

def sequential(low, high):
    """From dark to light, even steps to the eye (viridis)."""
    colors = vtkColorTransferFunction()
    for i, color in enumerate(VIRIDIS):
        colors.AddRGBPoint(low + (high - low) * i / (len(VIRIDIS) - 1), *color)
    return colors


def diverging(limit):
    """Blue below zero, white at zero, red above."""
    colors = vtkColorTransferFunction()
    colors.SetColorSpaceToDiverging()
    colors.AddRGBPoint(-limit, 0.23, 0.30, 0.75)
    colors.AddRGBPoint(limit, 0.71, 0.02, 0.15)
    return colors


def connect(consumer, source):
    if hasattr(source, "GetOutputPort"):
        consumer.SetInputConnection(source.GetOutputPort())
    else:
        consumer.SetInputData(source)


def actor_of(source, color):
    mapper = vtkPolyDataMapper()
    connect(mapper, source)
    mapper.ScalarVisibilityOff()
    actor = vtkActor()
    actor.SetMapper(mapper)
    actor.GetProperty().SetColor(color)
    return actor


def surface(source, color=IVORY, edges=True, opacity=1.0, smooth=False):
    """A surface in one colour; smooth shades it by its point normals, else facets show."""
    actor = actor_of(source, color)
    look = actor.GetProperty()
    if smooth:
        look.SetInterpolationToPhong()
    else:
        look.SetInterpolationToFlat()
    look.SetEdgeVisibility(edges)
    look.SetEdgeColor(EDGE)
    look.SetLineWidth(1.0)                       # half a pixel of the picture
    look.SetOpacity(opacity)
    look.SetAmbient(0.2)
    look.SetDiffuse(0.85)
    look.SetSpecular(0.1)
    look.SetSpecularPower(20.0)
    return actor


def colored(source, name, colors, edges=False, cells=False):
    """A surface coloured by a point or cell array; colors is sequential() or diverging()."""
    actor = surface(source, edges=edges)
    mapper = actor.GetMapper()
    mapper.ScalarVisibilityOn()
    if cells:
        mapper.SetScalarModeToUseCellFieldData()
    else:
        mapper.SetScalarModeToUsePointFieldData()
        mapper.InterpolateScalarsBeforeMappingOn()
    mapper.SelectColorArray(name)
    mapper.SetLookupTable(colors)
    mapper.UseLookupTableScalarRangeOn()
    return actor


def lines(source, color=SLATE, width=3.0):
    """Curves, outlines, wire frames: the edges of any data, unlit, before the surface they lie on.

    Width: in half pixels."""
    actor = actor_of(source, color)
    actor.GetMapper().SetResolveCoincidentTopologyToPolygonOffset()
    # No factor of the slope: VTK 9.1 does not follow it, and would draw another picture.
    actor.GetMapper().SetRelativeCoincidentTopologyLineOffsetParameters(0.0, -8.0)
    look = actor.GetProperty()
    look.SetRepresentationToWireframe()
    look.LightingOff()
    look.SetLineWidth(width)
    return actor


def boundary(source, color=RED, width=5.0):
    """Where a surface ends, as lines."""
    edges = vtkFeatureEdges()
    connect(edges, source)
    edges.FeatureEdgesOff()
    edges.ColoringOff()
    return lines(edges, color, width)


def glyphs(source, shape, size, color):
    glyph = vtkGlyph3D()
    connect(glyph, source)
    glyph.SetSourceConnection(shape.GetOutputPort())
    glyph.SetScaleFactor(size)
    glyph.SetScaleModeToDataScalingOff()
    return glyph, actor_of(glyph, color)


def arrows(source, name, length, color=BLUE, scaled=False):
    """An arrow at every point along a vector array; scaled: length times the vector's own."""
    shape = vtkArrowSource()
    shape.SetTipResolution(16)
    shape.SetShaftResolution(12)
    glyph, actor = glyphs(source, shape, length, color)
    glyph.SetInputArrayToProcess(1, 0, 0, 0, name)
    glyph.SetVectorModeToUseVector()
    if scaled:
        glyph.SetScaleModeToScaleByVector()
    return actor


def dots(source, radius, color=SLATE):
    """A little sphere at every point."""
    shape = vtkSphereSource()
    shape.SetRadius(radius)
    glyph, actor = glyphs(source, shape, 1.0, color)
    glyph.OrientOff()
    return actor


def volume(source, colors, opacities, shade=False):
    """A rendered volume of the active scalars; opacities: pairs of a value and a cell's opacity."""
    mapper = vtkFixedPointVolumeRayCastMapper()
    connect(mapper, source)
    mapper.Update()
    cell = min(mapper.GetInput().GetSpacing())
    mapper.AutoAdjustSampleDistancesOff()
    mapper.SetSampleDistance(0.25 * cell)
    opacity = vtkPiecewiseFunction()
    for value, amount in opacities:
        opacity.AddPoint(value, amount)
    prop = vtkVolume()
    prop.SetMapper(mapper)
    look = prop.GetProperty()
    look.SetColor(colors)
    look.SetScalarOpacity(opacity)
    look.SetScalarOpacityUnitDistance(cell)
    look.SetInterpolationTypeToLinear()
    look.SetShade(shade)
    return prop


def image_slice(source, axis, index, colors):
    """One slice across an axis (0, 1, 2) of an image, by its active scalars, unlit."""
    slab = vtkExtractVOI()
    connect(slab, source)
    slab.UpdateInformation()
    extent = list(slab.GetInputInformation().Get(vtkStreamingDemandDrivenPipeline.WHOLE_EXTENT()))
    extent[2 * axis:2 * axis + 2] = index, index
    slab.SetVOI(extent)
    squares = vtkImageDataGeometryFilter()
    squares.SetInputConnection(slab.GetOutputPort())
    actor = colored(squares, "", colors)
    actor.GetMapper().SetScalarModeToUsePointData()
    actor.GetMapper().SetColorModeToMapScalars()   # bytes, too, are intensities and no colours
    actor.GetProperty().LightingOff()
    return actor


def scalar_bar(colors, title, labels=5, form="%.3g"):
    """For a panel's `bar`, or for the one below all panels."""
    bar = vtkScalarBarActor()
    bar.SetLookupTable(colors)
    bar.SetTitle(title)
    bar.SetOrientationToHorizontal()
    bar.SetNumberOfLabels(labels)
    bar.SetLabelFormat(form)
    bar.SetTextPositionToSucceedScalarBar()
    bar.UnconstrainedFontSizeOn()
    bar.SetMaximumNumberOfColors(256)
    bar.SetBarRatio(0.45)
    text = bar.GetLabelTextProperty()
    text.SetColor(0.0, 0.0, 0.0)
    text.BoldOff()
    text.ItalicOff()
    text.ShadowOff()
    return bar
