#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The commands and dictionaries that README and user guide print for a case of
one's own run as they are printed, to an early time and without pictures.

    printedCases.py FOLDER
"""

import os
import subprocess
import sys

import fsiCase

ROOT = os.path.abspath(os.path.join(os.path.dirname(__file__), "../../.."))
BODY = os.path.join(ROOT, "tutorials/ownSurface/makeBody.py")
HEAD = ("FoamFile { version 2.0; format ascii; class dictionary; "
        "object seedObjectsDict; }\n")


def blocks(path, begin, end):
    """Indented blocks of a page between two headings, without the indent."""
    with open(os.path.join(ROOT, path), encoding="utf-8") as file:
        text = file.read()
    start = text.index(f"\n{begin}\n")
    found, lines = [], []
    for line in text[start:text.index(f"\n{end}\n", start)].split("\n"):
        if line.startswith("    ") or (lines and not line.strip()):
            lines.append(line[4:])
        elif lines:
            found.append("\n".join(lines).rstrip() + "\n")
            lines = []
    return found


def shell(home, text):
    """Runs commands from the project's folder, ~ being a folder of the test;
    the run ends early and pictures are left out."""
    short = ("sed -i 's/^endTime .*/endTime 0.02;/; s/^writeInterval .*/"
             "writeInterval 0.02;/' system/controlDict && fsiPisoFoam")
    lines = [line for line in text.split("\n") if "PROJECT_DIR/etc" not in line]
    script = "\n".join(["set -e", *lines])
    script = script.replace("\nfsiPisoFoam", "\n" + short)
    return subprocess.run(
        ["bash", "-c", script], cwd=ROOT, env=dict(os.environ, HOME=home),
        capture_output=True, text=True, timeout=600, check=False)


def main(folder):
    report = fsiCase.Report()
    home = os.path.join(folder, "readme")
    os.mkdir(home)
    body = os.path.join(home, "body.stl")
    subprocess.run([sys.executable, "-B", BODY, body], check=True)
    commands, = [b for b in blocks("README.md", "## A case of your own",
                                   "## Read on") if "seedObjects" in b]
    result = shell(home, commands.replace("cp body.stl", f"cp {body}"))
    report.check("the case of README runs",
                 result.returncode == 0 and "Objects are sound" in result.stdout
                 and " 2 objects" in result.stdout,
                 (result.stdout + result.stderr)[-600:])

    home = os.path.join(folder, "guide")
    os.mkdir(home)
    printed = blocks("doc/userGuide.md", "## 1. A first case", "## 2. Meshes")
    copy, = [b for b in printed if "cp -r" in b]
    objects, = [b for b in printed if "placements" in b]
    end, = [b for b in printed if b.startswith("blockMesh")]
    write = f"cat > system/seedObjectsDict << 'END'\n{HEAD}{objects}END\n"
    result = shell(home, copy + write + end)
    report.check("the first case of the guide runs",
                 result.returncode == 0 and "Objects are sound" in result.stdout
                 and " 2 objects" in result.stdout,
                 (result.stdout + result.stderr)[-600:])
    return 1 if report.failures else 0


sys.exit(main(os.path.abspath(sys.argv[1])))
