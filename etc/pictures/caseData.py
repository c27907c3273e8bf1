# SPDX-License-Identifier: GPL-3.0-or-later
"""What etc/render reads of a case: VTK series of the objects, and the mesh."""

import functools
import glob
import gzip
import json
import os
import re
import shutil
import subprocess

from vtkmodules import vtkCommonDataModel, vtkFiltersCore
from vtkmodules import vtkIOParallel, vtkIOXML
from vtkmodules.vtkParallelCore import vtkDummyController


def nearest(times, time):
    """The entry of a sorted list nearest to time; 0 if it is empty."""
    return min(times, key=lambda t: abs(t - time), default=0.0)


def times_of(reader):
    """The times that a reader of a case knows."""
    values = reader.GetTimeValues()
    count = values.GetNumberOfTuples() if values else 0
    return [values.GetValue(i) for i in range(count)]


def files_of(case, time, field):
    """The files of a field at a time, of the whole case or of its ranks."""
    found = []
    for path in (glob.glob(os.path.join(case, "*", field + "*"))
                 + glob.glob(os.path.join(case, "processor*", "*",
                                          field + "*"))):
        folder, name = os.path.split(path)
        try:
            same = float(os.path.basename(folder)) == time
        except ValueError:
            continue
        if same and name in (field, field + ".gz"):
            found.append(path)
    return found


@functools.lru_cache(maxsize=None)
def boundary_of(path):
    """The text of a field's file from its boundary values on."""
    opened = gzip.open if path.endswith(".gz") else open
    with opened(path, "rt", encoding="latin-1") as stream:
        text = stream.read()
    return text[text.rfind("boundaryField"):]


def wall_velocity(case, time, patch):
    """Velocity along x of a wall, from the fields that a run has written."""
    for path in files_of(case, time, "U"):
        entries = re.search(
            r"\n\s*" + re.escape(patch) + r"\s*\{(.*?)\n    \}",
            boundary_of(path), re.S)
        values = re.search(r"\bvalue\s+(.*?)\(\s*([^\s)]*)",
                           entries.group(1) if entries else "", re.S)
        if not values:
            if entries and re.search(r"type\s+noSlip\s*;", entries.group(1)):
                return 0.0
            continue
        if "nonuniform" not in values.group(1):
            return float(values.group(2))
        if not re.search(r"List<vector>\s*0\s*$", values.group(1)):
            raise OSError(f"the velocity of wall {patch} is not the same "
                          "everywhere")
    raise OSError(f"no velocity of wall {patch} in field U at {time}")


def entry(case, name, key):
    """The value of an entry of a dictionary, as text; None if there is none.
    OpenFOAM reads it where the file has variables or includes files."""
    path = os.path.join(case, name)
    if not os.path.exists(path):
        return None
    with open(path, encoding="utf-8") as stream:
        text = re.sub(r"/\*.*?\*/|//[^\n]*", "", stream.read(), flags=re.S)
    if not re.search(r"[$#]", text):
        found = re.search(r"(?:^|[;}\s])" + key + r"\s+([^;{}]*);", text)
        return found.group(1).strip() if found else None
    if not shutil.which("foamDictionary"):
        raise OSError(f"{path} has variables, which OpenFOAM reads: source its "
                      "environment")
    read = subprocess.run(
        ["foamDictionary", "-entry", key, "-value", name], cwd=case,
        capture_output=True, encoding="utf-8", check=False)
    return read.stdout.strip() if read.returncode == 0 else None


class Series:
    """A VTK series of polygons or lines; a restart continues an earlier one.
    times: those that runs wrote, else the time of seeding; files: of all."""

    def __init__(self, case, name):
        self.files = {}
        self.seeded = {}
        path = os.path.join(case, "postProcessing/seedObjects", name + ".vtp")
        if os.path.exists(path):
            self.seeded[self.time_of(path)] = path
        folders = glob.glob(os.path.join(case, "postProcessing/fsiObjects/*/"))
        for folder in sorted(folders, key=os.path.getmtime):
            path = os.path.join(folder, name + ".vtp.series")
            if os.path.exists(path):
                with open(path, encoding="utf-8") as file:
                    entries = json.load(file)["files"]
                for entry in entries:
                    path = os.path.join(folder, entry["name"])
                    self.files[float(entry["time"])] = path
        self.times = sorted(self.files or self.seeded)
        self.files = {**self.seeded, **self.files}

    @staticmethod
    def polygons(path):
        """The content of a file."""
        reader = vtkIOXML.vtkXMLPolyDataReader()
        reader.SetFileName(path)
        reader.Update()
        return reader.GetOutput()

    def time_of(self, path):
        """The time that is in a file."""
        data = self.polygons(path).GetFieldData().GetArray("TimeValue")
        return data.GetValue(0) if data else 0.0

    def read(self, time):
        """The polygons or lines of the time nearest to this one."""
        return self.polygons(self.files[nearest(self.files, time)])


