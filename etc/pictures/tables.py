# SPDX-License-Identifier: GPL-3.0-or-later
"""What etc/plot reads of a case: the tables that its runs left."""

import csv
import glob
import os

# Columns of names, also where a name is a number
NAMES = ("shape", "place")


def paths(case, name):
    """Files NAME of all runs of a case, in order of their start."""
    found = glob.glob(os.path.join(case, "postProcessing/fsiObjects/*", name))
    return sorted(found, key=start_of)


def start_of(path):
    """Time at which the run of a table started."""
    return float(os.path.basename(os.path.dirname(path)))


def value_of(text):
    """A number, or the text if it is none."""
    try:
        return float(text)
    except ValueError:
        return text


def rows(case, name):
    """Lines of a table of all runs as dictionaries. Where a run started
    before the end of the run before it, the later one counts. A last line
    that is being written is left out."""
    lines = []
    for path in paths(case, name):
        start = start_of(path)
        # The name of a folder has fewer digits than the time
        last = start + 1e-6*abs(start)
        lines = [line for line in lines if line["time"] <= last]
        with open(path, encoding="ascii") as stream:
            for row in csv.DictReader(stream):
                if None not in row and None not in row.values():
                    lines.append({k: v if k in NAMES else value_of(v)
                                  for k, v in row.items()})
    return lines


def columns(lines):
    """The names of a table's columns that hold numbers, time left out."""
    return [name for name, value in lines[0].items()
            if name != "time" and not isinstance(value, str)] if lines else []


def column(lines, name):
    """Values of a column; of a vector, whose columns end in X, Y and Z, its
    length. None if there is none of that name."""
    if not lines:
        return None
    if name in lines[0]:
        return [line.get(name, float("nan")) for line in lines]
    parts = [name + axis for axis in "XYZ"]
    if all(part in lines[0] for part in parts):
        return [sum(line[part]**2 for part in parts)**0.5 for line in lines]
    return None
