# SPDX-License-Identifier: GPL-3.0-or-later
"""Opens a case in ParaView with everything in view: the fluid's speed, the
objects on it, all written times.

    cd CASE; paraview --script=.../etc/showCase.py
    pvpython etc/showCase.py CASE PICTURE.png [TIME]

The last line makes a picture of the written time nearest to TIME, or the last.
"""

import glob
import os
import sys

from paraview import simple


USAGE = "showCase.py [CASE [PICTURE.png [TIME]]]"


def latest_time(folder):
    """The largest name of a time folder, -1 without one. (ParaView's reader
    knows the times of one kind of case only.)"""
    latest = -1.0
    for path in glob.glob(os.path.join(folder, "[0-9]*")):
        try:
            latest = max(latest, float(os.path.basename(path)))
        except ValueError:
            pass
    return latest


def open_fluid(case):
    """The mesh with its fields. A parallel run that was not reconstructed yet
    is read in parts."""
    if not os.path.isdir(os.path.join(case, "system")):
        sys.exit(f"showCase.py: {case} is not the folder of a case. {USAGE}")
    name = os.path.join(case, os.path.basename(os.path.abspath(case))
                        + ".foam")
    with open(name, "a", encoding="ascii"):
        pass
    reader = simple.OpenFOAMReader(FileName=name)
    if latest_time(os.path.join(case, "processor0")) > latest_time(case):
        reader.CaseType = "Decomposed Case"
    reader.UpdatePipeline()
    return reader


def open_objects(case):
    """The surfaces of all runs of the case; before the first one as they
    were seeded."""
    folder = os.path.join(case, "postProcessing")
    names = (glob.glob(os.path.join(folder, "fsiObjects/*/surfaces.vtp.series"))
             or glob.glob(os.path.join(folder, "seedObjects/surfaces.vtp")))
    readers = [simple.OpenDataFile(name) for name in sorted(names)]
    for reader in readers:
        reader.UpdatePipeline()
    return readers


def is_flat(surfaces):
    """Do the objects lie in a plane normal to z?"""
    boxes = [reader.GetDataInformation().GetBounds() for reader in surfaces]
    return all(box[5] - box[4] < 1e-6*(box[1] - box[0]) for box in boxes)


def show_fluid(reader, view, flat):
    """The mesh, coloured by the magnitude of U; in three dimensions a slice
    half way through it and its edges."""
    shown = reader
    if not flat:
        simple.Show(simple.Outline(Input=reader), view)
        shown = simple.Slice(Input=reader)
        shown.SliceType.Normal = [0, 0, 1]
    display = simple.Show(shown, view)
    if "U" in reader.CellData.keys():
        simple.ColorBy(display, ("CELLS", "U", "Magnitude"))
        display.RescaleTransferFunctionToDataRange(True)
        display.SetScalarBarVisibility(view, True)


def show_objects(reader, view, front):
    """Surfaces coloured by the object's id. In the plane they lie in front of
    the mesh, which ends there, with their outlines; outlines with hollows are
    filled right only as triangles. front: None in three dimensions."""
    filled = simple.Show(simple.Triangulate(Input=reader), view)
    simple.ColorBy(filled, ("CELLS", "object"))
    simple.GetColorTransferFunction("object").ApplyPreset(
        "Rainbow Desaturated", True)
    filled.SetScalarBarVisibility(view, False)
    if front is None:
        return
    filled.Position = [0, 0, front]
    outline = simple.Show(reader, view)
    outline.Position = [0, 0, 1.01*front]
    outline.SetRepresentationType("Wireframe")
    simple.ColorBy(outline, ("POINTS", ""))
    outline.AmbientColor = outline.DiffuseColor = [0, 0, 0]


def main(case, picture=None, time=None):
    """Shows a case; writes a picture if there is a name for it."""
    view = simple.GetActiveViewOrCreate("RenderView")
    view.OrientationAxesVisibility = 0
    reader, surfaces = open_fluid(case), open_objects(case)
    flat = is_flat(surfaces)
    view.InteractionMode = "2D" if flat else "3D"
    show_fluid(reader, view, flat)
    front = reader.GetDataInformation().GetBounds()[5] if flat else None
    for surface in surfaces:
        show_objects(surface, view, front)
    scene = simple.GetAnimationScene()
    scene.UpdateAnimationUsingDataTimeSteps()
    simple.ResetCamera(view)
    if not flat:
        view.GetActiveCamera().Azimuth(25)
        view.GetActiveCamera().Elevation(20)
    if picture:
        times = list(reader.TimestepValues) or [0.0]
        wanted = times[-1] if time is None else float(time)
        scene.AnimationTime = min(times, key=lambda t: abs(t - wanted))
        simple.SaveScreenshot(picture, view, ImageResolution=[1200, 900])
    simple.Render(view)


if len(sys.argv) > 4:
    sys.exit("showCase.py: too many arguments. " + USAGE)
main(*(sys.argv[1:] or [os.getcwd()]))
