#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Damaged files: a program must go on, or end in an error that names the file
and the entry; never by a signal, never without an end.

    fuzz.py FOLDER [N [SEED]]

A file of the case (state, shapes, dictionaries, mesh, fields, tables of points
and places, a surface) gets one fault: bytes changed, taken out or doubled, a
number made absurd, a word exchanged, the end cut off. Half of the state files
lose their check sums first, so that the checks behind them are met too. The
solver runs on one, two or three ranks.
"""

import os
import random
import re
import shutil
import subprocess
import sys

import fsiCase
import results
from smallCase import DISC_AND_CELL

SHAPES = DISC_AND_CELL + """
sheet
{
    shape { type circle; radius 0.1; }
    material { type membrane; density 1.1; shearModulus 0.1; areaModulus 1;
        bendingModulus 1e-5; innerViscosity 0.03; membraneViscosity 1e-4;
        viscousModulus 0.02; }
}
ball
{
    shape { type polygon; file "points.csv"; }
    material { type rigid; density 2; }
    motion { type oscillating; amplitude (0.01 0 0); frequency 1; }
}
"""

PLACEMENTS = """
table { type csv; shape disc; file "places.csv"; }
discs { type listed; shape disc; objects ({ centre (0.25 0.25 0); }); }
cells { type listed; shape cell; objects ({ centre (0.75 0.75 0); }); }
balls { type listed; shape ball; objects ({ centre (0.25 0.75 0); }); }
sheets { type listed; shape sheet; objects ({ centre (0.5 0.5 0); }); }
"""

PROPERTIES = """gravity (0 -1 0);
contact { law { type elastic; } }
levelSet { type rebuilt; }
output { globalEvery 1; }
"""

TABLES = {"points.csv": "0,0\n0.25,0\n0.3,0.2\n0.1,0.25\n0,0.2\n",
          "places.csv": "x,y,rotation\n0.75,0.22,30\n"}

BODY = """body { shape { type surface; file "body.stl"; cornerAngle 180; }
    material { density 1.1; E 100; } }"""

TIME = "0.02"
BODIES = ("disc", "cell", "sheet", "ball")
STATE = [f"{TIME}/uniform/fsiObjects/{s}" for s in BODIES]
STATE += [f"{TIME}/uniform/{f}" for f in ("fsiPopulation", "fsiRestart")]
SHAPE_FILES = [f"constant/fsiObjects/{s}" for s in BODIES]
MESH = [f"constant/polyMesh/{f}" for f in
        ("points", "faces", "owner", "neighbour", "boundary")]
PROGRAMS = {
    **{f: "fsiPisoFoam" for f in STATE + SHAPE_FILES},
    "constant/fsiProperties": "fsiPisoFoam",
    "system/seedObjectsDict": "seedObjects",
    "points.csv": "seedObjects",
    "places.csv": "seedObjects",
    "postProcessing/fsiObjects/0/global.csv": "checkObjects",
    **{f: "fsiPisoFoam" for f in MESH},
    f"{TIME}/p": "fsiPisoFoam",
    f"{TIME}/U": "fsiPisoFoam",
}
NUMBERS = (b"0", b"-1", b"1e300", b"-1e300", b"nan", b"999999999999",
           b"1e-300", b"2147483647", b"-2147483648", b"0.5", b"1000000")


def change_bytes(data, dice):
    """One to four bytes become others."""
    data = bytearray(data)
    for _ in range(dice.randint(1, 4)):
        data[dice.randrange(len(data))] = dice.randrange(256)
    return bytes(data)


def flip_bit(data, dice):
    """One bit the other way."""
    data = bytearray(data)
    data[dice.randrange(len(data))] ^= 1 << dice.randrange(8)
    return bytes(data)


def take_out(data, dice):
    """A piece is missing."""
    start = dice.randrange(len(data))
    return data[:start] + data[start + dice.randint(1, 60):]


def double(data, dice):
    """A piece comes twice."""
    start = dice.randrange(len(data))
    end = start + dice.randint(1, 60)
    return data[:end] + data[start:end] + data[end:]


def cut(data, dice):
    """The end is missing."""
    return data[:dice.randrange(len(data))]


def replace(pattern, choices):
    """A change of one match of a pattern."""
    def change(data, dice):
        start = data.find(b"object ") if data.startswith(b"/*") else 0
        found = [m for m in re.finditer(pattern, data) if m.start() > start]
        if not found:
            return flip_bit(data, dice)
        match = dice.choice(found)
        words = choices or [m.group() for m in found]
        return (data[:match.start()] + dice.choice(words)
                + data[match.end():])
    return change


CHANGES = (change_bytes, flip_bit, take_out, double, cut,
           replace(rb"(?<![\w.])-?\d[\d.e+-]*", NUMBERS),
           replace(rb"(?<![\w.])-?\d[\d.e+-]*", NUMBERS),
           replace(rb"\b[A-Za-z]\w+", None))


def keys(text):
    """Words that may be the name of an entry, or a line's number."""
    return set(re.findall(r"[A-Za-z]\w+", text)) - {"FoamFile", "version"}


