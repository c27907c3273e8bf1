# SPDX-License-Identifier: GPL-3.0-or-later
"""Tables in three dimensions: table6.3, table6.4, stock3D, bodies3D,
redCells."""

import os

import scenarios3D

# Seconds per step of the thesis, tables 6.3 and 6.4: (cells across, objects);
# None: a row of ours beside them
THESIS = {
    "table6.3": {(40, 2): 0.25, (80, 2): 3.75, (160, 10): 45.56,
                 (240, 43): None, (320, 101): 617.561},
    "table6.4": {(160, 40): None, (160, 80): None, (160, 160): None,
                 (320, 40): 745.161, (320, 80): 731.984, (320, 160): 696.097},
}

# Objects beside stock icoFoam, on the same mesh
STOCK = (2, 10, 49)

# Cells across a body, and of the cube that eight of them are in
BODIES = ((8, 64), (12, 80), (16, 96))

# Cells across the box of red cells
RED_CELLS = (50, 100)

NAMES = (*THESIS, "stock3D", "bodies3D", "redCells")


def row(tables, width, objects, across=12):
    """One case, without stock: case and dictionary, or None if too large."""
    name = f"falling-{width}-{objects}-{across}"
    if tables.left_out(name, width**3):
        return None, None
    case = scenarios3D.Falling(os.path.join(tables.folder, name), width,
                               objects, tables.options.steps, across)
    found = {"N": width, "objects": objects, "cells across a sphere": across,
             **tables.measured(case, width**3)}
    found["bytes per cell"] = found["MiB"]*2**20/width**3
    return case, found


def thesis(tables, name):
    """A table of the thesis beside its figures."""
    rows = []
    for (width, objects), seconds in THESIS[name].items():
        _, found = row(tables, width, objects)
        if found and seconds:
            found["thesis seconds/step"] = seconds
            found["thesis/here"] = seconds/found["seconds/step"]
        rows.append(found)
    return rows


def stock(tables):
    """Some numbers of objects, over icoFoam with GAMG for the fluid alone, on
    the largest mesh of up to 160^3 cells that -cells allows."""
    width = min(160, int(round(tables.options.cells**(1/3) - 0.49)))
    rows, reference = [], None
    for objects in STOCK:
        case, found = row(tables, width, objects)
        if reference is None:
            reference = tables.stock(case)
        found["icoFoam seconds/step"] = reference["seconds"]
        found["icoFoam bytes per cell"] = reference["memory"]*2**20/width**3
        found["ratio"] = found["seconds/step"]/reference["seconds"]
        found["over the least objects"] = (
            found["seconds/step"]/(rows or [found])[0]["seconds/step"])
        rows.append(found)
    return rows


def bodies(tables):
    """Milliseconds per object and step, by size."""
    rows = []
    for across, width in BODIES:
        _, found = row(tables, width, 8, across)
        if found:
            for part in ("solids", "coupling", "levelSet", "contact"):
                found[f"{part} ms/object"] = (
                    1e3*found["seconds/step"]
                    * found.get(f"{part} share", 0)/found["objects"])
        rows.append(found)
    return rows


def red_cells(tables):
    """Core-seconds per simulated millisecond and cell, bytes per mesh cell."""
    rows = []
    for width in RED_CELLS:
        name = f"redCells-{width}"
        if tables.left_out(name, 2*width**3):
            continue
        case = scenarios3D.RedCells(os.path.join(tables.folder, name), width,
                                    tables.options.steps)
        found = {"N": width, "objects": case.objects,
                 **tables.measured(case, 2*width**3)}
        found["bytes per cell"] = found["MiB"]*2**20/(2*width**3)
        found["s per ms and cell"] = (
            found["seconds/step"]*1e-3/case.controls["deltaT"]/case.objects)
        rows.append(found)
    return rows


def table(tables, name):
    """One of the tables by its name."""
    if name == "redCells":
        return red_cells(tables)
    if name == "stock3D":
        return stock(tables)
    if name == "bodies3D":
        return bodies(tables)
    return thesis(tables, name)
