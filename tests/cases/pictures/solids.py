#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""etc/render draws a case in three dimensions: two spheres as solids, one
behind the other, a slice of the velocity where it was asked for, from the
camera that was asked for.

    solids.py FOLDER
"""

import math
import os
import subprocess
import sys

import fsiCase
from pictures import SIZE, contents, png_size, render

RADIUS = 0.2

SHAPES = f"""sphere {{ shape {{ type sphere; radius {RADIUS}; }}
    material {{ density 1000; E 1e4; }} }}
"""
PLACEMENTS = """a { type listed; shape sphere;
    objects ({ centre (0.5 0.5 0.25); } { centre (0.5 0.5 0.75); }); }
"""

# Pixels that are neither white nor grey nor pale; what is to the right of the
# box, the palette, does not count
COUNT = """
import sys
from PIL import Image
picture = Image.open(sys.argv[1]).convert('RGB')
picture = picture.crop((0, 0, int(sys.argv[2]), picture.height))
print(sum(max(p) - min(p) > 40 for p in picture.getdata()))
"""


def coloured(case, *options):
    """Number of coloured pixels of the box in the picture of the last time."""
    width = png_size(contents(render(
        case, "-times", "0.02", "-slice", "none")[1].strip()))[0]
    status, text = render(case, "-times", "0.02", *options)
    path = text.strip()
    if status != 0 or png_size(contents(path)) == (0, 0):
        raise RuntimeError(text)
    done = subprocess.run(["/usr/bin/python3", "-c", COUNT, path,
                           str(width)],
                          capture_output=True, text=True, check=True)
    return int(done.stdout)


def box(folder):
    """A cube with a moving lid, run for two steps."""
    case = fsiCase.Case(
        os.path.join(folder, "cube"), box=(0, 0, 0, 1, 1, 1),
        cells=(16, 16, 16), density=1000, walls={"top": "(1 0 0)"},
        viscosity=0.1, shapes=SHAPES, placements=PLACEMENTS, endTime=0.02,
        writeInterval=2).set_up()
    case.run("fsiPisoFoam")
    return case.path


def check_objects(report, case):
    """As large as they must be, hidden and apart by the camera."""
    along = coloured(case, "-slice", "none", "-camera", "0,0")
    print(f"    along z: {along}")
    side = coloured(case, "-slice", "none", "-camera", "90,0")
    print(f"    from the side: {side}")
    # The box fills the frame; what is nearer is larger
    expected = math.pi*RADIUS**2*SIZE**2
    report.check("a sphere is as large as it must be",
                 0.5*expected < along < 1.5*expected,
                 f"{along}, {expected}")
    report.check("one hides the other from the front, not from the side",
                 side > 1.4*along, f"{along} {side}")


def check_slice(report, case):
    """The field is shown where it was asked for, or nowhere."""
    none = coloured(case, "-slice", "none")
    below, bottom = (coloured(case, "-range", "0,1", "-slice", f"y,{y}")
                     for y in (0.97, 0.1))
    print(f"    coloured: {none}, with a slice below the lid {below}, at the "
          f"bottom {bottom}")
    report.check("a slice below the lid has its colours",
                 below > none + 0.03*SIZE**2, f"{none} {below}")
    report.check("a slice at the bottom is pale",
                 bottom < none + 0.3*(below - none), f"{none} {bottom}")


def main(folder):
    """The checks."""
    report = fsiCase.Report()
    case = report.attempt("run", box, folder)
    if case is not None:
        report.attempt("objects", check_objects, report, case)
        report.attempt("slice", check_slice, report, case)


if __name__ == "__main__":
    main(sys.argv[1])
