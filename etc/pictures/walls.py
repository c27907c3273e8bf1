# SPDX-License-Identifier: GPL-3.0-or-later
"""Objects that reach out of a box on two opposite sides, for etc/render: walls,
as those of a tube, which have no images and would hide what they enclose."""

from vtkmodules import vtkCommonCore, vtkCommonDataModel
from vtkmodules import vtkFiltersCore, vtkFiltersGeometry


def wall_numbers(surfaces, bounds):
    """Numbers of the objects that are walls."""
    numbers = surfaces.GetCellData().GetArray("object")
    boxes = {}
    for i in range(surfaces.GetNumberOfCells() if numbers else 0):
        box = boxes.setdefault(int(numbers.GetTuple1(i)),
                               vtkCommonDataModel.vtkBoundingBox())
        box.AddBounds(surfaces.GetCell(i).GetBounds())

    def is_wall(box):
        found = [0]*6
        box.GetBounds(found)
        return any(found[2*d] < bounds[2*d] and found[2*d + 1] > bounds[2*d + 1]
                   for d in range(3))

    return {n for n, box in boxes.items() if is_wall(box)}


def chosen(surfaces, mark):
    """The cells with a mark of 1."""
    part = vtkFiltersCore.vtkThreshold()
    part.SetInputData(surfaces)
    part.SetInputArrayToProcess(
        0, 0, 0, vtkCommonDataModel.vtkDataObject.FIELD_ASSOCIATION_CELLS,
        mark)
    part.SetUpperThreshold(0.5)
    part.SetThresholdFunction(part.THRESHOLD_UPPER)
    polygons = vtkFiltersGeometry.vtkGeometryFilter()
    polygons.SetInputConnection(part.GetOutputPort())
    polygons.Update()
    return polygons.GetOutput()


def without_walls(surfaces, bounds):
    """Polygons of the bodies, and of the walls or None."""
    walls = wall_numbers(surfaces, bounds)
    if not walls:
        return surfaces, None
    numbers = surfaces.GetCellData().GetArray("object")
    for name, is_in in (("isWall", True), ("isBody", False)):
        mark = vtkCommonCore.vtkDoubleArray()
        mark.SetName(name)
        for i in range(surfaces.GetNumberOfCells()):
            mark.InsertNextValue(
                (int(numbers.GetTuple1(i)) in walls) == is_in)
        surfaces.GetCellData().AddArray(mark)
    return chosen(surfaces, "isBody"), chosen(surfaces, "isWall")
