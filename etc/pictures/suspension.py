# SPDX-License-Identifier: GPL-3.0-or-later
"""Profiles across a channel or a tube from what a run wrote: velocity of the
mixture, volume fraction of objects, and the layer without objects at walls.

The flow goes along x. Walls are at the ends of y, or a tube is around an axis
along x. A place across is the distance from the middle or from the axis."""

import numpy
from vtkmodules import vtkCommonDataModel, vtkFiltersCore
from vtkmodules.util.numpy_support import vtk_to_numpy

import caseData
from shapes import shape_names


class Section:
    """Plates, or a tube of radius R about (y, z) with the radius given."""

    def __init__(self, bounds, flat, tube=None):
        self.flat, self.tube = flat, tube
        self.middle = (tube[1:] if tube
                       else (0.5*(bounds[2] + bounds[3]), 0))
        self.half = tube[0] if tube else 0.5*(bounds[3] - bounds[2])
        self.length = bounds[1] - bounds[0]
        self.depth = bounds[5] - bounds[4]
        self.start = bounds[0]

    def across(self, points):
        """Place across of points: signed between plates."""
        y = points[:, 1] - self.middle[0]
        if not self.tube:
            return y
        return numpy.hypot(y, points[:, 2] - self.middle[1])

    def volume(self):
        """Of fluid and objects."""
        area = (numpy.pi*self.half**2 if self.tube
                else 2*self.half*self.depth)
        return self.length*area

    def bins(self, count):
        """Ends of the bins."""
        return numpy.linspace(0 if self.tube else -self.half, self.half,
                              count + 1)

    def sizes(self, ends):
        """Volume of each bin."""
        if self.tube:
            return numpy.pi*numpy.diff(ends**2)*self.length
        return numpy.diff(ends)*self.depth*self.length

    def binned(self, place, values, ends):
        """Means of cells' values in each bin, between those beside it where it
        has no cell."""
        number, _ = numpy.histogram(place, ends)
        total, _ = numpy.histogram(place, ends, weights=values)
        some = number > 0
        middles = 0.5*(ends[1:] + ends[:-1])
        return numpy.interp(middles, middles[some],
                            total[some]/number[some])

    def newtonian(self, velocity):
        """Shear rate at the walls of a Newtonian flow of this mean velocity
        that a force drives."""
        return (4 if self.tube else 3)*velocity/self.half


def velocities(fluid, time, section):
    """Places and velocities along x of the cells in the section."""
    fluid.reader.UpdateTimeStep(caseData.nearest(fluid.times, time))
    mesh = fluid.reader.GetOutput().GetBlock(0)
    centres = vtkFiltersCore.vtkCellCenters()
    centres.SetInputData(mesh)
    centres.Update()
    points = vtk_to_numpy(centres.GetOutput().GetPoints().GetData())
    speed = vtk_to_numpy(mesh.GetCellData().GetArray("U"))[:, 0]
    place = section.across(points)
    within = abs(place) < section.half
    return place[within], speed[within]


def corners_of(polygons):
    """Places of the corners of all triangles."""
    points = vtk_to_numpy(polygons.GetPoints().GetData()).astype(float)
    nodes = vtk_to_numpy(polygons.GetPolys().GetConnectivityArray())
    return points[nodes].reshape(-1, 3, 3)


def extents(polygons):
    """Names of the objects; for each its ends along x and its largest speed."""
    points = vtk_to_numpy(polygons.GetPoints().GetData()).astype(float)
    speed = numpy.linalg.norm(
        vtk_to_numpy(polygons.GetPointData().GetArray("velocity")), axis=1)
    polys = polygons.GetPolys()
    nodes = vtk_to_numpy(polys.GetConnectivityArray())
    sizes = numpy.diff(vtk_to_numpy(polys.GetOffsetsArray()))
    names, own = numpy.unique(
        vtk_to_numpy(polygons.GetCellData().GetArray("object")),
        return_inverse=True)
    own = numpy.repeat(own, sizes)
    low, high, fastest = numpy.full(
        (3, names.size), [[numpy.inf], [-numpy.inf], [0.0]])
    numpy.minimum.at(low, own, points[nodes, 0])
    numpy.maximum.at(high, own, points[nodes, 0])
    numpy.maximum.at(fastest, own, speed[nodes])
    return names, low, high, fastest


