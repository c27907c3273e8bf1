# SPDX-License-Identifier: GPL-3.0-or-later
"""Checks of etc/profiles in a channel whose walls are one patch."""

import os
import re
import subprocess

import fsiCase

PROFILES = os.path.join(os.path.dirname(os.path.abspath(__file__)),
                        "../../../etc/profiles")
WALLS = {"bottom": "(0 0 0)", "top": "(0 0 0)"}


def channel(folder):
    """A disc in a channel of 16 cells that is driven to a mean velocity of
    1."""
    case = fsiCase.Case(
        os.path.join(folder, "channel"), box=(0, 0, 2, 1), cells=(32, 16),
        cyclic="x", walls=WALLS, density=1000, viscosity=1/30, deltaT=0.02,
        endTime=0.2, writeInterval=5,
        properties="drivingForce { type meanVelocity; velocity (1 0 0); }\n",
        shapes="disc { shape { type circle; radius 0.2; } "
               "material { type rigid; density 1000; } }",
        placements="a { type listed; shape disc; objects "
                   "({ centre (0.5 0.5 0); velocity (1 0 0); }); }")
    case.replace("system/blockMeshDict", "bottom { type wall; faces ((0 1 5 4"
                 ")); }\ntop { type wall; faces ((3 7 6 2)); }",
                 "both { type wall; faces ((0 1 5 4) (3 7 6 2)); }")
    for name in ("U", "p"):
        case.replace(f"0/{name}", "\nbottom {", "\nboth {")
        case.replace(f"0/{name}", "\ntop {", "\nnone {")
    case.run("blockMesh")
    case.run("seedObjects")
    case.run("fsiPisoFoam")
    return case


def numbers(case, *options):
    """What etc/profiles prints: its numbers by their names, and the text."""
    done = subprocess.run([PROFILES, case.path, *options],
                          capture_output=True, text=True, check=False)
    text = done.stdout + done.stderr
    return {name.strip(): float(value) for name, value in re.findall(
        r"^(\D+) +([-+.e\d]+|nan)$", text, re.M)}, text


def check_profiles(report, folder):
    """The bins of the profile do not change the means; more bins than cells
    have values; no number is left out without a word."""
    case = channel(folder)
    rows, text = numbers(case, "-bins", "16")
    mean, viscosity = "mean velocity [m/s]", "apparent viscosity over the " \
        "fluid's"
    report.check("etc/profiles: walls that are one patch",
                 abs(rows.get(mean, 0) - 1) < 1e-3
                 and rows.get(viscosity, 0) > 1, text)
    for bins in ("7", "20", "40"):
        found, text = numbers(case, "-bins", bins)
        report.check(f"etc/profiles: means with {bins} bins",
                     all(abs(found.get(name, 0)/rows.get(name, 1) - 1) < 1e-4
                         for name in (mean, viscosity)), text)
    with open(os.path.join(case.path, "postProcessing/profiles/profiles.csv"),
              encoding="ascii") as stream:
        speeds = [float(line.split(",")[1]) for line in list(stream)[1:]]
    report.check("etc/profiles: no bin is empty",
                 len(speeds) == 40 and min(speeds) > 0.05, str(speeds))
    case.replace("constant/transportProperties", "nu ", "mu ")
    _, text = numbers(case)
    report.check("etc/profiles: a viscosity that is not there is told",
                 "no apparent viscosity: nu" in text, text)
