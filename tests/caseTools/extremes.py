#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Extreme cases: each is sound, or ends in an error that says what is wrong.

    extremes.py FOLDER [NAME...]

Dense, light, heavy, soft, stiff, thin and folded objects, blocked inlets, large
steps, in two and three dimensions. A case is sound if fsiPisoFoam comes to its
end and checkObjects finds no fault in any written time: no overlap, no surface
that cuts itself, nothing lost, volumes kept to 0.1 %, no node faster than 10
times what drives the flow. If it ends in an error, the error must come from
this project (not OpenFOAM's solvers) and hold the words that the case expects.
"""

import math
import os
import re
import sys

import fsiCase
import results
from extremeCases import CASES, OUTLINES

SPEED = 10


class Outcome:
    """What became of a case: a word and the reason."""

    def __init__(self, word, reason, steps=0, seconds=0):
        self.word = word
        self.reason = reason
        self.steps = steps
        self.seconds = seconds


def message_of(log):
    """The first sentence of an error, without its folder."""
    start = log.find("--> FOAM FATAL")
    if start < 0:
        return ""
    text = log[start:].split("From function")[0].split("\n    file:")[0]
    text = re.sub(r"--> FOAM FATAL \w*\s?ERROR:\s*", "", text)
    text = re.sub(r'"?/\S*/(\w[\w.]*)"?', r"\1", text)
    return " ".join(text.split())


def outline(points):
    """The text of a polygon's file."""
    return "".join(f"{x},{y}\n" for x, y in points)


def run_case(path, values, expected):
    """Sets up, runs and checks a case."""
    values = dict(values)
    speed = values.pop("speed", 1)
    case = fsiCase.Case(path, **{
        "cells": (40, 40), "viscosity": 0.01, "writeControl": "timeStep",
        "writeInterval": 50, "deltaT": 0.01, "endTime": 2, **values})
    for name, points in OUTLINES.items():
        with open(os.path.join(path, name), "w", encoding="ascii") as stream:
            stream.write(outline(points))
    program = ""
    try:
        for program in ("blockMesh", "seedObjects", "fsiPisoFoam"):
            case.run(program, limit=900)
    except RuntimeError as error:
        log = results.read(path, f"log.{program}")
        message = message_of(log)
        true = message and expected and all(
            word in message for word in expected)
        return Outcome("stopped" if true else "WRONG",
                       message or str(error)[:300])
    steps = results.read(path, "log.fsiPisoFoam").count("\nTime = ")
    try:
        case.run("checkObjects", "-maxSpeed", str(SPEED*speed))
    except RuntimeError:
        log = results.read(path, "log.checkObjects")
        return Outcome("WRONG", " ".join(log[log.find("Time = "):].split()),
                       steps, case.seconds["fsiPisoFoam"])
    if expected:
        return Outcome("WRONG", "was to be refused", steps)
    return Outcome("sound", "", steps, case.seconds["fsiPisoFoam"])


def dimensions(values):
    """2 or 3."""
    return len(values.get("cells", (1, 1)))


def row(name, values, found):
    """A row of the table."""
    words = re.sub(r"\s+", " ", found.reason).replace("|", "/")
    if len(words) > 160:
        words = words[:words.rfind(" ", 0, 160)] + " ..."
    return (f"| {name} | {dimensions(values)}D | {found.word} | "
            f"{words or f'{found.steps} steps'} |\n")


def main(folder, *wanted):
    """The cases."""
    report = fsiCase.Report()
    counts = {}
    rows = []
    for name, (values, expected) in CASES.items():
        if wanted and not any(w in name for w in wanted):
            continue
        found = run_case(os.path.join(folder, re.sub(r"\W+", "_", name)),
                         values, expected)
        counts[found.word] = counts.get(found.word, 0) + 1
        report.check(f"{name}: {found.word} ({math.ceil(found.seconds)} s)",
                     found.word != "WRONG", found.reason[:500])
        if found.word == "stopped":
            print(f"    {found.reason[:200]}")
        rows.append(row(name, values, found))
    print("    " + ", ".join(f"{n} {word}" for word, n in counts.items()))
    if not wanted:
        os.makedirs("log", exist_ok=True)
        with open("log/extremes.md", "w", encoding="ascii") as stream:
            stream.write("| case | | outcome | after, or the message |\n"
                         "|---|---|---|---|\n" + "".join(rows))


if __name__ == "__main__":
    main(*sys.argv[1:])
