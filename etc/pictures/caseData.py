# SPDX-License-Identifier: GPL-3.0-or-later
"""What etc/render reads of a case: VTK series of the objects, and the mesh."""

import glob
import json
import os

from vtkmodules import vtkCommonDataModel, vtkFiltersCore
from vtkmodules import vtkIOParallel, vtkIOXML
from vtkmodules.vtkParallelCore import vtkDummyController


def nearest(times, time):
    """The entry of a sorted list nearest to time; 0 if it is empty."""
    return min(times, key=lambda t: abs(t - time), default=0.0)


class Series:
    """A VTK series of polygons or lines; a restart continues an earlier one."""

    def __init__(self, case, name):
        self.files = {}
        folders = glob.glob(os.path.join(case, "postProcessing/fsiObjects/*/"))
        for folder in sorted(folders, key=os.path.getmtime):
            path = os.path.join(folder, name + ".vtp.series")
            if os.path.exists(path):
                with open(path, encoding="utf-8") as file:
                    entries = json.load(file)["files"]
                for entry in entries:
                    path = os.path.join(folder, entry["name"])
                    self.files[float(entry["time"])] = path
        self.times = sorted(self.files)

    def read(self, time):
        reader = vtkIOXML.vtkXMLPolyDataReader()
        reader.SetFileName(self.files[nearest(self.times, time)])
        reader.Update()
        return reader.GetOutput()


class Fluid:
    """The mesh and fields of a case, reconstructed or in processor folders."""

    def __init__(self, case):
        self.times, self.reader = [], None
        meshes = ("constant/polyMesh", "processor0/constant/polyMesh")
        found = [m for m in meshes if os.path.isdir(os.path.join(case, m))]
        if not found:
            return
        self.reader = vtkIOParallel.vtkPOpenFOAMReader()
        self.controller = vtkDummyController()  # it fails without one
        self.reader.SetController(self.controller)
        self.reader.SetFileName(os.path.join(case, "system/controlDict"))
        self.reader.SetCaseType(0 if found[0].startswith("p") else 1)
        self.reader.SkipZeroTimeOff()
        self.reader.UpdateInformation()
        self.reader.DisableAllPatchArrays()
        self.reader.SetPatchArrayStatus("internalMesh", 1)
        self.reader.EnableAllCellArrays()
        self.reader.CreateCellToPointOff()
        values = self.reader.GetTimeValues()
        count = values.GetNumberOfTuples() if values else 0
        self.times = [values.GetValue(i) for i in range(count)]

    def read(self, time):
        """The plane half way through the mesh, with the fields on points."""
        self.reader.UpdateTimeStep(nearest(self.times, time))
        mesh = self.reader.GetOutput().GetBlock(0)

        plane = vtkCommonDataModel.vtkPlane()
        plane.SetOrigin(mesh.GetCenter())
        plane.SetNormal(0, 0, 1)
        cutter = vtkFiltersCore.vtkCutter()
        cutter.SetCutFunction(plane)
        cutter.SetInputData(mesh)

        # The ranks' parts become one before values go from cells to points
        merge = vtkFiltersCore.vtkCleanPolyData()
        merge.SetInputConnection(cutter.GetOutputPort())
        points = vtkFiltersCore.vtkCellDataToPointData()
        points.SetInputConnection(merge.GetOutputPort())
        points.Update()
        return points.GetOutput()
