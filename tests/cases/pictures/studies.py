# SPDX-License-Identifier: GPL-3.0-or-later
"""Checks of etc/plot -column with several cases, chosen shapes, and places on
objects."""

import csv
import json
import os
import subprocess

from charts import ETC, plot

# Prints labels, colours and values of the curves of each chart, for the
# arguments of etc/plot
CURVES = """
import importlib.machinery, json, sys
plot = importlib.machinery.SourceFileLoader("plot", sys.argv[1]).load_module()
sys.argv = sys.argv[1:]
print(json.dumps({
    name: [[line.get_label(), line.get_color(), list(line.get_xdata()),
            list(line.get_ydata())] for line in axes.lines]
    for name, draw in plot.column_charts(plot.arguments()).items()
    for axes in [plot.pyplot.subplots()[1]] if draw(axes) is None}))
"""
TIMES = (1, 2, 3)
# Shapes of objects
SHAPES = ("bead", "bead", "bead", "post", "cell")


def write(folder, name, header, lines):
    """A table of a run."""
    path = os.path.join(folder, "postProcessing/fsiObjects/0")
    os.makedirs(path, exist_ok=True)
    with open(os.path.join(path, name), "w", encoding="ascii") as stream:
        stream.write(header + "\n" + "".join(
            ",".join(str(v) for v in line) + "\n" for line in lines))
    return folder


def case_of(folder, speed, followed=1):
    """Object i starts at (i, 10 i) and moves by (speed, 2 speed) in a second,
    a post stands; two places on so many objects, 100 i and one more above."""
    write(folder, "global.csv", "time,maxSpeed",
          [(t, speed*t) for t in TIMES])
    write(folder, "objects.csv",
          "time,object,shape,velocityY,unwrappedX,unwrappedY",
          [(t, i, shape, speed, i + u*(t - 1), 10*i + 2*u*(t - 1))
           for t in TIMES for i, shape in enumerate(SHAPES)
           for u in [0 if shape == "post" else speed]])
    return write(folder, "followed.csv",
                 "time,object,shape,place,positionY,velocityY",
                 [(t, i, "cell", place, 100*i + at + t, 7)
                  for t in TIMES for i in range(followed)
                  for at, place in enumerate(("root", "2"))])


def curves(*arguments):
    """The curves of the charts, or what etc/plot says."""
    done = subprocess.run(
        ["/usr/bin/python3", "-c", CURVES, os.path.join(ETC, "plot"),
         *arguments], capture_output=True, text=True, check=False)
    return json.loads(done.stdout or json.dumps({"error": done.stderr}))


def values(found, name):
    """Values by labels in a chart."""
    return {line[0]: line[3] for line in found.get(name, [])}


def check_cases(report, folder, cases):
    """A colour and a label for each case, whose name is in the table too."""
    found = curves(*cases, "-column", "unwrappedY,maxSpeed", "-shapes", "bead")
    report.check("a median of each case",
                 values(found, "unwrappedY") == {"slow": [10, 12, 14],
                                                 "fast": [10, 30, 50]}
                 and values(found, "maxSpeed") == {"slow": [1, 2, 3],
                                                   "fast": [10, 20, 30]},
                 found)
    found = curves(*cases, "-column", "unwrappedY", "-objects", "0,4")
    lines = found.get("unwrappedY", [])
    report.check("objects of each case, in the colour of the case",
                 [line[0] for line in lines]
                 == ["slow 0", "slow 4", "fast 0", "fast 4"]
                 and lines[0][1] == lines[1][1] != lines[2][1] == lines[3][1]
                 and lines[3][3] == [40, 60, 80], found)
    status, names, text = plot(cases[0], cases[1], "-column",
                               "unwrappedY,msd", "-output", folder)
    rows = []
    if status == 0:
        with open(os.path.join(folder, "unwrappedY.csv"),
                  encoding="ascii") as stream:
            rows = list(csv.DictReader(stream))
    report.check("the table has the names of the cases",
                 names == ["unwrappedY.png", "msd.png"]
                 and [row["case"] for row in rows] == ["slow"]*5 + ["fast"]*5
                 and rows[9]["largest"] == "80", text)
    status, _, text = plot(*cases)
    report.check("several cases without a column are refused",
                 status == 1 and "several cases go with -column" in text, text)


def check_shapes(report, case):
    """Tracks in the colours of the shapes that are chosen, from one place."""
    found = curves(case, "-column", "unwrappedY", "-x", "unwrappedX",
                   "-shapes", "bead,cell", "-fromStart")
    lines = found.get("unwrappedY", [])
    colours = [line[1] for line in lines]
    report.check("tracks of chosen shapes from one origin, a label for each",
                 all(line[2:] == [[0, 1, 2], [0, 2, 4]] for line in lines)
                 and [line[0] for line in lines if line[0][0] != "_"]
                 == ["bead", "cell"]
                 and colours == [colours[0]]*3 + [colours[-1]]
                 and colours[0] != colours[-1], found)
    status, _, text = plot(case, "-column", "unwrappedY", "-shapes", "disc")
    report.check("another shape is refused, with those there are",
                 status == 1 and "no shape disc, but bead cell post" in text,
                 text)
    for option in ("-fromStart", "-shapes=bead", "-x=time", "-places=tip"):
        status, _, text = plot(case, option)
        report.check(f"{option} without a column is refused",
                     status == 1 and "goes with -column" in text, text)


def check_places(report, folder, case):
    """Columns of followed.csv: a curve for each object and place."""
    found = curves(case, "-column", "positionY,velocityY")
    report.check("a curve for each object and place",
                 values(found, "positionY") == {"0 root": [1, 2, 3],
                                                "0 2": [2, 3, 4]}
                 and values(found, "velocityY").get("4") == [1, 1, 1], found)
    found = curves(case, "-column", "velocityY", "-places", "2")
    report.check("a column that objects have too, of a chosen place",
                 values(found, "velocityY") == {"0 2": [7, 7, 7]}, found)
    status, _, text = plot(case, "-column", "positionY", "-places", "tip")
    report.check("another place is refused, with those there are",
                 status == 1 and "no place tip, but 2 root" in text, text)
    many = case_of(os.path.join(folder, "many"), 1, followed=7)
    found = curves(many, "-column", "positionY")
    medians = {label: v for label, v in values(found, "positionY").items()
               if label[0] != "_"}
    report.check("a median of many for each shape and place",
                 medians == {"median of cell root": [301, 302, 303],
                             "median of cell 2": [302, 303, 304]}, found)
    status, names, text = plot(many, "-column", "positionY")
    report.check("a picture of places", (status, names)
                 == (0, ["positionY.png"]), text)


def check_studies(report, folder):
    """All of them."""
    cases = [case_of(os.path.join(folder, name), speed)
             for name, speed in (("slow", 1), ("fast", 10))]
    check_cases(report, folder, cases)
    check_shapes(report, cases[0])
    check_places(report, folder, cases[0])
