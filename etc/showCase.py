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


def fluid(case, view):
    """The mesh, coloured by the magnitude of U. A parallel run that was not
    reconstructed yet is read in parts."""
    name = os.path.join(case, os.path.basename(os.path.abspath(case))
                        + ".foam")
    with open(name, "a", encoding="ascii"):
        pass
    reader = simple.OpenFOAMReader(FileName=name)
    if latest_time(os.path.join(case, "processor0")) > latest_time(case):
        reader.CaseType = "Decomposed Case"
    reader.UpdatePipeline()
    shown = simple.Show(reader, view)
    if "U" in reader.CellData.keys():
        simple.ColorBy(shown, ("CELLS", "U", "Magnitude"))
        shown.RescaleTransferFunctionToDataRange(True)
        shown.SetScalarBarVisibility(view, True)
    return reader


def objects(case, view, front):
    """The surfaces of all runs of the case, coloured by the object's id, in
    front of the mesh, which ends there. Outlines with hollows are filled right
    only as triangles."""
    for name in sorted(glob.glob(os.path.join(
            case, "postProcessing/fsiObjects/*/surfaces.vtp.series"))):
        reader = simple.OpenDataFile(name)
        reader.UpdatePipeline()
        filled = simple.Show(simple.Triangulate(Input=reader), view)
        filled.Position = [0, 0, front]
        simple.ColorBy(filled, ("CELLS", "object"))
        simple.GetColorTransferFunction("object").ApplyPreset(
            "Rainbow Desaturated", True)
        filled.SetScalarBarVisibility(view, False)
        outline = simple.Show(reader, view)
        outline.Position = [0, 0, 1.01*front]
        outline.SetRepresentationType("Wireframe")
        simple.ColorBy(outline, ("POINTS", ""))
        outline.AmbientColor = outline.DiffuseColor = [0, 0, 0]


def main(case, picture=None, time=None):
    """Shows a case; writes a picture if there is a name for it."""
    view = simple.GetActiveViewOrCreate("RenderView")
    view.InteractionMode = "2D"
    view.OrientationAxesVisibility = 0
    reader = fluid(case, view)
    objects(case, view, reader.GetDataInformation().GetBounds()[5])
    scene = simple.GetAnimationScene()
    scene.UpdateAnimationUsingDataTimeSteps()
    simple.ResetCamera(view)
    if picture:
        times = reader.TimestepValues
        wanted = times[-1] if time is None else float(time)
        scene.AnimationTime = min(times, key=lambda t: abs(t - wanted))
        simple.SaveScreenshot(picture, view, ImageResolution=[1200, 900])
    simple.Render(view)


main(*(sys.argv[1:] or [os.getcwd()]))
