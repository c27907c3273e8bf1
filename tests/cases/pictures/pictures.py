#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""etc/render makes pictures, a strip and animations of a short run, with as
many pictures as were asked for; objects across a seam stand on both sides.
etc/plot draws the tables of all runs of a case, and any column; etc/monitor
hands columns to foamMonitor.

    pictures.py FOLDER
"""

import ast
import os
import re
import shutil
import struct
import subprocess
import sys

import fsiCase

ETC = os.path.join(os.path.dirname(os.path.abspath(__file__)),
                   "../../../etc")
RENDER = os.path.join(ETC, "render")
MEMBRANES = os.path.join(os.path.dirname(os.path.abspath(__file__)),
                         "../../../tutorials/membranes")
# Two times are written
END, TIMES = 0.02, 2
SIZE = 200


def render(case, *options):
    """Runs etc/render; status and output."""
    done = subprocess.run([RENDER, case, "-size", str(SIZE), *options],
                          capture_output=True, text=True, check=False)
    return done.returncode, done.stdout + done.stderr


def contents(*path):
    """The bytes of a file, none if it is not there."""
    try:
        with open(os.path.join(*path), "rb") as stream:
            return stream.read()
    except FileNotFoundError:
        return b""


def png_size(data):
    """Width and height of a PNG."""
    if data[:8] != b"\x89PNG\r\n\x1a\n":
        return (0, 0)
    return struct.unpack(">II", data[16:24])


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


def plot(case, *options):
    """Runs etc/plot; status, names of pictures without folders, output."""
    done = subprocess.run([os.path.join(ETC, "plot"), case, *options],
                          capture_output=True, text=True, check=False)
    pictures = done.stdout.split()
    sound = all(min(png_size(contents(p))) > 300 for p in pictures)
    return (done.returncode if sound else "not a picture",
            [os.path.basename(p) for p in pictures],
            done.stdout + done.stderr)


def check_plots(report, case):
    """Charts of the tables."""
    status, names, text = plot(case)
    report.check("a chart of each kind that the run has",
                 status == 0 and {"energies.png", "speeds.png",
                                  "timeStep.png", "whereTheTimeGoes.png"}
                 <= set(names), text)
    status, names, text = plot(case, "-page", os.path.join(case, "p.png"))
    report.check("all on one page", (status, names) == (0, ["p.png"]), text)
    status, names, text = plot(case, "-column", "D,velocity,contacts,maxSpeed")
    report.check("columns of objects.csv and global.csv",
                 status == 0 and names == ["deformation.png", "velocity.png",
                                           "contacts.png", "maxSpeed.png"],
                 text)
    status, names, text = plot(case, "-column", "colour")
    report.check("a column that there is not is refused, with those there are",
                 status == 1 and "colour" in text and "forceX" in text
                 and "elasticEnergy" in text, text)
    status, names, text = plot(os.path.dirname(case))
    report.check("a folder without tables is refused",
                 status == 1 and "global.csv" in text, text)


def check_monitor(report, case, folder):
    """etc/monitor with a gnuplot that keeps what it is to draw."""
    os.makedirs(folder)
    stub = os.path.join(folder, "gnuplot")
    with open(stub, "w", encoding="ascii") as stream:
        stream.write("#!/bin/sh\ncat $1\nexec cat $(sed -n "
                     "'s/^\"\\(.*\\)\" using 1:2 .*/\\1/p' $1)\n")
    os.chmod(stub, 0o755)

    # foamMonitor kills gnuplot after that many ticks of the clock's seconds:
    # with one the first tick may come before gnuplot has begun
    def monitor(*options):
        return subprocess.run(
            [os.path.join(ETC, "monitor"), *options, case, "-refresh", "1",
             "-idle", "3"], capture_output=True, text=True, check=False,
            env={**os.environ, "PATH": folder + ":" + os.environ["PATH"]})

    text = monitor().stdout
    report.check("etc/monitor gives foamMonitor the columns of global.csv",
                 'using 1:2 with lines title "smallestGap"' in text
                 and re.search(r"^# time smallestGap maxSpeed timeError\n"
                               r"(\S+ \S+ \S+ \S+ \n)+", text, re.M), text)
    done = monitor("-columns", "colour")
    report.check("etc/monitor refuses other columns",
                 done.returncode == 1 and "colour" in done.stderr
                 and "maxSpeed" in done.stderr, done.stderr)


def check_tables(report, folder):
    """The lines of two runs that share some time, the last one broken off."""
    for start, lines in (("0", "0.1,1\n0.2,2\n0.3,3\n"),
                         ("0.2", "0.3,30\n0.4,inf\n0.5")):
        path = os.path.join(folder, "postProcessing/fsiObjects", start)
        os.makedirs(path)
        with open(os.path.join(path, "global.csv"), "w",
                  encoding="ascii") as stream:
            stream.write("time,gap\n" + lines)
    sys.path.insert(0, os.path.join(ETC, "pictures"))
    import tables  # of this project's folder, known now
    found = [(r["time"], r["gap"]) for r in tables.rows(folder, "global.csv")]
    report.check("where two runs share a time the later one counts",
                 found == [(0.1, 1), (0.2, 2), (0.3, 30),
                           (0.4, float("inf"))], found)


def check_log(report, log):
    """A line per step that fits, then a summary."""
    lines = log.split("\n")
    start = lines.index("Starting time loop")
    end = next(i for i, line in enumerate(lines)
               if line.startswith("Summary of "))
    steps = [line for line in lines[start + 1:end] if line]
    report.check("the log has a line per step, within 120 columns",
                 len(steps) == int(lines[end].split()[2])
                 and all(line.startswith("Time = ") and len(line) <= 120
                         and " left)" in line for line in steps),
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
    fsiCase.run(case, "fsiPisoFoam", ranks=2)


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
    check_animations(report, case)
    check_plots(report, case)
    check_monitor(report, case, os.path.join(folder, "stub"))
    check_tables(report, os.path.join(folder, "tables"))

    case = os.path.join(folder, "box")
    shear_box(case)
    check_parallel(report, case)
    check_seam(report, case)


if __name__ == "__main__":
    main(sys.argv[1])
