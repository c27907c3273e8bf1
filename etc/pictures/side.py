# SPDX-License-Identifier: GPL-3.0-or-later
"""What stands to the right of a picture of etc/render: the bar of a field's
colours, and the names of shapes with theirs. Lengths are in pixels."""

from vtkmodules import vtkFiltersSources
from vtkmodules import vtkRenderingAnnotation, vtkRenderingCore

# The bar: its least width, that of its colours; gaps
BAR_WIDTH, STRIPE, GAP = 110, 39, 8
NUMBERS, FORMAT = 5, "%.3g"
# The legend: height of a line, side of a square of colour
ROW, SQUARE = 22, 14
DOTS_PER_INCH = 72


def write_black(properties):
    """Plain text of one size."""
    properties.SetColor(0, 0, 0)
    properties.SetFontSize(14)
    properties.ShadowOff()
    properties.ItalicOff()


def width_of(text, properties):
    """Width of a text."""
    box = [0]*4
    vtkRenderingCore.vtkTextRenderer.GetInstance().GetBoundingBox(
        properties, text, box, DOTS_PER_INCH)
    return box[1] - box[0] + 1


def bar_of(table, name):
    """The bar of a table of colours, and how wide it is with its numbers and
    its title."""
    bar = vtkRenderingAnnotation.vtkScalarBarActor()
    bar.SetLookupTable(table)
    bar.SetTitle(name)
    bar.SetNumberOfLabels(NUMBERS)
    bar.SetLabelFormat(FORMAT)
    bar.SetVerticalTitleSeparation(12)
    bar.UnconstrainedFontSizeOn()
    for properties in (bar.GetTitleTextProperty(), bar.GetLabelTextProperty()):
        write_black(properties)
    low, high = table.GetRange()
    widest = max(width_of(FORMAT % (low + (high - low)*i/(NUMBERS - 1)),
                          bar.GetLabelTextProperty())
                 for i in range(NUMBERS))
    width = max(BAR_WIDTH, STRIPE + widest + 3*GAP,
                width_of(name, bar.GetTitleTextProperty()) + 3*GAP)
    bar.SetBarRatio(STRIPE/(width - 2*GAP))
    return bar, width


def square(left, low, colour):
    """A square of a colour, from 0 to 255."""
    source = vtkFiltersSources.vtkPlaneSource()
    source.SetOrigin(left, low, 0)
    source.SetPoint1(left + SQUARE, low, 0)
    source.SetPoint2(left, low + SQUARE, 0)
    mapper = vtkRenderingCore.vtkPolyDataMapper2D()
    mapper.SetInputConnection(source.GetOutputPort())
    actor = vtkRenderingCore.vtkActor2D()
    actor.SetMapper(mapper)
    actor.GetProperty().SetColor(*(c/255 for c in colour))
    return actor


def legend_of(colours, left, low, high):
    """Squares of colour with names beside them, from the height high down to
    low, in as many columns as that needs; and how wide they are."""
    actors, start = [], left
    names, rows = list(colours), max(1, int((high - low)//ROW))
    for first in range(0, len(names), rows):
        widest = 0
        for i, name in enumerate(names[first:first + rows]):
            bottom = high - ROW*(i + 1) + (ROW - SQUARE)/2
            text = vtkRenderingCore.vtkTextActor()
            text.SetInput(name)
            text.SetPosition(left + SQUARE + GAP, bottom)
            write_black(text.GetTextProperty())
            widest = max(widest, width_of(name, text.GetTextProperty()))
            actors += [square(left, bottom, colours[name]), text]
        left += SQUARE + widest + 3*GAP
    return actors, left - start
