#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The page of entries is what the headers say, and files, tutorials and links
that the documents name exist.

    documents.py FOLDER
"""

import os
import re
import subprocess
import sys

import fsiCase

ROOT = os.path.join(os.path.dirname(os.path.abspath(__file__)), "../../..")
DOCUMENTS = ("README.md", "CONTRIBUTING.md", "doc/dataFlow.md",
             "doc/theory.md", "doc/performance.md", "doc/userGuide.md",
             "doc/validation.md", "doc/entries.md")


def read(path):
    with open(os.path.join(ROOT, path), encoding="utf-8") as file:
        return file.read()


def existing(path):
    return os.path.exists(os.path.join(ROOT, path))


def all_files():
    """Names and last two parts of all files of the project."""
    names = subprocess.run(["git", "-C", ROOT, "ls-files"], check=True,
                           capture_output=True, text=True).stdout.split()
    known = set()
    for name in names:
        parts = name.split("/")
        known.update("/".join(parts[i:]) for i in range(len(parts)))
        known.update("/".join(parts[:i]) for i in range(len(parts)))
    return known


def check_entries(report):
    """The generated page."""
    result = subprocess.run([os.path.join(ROOT, "etc/entries"), "-check"],
                            capture_output=True, text=True, check=False)
    report.check("all entries are in doc/entries.md", result.returncode == 0,
                 result.stdout)


def check_links(report, path, text):
    """Links to files."""
    folder = os.path.dirname(path)
    missing = [
        link for link in re.findall(r"\]\(([^)#]+)(?:#[^)]*)?\)", text)
        if "://" not in link
        and not existing(os.path.normpath(os.path.join(folder, link)))
    ]
    report.check(f"links of {path} lead to files", not missing, missing)


def check_names(report, path, text, known):
    """Sources and scripts in backticks."""
    names = re.findall(r"`([\w./-]+\.(?:[CH]|py))`", text)
    names += re.findall(r"`((?:src|tutorials|tests|etc)/[\w./-]+\w)`", text)
    names = [n for n in names if not n.endswith(".png")]
    missing = sorted({n for n in names if n not in known
                      and not existing(n)})
    report.check(f"files that {path} names exist", not missing, missing)


def check_columns(report):
    """The guide has every column of global.csv and objects.csv; of a vector
    or another group, its beginning."""
    guide, missing = read("doc/userGuide.md"), []
    for name in ("stepRecord", "objectRecord"):
        source = read(f"src/FSIObjects/output/{name}.C")
        start = source.index("::columns(")
        columns = source[start:source.index("\n}\n", start)]
        missing += [c for c in re.findall(r'"(\w+)"', columns)
                    if "`" + re.sub("[XYZABC]$", "", c) not in guide]
    report.check("the guide has every column of the tables", not missing,
                 missing)


def main():
    report = fsiCase.Report()
    check_entries(report)
    check_columns(report)
    known = all_files()
    for path in DOCUMENTS:
        if existing(path):
            text = read(path)
            check_links(report, path, text)
            check_names(report, path, text, known)
    return 1 if report.failures else 0


sys.exit(main())
