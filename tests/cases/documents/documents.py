#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The page of entries is what the headers say, and files, tutorials, links and
equations that documents and sources name exist.

    documents.py FOLDER
"""

import fnmatch
import os
import re
import subprocess
import sys

import fsiCase

ROOT = os.path.join(os.path.dirname(os.path.abspath(__file__)), "../../..")
DOCUMENTS = ("README.md", "CONTRIBUTING.md", "doc/dataFlow.md",
             "doc/extending.md",
             "doc/theory.md", "doc/performance.md", "doc/scaling.md",
             "doc/userGuide.md", "doc/validation.md", "doc/entries.md",
             "doc/choices.md")

# Folders of what was built or has run
MADE = (".git", "platforms", "lnInclude", "units", "__pycache__")


def read(path):
    with open(os.path.join(ROOT, path), encoding="utf-8") as file:
        return file.read()


def existing(path):
    return os.path.exists(os.path.join(ROOT, path))


def files(*patterns):
    """Paths of the project's files that fit one of the patterns. The source
    tree need not be git's."""
    found = []
    for folder, names, here in os.walk(ROOT):
        names[:] = [n for n in names if n not in MADE]
        found += [os.path.relpath(os.path.join(folder, n), ROOT)
                  for n in here]
    return [f for f in found if any(fnmatch.fnmatch(f, p) for p in patterns)]


def all_files():
    """Names and last two parts of all files of the project."""
    known = set()
    for name in files("*"):
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


def check_contents(report, path, text):
    """Links to headings of the page itself; contents list all main ones."""
    headings = [(level, re.sub(r"[^\w\- ]", "", h.lower()).replace(" ", "-"))
                for level, h in re.findall(r"^(###?) (.*)$", text, re.M)]
    links = re.findall(r"\]\(#([^)]+)\)", text)
    wrong = sorted(set(links) - {h for _, h in headings})
    if "Contents:" in text:
        wrong += [h for level, h in headings
                  if level == "##" and h not in links]
    report.check(f"contents of {path}", not wrong, wrong)


def check_revisions(report):
    """Revisions and their dates are in choices.md and CHANGELOG.md only, and
    the date of a table of versions in README.md. Runs write tables."""
    found = []
    for name in (set(files("*.md")) - set(files("*/table*.md"))
                 - {"doc/choices.md", "CHANGELOG.md"}):
        pattern = r"(?<![\w.-])(?=\d*[a-f])(?=[a-f]*\d)[0-9a-f]{7}(?![\w.])"
        if name != "README.md":
            pattern += r"|(?<!\d)20\d\d-\d\d-\d\d"
        found += [f"{name}: {f}" for f in re.findall(pattern, read(name))]
    report.check("documents name no revisions", not found, sorted(found))


def check_names(report, path, text, known):
    """Sources and scripts in backticks."""
    names = re.findall(r"`([\w./-]+\.(?:[CH]|py))`", text)
    names += re.findall(r"`((?:src|tutorials|tests|etc)/[\w./-]+\w)`", text)
    names = [n for n in names if not n.endswith(".png")]
    missing = sorted({n for n in names if n not in known
                      and not existing(n)})
    report.check(f"files that {path} names exist", not missing, missing)


def cited(path, text):
    """Numbers of equations of theory.md that a file cites; those of the thesis
    have "thesis" in front. In tutorials, which have other numbers in
    parentheses, only those after the page's name count."""
    text = re.sub(r"\s+(?://|#)?\s*", " ", text)
    number, more = r"\(\d\.\d+\)", r"(?:(?:-|, | and | to )\(\d\.\d+\))*"
    if path.startswith("tutorials"):
        text = " ".join(re.findall(
            r"theory(?:\.md)?,? (?:below )?" + number + more, text))
    text = re.sub("[Tt]hesis " + number + more, "", text)
    return set(re.findall(r"(?<![\w)])(?<!\d )\(([1-9]\.\d+)\)", text))


def check_equations(report):
    """Each number of theory.md stands once, and all that are cited do."""
    numbers = re.findall(r"^    .*\((\d\.\d+)\)$", read("doc/theory.md"), re.M)
    double = sorted({n for n in numbers if numbers.count(n) > 1})
    report.check("numbers of equations stand once", not double, double)
    names = files("src/*", "doc/*.md", "tutorials/*", "tests/*.[CH]",
                  "tests/*.py")
    missing = [f"{name}: ({n})" for name in names
               if name.endswith((".C", ".H", ".md", ".py"))
               for n in sorted(cited(name, read(name)) - set(numbers))]
    report.check("equations that are cited are in theory.md", not missing,
                 missing)


