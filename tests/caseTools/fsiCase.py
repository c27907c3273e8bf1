# SPDX-License-Identifier: GPL-3.0-or-later
"""Cases of fsiPisoFoam from a few parameters: a box of squares, or of cubes,
with objects.

A case is a fsiCase.Case. Its keywords are those of DEFAULTS and of
CONTROLS; values go into the dictionaries as they are. A case is in three
dimensions if it has three numbers of cells.
"""

import itertools
import math
import os
import re
import shutil
import subprocess
import time

import results
from boxFiles import DEFAULTS, BoxFiles

# Entry of fsiProperties for the thesis's couplings, walls and level set
THESIS = 'libs ("libFSIThesis.so");\n'

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


class Case(BoxFiles):
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
        self.control()

    def control(self, **changes):
        """Writes controlDict, with changes."""
        self.controls.update(changes)
        self.file("system/controlDict",
                  "".join(f"{k} {v};\n" for k, v in self.controls.items()))

    def text(self, name, text):
        """Writes a file without a header."""
        with open(os.path.join(self.path, name), "w",
                  encoding="ascii") as stream:
            stream.write(text)

    def replace(self, name, old, new):
        """Replaces a text that must be in a file."""
        text = results.read(self.path, name)
        if old not in text:
            raise ValueError(f"{self.path}/{name} has no '{old}'")
        self.text(name, text.replace(old, new))

    def set_field(self, name, kind, cells):
        """Writes the value of each cell, as text, as the start of a field."""
        zero = "(0 0 0)" if kind == "vector" else "0"
        self.replace(f"0/{name}", f"internalField uniform {zero};",
                     f"internalField nonuniform List<{kind}>\n"
                     f"{len(cells)}\n(\n" + "\n".join(cells) + "\n);")

    def set_velocity(self, velocity):
        """Starts from a velocity (u, v), in three dimensions (u, v, w), that is
        a function of the place."""
        h = self.spacing()
        axes = [[x + (i + 0.5)*h for i in range(n)] for x, n in
                zip(self.values["box"], self.values["cells"])]
        self.set_field("U", "vector",
                       ["({!r} {!r} {!r})".format(*velocity(*place[::-1]), 0)
                        for place in itertools.product(*axes[::-1])])

    def spacing(self):
        """Length of a cell."""
        box = self.values["box"]
        return (box[self.dimensions()] - box[0])/self.values["cells"][0]

    def run(self, *command, ranks=1, limit=600):
        """Runs an application, log.NAME in the case; raises if it fails."""
        return run(self.path, *command, ranks=ranks, limit=limit,
                   seconds=self.seconds)

    def decompose(self, *parts, options=()):
        """Boxes of nx by ny ranks, or nx by ny by nz, (parts), by
        decomposePar."""
        n = math.prod(parts)
        parts += (1,)*(3 - len(parts))
        self.file("system/decomposeParDict",
                  f"numberOfSubdomains {n}; method simple; simpleCoeffs "
                  f"{{ n ({' '.join(map(str, parts))}); delta 0.001; }}\n")
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


def of_this_line(path, command):
    """The command as the line of OpenFOAM that is sourced has it: where the
    step is a solver module, the case gets what that line needs as well."""
    if (os.environ.get("FSI_LINE") != "foundation"
            or command[0] != "fsiPisoFoam"):
        return list(command)
    script = os.path.join(os.path.dirname(__file__), "../../etc")
    subprocess.run([os.path.join(script, "foundationCase"), path],
                   stdout=subprocess.DEVNULL, check=True)
    return ["foamRun", "-solver", "fsiFluid", *command[1:]]


def run(path, *command, ranks=1, limit=600, seconds=None):
    """Runs an application for a case; raises RuntimeError if it fails."""
    args = of_this_line(path, command) + ["-case", path]
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
        end = text[cut:cut + 600] if cut >= 0 else text[-2000:]
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
