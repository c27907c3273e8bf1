# SPDX-License-Identifier: GPL-3.0-or-later
"""Rules of etc/checkStyle that need all files of src at once.

circles     No circle of folders: a folder that includes a header of another
            one, over however many steps, is not included by it.
ranks       Only the files below know of messages between ranks (Pstream, or
            OpenFOAM's functions that all ranks must call).
collectives A call that all ranks must make stands in no loop and no branch over
            something of which each rank has its own number: patches, cells,
            faces. What this does not see collectiveCalls finds in a run.
sizes       A class, its header and its sources together, has at most 600
            lines; a folder has at most 25 headers and sources.
places      A folder of tests has the name of the folder of src that it tests,
            but for those with what tests share.

Each takes a dictionary of texts by path and yields (path, line, what).
"""

import collections
import os
import re

MAX_CLASS = 600
MAX_FOLDER = 25

# Folders of tests with what tests share
SHARED = ("samples", "boxMesh")

# Files and folders that may send messages between ranks; all others call
# their functions
RANKS = (
    "src/fastPoisson/lattice/",
    "src/FSIObjects/cartesianMesh/",
    "src/compatibility/openfoamCase.H",
    "src/compatibility/openfoamRanks.H",
    "src/FSIObjects/output/",
    "src/FSIObjects/population/ranks/",
)

INCLUDE = re.compile(r'^\s*#\s*include\s+"([^"]+)"')
MESSAGES = re.compile(
    r"\b(?:(?:U|I|O|UI|UO|UIO)?Pstream\w*"
    r"|syncTools\b|(?:reduce|returnReduce\w*|g(?:Sum|Max|Min|Average)\w*)"
    r"(?=\s*\())")

# What all ranks must call, and what they have different numbers of
COLLECTIVE = re.compile(
    r"\b(?:\w*[oO]verRanks|collect|swapCoupled\w+|syncCoupledFaces"
    r"|fillFromNeighbours|correctBoundaryConditions)\s*\(")
LOCAL = re.compile(
    r"\b(?:patch(?:es|i)?|boundary(?:Field|FieldRef|Mesh)?|n?[cC]ells|celli"
    r"|n?[fF]aces|facei|nInternalFaces)\b")


def sources_of(texts):
    """The C++ files of src."""
    return {path: text for path, text in texts.items()
            if path.startswith("src/") and path.endswith((".C", ".H"))}


def includes(text):
    """Yields (line number, name) of the headers that a text includes."""
    for number, line in enumerate(text.split("\n"), 1):
        match = INCLUDE.match(line)
        if match:
            yield number, os.path.basename(match.group(1))


def folder_graph(texts):
    """Of each folder the others that it includes, with the first place."""
    homes = {}
    for path in sorted(texts):
        homes.setdefault(os.path.basename(path), os.path.dirname(path))
    graph = {folder: {} for folder in homes.values()}
    for path in sorted(texts):
        here = os.path.dirname(path)
        for number, name in includes(texts[path]):
            beside = os.path.join(here, name) in texts
            there = here if beside else homes.get(name, here)
            if there != here:
                graph.setdefault(here, {}).setdefault(
                    there, (path, number, name))
    return graph


def shortest_circle(graph, start):
    """Folders from start to where it is included again; [] if none."""
    before, row = {}, [start]
    while row:
        following = []
        for here in row:
            for there in sorted(graph.get(here, ())):
                if there == start:
                    circle = [here]
                    while circle[0] != start:
                        circle.insert(0, before[circle[0]])
                    return circle
                if there not in before:
                    before[there] = here
                    following.append(there)
        row = following
    return []


def circles(texts):
    """No circle of folders; each shortest one is told once."""
    graph = folder_graph(sources_of(texts))
    told = set()
    for start in sorted(graph):
        circle = shortest_circle(graph, start)
        if not circle or told & set(circle):
            continue
        told |= set(circle)
        steps = [(a, graph[a][b])
                 for a, b in zip(circle, circle[1:] + circle[:1])]
        way = "; ".join(f"{path}:{number} includes {name}"
                        for _, (path, number, name) in steps)
        path, number, _ = steps[0][1]
        names = " -> ".join(circle + circle[:1])
        yield path, number, f"circle of folders {names}: {way}"


