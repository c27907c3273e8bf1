#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Validation cases of fsiPisoFoam; writes table.md.

cylinder   fixed disc in a channel, DFG 2D-1, Re 20 (Schaefer and Turek 1996):
           drag 5.57953523384, lift 0.010618948146
settling   disc settling in a closed channel, density ratio 1.25 (Glowinski
           2001, Wan and Turek 2006, Koblitz 2017): U 5.55 +- 0.15
softDisc   soft disc in a driven cavity (Zhao 2008, Sugiyama 2011): the first
           turning points of its centre
"""

import os
import sys
import time

import fsiCase
import results


class Channel(fsiCase.Case):
    """The channel of DFG 2D-1: parabolic inflow, outflow at p = 0."""

    HEIGHT = 0.41

    def mesh(self):
        """The box with its left and right sides open."""
        super().mesh()
        for side in ("left", "right"):
            self.replace("system/blockMeshDict", f"{side} {{ type wall;",
                         f"{side} {{ type patch;")

    def fields(self):
        """Inflow and outflow in place of walls."""
        super().fields()
        n = self.values["cells"][1]
        h = self.HEIGHT/n
        profile = " ".join(
            f"({4*0.3*y*(self.HEIGHT - y)/self.HEIGHT**2:.10g} 0 0)"
            for y in ((j + 0.5)*h for j in range(n))
        )
        still = "type fixedValue; value uniform (0 0 0);"
        self.replace("0/U", f"left {{ {still}", "left { type fixedValue; "
                     f"value nonuniform List<vector> {n} ({profile});")
        self.replace("0/U", f"right {{ {still}", "right { type zeroGradient;")
        self.replace("0/p", "right { type zeroGradient;",
                     "right { type fixedValue; value uniform 0;")

    def replace(self, name, old, new):
        """Replaces a text that must be in a file."""
        path = os.path.join(self.path, name)
        with open(path, encoding="ascii") as stream:
            text = stream.read()
        if old not in text:
            raise ValueError(f"{path} has no '{old}'")
        with open(path, "w", encoding="ascii") as stream:
            stream.write(text.replace(old, new))


def cylinder():
    """Drag and lift of a fixed disc."""
    for wall in ("openArea", "voxel"):
        for cells in (10, 20):
            ny = round(Channel.HEIGHT/0.1*cells)
            h = Channel.HEIGHT/ny
            nx = round(2.2/h)
            case = Channel(
                f"cases/cylinder-{wall}-{cells}",
                box=(0, 0, nx*h, Channel.HEIGHT), cells=(nx, ny),
                viscosity=1e-3, properties=f"wall {wall};",
                shapes="disc { shape { type circle; radius 0.05; } material "
                       "{ density 1; E 1e3; } motion { type fixed; } }",
                placements="one { type listed; shape disc; objects "
                           "({ centre (0.2 0.2 0); }); }",
                deltaT=0.04/cells, endTime=8,
                writeControl="adjustableRunTime", writeInterval=1,
            ).set_up()
            case.run("fsiPisoFoam", limit=3600)
            last = results.table(case.path, "objects.csv")[-1]
            scale = 2/(0.2**2*0.1*h)        # per thickness h
            minutes = case.seconds["fsiPisoFoam"]/60
            name = f"DFG 2D-1, {wall}"
            yield (name + ", drag", f"D/h = {cells}", 5.57953523384,
                   scale*last["forceX"], "1 % at D/h = 20", minutes)
            yield (name + ", lift", f"D/h = {cells}", 0.010618948146,
                   scale*last["forceY"], "0.002", minutes)


def settling():
    """Speed of a settling disc."""
    for cells in (8, 16):
        n = 8*cells
        case = fsiCase.Case(
            f"cases/settling-{cells}",
            box=(0, 0, 2, 6), cells=(n, 3*n), viscosity=0.1,
            gravity="(0 -981 0)",
            shapes="disc { shape { type circle; radius 0.125; } material "
                   "{ density 1.25; E 1e5; } }",
            placements="one { type listed; shape disc; objects "
                       "({ centre (1 4 0); }); }",
            deltaT=8e-3/cells, endTime=0.6,
            writeControl="adjustableRunTime", writeInterval=0.1,
        ).set_up()
        case.run("fsiPisoFoam", limit=3600)
        rows = results.table(case.path, "objects.csv")
        minutes = case.seconds["fsiPisoFoam"]/60
        yield ("settling disc, largest speed [cm/s]", f"d/h = {cells}", 5.55,
               max(-row["velocityY"] for row in rows), "0.15", minutes)


def soft_disc():
    """Turning points of a soft disc in a driven cavity."""
    case = fsiCase.Case(
        "cases/softDisc-64", cells=(64, 64), viscosity=0.01,
        walls={"top": "(1 0 0)"}, properties="contact { range 1; }",
        # A triangular network of modulus E has the shear modulus 3 E/8 = 0.1
        shapes="disc { shape { type circle; radius 0.2; } material "
               "{ density 1; E 0.26667; } }",
        placements="one { type listed; shape disc; objects "
                   "({ centre (0.6 0.5 0); }); }",
        deltaT=0.005, endTime=7,
        writeControl="adjustableRunTime", writeInterval=0.05,
    ).set_up()
    case.run("fsiPisoFoam", limit=3600)
    rows = results.table(case.path, "objects.csv")
    minutes = case.seconds["fsiPisoFoam"]/60

    left = min(rows, key=lambda row: row["centroidX"])
    rows = [row for row in rows if row["time"] > left["time"]]
    top = max(rows, key=lambda row: row["centroidY"])
    rows = [row for row in rows if row["time"] > top["time"]]
    right = max(rows, key=lambda row: row["centroidX"])
    for name, reference, value in (
            ("x at its first left turn", 0.2894, left["centroidX"]),
            ("y at its first left turn", 0.7211, left["centroidY"]),
            ("y at its first top", 0.8684, top["centroidY"]),
            ("x at its first right turn", 0.7021, right["centroidX"]),
            ("y at its first right turn", 0.7662, right["centroidY"])):
        yield ("soft disc, " + name, "h = 1/64", reference, value, "0.03",
               minutes)


CASES = {"cylinder": cylinder, "settling": settling, "softDisc": soft_disc}


def main(names):
    """Runs the cases named, or all, and writes the table."""
    unknown = [name for name in names if name not in CASES]
    if unknown:
        sys.exit(f"Unknown cases {unknown}; there are {list(CASES)}")

    lines = ["| case | grid | reference | here | difference | tolerance "
             "| CPU minutes |", "|---|---|---|---|---|---|---|"]
    for name in names or CASES:
        for row in CASES[name]():
            what, grid, reference, value, tolerance, minutes = row
            lines.append(
                f"| {what} | {grid} | {reference:.5g} | {value:.5g} | "
                f"{value - reference:+.2g} ({100*(value/reference - 1):+.1f} "
                f"%) | {tolerance} | {minutes:.1f} |"
            )
            print(lines[-1], flush=True)
    with open("table.md", "w", encoding="ascii") as stream:
        stream.write(f"Made by tutorials/validation/Allrun on "
                     f"{time.strftime('%Y-%m-%d')}\n\n"
                     + "\n".join(lines) + "\n")


if __name__ == "__main__":
    main(sys.argv[1:])