class Fluid:
    """The mesh and fields of a case, reconstructed or in processor folders."""

    def __init__(self, case):
        self.times, self.reader, self.case = [], None, case
        self.controller = vtkDummyController()  # readers fail without one
        self.has_mesh, rank_has_mesh = (
            os.path.isdir(os.path.join(case, folder, "constant/polyMesh"))
            for folder in ("", "processor0")
        )
        readers = [
            self.open("internalMesh", in_parts)
            for in_parts, there in ((False, self.has_mesh),
                                    (True, rank_has_mesh)) if there
        ]
        if not readers:
            return
        # A parallel run that was not reconstructed yet is read in parts
        self.reader = max(readers, key=lambda reader: times_of(reader)[-1:])
        self.reader.EnableAllCellArrays()
        self.reader.CreateCellToPointOff()
        self.times = times_of(self.reader)

    def open(self, part, in_parts):
        """A reader for a part of the mesh or a group of patches, of the whole
        case or of the ranks' parts."""
        reader = vtkIOParallel.vtkPOpenFOAMReader()
        reader.SetController(self.controller)
        reader.SetFileName(os.path.join(self.case, "system/controlDict"))
        reader.SetCaseType(0 if in_parts else 1)
        reader.SkipZeroTimeOff()
        reader.UpdateInformation()
        reader.DisableAllPatchArrays()
        reader.SetPatchArrayStatus(part, 1)
        return reader

    def patches(self, kind):
        """Names and faces of the patches of a type."""
        if not self.reader:
            return []
        reader = self.open("group/" + kind, not self.has_mesh)
        reader.DisableAllCellArrays()
        reader.Update()
        found = []
        blocks = reader.GetOutput().NewIterator()
        while not blocks.IsDoneWithTraversal():
            found.append((
                blocks.GetCurrentMetaData().Get(
                    vtkCommonDataModel.vtkCompositeDataSet.NAME()),
                blocks.GetCurrentDataObject()))
            blocks.GoToNextItem()
        return found

    def flat(self):
        """Is there no mesh, or one that is one cell thick in z?"""
        return not self.reader or bool(self.patches("empty"))

    def periods(self, bounds):
        """Length of the mesh in each direction, 0 where no cyclic patches join
        it."""
        periods = [0, 0, 0]
        for _, faces in self.patches("cyclic"):
            box = faces.GetBounds()
            for i in range(3):
                length = bounds[2*i + 1] - bounds[2*i]
                if abs(box[2*i + 1] - box[2*i]) < 1e-5*length:
                    periods[i] = length
        return periods

    def walls(self, axis, bounds):
        """Names of the walls at the lower and at the upper end of an axis."""
        low, high = bounds[2*axis:2*axis + 2]

        def reaches(faces, end):
            boxes = (faces.GetCell(i).GetBounds()
                     for i in range(faces.GetNumberOfCells()))
            return any(max(abs(v - end) for v in box[2*axis:2*axis + 2])
                       < 1e-5*(high - low) for box in boxes)

        walls = self.patches("wall")
        return [[name for name, faces in walls if reaches(faces, end)]
                for end in (low, high)]

    def bounds(self, time):
        """The box of the mesh."""
        self.reader.UpdateTimeStep(nearest(self.times, time))
        return self.reader.GetOutput().GetBlock(0).GetBounds()

    def read(self, time, axis=2, place=None):
        """A plane with the fields on points: normal to an axis, at a place or
        half way through the mesh."""
        self.reader.UpdateTimeStep(nearest(self.times, time))
        mesh = self.reader.GetOutput().GetBlock(0)

        origin, normal = list(mesh.GetCenter()), [0, 0, 0]
        normal[axis] = 1
        if place is not None:
            origin[axis] = place
        plane = vtkCommonDataModel.vtkPlane()
        plane.SetOrigin(*origin)
        plane.SetNormal(*normal)
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
