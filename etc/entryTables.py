# SPDX-License-Identifier: GPL-3.0-or-later
"""The tables of entries in the project's headers, and the names that they point
to."""

import os
import re

ROOT = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
FOLDERS = ("src/kernels", "src/FSIObjects", "src/FSISeeding", "src/FSIThesis",
           "src/FSIStock", "src/fastPoisson")


def read(path):
    with open(os.path.join(ROOT, path), encoding="utf-8") as file:
        return file.read()


def files_of(ending):
    """Paths of all headers or sources, from the root, without links to them."""
    for folder in FOLDERS:
        for here, names, files in os.walk(os.path.join(ROOT, folder)):
            names[:] = sorted(n for n in names
                              if n not in ("lnInclude", "Make"))
            for name in sorted(files):
                if name.endswith(ending):
                    yield os.path.relpath(os.path.join(here, name), ROOT)


def rows_of(block):
    """Rows of a \\table block: cells may go on in the next line."""
    bar = r"(?<!\\)\|"
    lines = [line.rstrip("\\").strip() for line in block.split("\n")]
    lines = [line for line in lines if line]
    width = len(re.findall(bar, lines[0]))
    rows = []
    for line in lines:
        bars = len(re.findall(bar, " ".join(rows[-1:])))
        if rows and (bars < width or not re.search(bar, line)):
            rows[-1] += " " + line
        else:
            rows.append(line)
    return [[cell.strip() for cell in re.split(bar, row)] for row in rows]


def tables(text):
    """Tables of entries in a header, each with the line that introduces it."""
    for match in re.finditer(r"\\table\n(.*?)\\endtable", text, re.S):
        rows = rows_of(match.group(1))
        if rows and rows[0][0].startswith(("Property", "Entry")):
            before = text[:match.start()].rstrip(" ")
            title = re.split(r"\n\s*\n|Usage\n|endtable\n|endverbatim\n",
                             before)[-1]
            rest = text[match.end():]
            after = re.split(r"\n\s*\n|\\(?:verbatim|table)|SourceFiles",
                             rest)[0]
            if rest[len(after):].startswith("\\table"):
                # It introduces the next table
                after = ""
            yield plain(title), rows, plain(after)


def plain(text):
    """A paragraph of a header as one line of Markdown."""
    text = re.sub(r"\\c (\S+?)([,.:]?)(?=\s|$)", r"`\1`\2", text)
    return re.sub(r"\\([<>|])", r"\1", " ".join(text.split()))


def headers():
    """Path of each header by its name."""
    return {os.path.basename(path)[:-2]: path for path in files_of(".H")}


# Names that a table or the lines around it send a reader to
POINTER = re.compile(r"\b([Ss]ee |entries of |those of )"
                     r"(?!above|below|the )"
                     r"((?:(?!or\b|and\b|for\b)`?\w+`?(?:\.H)?(?:, |$|\b))+)")


def pointers(text):
    """Names that a text points to."""
    for _, names in POINTER.findall(text):
        yield from re.findall(r"\w{2,}", names.replace(".H", ""))