def check_columns(report):
    """The guide has every column of global.csv and objects.csv; of a vector
    or another group, its beginning."""
    guide, missing = read("doc/userGuide.md"), []
    for name in ("stepRecord", "objectRecord"):
        source = read(f"src/FSIObjects/output/{name}.C")
        start = re.search(r"::columns\s*\(", source).start()
        columns = source[start:source.index("\n}\n", start)]
        missing += [c for c in re.findall(r'"(\w+)"', columns)
                    if "`" + re.sub("[XYZABC]+$", "", c) not in guide]
    report.check("the guide has every column of the tables", not missing,
                 missing)


def check_calls(report):
    """Functions that dataFlow.md names are declared, those with a class in its
    header."""
    texts = {os.path.basename(h)[:-2]: read(h) for h in files("src/*.H")}
    rows = re.findall(r"^\| [\d ]*\|[^|]*\|[^|]*\|([^|]*)\|",
                      read("doc/dataFlow.md"), re.M)
    calls = re.findall(r"`([\w:]+)`", " ".join(rows))
    missing = []
    for call in calls:
        *of, name = call.split("::")
        where = [texts.get(c, "") for c in of] or texts.values()
        if call != "thesis" and not any(
                re.search(rf"\b{name}\s*\(", text) for text in where):
            missing.append(call)
    report.check("functions that dataFlow.md names exist",
                 calls and not missing, missing)


def messages():
    """Texts of the messages of all sources, the warnings' apart."""
    every, warnings = "", []
    for name in files("src/*.C", "applications/*.C"):
        source = read(name)
        literal = r'"((?:[^"\\\n]|\\.)*)"'
        every += "".join(re.findall(literal, source)) + "\n"
        for part in re.findall(r"WarningInFunction(.*?);", source, re.S):
            warnings.append((name, "".join(re.findall(literal, part))))
    return every, warnings


def check_messages(report):
    """The guide's table of messages: each is in a source, and each warning of
    a source is there."""
    guide = read("doc/userGuide.md")
    start = guide.index("\n## 13.")
    section = guide[start:guide.index("\n## 14.", start)]
    rows = re.findall(r"^\|([^|]*)\|", section, re.M)
    rows += re.findall(r"\n\*\*Afterwards.*", section, re.S)
    texts = [part.strip(" ,.") for row in rows
             for quote in re.findall(r'"([^"]+)"', row)
             for part in re.sub(r"\s+", " ", quote).split("...")]
    texts = [text for text in texts if text]
    every, warnings = messages()
    stale = [text for text in texts if text not in every
             and not text.startswith(("cannot find file", "/p"))]
    report.check("messages of the guide are in the sources", not stale, stale)
    missing = [warning for warning in warnings
               if not any(len(t) > 12 and t in warning[1] for t in texts)]
    report.check("the guide has every warning", not missing, missing)


def check_version(report):
    """The version of debian/changelog, which the program prints, is the first
    of CHANGELOG.md and that of CITATION.cff, with one date."""
    version = re.match(r"fsiobjects \((.*?)\)", read("debian/changelog"))[1]
    head = re.search(r"^## (.*), (.*)$", read("CHANGELOG.md"), re.M)
    citation = read("CITATION.cff")
    found = [head[1], re.search(r"^version: (.*)$", citation, re.M)[1]]
    report.check("documents name the version of debian/changelog",
                 found == [version]*2, [version] + found)
    report.check("CITATION.cff has the date of CHANGELOG.md",
                 f"\ndate-released: {head[2]}\n" in citation, head[2])


def main():
    report = fsiCase.Report()
    check_entries(report)
    check_columns(report)
    check_equations(report)
    check_messages(report)
    check_calls(report)
    check_revisions(report)
    check_version(report)
    known = all_files()
    for path in DOCUMENTS:
        if existing(path):
            text = read(path)
            check_links(report, path, text)
            check_contents(report, path, text)
            check_names(report, path, text, known)
    return 1 if report.failures else 0


sys.exit(main())
