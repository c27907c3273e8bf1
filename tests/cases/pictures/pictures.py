#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""etc/render makes pictures, a strip and animations of a short run, with as
many pictures as were asked for; objects across a seam stand on both sides.
Tables, charts and the log are in charts.py, charts of several cases in
studies.py, colours in colours.py.

    pictures.py FOLDER
"""

import ast
import os
import re
import shutil
import subprocess
import sys

import acrossChannel
import charts
from charts import ETC, contents, png_size
import colours
import fsiCase
import studies

RENDER = os.path.join(ETC, "render")
MEMBRANES = os.path.join(os.path.dirname(os.path.abspath(__file__)),
                         "../../../tutorials/membranes")
# Two times are written
END, TIMES = 0.02, 2
SIZE = 200
SHAPES = ["disc"]


def render(case, *options):
    """Runs etc/render; status and output."""
    done = subprocess.run([RENDER, case, "-size", str(SIZE), *options],
                          capture_output=True, text=True, check=False)
    return done.returncode, done.stdout + done.stderr


def check_pictures(report, case):
    """One PNG per time, and all of them side by side."""
    status, text = render(case)
    names = text.split()
    sizes = [png_size(contents(name)) for name in names]
    report.check("a picture of each time",
                 status == 0 and len(sizes) == TIMES
                 and all(min(size) > 0.9*SIZE for size in sizes), text)
    path = os.path.join(case, "strip.png")
    render(case, "-strip", path)
    width = png_size(contents(path))[0]
    report.check("a strip is as wide as its pictures",
                 width >= TIMES*0.9*SIZE, width)
    sizes = []
    for times in (1, 9):
        render(case, "-strip", path, "-times", ",".join([str(END)]*times))
        sizes.append(png_size(contents(path)))
    report.check("nine pictures stand in three rows",
                 sizes[0][0] > 0 and sizes[1] == tuple(3*n for n in sizes[0]),
                 sizes)
    status, text = render(case, "-times", f"0,{0.9*END:g}")
    names = [os.path.basename(word) for word in text.split()
             if word.endswith(".png")]
    report.check("the seeding, and the nearest of the written times",
                 status == 0 and names == ["U_0.png", f"U_{END}.png"]
                 and f"time {0.9*END:g} was not written" in text, text)
    status, text = render(case, "-strip", "strip.jpg")
    report.check("a strip of another ending is refused",
                 status == 2 and ".png" in text, text)


def check_surface(report, case):
    """The outline of an object has colours from yellow to violet."""
    code = ("import sys; from PIL import Image; "
            "a = Image.open(sys.argv[1]).convert('RGB'); "
            "print(len({r for r, g, b in a.crop((0, 0, a.width//2, a.height))"
            ".getdata() if b < 110 and abs((r - 76)/176 - (g - 13)/206) "
            "< 0.03 and abs((r - 76)/176 - (102 - b)/25) < 0.2}))")
    status, text = render(case, "-surface", "velocity", "-times", f"{END}")
    done = subprocess.run(["/usr/bin/python3", "-c", code, text.strip()],
                          capture_output=True, text=True, check=False)
    report.check("objects in the colours of an array of their surfaces",
                 status == 0 and text.endswith(f"velocity_{END}.png\n")
                 and int(done.stdout or 0) > 10, text + done.stdout
                 + done.stderr)
    status, text = render(case, "-surface", "colour")
    report.check("an array that there is not is refused",
                 status == 1 and "no field colour" in text, text)


def check_shape_names(report, case):
    """VTK reads the names of the shapes from the objects' files."""
    code = (
        "import sys; from vtkmodules import vtkIOXML; "
        "r = vtkIOXML.vtkXMLPolyDataReader(); r.SetFileName(sys.argv[1]); "
        "r.Update(); a = r.GetOutput().GetFieldData().GetAbstractArray("
        "'shapeNames'); "
        "print([a.GetValue(i) for i in range(a.GetNumberOfValues())])")
    for name in ("fsiObjects/0/surfaces_000000.vtp",
                 "fsiObjects/0/springs_000001.vtp", "seedObjects/surfaces.vtp"):
        done = subprocess.run(
            ["/usr/bin/python3", "-c", code,
             os.path.join(case, "postProcessing", name)],
            capture_output=True, text=True, check=False)
        report.check(f"VTK reads the shapes' names in {name}",
                     done.stdout.strip() == str(SHAPES),
                     done.stdout + done.stderr)


def check_animations(report, case):
    """GIF and Ogg Theora hold the times that were asked for."""
    status, text = render(case, "-times", f"{END/2},{END}", "-rate", "4",
                          "-animate", os.path.join(case, "a.gif"))
    gif = contents(case, "a.gif")
    # The mark of a picture and its duration in hundredths of a second
    frames = len(re.findall(rb"\x21\xf9\x04.\x19\x00", gif, re.S))
    report.check("a GIF of two pictures, 4 per second",
                 status == 0 and gif[:6] == b"GIF89a" and frames == 2,
                 f"{frames} pictures, {len(gif)} bytes; {text}")
    status, text = render(case, "-animate", os.path.join(case, "a.ogv"))
    report.check("a film in Ogg Theora",
                 status == 0 and contents(case, "a.ogv")[:4] == b"OggS", text)
    status, text = render(case, "-animate", os.path.join(case, "a.xyz"))
    report.check("another ending is refused",
                 status != 0 and ".gif or .ogv" in text, text)