def names_place(message, path, text):
    """Has the error the file, and an entry of it or a line?"""
    # A sound value of which the run itself has to stop: the cure is named
    if "Take a smaller deltaT" in message or "take a smaller deltaT" in message:
        return True
    # What an outline's points make is told of the dictionary that names it
    if path == "points.csv" and "seedObjectsDict" in message:
        return ("'shape'" in message or "shapes" in message
                or "(ball of placement balls" in message)
    # Sound files of another mesh: it is named, with a cell or a patch of it
    if path.endswith(tuple(MESH)) and re.search(
            r"polyMesh.*(cell \d+ with centre|has a face at)", message, re.S):
        return True
    if os.path.basename(path) not in message:
        return False
    return bool(re.search(r"\bline \d+|\bat line|\bheader\b", message)
                or keys(text) & set(re.findall(r"[A-Za-z]\w+", message)))


def outcome(case, path, program, ranks):
    """What a program does with the case: a word and the end of its log."""
    command = [program, "-case", case]
    if ranks > 1:
        command = ["mpirun", "--oversubscribe", "-np", str(ranks), *command,
                   "-parallel"]
    with open(os.path.join(case, "log"), "wb") as log:
        try:
            status = subprocess.run(
                command, stdout=log, stderr=log, timeout=60,
                check=False).returncode
        except subprocess.TimeoutExpired:
            return "endless", ""
    with open(os.path.join(case, "log"), encoding="utf-8",
              errors="replace") as stream:
        log = stream.read()
    start = log.find("--> FOAM FATAL")
    message = log[start:] if start >= 0 else log[-600:]
    if status < 0 or status >= 128 or "exited on signal" in log:
        return "signal", message
    if status == 0 or "Objects are not sound" in log:
        return "accepted", ""
    with open(os.path.join(case, path), encoding="utf-8",
              errors="replace") as stream:
        text = stream.read()
    clear = start >= 0 and names_place(message, path, text)
    return ("clear" if clear else "unclear"), message


def go_on(case):
    """Writes a case's first time, from which it then starts."""
    case.set_up()
    case.run("fsiPisoFoam")
    case.control(startFrom="latestTime", endTime=0.03, writeInterval=100)


def flat_case(folder, write_format, ranks=1):
    """Discs, membranes and a moved polygon, with their first time written; its
    folder, what runs on which of its files, and on how many ranks. On several
    ranks the files are those of the first rank and of the last one."""
    case = fsiCase.Case(
        os.path.join(folder, f"{write_format}{ranks}"), cells=(20, 20),
        deltaT=0.01,
        endTime=TIME, writeInterval=2, walls={"top": "(1 0 0)"},
        shapes=SHAPES, placements=PLACEMENTS, properties=PROPERTIES,
        writeFormat=write_format)
    for name, text in TABLES.items():
        with open(os.path.join(case.path, name), "w",
                  encoding="ascii") as stream:
            stream.write(text)
    go_on(case)
    if ranks == 1:
        return case.path, PROGRAMS, 1
    case.decompose(ranks, 1, options=("-latestTime",))
    files = [f"processor0/{f}" for f in STATE]
    files += [*SHAPE_FILES, "constant/fsiProperties"]
    files += [f"processor{ranks - 1}/{f}"
              for f in MESH + [f"{TIME}/p", f"{TIME}/U"]]
    return case.path, dict.fromkeys(files, "fsiPisoFoam"), ranks


