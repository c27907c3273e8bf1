# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs solvers and measures their time steps."""

import os
import re
import statistics
import subprocess
import time

import results

# Steps that are not counted: factors, agglomeration, first pages of memory
WARM_UP = 5

PARTS = ("fluid", "pressure", "levelSet", "solids", "contact", "coupling")


def cpu_seconds(pid):
    """Processor time that a process has had."""
    with open(f"/proc/{pid}/schedstat", encoding="ascii") as stream:
        return int(stream.read().split()[0])*1e-9


def run_steps(path, *command, ranks=1, limit=3600):
    """Runs a solver; a dictionary with seconds (median per step: processor
    time on one rank, wall clock on several), steps, iterations (median per
    solution for p) and memory (largest resident size of a process [MiB])."""
    args = list(command) + ["-case", path]
    if ranks > 1:
        args = (["mpirun", "--oversubscribe", "-np", str(ranks)] + args
                + ["-parallel"])
    clock, lines = [], []
    end = time.monotonic() + limit
    with subprocess.Popen(args, stdout=subprocess.PIPE,
                          stderr=subprocess.STDOUT, text=True,
                          errors="replace") as process:
        for line in process.stdout:
            lines.append(line)
            if line.startswith("Time = "):
                clock.append(time.monotonic() if ranks > 1
                             else cpu_seconds(process.pid))
            if time.monotonic() > end:
                process.kill()
        # Memory of this run alone, and of the ranks that mpirun waited for
        _, status, usage = os.wait4(process.pid, 0)
        process.returncode = os.waitstatus_to_exitcode(status)
    text = "".join(lines)
    with open(os.path.join(path, "log." + command[0]), "w",
              encoding="utf-8") as stream:
        stream.write(text)
    if process.returncode != 0:
        raise RuntimeError(f"{command[0]} in {path} ended with "
                           f"{process.returncode}: {text[-400:]}")
    steps = [b - a for a, b in zip(clock, clock[1:])][WARM_UP:]
    counts = [int(n) for n in
              re.findall(r"(?m)^Time = .* p (\d+)", text)
              or re.findall(r"for p, .*No Iterations (\d+)", text)]
    return {"seconds": statistics.median(steps), "steps": len(steps),
            "iterations": statistics.median(counts) if counts else 0,
            "memory": usage.ru_maxrss/1024}


def shares(path):
    """Part of each kind of work in the time of the steps after the first
    ones; 0 for a kind that global.csv does not have."""
    rows = results.table(path, "global.csv")[WARM_UP:]
    sums = {part: sum(row.get(part + "Seconds", 0) for row in rows)
            for part in PARTS}
    total = sum(sums.values())
    return {part: value/total for part, value in sums.items()}
