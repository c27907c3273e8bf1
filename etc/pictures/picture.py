# SPDX-License-Identifier: GPL-3.0-or-later
"""One time of a case drawn with VTK, for etc/render."""

import vtkmodules.vtkRenderingFreeType  # noqa: F401, text
import vtkmodules.vtkRenderingOpenGL2  # noqa: F401, the renderer
from vtkmodules import vtkCommonCore, vtkCommonDataModel, vtkCommonTransforms
from vtkmodules import vtkFiltersCore, vtkFiltersGeneral, vtkFiltersSources
from vtkmodules import vtkRenderingAnnotation, vtkRenderingCore

PALETTE = (
    (227, 120, 41), (43, 140, 87), (204, 64, 84),
    (115, 92, 166), (148, 107, 71), (217, 166, 33),
)
# Pixels
BAR_WIDTH, TITLE_HEIGHT, MARGIN = 110, 30, 10


def actor_of(data, colour=None, height=0.0):
    """An actor for polygons or lines, at a height above the plane."""
    mapper = vtkRenderingCore.vtkPolyDataMapper()
    mapper.SetInputData(data)
    mapper.ScalarVisibilityOff()
    actor = vtkRenderingCore.vtkActor()
    actor.SetMapper(mapper)
    actor.SetPosition(0, 0, height - data.GetCenter()[2])
    actor.GetProperty().LightingOff()
    if colour:
        actor.GetProperty().SetColor(*colour)
    return actor


def with_images(data, periods):
    """Polygons or lines and their copies in the periods beside theirs."""
    copies = vtkFiltersCore.vtkAppendPolyData()
    steps = [(-p, 0, p) if p else (0,) for p in periods]
    for x in steps[0]:
        for y in steps[1]:
            transform = vtkCommonTransforms.vtkTransform()
            transform.Translate(x, y, 0)
            moved = vtkFiltersGeneral.vtkTransformPolyDataFilter()
            moved.SetInputData(data)
            moved.SetTransform(transform)
            copies.AddInputConnection(moved.GetOutputPort())
    copies.Update()
    return copies.GetOutput()


def magnitude_range(data, name):
    """Range of a field on the points: of the magnitude if it is a vector."""
    array = data.GetPointData().GetArray(name)
    return array.GetRange(-1 if array.GetNumberOfComponents() > 1 else 0)


def colour_table(bounds):
    """Colours from pale to dark blue, so that the objects stand out."""
    table = vtkCommonCore.vtkLookupTable()
    table.SetNumberOfTableValues(256)
    for i in range(256):
        s = i/255
        table.SetTableValue(i, 0.97 - 0.86*s, 0.98 - 0.67*s, 1 - 0.42*s, 1)
    table.SetRange(*bounds)
    return table