def carried(polygons, section):
    """The surfaces of the objects that the flow carries. Walls that go through
    the mesh are left out. Other fixed objects are an error: the section is not
    the same along x."""
    names, low, high, fastest = extents(polygons)
    walls = (high - low > section.length) & (fastest == 0)
    if walls.any() and not section.tube:
        raise OSError("objects are walls that go through the mesh: -tube")
    if ((fastest == 0) & ~walls).any():
        raise OSError("fixed objects stand in the flow: its section is not the "
                      "same along x")
    if not walls.any():
        return polygons
    object_ids = vtk_to_numpy(polygons.GetCellData().GetArray("object"))
    rest = vtkCommonDataModel.vtkPolyData()
    rest.DeepCopy(polygons)
    rest.BuildLinks()
    for cell in numpy.flatnonzero(numpy.isin(object_ids, names[walls])):
        rest.DeleteCell(int(cell))
    rest.RemoveDeletedCells()
    return rest


def quarters(corners):
    """Triangles, each cut in four."""
    a, b, c = (corners[:, i] for i in range(3))
    ab, bc, ca = 0.5*(a + b), 0.5*(b + c), 0.5*(c + a)
    return numpy.concatenate([
        numpy.stack(t, 1) for t in ((a, ab, ca), (ab, b, bc),
                                    (ca, bc, c), (ab, bc, ca))])


def normals(corners):
    """Normals of triangles, as long as their areas."""
    return 0.5*numpy.cross(corners[:, 1] - corners[:, 0],
                           corners[:, 2] - corners[:, 0])


def section_of(polygons, shape, bounds):
    """Radius and centre of the round tube that has the area and the centre of
    a vessel's mean section within the mesh. By Gauss' theorem they are
    integrals over its wall."""
    names = shape_names(polygons)
    if shape not in names:
        raise OSError(f"no shape {shape}, but " + ", ".join(names))
    own = vtk_to_numpy(polygons.GetCellData().GetArray("shape"))
    corners = quarters(quarters(
        corners_of(polygons)[own == names.index(shape)]))
    middles = corners.mean(axis=1)
    inside = numpy.all([(middles[:, i] > bounds[2*i])
                        & (middles[:, i] < bounds[2*i + 1])
                        for i in range(3)], axis=0)
    y, z = middles[inside, 1], middles[inside, 2]
    n_x, n_y, n_z = normals(corners[inside]).T
    if abs(n_x).sum() > 0.05*numpy.sqrt(n_x**2 + n_y**2 + n_z**2).sum():
        raise OSError(f"the section of {shape} is not the same along x")
    volume = 0.5*(y*n_y + z*n_z).sum()
    if volume == 0:
        raise OSError(f"no wall of shape {shape} in the mesh")
    centre = [0.5*(place**2*n).sum()/volume for place, n in ((y, n_y),
                                                             (z, n_z))]
    area = abs(volume)/(bounds[1] - bounds[0])
    return [numpy.sqrt(area/numpy.pi), *centre]


def pieces(polygons, section):
    """Middles of parts of the surfaces, and x n_x times their areas, in 2D
    lengths; triangles are cut in sixteen."""
    if section.flat:
        points = vtk_to_numpy(polygons.GetPoints().GetData()).astype(float)
        polys = polygons.GetPolys()
        nodes = vtk_to_numpy(polys.GetConnectivityArray())
        ends = vtk_to_numpy(polys.GetOffsetsArray())
        following = numpy.roll(nodes, -1)
        following[ends[1:] - 1] = nodes[ends[:-1]]
        corners = numpy.stack([points[nodes], points[following]], 1)
        fractions = (numpy.arange(8) + 0.5)/8
        middles = numpy.concatenate(
            [(1 - f)*corners[:, 0] + f*corners[:, 1] for f in fractions])
        area = numpy.tile((corners[:, 1] - corners[:, 0])[:, 1]/8, 8)
        return middles, middles[:, 0]*area
    corners = quarters(quarters(corners_of(polygons)))
    middles = corners.mean(axis=1)
    return middles, middles[:, 0]*normals(corners)[:, 0]


def fractions(polygons, section, ends):
    """Volume fraction of objects in each bin. By Gauss' theorem the volume of
    an object in a bin is the integral of x n_x over its surface there."""
    middles, flux = pieces(polygons, section)
    volumes, _ = numpy.histogram(section.across(middles), ends, weights=flux)
    if section.flat:
        # Outlines may go round either way
        volumes = abs(volumes)*section.depth
    return volumes/section.sizes(ends)


def free_layer(polygons, section):
    """Mean distance from the walls to the nearest surface, over pieces of the
    length as long as a tenth of it."""
    points = vtk_to_numpy(polygons.GetPoints().GetData()).astype(float)
    points = points[vtk_to_numpy(polygons.GetPolys().GetConnectivityArray())]
    piece = numpy.floor(10*(points[:, 0] - section.start)/section.length) % 10
    place = section.across(points)
    gaps = []
    for i in range(10):
        own = place[piece == i]
        if own.size:
            gaps.append(section.half - own.max())
            if not section.tube:
                gaps.append(section.half + own.min())
    return numpy.mean(gaps) if gaps else float("nan")
