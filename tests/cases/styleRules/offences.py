#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""A small tree of sources in which etc/checkStyle finds nothing, and the same
with one offence at a time, which it refuses by file and line.

    offences.py FOLDER
"""

import os
import subprocess
import sys

import fsiCase

ETC = os.path.join(os.path.dirname(os.path.abspath(__file__)), "../../../etc")
CHECK = os.path.join(ETC, "checkStyle")
SPDX = "// SPDX-License-Identifier: GPL-3.0-or-later\n"


def header(name, includes=(), sources=(), lines=0):
    """A header with a class."""
    listed = "".join(f"    {s}\n" for s in sources)
    text = SPDX + f"/*\nSourceFiles\n{listed}*/\n"
    text += "".join(f'#include "{i}"\n' for i in includes)
    return text + f"class {name}\n{{\n" + "    //-\n"*lines + "};\n"


def body(lines):
    """A function."""
    return SPDX + "void f()\n{\n" + "    g();\n"*lines + "}\n"


def large_class(lines):
    """A class of so many lines in three files."""
    return {
        "src/kernels/low/low.H":
            header("low", sources=["lowMore.C"], lines=242),
        "src/kernels/low/low.C": SPDX + "\n"*174,
        "src/kernels/low/lowMore.C": SPDX + "\n"*(lines - 426),
    }


# A message in a comment is none, and one in the lattice is allowed
TREE = {
    "src/kernels/low/low.H": header("low", sources=["lowMore.C"]),
    "src/kernels/low/low.C": SPDX + '#include "low.H"\n// Pstream\n',
    "src/kernels/low/lowMore.C": SPDX + '#include "low.H"\n',
    "src/kernels/middle/middle.H": header("middle", ["low.H"]),
    "src/FSIObjects/high/high.H": header("high", ["middle.H", "low.H"]),
    "src/FSIObjects/high/high.C": body(60),
    "src/fastPoisson/lattice/ranks.H":
        SPDX + '#include "Pstream.H"\n' + header("ranks"),
    "etc/script.py": "# SPDX-License-Identifier: GPL-3.0-or-later\nx = 1\n",
}

# Name, files in place of those of the tree, start of the line printed, and
# what else it says
OFFENCES = [
    ("circle of two folders",
     {"src/kernels/low/low.H": header("low", ["high.H"], ["lowMore.C"])},
     "src/FSIObjects/high/high.H:6:",
     ["circle of folders src/FSIObjects/high -> src/kernels/low -> "
      "src/FSIObjects/high:",
      "src/kernels/low/low.H:6 includes high.H"]),
    ("circle of three folders, by a source",
     {"src/FSIObjects/high/high.H": header("high", ["middle.H"]),
      "src/kernels/low/lowMore.C": SPDX + '#include "high.H"\n'},
     "src/FSIObjects/high/high.H:5:",
     ["src/FSIObjects/high -> src/kernels/middle -> src/kernels/low -> ",
      "src/kernels/low/lowMore.C:2 includes high.H",
      "src/kernels/middle/middle.H:5 includes low.H"]),
    ("message between ranks",
     {"src/FSIObjects/high/high.C": body(3) + "int n = Pstream::nProcs();\n"},
     "src/FSIObjects/high/high.C:8:", ["Pstream", "etc/houseRules.py"]),
    ("header of messages",
     {"src/kernels/low/low.C": SPDX + '#include "PstreamReduceOps.H"\n'},
     "src/kernels/low/low.C:2:", ["PstreamReduceOps", "etc/houseRules.py"]),
    ("sum over ranks in a loop over cells",
     {"src/kernels/low/low.C": SPDX + "void f()\n{\n    forAll(cells, celli)\n"
                               "    {\n        part.collect();\n    }\n}\n"},
     "src/kernels/low/low.C:6:", ["all ranks must make", "cells"]),
    ("class of 601 lines", large_class(601),
     "src/kernels/low/low.H:1:",
     ["low has 601 lines in low.H, low.C, lowMore.C (at most 600)"]),
    ("folder of 26 files",
     {f"src/kernels/wide/w{i:02}.H": header(f"w{i:02}") for i in range(26)},
     "src/kernels/wide/w00.H:1:", ["26 headers and sources (at most 25)"]),
    ("tests of no folder", {"tests/unit/wide/testWide.C": SPDX},
     "tests/unit/wide/testWide.C:1:", ["tests/unit/wide", "no folder of src"]),
    ("file of 301 lines", {"src/kernels/low/low.C": SPDX + "\n"*300},
     "src/kernels/low/low.C:301:", ["301 lines"]),
    ("function of 61 lines", {"src/FSIObjects/high/high.C": body(61)},
     "src/FSIObjects/high/high.C:3:", ["function f has 61 lines"]),
    ("Python function of 61 lines",
     {"etc/script.py": "# SPDX-License-Identifier: GPL-3.0-or-later\n"
                       "def f():\n" + "    g()\n"*61},
     "etc/script.py:2:", ["function f has 61 lines"]),
    ("line of 81 columns",
     {"src/kernels/low/low.C": SPDX + "x"*81 + "\n"},
     "src/kernels/low/low.C:2:", ["81 columns"]),
    ("comment that leans on the one before",
     {"src/kernels/low/low.C":
          SPDX + "//- Radius\nint a;\n//- The same of\n//  b\nint b;\n"},
     "src/kernels/low/low.C:4:", ["'The same'", "say of what"]),
    ("description without a subject",
     {"src/kernels/low/low.C":
          SPDX + "/*\nDescription\n    What is low\n*/\nint a;\n"},
     "src/kernels/low/low.C:4:", ["'What is'"]),
    ("comment without a subject",
     {"src/kernels/low/low.C": SPDX + "int a;\n\n    // Of a disc\n"},
     "src/kernels/low/low.C:4:", ["'Of a'"]),
    ("tab", {"src/kernels/low/low.C": SPDX + "x\ty\n"},
     "src/kernels/low/low.C:2:", ["tab"]),
    ("trailing blank", {"src/kernels/low/low.C": SPDX + "x \n"},
     "src/kernels/low/low.C:2:", ["trailing blank"]),
    ("script that cannot be run",
     {"tutorials/one/Allrun":
          "#!/bin/bash\n# SPDX-License-Identifier: GPL-3.0-or-later\n"},
     "tutorials/one/Allrun:1:", ["not executable"]),
    ("no licence", {"src/kernels/low/low.C": "\n"},
     "src/kernels/low/low.C:1:", ["no SPDX identifier"]),
    ("two classes in a header",
     {"src/kernels/middle/middle.H": header("middle") + "class other\n{\n};\n"},
     "src/kernels/middle/middle.H:1:", ["2 classes", "other"]),
    ("class in a file of another name",
     {"src/kernels/middle/middle.H": header("other")},
     "src/kernels/middle/middle.H:", ["class other in a file named middle"]),
    ("source without a header",
     {"src/kernels/low/alone.C": SPDX},
     "src/kernels/low/alone.C:1:", ["no alone.H"]),
    ("test of the version in a source",
     {"src/kernels/low/low.C": SPDX + "#if OPENFOAM > 2000\n#endif\n"},
     "src/kernels/low/low.C:2:", ["test of the version"]),
]


def found(folder, changes):
    """Exit status and lines of the check of the changed tree."""
    for path, text in {**TREE, **changes}.items():
        path = os.path.join(folder, path)
        os.makedirs(os.path.dirname(path), exist_ok=True)
        with open(path, "w", encoding="utf-8") as stream:
            stream.write(text)
    result = subprocess.run(
        [sys.executable, "-B", CHECK, "-root", folder], text=True,
        stdout=subprocess.PIPE, stderr=subprocess.STDOUT, check=False)
    return result.returncode, result.stdout.strip().split("\n")


def main(folder):
    """The checks."""
    report = fsiCase.Report()
    status, lines = found(os.path.join(folder, "good"), {})
    report.check("a good tree is accepted",
                 status == 0 and lines == [f"{len(TREE)} files checked, "
                                           "0 offences"], lines)
    status, lines = found(os.path.join(folder, "600"), large_class(600))
    report.check("a class of 600 lines is accepted", status == 0, lines)
    for number, (name, changes, start, said) in enumerate(OFFENCES):
        status, lines = found(os.path.join(folder, str(number)), changes)
        report.check(
            f"refused: {name}",
            status == 1 and len(lines) == 2 and lines[0].startswith(start)
            and all(text in lines[0] for text in said), lines)


if __name__ == "__main__":
    main(sys.argv[1])