def solid_case(folder):
    """A body from a surface file, in three dimensions."""
    case = fsiCase.Case(
        os.path.join(folder, "solid"), box=(0, 0, 0, 1, 1, 1),
        cells=(10, 10, 10), deltaT=0.01, endTime=TIME, writeInterval=2,
        walls={"top": "(1 0 0)"}, shapes=BODY,
        placements="a { type listed; shape body; "
        "objects ({ centre (0.5 0.5 0.5); }); }")
    corners = [tuple(0.35*s*(i == axis) for i in range(3))
               for axis in range(3) for s in (1, -1)]
    with open(os.path.join(case.path, "body.stl"), "w",
              encoding="ascii") as stream:
        stream.write("solid body\n" + "".join(
            "facet normal 0 0 0\nouter loop\n" + "".join(
                "vertex {} {} {}\n".format(*corners[c]) for c in
                ((a, b, c) if (a + b + c) % 2 == 0 else (a, c, b)))
            + "endloop\nendfacet\n"
            for a in (0, 1) for b in (2, 3) for c in (4, 5)) + "endsolid\n")
    go_on(case)
    return case.path, {
        "body.stl": "seedObjects", "constant/fsiObjects/body": "fsiPisoFoam",
        f"{TIME}/uniform/fsiObjects/body": "fsiPisoFoam"}, 1


def one(cases, folder, dice):
    """One damaged file; its outcome, a description and the message."""
    case, programs, ranks = dice.choice(cases)
    path = dice.choice(list(programs))
    wrong = os.path.join(folder, "wrong")
    shutil.rmtree(wrong, ignore_errors=True)
    shutil.copytree(case, wrong)
    file = os.path.join(wrong, path)
    with open(file, "rb") as stream:
        data = stream.read()
    bare = ("/fsi" in path and "fsiProperties" not in path
            and dice.random() < 0.5)
    if bare:
        data = results.without_sums(data.decode("latin1")).encode("latin1")
    change = dice.choice(CHANGES)
    with open(file, "wb") as stream:
        stream.write(change(data, dice))
    if programs[path] == "seedObjects":
        # It would not drop the objects of a run
        shutil.rmtree(os.path.join(wrong, TIME))
    word, message = outcome(wrong, path, programs[path], ranks)
    return (word, f"{path} {change.__name__}"
            f"{' without sums' if bare else ''} on {ranks} ranks", message)


def main(folder, count=200, seed=1):
    """The damaged files."""
    report = fsiCase.Report()
    formats = ("ascii", "binary")
    cases = (3*[flat_case(folder, f) for f in formats] + [solid_case(folder)]
             + [flat_case(folder, f, n) for f in formats for n in (2, 3)])
    dice = random.Random(int(seed))
    counts = dict.fromkeys(
        ("accepted", "clear", "unclear", "signal", "endless"), 0)
    for i in range(int(count)):
        word, name, message = one(cases, folder, dice)
        counts[word] += 1
        if word in ("unclear", "signal", "endless"):
            print(f"    {i}: {word}: {name}: {' '.join(message.split())[:300]}",
                  flush=True)
            keep = os.environ.get("FSI_KEEP")
            if keep:
                shutil.move(os.path.join(folder, "wrong"),
                            os.path.join(folder, f"{word}{i}"))
    print("    " + ", ".join(f"{n} {word}" for word, n in counts.items()))
    errors = counts["clear"] + counts["unclear"]
    report.check("no signal", counts["signal"] == 0, str(counts))
    report.check("no endless run", counts["endless"] == 0, str(counts))
    report.check("98 % of the errors name file and entry",
                 counts["unclear"] <= max(0.02*errors, 1), str(counts))


if __name__ == "__main__":
    main(*sys.argv[1:])
