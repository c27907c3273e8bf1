# SPDX-License-Identifier: GPL-3.0-or-later
"""One time of a case in three dimensions drawn with VTK, for etc/render: solid
surfaces, a slice through the field, and the box, seen from a chosen side."""

import math

from vtkmodules import vtkFiltersCore, vtkFiltersSources

from picture import MARGIN, TITLE_HEIGHT, Picture, actor_of


class Scene(Picture):
    """A picture with a camera: degrees to the right of the view along -z, and
    degrees above the horizon."""

    def __init__(self, size, time, bounds, table, camera):
        self.azimuth, self.elevation = camera
        super().__init__(size, time, bounds, table)

    def extent(self):
        """Width and height of the box as the camera sees it."""
        right, up, _ = self.axes()
        spans = [self.bounds[2*i + 1] - self.bounds[2*i] for i in range(3)]
        return tuple(
            1.04*sum(abs(a)*s for a, s in zip(axis, spans))
            for axis in (right, up)
        )

    def axes(self):
        """Unit vectors to the right, upwards and towards the camera."""
        a, e = math.radians(self.azimuth), math.radians(self.elevation)
        return (
            (math.cos(a), 0, -math.sin(a)),
            (-math.sin(a)*math.sin(e), math.cos(e), -math.cos(a)*math.sin(e)),
            (math.sin(a)*math.cos(e), math.sin(e), math.cos(a)*math.cos(e)),
        )

    def placed(self, data, colour=None, height=0.0):
        """An actor where the data are: there is no plane to lie above."""
        return actor_of(data, colour)

    def add_frame(self):
        """The edges of the box."""
        source = vtkFiltersSources.vtkOutlineSource()
        source.SetBounds(*self.bounds)
        source.Update()
        self.add(actor_of(source.GetOutput(), (0, 0, 0)))

    def add_objects(self, surfaces, name):
        """Each object as a solid in its colour or those of an array, in light.
        Its parts beyond the box are cut off, as they are shown across the
        seam."""
        actor = self.coloured(self.smooth(surfaces))
        if name:
            self.paint(actor, surfaces, name)
        light = actor.GetProperty()
        light.LightingOn()
        light.SetInterpolationToPhong()
        light.SetAmbient(0.25)
        light.SetDiffuse(0.75)
        light.SetSpecular(0.15)
        self.add_inside(actor)

    def add_walls(self, walls):
        """What reaches out of the box on both sides, so that one sees what it
        encloses."""
        actor = actor_of(self.smooth(walls), (0.5, 0.5, 0.5))
        actor.GetProperty().LightingOn()
        actor.GetProperty().SetOpacity(0.2)
        self.add_inside(actor)

    @staticmethod
    def smooth(surfaces):
        """Triangles with the normals of a smooth surface at their corners."""
        triangles = vtkFiltersCore.vtkTriangleFilter()
        triangles.SetInputData(surfaces)
        normals = vtkFiltersCore.vtkPolyDataNormals()
        normals.SetInputConnection(triangles.GetOutputPort())
        normals.SetFeatureAngle(40)
        normals.ConsistencyOff()
        normals.Update()
        return normals.GetOutput()

    def add_contour(self, plane, name):
        """The zero of a field on the slice, as a tube that light does not
        dim."""
        line = self.zero_of(plane, name)
        tube = vtkFiltersCore.vtkTubeFilter()
        tube.SetInputData(line)
        tube.SetRadius(0.002*self.width)
        tube.Update()
        self.add(actor_of(tube.GetOutput(), (0, 0, 0)))

    def sides(self):
        """All six sides of the box."""
        return range(6)

    def set_camera(self, camera, high):
        right, up, back = self.axes()
        middle = [sum(self.bounds[2*i:2*i + 2])/2 for i in range(3)]
        shift = (0.5*self.side/self.scale,
                 -0.5*(TITLE_HEIGHT - MARGIN)/self.scale)
        centre = [m + shift[0]*r + shift[1]*u
                  for m, r, u in zip(middle, right, up)]
        far = 10*(self.width + self.height)
        camera.SetFocalPoint(*centre)
        camera.SetPosition(*(c + far*b for c, b in zip(centre, back)))
        camera.SetViewUp(*up)
        camera.SetParallelScale(0.5*high/self.scale)
