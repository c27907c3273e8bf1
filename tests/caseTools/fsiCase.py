# SPDX-License-Identifier: GPL-3.0-or-later
"""Cases of fsiPisoFoam from a few parameters: a box of squares with objects.

A case is a fsiCase.Case. Its keywords are those of DEFAULTS and of
CONTROLS; values go into the dictionaries as they are.
"""

import math
import os
import re
import shutil
import subprocess
import time

HEADER = """// SPDX-License-Identifier: GPL-3.0-or-later
FoamFile
{{
    version     2.0;
    format      ascii;
    class       {};
    object      {};
}}

"""

FACES = {"left": "(0 4 7 3)", "right": "(1 2 6 5)",
         "bottom": "(0 1 5 4)", "top": "(3 7 6 2)"}

OPPOSITE = {"left": "right", "right": "left",
            "bottom": "top", "top": "bottom"}

DEFAULTS = {
    "box": (0, 0, 1, 1),
    "cells": (32, 32),
    "grading": "1 1 1",
    "viscosity": 0.01,
    "density": 1,
    "gravity": "(0 0 0)",
    # Velocity of the sides that are not at rest
    "walls": {},
    # Velocity of the fluid at the start
    "velocity": "(0 0 0)",
    # Directions closed by cyclic patches: "x", "y" or "xy"
    "cyclic": "",
    # Open patches: side: (boundary condition of U, of p)
    "open": {},
    "properties": "",
    "shapes": "",
    "placements": "",
    "p_tolerance": 1e-7,
    "U_tolerance": 1e-8,
    # Further entries of the solver of U
    "U_controls": "",
}

CONTROLS = {
    "application": "fsiPisoFoam",
    "startFrom": "startTime",
    "startTime": 0,
    "stopAt": "endTime",
    "endTime": 1,
    "deltaT": 0.01,
    "writeControl": "timeStep",
    "writeInterval": 1000000,
    "writeFormat": "ascii",
    "writePrecision": 12,
    "timePrecision": 8,
    "runTimeModifiable": "no",
    "adjustTimeStep": "no",
}

SCHEMES = """ddtSchemes { default Euler; }
gradSchemes { default Gauss linear; }
divSchemes { default none; div(phi,U) Gauss linear; }
laplacianSchemes { default Gauss linear orthogonal; }
interpolationSchemes { default linear; }
snGradSchemes { default orthogonal; }
"""

SOLUTION = """solvers
{{
    p {{ solver PCG; preconditioner DIC; tolerance {}; relTol 0; }}
    U {{ solver PBiCGStab; preconditioner DILU; tolerance {}; relTol 0; {} }}
}}
PISO {{ nCorrectors 1; }}
"""


class Case:
    """A case folder: writes it, runs applications in it."""

    def __init__(self, path, **parameters):
        self.path = path
        self.seconds = {}
        self.values = dict(DEFAULTS)
        self.controls = dict(CONTROLS)
        for key, value in parameters.items():
            (self.values if key in DEFAULTS else self.controls)[key] = value
        shutil.rmtree(path, ignore_errors=True)
        self.write()

    def file(self, name, text, kind="dictionary"):
        """Writes the file "name" of the case."""
        path = os.path.join(self.path, name)
        os.makedirs(os.path.dirname(path), exist_ok=True)
        with open(path, "w", encoding="ascii") as stream:
            stream.write(HEADER.format(kind, os.path.basename(name)) + text)

    def write(self):
        """Writes all files of the case."""
        v = self.values
        self.mesh()
        self.fields()
        self.control()
        self.file("constant/transportProperties",
                  f"nu [0 2 -1 0 0 0 0] {v['viscosity']};\n")
        self.file("constant/fsiProperties",
                  f"fluidDensity {v['density']};\ngravity {v['gravity']};\n"
                  + v["properties"])
        self.file("system/seedObjectsDict",
                  f"shapes\n{{\n{v['shapes']}\n}}\n"
                  f"placements\n{{\n{v['placements']}\n}}\n")
        self.file("system/fvSchemes", SCHEMES)
        self.file("system/fvSolution",
                  SOLUTION.format(v["p_tolerance"], v["U_tolerance"],
                                  v["U_controls"]))

    def is_cyclic(self, side):
        """True if the side is one half of a cyclic."""
        axis = "x" if side in ("left", "right") else "y"
        return axis in self.values["cyclic"]

    def patch_type(self, side):
        """Entries of a side in blockMeshDict."""
        if self.is_cyclic(side):
            return f"type cyclic; neighbourPatch {OPPOSITE[side]};"
        return f"type {'patch' if side in self.values['open'] else 'wall'};"

    def boundary_condition(self, side, field):
        """Entries of a side in 0/U or 0/p."""
        if self.is_cyclic(side):
            return "type cyclic;"
        if side in self.values["open"]:
            return self.values["open"][side][field == "p"]
        if field == "p":
            return "type zeroGradient;"
        velocity = self.values["walls"].get(side, "(0 0 0)")
        return f"type fixedValue; value uniform {velocity};"

    def mesh(self):
        """Writes blockMeshDict: one block, one cell thick."""
        x0, y0, x1, y1 = self.values["box"]
        nx, ny = self.values["cells"]
        thickness = (x1 - x0)/nx
        corners = " ".join(
            f"({x} {y} {z})" for z in (0, thickness)
            for x, y in ((x0, y0), (x1, y0), (x1, y1), (x0, y1))
        )
        sides = "\n".join(f"{name} {{ {self.patch_type(name)} "
                          f"faces ({face}); }}"
                          for name, face in FACES.items())
        self.file(
            "system/blockMeshDict",
            f"vertices ({corners});\nblocks\n(\n    hex (0 1 2 3 4 5 6 7) "
            f"({nx} {ny} 1) simpleGrading ({self.values['grading']})\n);\n"
            f"boundary\n(\n{sides}\n"
            "frontAndBack { type empty; faces ((0 3 2 1) (4 5 6 7)); }\n);\n"
        )

    def fields(self):
        """Writes p and U: at rest, walls at rest or with a velocity."""
        U, p = ("".join(f"{s} {{ {self.boundary_condition(s, field)} }}\n"
                        for s in FACES) for field in "Up")
        text = ("dimensions {};\ninternalField uniform {};\n"
                "boundaryField\n{{\n{}frontAndBack {{ type empty; }}\n}}\n")
        self.file("0/U", text.format("[0 1 -1 0 0 0 0]",
                                      self.values["velocity"], U),
                  "volVectorField")
        self.file("0/p", text.format("[0 2 -2 0 0 0 0]", 0, p),
                  "volScalarField")

    def control(self, **changes):
        """Writes controlDict, with changes."""
        self.controls.update(changes)
        self.file("system/controlDict",
                  "".join(f"{k} {v};\n" for k, v in self.controls.items()))

    def run(self, *command, ranks=1, limit=600):
        """Runs an application, log.NAME in the case; raises if it fails."""
        return run(self.path, *command, ranks=ranks, limit=limit,
                   seconds=self.seconds)

    def decompose(self, *parts, options=()):
        """Boxes of nx by ny ranks, (parts), by decomposePar."""
        n = math.prod(parts)
        self.file("system/decomposeParDict",
                  f"numberOfSubdomains {n}; method simple; simpleCoeffs "
                  f"{{ n ({' '.join(map(str, parts))} 1); delta 0.001; }}\n")
        self.run("decomposePar", *options)
        return n

    def set_up(self):
        """blockMesh and seedObjects."""
        self.run("blockMesh")
        self.run("seedObjects")
        return self


