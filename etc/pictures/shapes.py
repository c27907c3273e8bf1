# SPDX-License-Identifier: GPL-3.0-or-later
"""Names and colours of the shapes of objects, for etc/render and
etc/profiles."""

import numpy
from vtkmodules.util.numpy_support import vtk_to_numpy

PALETTE = (
    (227, 120, 41), (43, 140, 87), (204, 64, 84),
    (115, 92, 166), (148, 107, 71), (217, 166, 33),
)
# Of shapes that stand still
GREY = (165, 165, 165)


def shape_names(polygons):
    """Names of shapes, in the order of their numbers."""
    if not polygons.GetNumberOfCells():
        return []
    names = polygons.GetFieldData().GetAbstractArray("shapeNames")
    if not names or not polygons.GetCellData().GetArray("shape"):
        raise OSError("the surfaces have no names of shapes")
    return [names.GetValue(i) for i in range(names.GetNumberOfValues())]


def shapes_in(polygons):
    """Names of the shapes that there are, and of those that move."""
    names = shape_names(polygons)
    if not names:
        return [set(), set()]
    own = vtk_to_numpy(polygons.GetCellData().GetArray("shape"))
    velocity = polygons.GetPointData().GetArray("velocity")
    moving = []
    if velocity:
        polys = polygons.GetPolys()
        sizes = numpy.diff(vtk_to_numpy(polys.GetOffsetsArray()))
        nodes = vtk_to_numpy(polys.GetConnectivityArray())
        moves = vtk_to_numpy(velocity)[nodes].any(axis=1)
        moving = numpy.repeat(own, sizes)[moves]
    return [{names[i] for i in numpy.unique(part)} for part in (own, moving)]


def colour_of(i):
    """One of the palette, then paler and darker ones."""
    tone = (1, 0.5, 0.6)[i//len(PALETTE) % 3]
    light = 255 if i//len(PALETTE) % 3 == 1 else 0
    return tuple(round(tone*c + (1 - tone)*light)
                 for c in PALETTE[i % len(PALETTE)])


def shape_colours(times):
    """Colours of the shapes by their names, from the surfaces at some times;
    grey for those that stand still while others move."""
    there, moving = set(), set()
    for polygons in times:
        for found, new in zip((there, moving), shapes_in(polygons)):
            found |= new
    free = sorted(moving or there)
    return {name: colour_of(free.index(name)) if name in free else GREY
            for name in sorted(there)}


def by_number(polygons, colours):
    """Colours by the numbers that the shapes have in a file: the seeding may
    have others than the run."""
    return {i: colours[name] for i, name in enumerate(shape_names(polygons))
            if name in colours} if colours else {}
