# SPDX-License-Identifier: GPL-3.0-or-later
"""Checks of what draws and reads the tables and the log of a case: etc/plot,
etc/monitor with a gnuplot that keeps what it is to draw, foamLog."""

import csv
import json
import os
import re
import shutil
import struct
import subprocess
import sys

ETC = os.path.join(os.path.dirname(os.path.abspath(__file__)),
                   "../../../etc")

# Prints the lines of a chart by their labels
MEDIANS = """
import json, sys
import matplotlib
matplotlib.use("Agg")
from matplotlib import pyplot
sys.path.insert(0, sys.argv[1])
import objectCharts, tables
axes = pyplot.subplots()[1]
objectCharts.ObjectChart(
    {"": tables.rows(sys.argv[2], "objects.csv")}, "velocity")(axes)
print(json.dumps({line.get_label(): list(line.get_ydata())
                  for line in axes.lines}))
"""


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


def plot(case, *options):
    """Runs etc/plot; status, names of pictures without folders, output."""
    done = subprocess.run([os.path.join(ETC, "plot"), case, *options],
                          capture_output=True, text=True, check=False)
    pictures = [p for p in done.stdout.split() if not p.endswith(".csv")]
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
    status, names, text = plot(case, "-column", "velocity,msd,msdY", "-x",
                               "centroidX")
    report.check("columns over another one, mean-square displacement",
                 status == 0 and names
                 == ["velocity.png", "msd.png", "msdY.png"], text)
    status, names, text = plot(case, "-column", "D", "-x", "colour")
    report.check("another column that there is not is refused",
                 status == 1 and "colour" in text and "forceX" in text, text)
    status, names, text = plot(case, "-column", "colour")
    report.check("a column that there is not is refused, with those there are",
                 status == 1 and "colour" in text and "forceX" in text
                 and "elasticEnergy" in text
                 and " D msd msdX msdY msdZ;" in text, text)
    status, names, text = plot(case, "-column", "D", "-objects", "a")
    report.check("objects that are no ids are refused",
                 status == 1 and "takes ids" in text, text)
    status, names, text = plot(case, "-page", "plots")
    report.check("a page without an ending is refused",
                 status == 1 and ".png" in text, text)
    status, names, text = plot(os.path.dirname(case))
    report.check("a folder without tables is refused",
                 status == 1 and "global.csv" in text, text)


def check_objects(report, folder):
    """Many objects of two shapes: a median of each, and what each object had
    at most. Object 3 is there from the second time on."""
    path = os.path.join(folder, "postProcessing/fsiObjects/0")
    os.makedirs(path)
    with open(os.path.join(path, "global.csv"), "w",
              encoding="ascii") as stream:
        stream.write("time,gap\n1,1\n2,1\n3,1\n")
    with open(os.path.join(path, "objects.csv"), "w",
              encoding="ascii") as stream:
        stream.write("time,object,shape,velocityX,velocityY,velocityZ\n"
                     + "".join(
                         f"{t},{i},{'bead' if i < 6 else 'cell'},"
                         f"{3*(t if t < 3 else 0)},{4*(t if t < 3 else 0)},0\n"
                         for t in (1, 2, 3) for i in range(12)
                         if i != 3 or t > 1))
    status, names, text = plot(folder, "-column", "velocity")
    with open(os.path.join(folder, "postProcessing/plots/velocity.csv"),
              encoding="ascii") as stream:
        rows = {row["object"]: row for row in csv.DictReader(stream)}
    report.check("smallest, mean and largest values of each object",
                 status == 0 and names == ["velocity.png"] and len(rows) == 12
                 and list(rows["0"].values())
                 == ["0", "bead", "1.0", "3.0", "0", "3", "5", "10", "2"]
                 and list(rows["3"].values())
                 == ["3", "bead", "2.0", "3.0", "0", "3", "5", "10", "2"]
                 and rows["6"]["shape"] == "cell", (text, rows))
    done = subprocess.run(
        ["/usr/bin/python3", "-c", MEDIANS, os.path.join(ETC, "pictures"),
         folder], capture_output=True, text=True, check=False)
    found = json.loads(done.stdout or "{}")
    report.check("a median of each shape",
                 found.get("median of bead") == [5, 10, 0]
                 and found.get("median of cell") == [5, 10, 0],
                 (found, done.stderr))


def check_rheology(report, case, folder):
    """The case with a table of the stress: columns of it, and each viscosity
    once."""
    shutil.copytree(os.path.join(case, "postProcessing"),
                    os.path.join(folder, "postProcessing"))
    with open(os.path.join(folder, "postProcessing/fsiObjects/0/rheology.csv"),
              "w", encoding="ascii") as stream:
        stream.write("time,wallViscosity,viscosity,N1\n" + "".join(
            f"{i},1.5,{1.4 + 0.1*(i % 2)},{-0.1*i}\n" for i in range(32)))
    status, names, text = plot(folder, "-column", "N1")
    report.check("columns of rheology.csv",
                 (status, names) == (0, ["N1.png"]), text)
    text = plot(folder)[2]
    report.check("each viscosity is printed once",
                 text.count("wallViscosity 1.5 +- 0 ") == 1
                 and text.count("\nviscosity 1.45 +-") == 1
                 and "rheology.png" in text, text)


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
    def monitor(*options, of=case):
        return subprocess.run(
            [os.path.join(ETC, "monitor"), *options, of, "-refresh", "1",
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
    done = monitor(of=folder)
    report.check("etc/monitor refuses a folder without tables",
                 done.returncode == 1 and "no global.csv" in done.stderr,
                 done.stderr)


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


def check_foam_log(report, case):
    """OpenFOAM's foamLog reads the line of a step."""
    shutil.copy(os.path.join(ETC, "foamLog.db"), case)
    done = subprocess.run(["foamLog", "-case", case, "log.fsiPisoFoam"],
                          capture_output=True, text=True, check=False)
    found = {name: contents(case, "logs", name + "_0").decode().split()
             for name in ("dt", "Co", "U", "p", "contacts", "gap", "speed",
                          "error")}
    steps = len(found["dt"])
    report.check("foamLog makes a file of each entry of the log",
                 steps > 0 and all(len(f) == steps for f in found.values()),
                 f"{found} {done.stdout}{done.stderr}")