def without_comments(text):
    """C++ text with comments blanked, lines kept."""
    return re.sub(r"//[^\n]*|/\*.*?\*/",
                  lambda m: re.sub(r"[^\n]", " ", m.group()), text, flags=re.S)


def ranks(texts):
    """Messages between ranks in the files named above only."""
    for path, text in sorted(sources_of(texts).items()):
        if path.startswith(RANKS):
            continue
        for number, line in enumerate(without_comments(text).split("\n"), 1):
            match = MESSAGES.search(line)
            if match:
                yield path, number, (
                    f"{match.group()}: messages between ranks belong in the "
                    "files that etc/houseRules.py names")
                break


def heads(text):
    """Yields (position, heads of the loops and branches around it) of each
    collective call in a C++ text without comments."""
    calls = {match.start() for match in COLLECTIVE.finditer(text)}
    stack, start, depth = [], 0, 0
    for place, char in enumerate(text):
        if char in "()":
            depth += 1 if char == "(" else -1
        elif char == "{":
            stack.append((text[start:place], depth))
            start, depth = place + 1, 0
        elif char == "}" and stack:
            depth = stack.pop()[1]
            start = place + 1
        elif char == ";" and depth == 0:
            start = place + 1
        if place in calls:
            yield place, [head for head, _ in stack
                          if re.match(r"\s*(?:for|forAll|while|if|else)\b",
                                      head)]


def collectives(texts):
    """No collective call in a loop or branch that may differ on ranks."""
    for path, text in sorted(sources_of(texts).items()):
        text = without_comments(text)
        for place, around in heads(text):
            for head in around:
                local = LOCAL.search(head)
                if local:
                    yield path, text.count("\n", 0, place) + 1, (
                        "a call that all ranks must make, in a loop or branch "
                        f"over what each rank has its own number of: "
                        f"{local.group()}")
                    break


def files_of_class(texts, header):
    """A header, what belongs to its name, and what its SourceFiles list."""
    base = header[:-2]
    names = {base + ".C", base + "I.H"}
    for listed in texts[header].split("SourceFiles")[1:2]:
        folder = os.path.dirname(header)
        names |= {os.path.join(folder, word)
                  for word in listed.split("*/")[0].split()
                  if word.endswith((".C", ".H"))}
    return [header] + sorted(n for n in names - {header} if n in texts)


def sizes(texts):
    """At most so many lines per class."""
    texts = sources_of(texts)
    for header in sorted(p for p in texts if p.endswith(".H")):
        base = header[:-2]
        if base.endswith("I") and base[:-1] + ".H" in texts:
            continue
        files = files_of_class(texts, header)
        length = sum(texts[path].count("\n") for path in files)
        name = os.path.basename(base)
        if length > MAX_CLASS:
            names = ", ".join(os.path.basename(path) for path in files)
            yield header, 1, (f"{name} has {length} lines in {names} "
                              f"(at most {MAX_CLASS})")


def folders(texts):
    """At most so many headers and sources in a folder."""
    counts = collections.Counter(map(os.path.dirname, sources_of(texts)))
    for folder, count in sorted(counts.items()):
        if count > MAX_FOLDER:
            first = min(p for p in texts if os.path.dirname(p) == folder)
            yield first, 1, (f"{folder} has {count} headers and sources "
                             f"(at most {MAX_FOLDER})")


def places(texts):
    """Tests stand in folders with the names of those that they test."""
    known = {part for path in sources_of(texts)
             for part in os.path.dirname(path).split("/")}
    for path in sorted(texts):
        parts = path.split("/")
        if (parts[0] == "tests" and parts[1] in ("unit", "mesh")
                and path.endswith(".C") and len(parts) > 3
                and parts[2] not in known and parts[2] not in SHARED):
            yield path, 1, (f"{'/'.join(parts[:3])} tests no folder of src: "
                            "it needs the name of one")


def check(texts):
    """All of them."""
    for rule in (circles, ranks, collectives, sizes, folders, places):
        yield from rule(texts)
