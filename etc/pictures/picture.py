# SPDX-License-Identifier: GPL-3.0-or-later
"""One time of a case drawn with VTK, for etc/render."""

import itertools

import vtkmodules.vtkRenderingFreeType  # noqa: F401, text
import vtkmodules.vtkRenderingOpenGL2  # noqa: F401, the renderer
from vtkmodules import vtkCommonCore, vtkCommonDataModel, vtkCommonTransforms
from vtkmodules import vtkFiltersCore, vtkFiltersGeneral, vtkFiltersSources
from vtkmodules import vtkRenderingCore

from shapes import PALETTE
from side import GAP, bar_of, legend_of

# Pixels
TITLE_HEIGHT, MARGIN = 30, 10


def actor_of(data, colour=None):
    """An actor for polygons or lines, which no light dims."""
    mapper = vtkRenderingCore.vtkPolyDataMapper()
    mapper.SetInputData(data)
    mapper.ScalarVisibilityOff()
    actor = vtkRenderingCore.vtkActor()
    actor.SetMapper(mapper)
    actor.GetProperty().LightingOff()
    if colour:
        actor.GetProperty().SetColor(*colour)
    return actor


def with_images(data, periods):
    """Polygons or lines and their copies in the periods beside theirs."""
    copies = vtkFiltersCore.vtkAppendPolyData()
    for shift in itertools.product(*((-p, 0, p) if p else (0,)
                                     for p in periods)):
        transform = vtkCommonTransforms.vtkTransform()
        transform.Translate(*shift)
        moved = vtkFiltersGeneral.vtkTransformPolyDataFilter()
        moved.SetInputData(data)
        moved.SetTransform(transform)
        copies.AddInputConnection(moved.GetOutputPort())
    copies.Update()
    return copies.GetOutput()


def array_of(data, name):
    """Values at points, else of cells; None if there are none."""
    return (data.GetPointData().GetArray(name)
            or data.GetCellData().GetArray(name))


def magnitude_range(data, name):
    """Range of a field: of the magnitude if it is a vector."""
    array = array_of(data, name)
    return array.GetRange(-1 if array.GetNumberOfComponents() > 1 else 0)


# First and last colour of a field: pale to dark blue, so that objects stand
# out, and of surfaces, yellow to violet, so that they do so on white
FIELD = ((0.97, 0.98, 1), (0.11, 0.31, 0.58))
SURFACE = ((0.99, 0.86, 0.3), (0.3, 0.05, 0.4))


def colour_table(bounds, ends=FIELD):
    """Colours from one to another."""
    table = vtkCommonCore.vtkLookupTable()
    table.SetNumberOfTableValues(256)
    for i in range(256):
        table.SetTableValue(i, *(a + (b - a)*i/255 for a, b in zip(*ends)), 1)
    table.SetRange(*bounds)
    return table