def check_log(report, log):
    """A line per step, all of one form, then a summary."""
    lines = log.split("\n")
    start = lines.index("Starting time loop")
    end = next(i for i, line in enumerate(lines)
               if line.startswith("Summary of "))
    steps = [line for line in lines[start + 1:end]
             if line.startswith("Time = ")]
    form = re.compile(r"Time = \S+ \(\d+ %, \S+ left\) dt \S+ Co \S+ "
                      r"(U \d+ p \d+ (passes \d+ )?)?contacts \d+ gap \S+ "
                      r"speed \S+ error \S+")
    report.check("the log has a line per step, all with the same entries",
                 len(steps) == int(lines[end].split()[2])
                 and all(form.fullmatch(line) for line in steps),
                 "\n".join(lines[start:end])[:600])
    report.check("its summary counts the warnings and tells where time went",
                 any(line.split() == ["warnings", "none"] for line in lines)
                 and "Wall-clock time" in log, "\n".join(lines[end:]))


def pixels(path, places):
    """Colours of a picture, by the Python that etc/render runs on."""
    code = ("import sys; from PIL import Image; "
            "print([Image.open(sys.argv[1]).convert('RGB').getpixel(p) "
            f"for p in {places}])")
    done = subprocess.run(["/usr/bin/python3", "-c", code, path],
                          capture_output=True, text=True, check=True)
    return ast.literal_eval(done.stdout)


def shear_box(case):
    """Two membranes, of which one lies across the seam, at two ranks."""
    fsiCase.copy(MEMBRANES, case)
    fsiCase.set_entry(os.path.join(case, "system/controlDict"),
                      "endTime", 0.02)
    fsiCase.set_entry(os.path.join(case, "system/controlDict"),
                      "writeInterval", 0.02)
    name = os.path.join(case, "system/seedObjectsDict")
    with open(name, encoding="ascii") as stream:
        text = stream.read()
    with open(name, "w", encoding="ascii") as stream:
        stream.write(text.replace("(0.5 0.5 0)", "(0.02 0.5 0)"))
    fsiCase.run(case, "blockMesh")
    fsiCase.run(case, "seedObjects")
    shutil.copy(os.path.join(MEMBRANES,
                             "../redCells/system/decomposeParDict"),
                os.path.join(case, "system"))
    fsiCase.run(case, "decomposePar")
    return fsiCase.run(case, "fsiPisoFoam", ranks=2)


def check_parallel(report, case):
    """The parts of two ranks look like the whole."""
    parts = contents(render(case, "-times", "0.02")[1].strip())
    fsiCase.run(case, "reconstructPar")
    whole = contents(render(case, "-times", "0.02")[1].strip())
    report.check("two ranks' fields as those put together",
                 parts == whole != b"", f"{len(parts)}, {len(whole)} bytes")


def check_seam(report, case):
    """What leaves the frame of a periodic mesh comes in on the other side."""
    # 2 m are SIZE pixels, in a frame ten pixels from the left, right and top;
    # the cell reaches from -0.12 to 0.16 m
    text = render(case, "-times", "0.02", "-field", "none")[1]
    columns = (4, 10 + SIZE//40, 10 + SIZE//2, 10 + SIZE - SIZE//40, 15 + SIZE)
    across = pixels(text.strip(), [(x, 10 + SIZE//4) for x in columns])
    white = (255, 255, 255)
    report.check("a cell across a seam is on both sides, and in the frame",
                 across[1] == across[3] != white
                 and across[0] == across[2] == across[4] == white, across)


def main(folder):
    """The checks."""
    report = fsiCase.Report()
    case = fsiCase.tutorial("01-twoDiscs", os.path.join(folder, "case"),
                            endTime=END, writeInterval=END/2)
    check_log(report, fsiCase.run(case, "fsiPisoFoam"))
    check_pictures(report, case)
    check_shape_names(report, case)
    check_animations(report, case)
    charts.check_plots(report, case)
    charts.check_rheology(report, case, os.path.join(folder, "rheology"))
    charts.check_objects(report, os.path.join(folder, "objects"))
    charts.check_monitor(report, case, os.path.join(folder, "stub"))
    charts.check_tables(report, os.path.join(folder, "tables"))

    studies.check_studies(report, os.path.join(folder, "studies"))

    colours.check_colours(report, folder, render, SIZE)
    acrossChannel.check_profiles(report, folder)

    case = os.path.join(folder, "box")
    check_log(report, shear_box(case))
    charts.check_foam_log(report, case)
    check_surface(report, case)
    check_parallel(report, case)
    check_seam(report, case)


if __name__ == "__main__":
    main(sys.argv[1])
