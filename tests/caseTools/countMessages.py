# SPDX-License-Identifier: GPL-3.0-or-later
"""Counts the messages of a run, for each rank and time step."""

import csv
import os
import subprocess

SOURCE = os.path.join(os.path.dirname(os.path.abspath(__file__)),
                      "countMessages", "countMessages.C")


def library(folder):
    """Compiles the library that stands between the solver and MPI."""
    path = os.path.join(os.path.abspath(folder), "libcountMessages.so")
    if not os.path.exists(path):
        subprocess.run(["g++", "-std=c++14", "-O2", "-fPIC", "-shared",
                        "-o", path, SOURCE, "-ldl"], check=True)
    return path


def counted(case, ranks, preloaded):
    """Runs a case with the library; the rows of all steps of each rank."""
    folder = os.path.join(case.path, "counts")
    os.makedirs(folder)
    names = {"LD_PRELOAD": preloaded, "FSI_COUNTS": folder}
    os.environ.update(names)
    try:
        case.run("fsiPisoFoam", ranks=ranks)
    finally:
        for name in names:
            del os.environ[name]
    rows = []
    for rank in range(ranks):
        with open(os.path.join(folder, f"{rank}.csv"),
                  encoding="ascii") as stream:
            rows.append([{k: float(v) for k, v in row.items()}
                         for row in csv.DictReader(stream)])
    return rows