class Picture:
    """One time of a case, drawn."""

    def __init__(self, size, time, bounds, table, with_bar):
        self.renderer = vtkRenderingCore.vtkRenderer()
        self.renderer.SetBackground(1, 1, 1)
        self.bounds, self.table = bounds, table
        self.width = bounds[1] - bounds[0]
        self.height = bounds[3] - bounds[2]
        self.scale = size/max(self.width, self.height)
        self.line = max(1.0, size/400)
        self.bar = BAR_WIDTH if with_bar else 0
        self.add_title(f"t = {time:.6g} s")

    def add(self, actor, line_width=1.0):
        actor.GetProperty().SetLineWidth(line_width*self.line)
        self.renderer.AddActor(actor)

    def add_inside(self, actor, line_width=1.0):
        """Adds what is in the frame of an actor: objects reach across seams."""
        sides = ((0, (1, 0)), (1, (-1, 0)), (2, (0, 1)), (3, (0, -1)))
        for side, normal in sides:
            origin = [0, 0, 0]
            origin[side//2] = self.bounds[side]
            plane = vtkCommonDataModel.vtkPlane()
            plane.SetOrigin(*origin)
            plane.SetNormal(*normal, 0)
            actor.GetMapper().AddClippingPlane(plane)
        self.add(actor, line_width)

    def add_title(self, text):
        title = vtkRenderingCore.vtkTextActor()
        title.SetInput(text)
        title.SetPosition(10, 5)
        title.GetTextProperty().SetFontSize(18)
        title.GetTextProperty().SetColor(0, 0, 0)
        self.renderer.AddActor2D(title)

    def add_frame(self):
        """The outline of the region shown."""
        source = vtkFiltersSources.vtkOutlineSource()
        source.SetBounds(*self.bounds[:4], 0, 0)
        source.Update()
        self.add(actor_of(source.GetOutput(), (0, 0, 0), 6*self.width))

    def add_field(self, plane, name):
        """A field as colours; the magnitude of a vector."""
        actor = actor_of(plane)
        mapper = actor.GetMapper()
        mapper.ScalarVisibilityOn()
        mapper.SetScalarModeToUsePointFieldData()
        mapper.SelectColorArray(name)
        mapper.SetLookupTable(self.table)
        mapper.UseLookupTableScalarRangeOn()
        if plane.GetPointData().GetArray(name).GetNumberOfComponents() > 1:
            self.table.SetVectorModeToMagnitude()
        self.add(actor)

    def add_bar(self, name):
        bar = vtkRenderingAnnotation.vtkScalarBarActor()
        bar.SetLookupTable(self.table)
        bar.SetTitle(name)
        bar.SetNumberOfLabels(5)
        bar.SetLabelFormat("%.3g")
        bar.SetVerticalTitleSeparation(12)
        bar.UnconstrainedFontSizeOn()
        for text in (bar.GetTitleTextProperty(), bar.GetLabelTextProperty()):
            text.SetColor(0, 0, 0)
            text.SetFontSize(14)
            text.ShadowOff()
            text.ItalicOff()
        start = 1 - self.bar/self.pixels()[0]
        bar.SetPosition(start + 0.01, 0.1)
        bar.SetPosition2(0.95*(1 - start), 0.8)
        self.renderer.AddActor2D(bar)

    def add_vectors(self, plane, count):
        """Arrows of U on a lattice; the longest are as long as its spacing."""
        spacing = max(self.width, self.height)/count
        lattice = vtkCommonDataModel.vtkImageData()
        nx, ny = int(self.width/spacing), int(self.height/spacing)
        lattice.SetDimensions(nx, ny, 1)
        lattice.SetSpacing(spacing, spacing, 1)
        lattice.SetOrigin(
            self.bounds[0] + spacing/2, self.bounds[2] + spacing/2,
            plane.GetCenter()[2],
        )
        probe = vtkFiltersCore.vtkProbeFilter()
        probe.SetInputData(lattice)
        probe.SetSourceData(plane)
        probe.Update()
        samples = probe.GetOutput()
        samples.GetPointData().SetActiveVectors("U")
        arrow = vtkFiltersSources.vtkArrowSource()
        glyph = vtkFiltersCore.vtkGlyph3D()
        glyph.SetInputData(samples)
        glyph.SetSourceConnection(arrow.GetOutputPort())
        glyph.SetVectorModeToUseVector()
        glyph.SetScaleModeToScaleByVector()
        fastest = magnitude_range(samples, "U")[1]
        glyph.SetScaleFactor(1.5*spacing/fastest if fastest > 0 else 0)
        glyph.Update()
        self.add(actor_of(glyph.GetOutput(), (0.1, 0.1, 0.1), 2*self.width))

    def add_contour(self, plane, name):
        contour = vtkFiltersCore.vtkContourFilter()
        contour.SetInputData(plane)
        contour.SetInputArrayToProcess(0, 0, 0, 0, name)
        contour.SetValue(0, 0.0)
        contour.Update()
        line = actor_of(contour.GetOutput(), (0, 0, 0), 5*self.width)
        self.add(line, 1.5)

    def add_objects(self, surfaces):
        """Each object filled in the colour of its number, with its outline."""
        triangles = vtkFiltersCore.vtkTriangleFilter()
        triangles.SetInputData(surfaces)
        triangles.Update()
        data = triangles.GetOutput()
        numbers = data.GetCellData().GetArray("object")
        colours = vtkCommonCore.vtkUnsignedCharArray()
        colours.SetNumberOfComponents(3)
        for i in range(data.GetNumberOfCells()):
            number = int(numbers.GetTuple1(i)) if numbers else 0
            colours.InsertNextTuple3(*PALETTE[number % len(PALETTE)])
        data.GetCellData().SetScalars(colours)
        actor = actor_of(data, None, 3*self.width)
        actor.GetMapper().ScalarVisibilityOn()
        actor.GetMapper().SetScalarModeToUseCellData()
        self.add_inside(actor)

        edges = actor_of(surfaces, (0.15, 0.15, 0.15), 4*self.width)
        edges.GetProperty().SetRepresentationToWireframe()
        self.add_inside(edges)

    def add_springs(self, springs):
        actor = actor_of(springs, (0.3, 0.3, 0.3), 3.5*self.width)
        self.add_inside(actor, 0.5)

    def pixels(self):
        """Width and height of the picture."""
        wide = round(self.width*self.scale) + self.bar + 2*MARGIN
        return wide, round(self.height*self.scale) + TITLE_HEIGHT + 2*MARGIN

    def image(self):
        """The picture as VTK image data."""
        wide, high = self.pixels()
        window = vtkRenderingCore.vtkRenderWindow()
        window.SetOffScreenRendering(1)
        window.SetMultiSamples(4)
        window.SetSize(wide, high)
        window.AddRenderer(self.renderer)

        camera = self.renderer.GetActiveCamera()
        camera.ParallelProjectionOn()
        shift = (
            0.5*(self.bounds[0] + self.bounds[1]) + 0.5*self.bar/self.scale,
            0.5*(self.bounds[2] + self.bounds[3]) - 0.5*TITLE_HEIGHT/self.scale,
        )
        camera.SetFocalPoint(*shift, 0)
        camera.SetPosition(*shift, 100*self.width)
        camera.SetParallelScale(0.5*high/self.scale)
        self.renderer.ResetCameraClippingRange()
        window.Render()

        image = vtkRenderingCore.vtkWindowToImageFilter()
        image.SetInput(window)
        image.ReadFrontBufferOff()
        image.Update()
        window.Finalize()
        return image.GetOutput()
