#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Table of icoFoam's logs:  table.py FOLDER CELLS... -- SOLVER...

Reads FOLDER/CELLS/log.SOLVER and prints CSV: cells, solver, mean iterations
per solution, median processor time per step over that of the first solver,
and the time of the first solver in seconds.
"""

import re
import statistics
import sys


def read_log(path):
    """Mean iterations for p and median processor time per step of a log."""
    with open(path, encoding="ascii", errors="replace") as log:
        text = log.read()
    if "\nEnd" not in text:
        sys.exit(f"{path} has not ended")
    counts = [
        int(n) for n in re.findall(r"for p, .*No Iterations (\d+)", text)
    ]
    times = [
        float(t) for t in re.findall(r"^ExecutionTime = ([\d.]+)", text, re.M)
    ]
    steps = [b - a for a, b in zip(times, times[1:])]
    return statistics.mean(counts), statistics.median(steps)


def main():
    """Prints the table."""
    folder, *rest = sys.argv[1:]
    split = rest.index("--")
    print("cells,solver,iterations,time per step / first,first [s]")
    for cells in rest[:split]:
        first = None
        for solver in rest[split + 1:]:
            count, time = read_log(f"{folder}/{cells}/log.{solver}")
            first = first or time
            print(
                f"{cells},{solver},{count:.1f},{time / first:.3f},{first:.3f}"
            )


main()