class Picture:
    """One time of a case, drawn."""

    def __init__(self, size, time, bounds, table):
        self.renderer = vtkRenderingCore.vtkRenderer()
        self.renderer.SetBackground(1, 1, 1)
        self.bounds, self.table = bounds, table
        # By numbers of shapes, where these decide
        self.shape_colours = {}
        self.width, self.height = self.extent()
        self.scale = size/max(self.width, self.height)
        self.line = max(1.0, size/400)
        self.side = 0
        self.add_title(f"t = {time:.6g} s")

    def extent(self):
        """Width and height of what is shown."""
        return (self.bounds[1] - self.bounds[0],
                self.bounds[3] - self.bounds[2])

    def placed(self, data, colour=None, height=0.0):
        """An actor at a height above the plane, in widths of the picture."""
        actor = actor_of(data, colour)
        actor.SetPosition(0, 0, height*self.width - data.GetCenter()[2])
        return actor

    def sides(self):
        """Sides of the box that objects may reach across."""
        return range(4)

    def add(self, actor, line_width=1.0):
        actor.GetProperty().SetLineWidth(line_width*self.line)
        self.renderer.AddActor(actor)

    def add_inside(self, actor, line_width=1.0):
        """Adds what is in the frame of an actor: objects reach across seams."""
        for side in self.sides():
            origin, normal = [0, 0, 0], [0, 0, 0]
            origin[side//2] = self.bounds[side]
            normal[side//2] = -1 if side % 2 else 1
            plane = vtkCommonDataModel.vtkPlane()
            plane.SetOrigin(*origin)
            plane.SetNormal(*normal)
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
        self.add(self.placed(source.GetOutput(), (0, 0, 0), 6))

    def add_field(self, plane, name):
        """A field as colours."""
        actor = self.placed(plane)
        self.paint(actor, plane, name)
        self.add(actor)

    def paint(self, actor, data, name):
        """Gives an actor the colours of an array, if there is one: of the
        magnitude of a vector."""
        array = array_of(data, name)
        if not array:
            return
        mapper = actor.GetMapper()
        mapper.ScalarVisibilityOn()
        if data.GetPointData().GetArray(name):
            mapper.SetScalarModeToUsePointFieldData()
        else:
            mapper.SetScalarModeToUseCellFieldData()
        mapper.SelectColorArray(name)
        mapper.SetLookupTable(self.table)
        mapper.UseLookupTableScalarRangeOn()
        if array.GetNumberOfComponents() > 1:
            self.table.SetVectorModeToMagnitude()

    def add_bar(self, name):
        """The colours of the field, to the right of all else."""
        bar, width = bar_of(self.table, name)
        start = self.pixels()[0]
        self.side += width
        bar.SetPosition((start + GAP)/self.pixels()[0], 0.1)
        bar.SetPosition2((width - 2*GAP)/self.pixels()[0], 0.8)
        self.renderer.AddActor2D(bar)

    def add_legend(self, colours):
        """Names of shapes and their colours, to the right of the frame."""
        wide, high = self.pixels()
        actors, width = legend_of(colours, wide + GAP, TITLE_HEIGHT + MARGIN,
                                  high - MARGIN)
        self.side += width
        for actor in actors:
            self.renderer.AddActor2D(actor)

    def add_vectors(self, plane, count):
        """Arrows of U on a lattice; the longest are as long as its spacing."""
        spacing = max(self.width, self.height)/count
        box = plane.GetBounds()
        counts = [max(int((box[2*i + 1] - box[2*i])/spacing), 1)
                  for i in range(3)]
        lattice = vtkCommonDataModel.vtkImageData()
        lattice.SetDimensions(*counts)
        lattice.SetSpacing(spacing, spacing, spacing)
        lattice.SetOrigin(*(
            box[2*i] + spacing/2 if counts[i] > 1 else plane.GetCenter()[i]
            for i in range(3)
        ))
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
        self.add(self.placed(glyph.GetOutput(), (0.1, 0.1, 0.1), 2))

    @staticmethod
    def zero_of(plane, name):
        """The line on which a field is zero."""
        contour = vtkFiltersCore.vtkContourFilter()
        contour.SetInputData(plane)
        contour.SetInputArrayToProcess(0, 0, 0, 0, name)
        contour.SetValue(0, 0.0)
        contour.Update()
        return contour.GetOutput()

    def add_contour(self, plane, name):
        self.add(self.placed(self.zero_of(plane, name), (0, 0, 0), 5), 1.5)

    def coloured(self, data, height=0.0):
        """An actor of polygons in the colours of their objects' numbers or
        shapes."""
        numbers = data.GetCellData().GetArray(
            "shape" if self.shape_colours else "object")
        colours = vtkCommonCore.vtkUnsignedCharArray()
        colours.SetNumberOfComponents(3)
        for i in range(data.GetNumberOfCells()):
            number = int(numbers.GetTuple1(i)) if numbers else 0
            colours.InsertNextTuple3(*self.shape_colours.get(
                number, PALETTE[number % len(PALETTE)]))
        data.GetCellData().SetScalars(colours)
        actor = self.placed(data, None, height)
        actor.GetMapper().ScalarVisibilityOn()
        actor.GetMapper().SetScalarModeToUseCellData()
        return actor

    def add_objects(self, surfaces, name):
        """Each object filled in its colour, with its outline; or grey, with an
        outline in the colours of an array."""
        triangles = vtkFiltersCore.vtkTriangleFilter()
        triangles.SetInputData(surfaces)
        triangles.Update()
        filled = triangles.GetOutput()
        self.add_inside(self.placed(filled, (0.85, 0.85, 0.85), 3) if name
                        else self.coloured(filled, 3))

        edges = self.placed(surfaces, (0.15, 0.15, 0.15), 4)
        edges.GetProperty().SetRepresentationToWireframe()
        if name:
            self.paint(edges, surfaces, name)
        self.add_inside(edges, 4 if name else 1)

    def add_springs(self, springs):
        actor = self.placed(springs, (0.3, 0.3, 0.3), 3.5)
        self.add_inside(actor, 0.5)

    def pixels(self):
        """Width and height of the picture."""
        wide = round(self.width*self.scale) + self.side + 2*MARGIN
        return wide, round(self.height*self.scale) + TITLE_HEIGHT + 2*MARGIN

    def set_camera(self, camera, high):
        """Looks at the plane from above; high: pixels of the picture."""
        shift = (
            0.5*(self.bounds[0] + self.bounds[1]) + 0.5*self.side/self.scale,
            0.5*(self.bounds[2] + self.bounds[3]) - 0.5*TITLE_HEIGHT/self.scale,
        )
        camera.SetFocalPoint(*shift, 0)
        camera.SetPosition(*shift, 100*self.width)
        camera.SetParallelScale(0.5*high/self.scale)

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
        self.set_camera(camera, high)
        self.renderer.ResetCameraClippingRange()
        window.Render()

        image = vtkRenderingCore.vtkWindowToImageFilter()
        image.SetInput(window)
        image.ReadFrontBufferOff()
        image.Update()
        window.Finalize()
        return image.GetOutput()
