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
    command = ["fsiPisoFoam", "-case", case.path]
    if ranks == 1:
        command = ["env", *(f"{k}={v}" for k, v in names.items()), *command]
    else:
        command = (["mpirun", "--oversubscribe", "-np", str(ranks)]
                   + [word for k, v in names.items()
                      for word in ("-x", f"{k}={v}")]
                   + command + ["-parallel"])
    with open(os.path.join(case.path, "log.fsiPisoFoam"), "w",
              encoding="utf-8") as log:
        subprocess.run(command, stdout=log, stderr=log, check=True)
    rows = []
    for rank in range(ranks):
        with open(os.path.join(folder, f"{rank}.csv"),
                  encoding="ascii") as stream:
            rows.append([{k: float(v) for k, v in row.items()}
                         for row in csv.DictReader(stream)])
    return rows
