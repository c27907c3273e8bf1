# SPDX-License-Identifier: GPL-3.0-or-later
"""Checks of the colours of etc/render: of shapes with their legend, and the
numbers beside the bar of a field's colours."""

import os
import subprocess

import fsiCase
from charts import contents, png_size

# Prints the colours that have so many pixels of a picture, between columns
COLOURS = """
import sys
from PIL import Image
picture = Image.open(sys.argv[1]).convert('RGB')
left, right = (int(n) % (picture.width + 1) for n in sys.argv[2:4])
part = picture.crop((left, 0, right, picture.height))
print(*sorted('%d,%d,%d' % colour for n, colour in part.getcolors(1000000)
              if n >= int(sys.argv[4])))
"""
GREY, FIRST, WHITE = "165,165,165", "227,120,41", "255,255,255"


def colours(path, left, right, least=50):
    """Colours between columns of a picture, with at least so many pixels."""
    done = subprocess.run(
        ["/usr/bin/python3", "-c", COLOURS, path,
         *map(str, (left, right, least))],
        capture_output=True, text=True, check=False)
    return set(done.stdout.split())


def posts(folder):
    """Two posts that stand and a disc that falls; the seeding has their shapes
    in another order than the run."""
    case = fsiCase.Case(
        os.path.join(folder, "posts"), box=(0, 0, 2, 1), cells=(32, 16),
        density=1000, viscosity=1/30, deltaT=0.02, endTime=0.04,
        writeInterval=2,
        shapes="post { shape { type circle; radius 0.2; } material { type "
               "rigid; density 1000; } motion { type fixed; } } "
               "disc { shape { type circle; radius 0.2; } "
               "material { type rigid; density 1000; } }",
        placements="a { type listed; shape post; objects "
                   "({ centre (0.4 0.5 0); } { centre (1.6 0.5 0); }); } "
                   "b { type listed; shape disc; objects "
                   "({ centre (1 0.5 0); velocity (0 -0.1 0); }); }").set_up()
    case.run("fsiPisoFoam")
    return case.path


def check_shapes(report, case, render, size):
    """A colour for the disc, grey for the posts, at both times alike; names to
    the right of the frame."""
    for time in ("0", "0.04"):
        status, text = render(case, "-times", time, "-field", "none",
                              "-colour", "shape")
        path = text.strip()
        posts_at, disc_at, legend = (
            colours(path, *ends) & {GREY, FIRST} for ends in (
                (0, size//3), (size//3, 2*size//3), (size + 25, -1)))
        report.check(f"colours by shapes at {time} s, what stands is grey",
                     status == 0 and posts_at == {GREY} and disc_at == {FIRST},
                     (text, posts_at, disc_at))
        report.check(f"a legend of them at {time} s", legend == {GREY, FIRST},
                     (text, legend))
    status, text = render(case, "-colour", "size")
    report.check("another way to colour is refused, with those there are",
                 status == 2 and "'object', 'shape'" in text, text)


def check_bar(report, case, render):
    """Long numbers are not cut off at the right edge."""
    widths = []
    for ends in ("0,1", "-1.23e-120,9.87e+120"):
        text = render(case, "-times", "0.04", f"-range={ends}")[1]
        path = text.strip()
        widths.append(png_size(contents(path))[0])
        report.check(f"numbers of the bar of {ends} are whole",
                     colours(path, -4, -1, 1) == {WHITE}, text)
    report.check("a bar with long numbers is wider",
                 0 < widths[0] < widths[1], widths)


def check_colours(report, folder, render, size):
    """All of them."""
    case = report.attempt("posts", posts, folder)
    if case is not None:
        check_shapes(report, case, render, size)
        check_bar(report, case, render)
