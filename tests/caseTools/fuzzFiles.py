#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Damaged surfaces and tables: seedObjects must make of them what they say, or
end in an error that names the file.

    fuzzFiles.py FOLDER [N [SEED]]

A surface (STL of text and binary, OBJ, OFF) or a table (places, points) gets
one to three of the faults of fuzz.py, or one of its lines goes, comes twice or
changes places with another. What is accepted is read here as well, in another
way: the volume or area and the number of objects must be the same.
"""

import csv
import os
import random
import re
import struct
import subprocess
import sys

import fsiCase
import fuzz

POINTS = [tuple(0.35*s*(i == axis) for i in range(3))
          for axis in range(3) for s in (1, -1)]
FACES = [(a, b, c) if (a + b + c) % 2 == 0 else (a, c, b)
         for a in (0, 1) for b in (2, 3) for c in (4, 5)]

SURFACES = {
    "text.stl": "".join(
        f"solid part {part}\n" + "".join(
            "  facet normal 0 0 0\n    outer loop\n" + "".join(
                "      vertex {} {} {}\n".format(*POINTS[c]) for c in face)
            + "    endloop\n  endfacet\n" for face in FACES[part::2])
        + f"endsolid part {part}\n" for part in (0, 1)).encode(),
    "binary.stl": b"solid but binary".ljust(80) + struct.pack("<I", 8)
    + b"".join(struct.pack("<12fH", 0, 0, 0, *(x for c in face
                                               for x in POINTS[c]), 0)
               for face in FACES),
    "body.obj": ("# body\no body\n" + "".join(
        "v {} {} {}\n".format(*p) for p in POINTS) + "vn 0 0 1\n" + "".join(
            "f {}//1 {}//1 {}//1\n".format(*(
                c + 1 if i % 2 else c - 6 for c in face))
            for i, face in enumerate(FACES))).encode(),
    "body.off": ("OFF\n6 8 0\n" + "".join(
        "{} {} {}\n".format(*p) for p in POINTS) + "".join(
            "3 {} {} {}\n".format(*face) for face in FACES)).encode(),
}
PLACES = (b"x,y,rotation,velocityX,shape\n0.2,0.2,30,1,a\n0.6,0.2,0,0.5,b\n"
          b"0.2,0.6,-10,0,a\n0.6,0.6,0,-1e-3,b\n")
OUTLINE = b"0,0\n0.15,0\n0.16,0.1\n0.1,0.15\n0,0.12\n"
TABLES = {"places.csv": PLACES,
          "excel.csv": b"\xef\xbb\xbf" + PLACES.replace(b",", b";").replace(
              b"\n", b"\r\n"),
          "outline.csv": OUTLINE,
          "outline.dat": b"AN OUTLINE\n" + OUTLINE.replace(b",", b"  ")}


def change_lines(data, dice):
    """A line goes, comes twice or changes places with another."""
    lines = data.splitlines(True)
    i, j = dice.randrange(len(lines)), dice.randrange(len(lines))
    what = dice.randrange(3)
    if what == 0:
        del lines[i]
    elif what == 1:
        lines.insert(j, lines[i])
    else:
        lines[i], lines[j] = lines[j], lines[i]
    return b"".join(lines)


def triangles_of(name, data):
    """Points of all triangles of a surface file."""
    if name == "binary.stl":
        flat = [struct.unpack_from("<9f", data, at + 12)
                for at in range(84, len(data) - 49, 50)]
        return [(t[:3], t[3:6], t[6:]) for t in flat]
    text = data.decode("latin1")
    if name == "text.stl":
        # Titles of solids and normals may be any words, "vertex" as well
        text = re.sub(r"(?im)^(.*?)\b(end)?solid\b.*$|\bfacet([ \t]+\S+){0,4}",
                      r"\1", text)
        flat = [tuple(map(float, m)) for m in re.findall(
            r"(?i)\bvertex\s+(\S+)\s+(\S+)\s+(\S+)", text)]
        return list(zip(flat[::3], flat[1::3], flat[2::3]))
    rows = [r.split("#")[0].split() for r in text.splitlines()]
    rows = [r for r in rows if r]
    if name == "body.obj":
        points, faces = [], []
        for row in rows:
            if row[0] == "v":
                points.append(tuple(map(float, row[1:4])))
            elif row[0] == "f":
                faces.append([int(w.split("/")[0]) for w in row[1:]])
                faces[-1] = [c - 1 if c > 0 else c + len(points)
                             for c in faces[-1]]
    else:
        n = int(rows[1][0])
        points = [tuple(map(float, r[:3])) for r in rows[2:2 + n]]
        faces = [list(map(int, r[1:1 + int(r[0])])) for r in rows[2 + n:]]
    return [(points[f[0]], points[f[i]], points[f[i + 1]])
            for f in faces for i in range(1, len(f) - 1)]


def volume(triangles):
    """Volume within triangles; those that come twice count once."""
    def key(t):
        i = t.index(min(t))
        return t[i:] + t[:i]
    return abs(sum(
        a[0]*(b[1]*c[2] - b[2]*c[1]) + a[1]*(b[2]*c[0] - b[0]*c[2])
        + a[2]*(b[0]*c[1] - b[1]*c[0])
        for a, b, c in {key(t) for t in triangles})/6)


def rows_of(data):
    """Values of the lines of a table."""
    text = data.decode("latin1").replace("\xef\xbb\xbf", "")
    lines = [r.split("#")[0].strip() for r in re.split(r"\r\n?|\n", text)]
    lines = [r for r in lines if r]
    for separator in ";,":
        if 2*sum(separator in r for r in lines) >= len(lines):
            return [[v.strip() for v in r] for r in csv.reader(
                lines, delimiter=separator)]
    return [r.split() for r in lines]


def area(data):
    """Area of an outline."""
    points = [(float(r[0]), float(r[1])) for r in rows_of(data)
              if r[0][0] in "+-.0123456789"]
    return abs(sum(a[0]*b[1] - a[1]*b[0] for a, b in zip(
        points, points[1:] + points[:1]))/2)


def is_right(name, data, log):
    """Is what seedObjects says of a file what it holds?"""
    sizes = re.findall(r": (\d+) objects of .* (?:area|volume) (\S+) m", log)
    try:
        if name in SURFACES:
            expected = volume(triangles_of(name, data))
        elif name.startswith("outline"):
            expected = area(data)
        else:
            rows = rows_of(data)
            return (sum(int(n) for n, _ in sizes) == len(rows) - 1
                    and all(len(r) == len(rows[0]) for r in rows))
    except (ValueError, IndexError, struct.error):
        return False
    return abs(float(sizes[0][1]) - expected) <= 1e-4*expected


def outcome(case, name, data):
    """What seedObjects makes of a file: a word and the end of its log."""
    path = os.path.join(case, name)
    with open(path, "wb") as stream:
        stream.write(data)
    try:
        done = subprocess.run(
            ["seedObjects", "-case", case, "-dict", f"system/{name}.dict"],
            stdout=subprocess.PIPE, stderr=subprocess.STDOUT, timeout=40,
            check=False)
    except subprocess.TimeoutExpired:
        return "endless", ""
    log = done.stdout.decode("utf-8", "replace")
    start = log.find("--> FOAM FATAL")
    message = log[start:] if start >= 0 else log[-600:]
    if done.returncode < 0 or done.returncode >= 128:
        return "signal", message
    if done.returncode == 0:
        return ("accepted" if is_right(name, data, log) else "wrong"), message
    # A shape that does not suit the mesh is told by its dictionary
    clear = start >= 0 and (name in message or "'shape'" in message)
    return ("clear" if clear else "unclear"), message


def make_cases(folder):
    """Cases in space and in the plane, with a dictionary for each file; what is
    in the files, by folder."""
    rigid = "material { type rigid; density 1; }"
    place = "a {{ type listed; shape a; objects ({{ centre ({}); }}); }}"
    found = {}
    for names, cells in ((SURFACES, (8, 8, 8)), (TABLES, (20, 20))):
        case = fsiCase.Case(os.path.join(folder, f"case{len(cells)}"),
                            box=(0,)*len(cells) + (1,)*len(cells),
                            cells=cells)
        case.run("blockMesh")
        for name in names:
            shapes = f'a {{ shape {{ type surface; file "{name}"; }} {rigid} }}'
            places = place.format("0.5 0.5 0.5")
            if name.startswith("outline"):
                shapes = shapes.replace("surface", "polygon")
                places = place.format("0.5 0.5 0")
            elif name in TABLES:
                shapes = "".join(
                    f"{s} {{ shape {{ type circle; radius 0.1; }} {rigid} }}\n"
                    for s in "ab")
                places = f'a {{ type csv; shape a; file "{name}"; }}'
            case.file(f"system/{name}.dict", f"shapes\n{{\n{shapes}\n}}\n"
                      f"placements\n{{\n{places}\n}}\n")
        found[case.path] = names
    return found


def main(folder, count=200, seed=1):
    """The damaged files."""
    report = fsiCase.Report()
    cases = make_cases(folder)
    for case, names in cases.items():
        for name, data in names.items():
            word, message = outcome(case, name, data)
            report.check(f"{name} is read", word == "accepted",
                         f"{word}: {' '.join(message.split())[:300]}")
    dice = random.Random(int(seed))
    counts = dict.fromkeys(
        ("accepted", "clear", "unclear", "signal", "endless", "wrong"), 0)
    for i in range(int(count)):
        case, names = dice.choice(list(cases.items()))
        name = dice.choice(list(names))
        data = names[name]
        for change in dice.choices(fuzz.CHANGES + 3*(change_lines,),
                                   k=dice.choice((1, 1, 2, 3))):
            data = change(data, dice) if data else data
        word, message = outcome(case, name, data)
        counts[word] += 1
        if word not in ("accepted", "clear"):
            print(f"    {i}: {word}: {name}: "
                  f"{' '.join(message.split())[:300]}", flush=True)
            if os.environ.get("FSI_KEEP"):
                with open(os.path.join(folder, f"{word}{i}{name}"),
                          "wb") as stream:
                    stream.write(data)
    print("    " + ", ".join(f"{n} {word}" for word, n in counts.items()))
    for word in ("signal", "endless", "wrong", "unclear"):
        report.check(f"no file ends {word}", counts[word] == 0, str(counts))


if __name__ == "__main__":
    main(*sys.argv[1:])
