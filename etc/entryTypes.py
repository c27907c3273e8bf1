#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Type and range of a dictionary's entry, from the call that reads it."""

import os
import re

# Calls that read a value, with what they demand of it; {0}, {1}: arguments
# after the default
READERS = {
    "readPositive": ("number", "> 0"),
    "readNonNegative": ("number", ">= 0"),
    "readScalarBetween": ("number", "{0} to {1}"),
    "readBetween": ("whole number", "{0} to {1}"),
    "readAtLeast": ("whole number", ">= {0}"),
    "readFinite": ("vector", ""),
    "readLengths": ("vector", "> 0"),
    "readChoice": ("word", ""),
    "readName": ("word", ""),
    "readAngle": ("number", ""),
    "readMatrix": ("numbers", ""),
    "readField": ("numbers", ""),
    "readFunction": ("function of time", ""),
}
TYPES = {
    "scalar": "number", "label": "whole number", "Switch": "yes or no",
    "bool": "yes or no", "word": "word", "vector": "vector",
    "vector2D": "two numbers", "fileName": "file name",
    "boundBox": "two corners", "wordList": "words",
    "labelList": "whole numbers", "scalarField": "numbers",
    "pointField": "vectors", "quaternion": "quaternion",
}

# Entries that no single call reads
OTHERS = {
    "type": "word", "restCurvature": "number or word",
    "counts": "whole numbers", "areaFraction": "number",
    "size": "dictionary", "shapes": "names with numbers",
    "quaternion": "quaternion", "objects": "list of dictionaries",
    "motions": "list of dictionaries",
    "file": "file name",
    "centre": "vector", "faces": "whole numbers", "elements": "whole numbers",
    "libs": "file names", "U": "word", "p": "word", "simulationType": "word",
    "transportModel": "word", "follow": "whole number or all",
}
# Entries whose type in one class is not that of the call that reads them
OWN = {
    ("shapeParts", "shapes"): ("names with numbers", ""),
    ("shapeClasses", "density"): ("dictionary", ""),
    ("shapeClasses", "E"): ("dictionary", ""),
    ("shapeClasses", "size"): ("dictionary", ""),
    ("surfaceFile", "piece"): ("whole number or all", ">= 1"),
}


def arguments(text, start):
    """Arguments of the call whose bracket opens at start."""
    depth, out, word = 0, [], ""
    for char in text[start:]:
        if char in "([{":
            depth += 1
            if depth == 1:
                continue
        elif char in ")]}":
            depth -= 1
            if depth == 0:
                return [*out, word.strip()]
        if char == "," and depth == 1:
            out.append(word.strip())
            word = ""
        else:
            word += char
    return out


def reads(text):
    """Yields name, type and range of each entry that a source reads."""
    call = r"\b(read[A-Z]\w*|getEntry)\s*(?:<(\w+)>\s*)?\("
    for match in re.finditer(call, text):
        name, kind = match.groups()
        values = arguments(text, match.end() - 1)
        if len(values) < 2 or not re.fullmatch(r'"\w+"', values[1]):
            continue
        key = values[1].strip('"')
        if name in READERS:
            what, limits = READERS[name]
            limits = limits.format(*values[3:], "", "")
            yield key, what, limits.replace("-GREAT to GREAT", "")
        elif kind in TYPES:
            yield key, TYPES[kind], ""
    call = (r"(?:get|lookupOrDefault|getOrDefault|lookup)\s*<(\w+)>"
            r"\s*\(\s*\"(\w+)\"")
    for kind, key in re.findall(call, text):
        if kind in TYPES:
            yield key, TYPES[kind], ""
    for key in re.findall(r"[sS]ub\w*Dict\w*\s*\(\s*\"(\w+)\"", text):
        yield key, "dictionary", ""


class Types:
    """Types of all entries, from the sources' texts by path."""

    def __init__(self, texts):
        self.reads_ = {path: list(reads(text)) for path, text in texts.items()}

    def of(self, path, name):
        """Type and range of an entry in a header's table: from the sources of
        its class, else of its folder, else from any."""
        folder, base = os.path.dirname(path), os.path.basename(path)[:-2]

        def distance(source):
            near = os.path.dirname(source) == folder
            return (not (near and os.path.basename(source).startswith(base)),
                    not near)

        if (base, name) in OWN:
            return OWN[(base, name)]
        if name == "rotation" and path.startswith(
                ("src/FSIObjects", "src/FSISeeding")):
            return "angle or dictionary", ""
        for source in sorted(self.reads_, key=distance):
            for key, kind, limits in self.reads_[source]:
                if key == name:
                    return kind, limits
        return OTHERS.get(name, ""), ""