def copy(source, target):
    """A copy of a case folder, without its results."""
    shutil.copytree(source, target, ignore=shutil.ignore_patterns(
        "processor*", "postProcessing", "log.*", "polyMesh",
        r"[1-9]*", "0.*", "uniform", "Allrun", "README*"))


def tutorial(name, target, **control):
    """A copy of a tutorial with its mesh and objects, and with other entries
    of controlDict. All digits of ascii files are written: the mesh has the
    rounding errors of a binary one."""
    copy(os.path.join(os.path.dirname(__file__), "../../tutorials", name),
         target)
    for key, value in control.items():
        set_entry(os.path.join(target, "system/controlDict"), key, value)
    with open(os.path.join(target, "system/controlDict"), "a",
              encoding="ascii") as stream:
        stream.write("writePrecision 17;\n")
    run(target, "blockMesh")
    run(target, "seedObjects")
    return target


def set_entry(path, key, value):
    """Sets an entry that stands on a line of its own in a file."""
    with open(path, encoding="ascii") as stream:
        text, n = re.subn(rf"(?m)^(\s*){key}\s[^;]*;",
                          rf"\g<1>{key} {value};", stream.read())
    if n == 0:
        raise ValueError(f"{path} has no entry {key}")
    with open(path, "w", encoding="ascii") as stream:
        stream.write(text)


def run(path, *command, ranks=1, limit=600, seconds=None):
    """Runs an application for a case; raises RuntimeError if it fails."""
    args = list(command) + ["-case", path]
    if ranks > 1:
        args = ["mpirun", "--oversubscribe", "-np", str(ranks)] + args
        args.append("-parallel")
    log = os.path.join(path, "log." + command[0])
    start = os.times()
    with open(log, "w", encoding="utf-8") as stream:
        status = subprocess.run(args, stdout=stream, stderr=stream,
                                timeout=limit, check=False).returncode
    end = os.times()
    if seconds is not None:
        seconds[command[0]] = (end.children_user - start.children_user
                               + end.children_system - start.children_system)
    with open(log, encoding="utf-8", errors="replace") as stream:
        text = stream.read()
    if status != 0:
        cut = text.find("--> FOAM FATAL")
        end = text[cut:cut + 600] if cut >= 0 else text[-300:]
        raise RuntimeError(f"{' '.join(command)} ended with {status}: "
                           + " ".join(end.split()))
    return text


class Report:
    """Prints "ok NAME" and "FAIL NAME: reason"."""

    def __init__(self):
        self.failures = 0

    def check(self, name, passed, reason=""):
        """Prints one outcome; the reason tells the figures."""
        self.failures += not passed
        print(f"ok {name}" if passed else f"FAIL {name}: {reason}", flush=True)

    def attempt(self, name, function, *args, **parameters):
        """Runs a part of a test; an exception is its failure."""
        start = time.time()
        try:
            return function(*args, **parameters)
        except Exception as error:  # the test must go on
            self.check(name, False, f"{type(error).__name__}: {error}")
            return None
        finally:
            print(f"    {name}: {time.time() - start:.1f} s", flush=True)
