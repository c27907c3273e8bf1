#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Each of OpenFOAM's file handlers starts a run and goes on with it, also with
what another one wrote, and gives the same state:

    fileHandlers.py FOLDER
"""

import glob
import os
import shutil
import sys

import fsiCase
import results
import smallCase

STEP = 0.005
UNCOLLATED, MASTER, COLLATED = "uncollated", "masterUncollated", "collated"

# Of the start and of the restart
PAIRS = [(MASTER, MASTER), (COLLATED, COLLATED), (UNCOLLATED, COLLATED),
         (COLLATED, UNCOLLATED), (MASTER, COLLATED), (COLLATED, MASTER)]


def case_of(folder, name, **parameters):
    """A case of four steps that writes each second one."""
    return smallCase.small_case(os.path.join(folder, name), **{
        "writeInterval": 2, "writeFormat": "binary", "endTime": 4*STEP,
        **parameters})


def solve(case, ranks, handler, step, how="option", more=""):
    """Runs a case to a step. how: the way in which the handler is given; more
    switches of it."""
    options = ("-fileHandler", handler) if how == "option" else ()
    case.control(endTime=step*STEP, OptimisationSwitches=(
        f"{{ fileHandler {handler}; {more} }}" if how == "control" else "{}"))
    if how == "environment":
        os.environ["FOAM_FILEHANDLER"] = handler
    try:
        return case.run("fsiPisoFoam", *options, ranks=ranks)
    finally:
        os.environ.pop("FOAM_FILEHANDLER", None)


def state(case, handler):
    """The last state of ranks, put together."""
    case.run("reconstructPar", "-latestTime", "-fileHandler", handler)
    case.run("checkObjects", "-latestTime", "-fileHandler", handler)
    found = smallCase.result(os.path.join(
        case.path, results.times(case.path)[-1]))
    # Of the run's clock and handler
    return {name: text for name, text in found.items()
            if name.startswith("uniform/fsi") or name in ("U", "p", "phi")}


def differences(one, other):
    """Names of the files that differ."""
    return [name for name in sorted(set(one) | set(other))
            if one.get(name) != other.get(name)]


def check_pair(report, folder, expected, first, then):
    """A start and a restart."""
    case = case_of(folder, f"{first}-{then}")
    case.decompose(2, 1, options=("-fileHandler", first))
    solve(case, 2, first, 2)
    solve(case, 2, then, 4)
    differ = differences(expected, state(case, then))
    report.check(f"start with {first}, restart with {then}", not differ, differ)


def check_serial(report, folder):
    """On one rank, with each way to give a handler."""
    whole = case_of(folder, "serial")
    solve(whole, 1, UNCOLLATED, 4)
    last = results.times(whole.path)[-1]
    expected = smallCase.result(os.path.join(whole.path, last))
    for how in ("option", "environment", "control"):
        case = case_of(folder, f"serial-{how}")
        solve(case, 1, COLLATED, 2, how)
        solve(case, 1, MASTER, 4, how)
        differ = differences(expected,
                             smallCase.result(os.path.join(case.path, last)))
        report.check(f"handlers on one rank, by {how}", not differ, differ)


def check_ways(report, folder, expected):
    """On ranks, with each way to give a handler."""
    for how in ("environment", "control"):
        case = case_of(folder, f"ranks-{how}")
        case.decompose(2, 1, options=("-fileHandler", COLLATED))
        solve(case, 2, COLLATED, 2, how)
        solve(case, 2, COLLATED, 4, how)
        differ = differences(expected, state(case, COLLATED))
        report.check(f"collated on two ranks, by {how}", not differ, differ)


def check_cut(report, folder, expected):
    """A time of which a file is cut is set aside."""
    case = case_of(folder, "cut")
    case.decompose(2, 1, options=("-fileHandler", COLLATED))
    solve(case, 2, COLLATED, 4)
    last = os.path.join(case.path, "processors2", f"{4*STEP:g}")
    with open(os.path.join(last, "p"), "r+b") as stream:
        stream.truncate(os.path.getsize(stream.name) - 100)
    text = solve(case, 2, COLLATED, 4)
    report.check("a cut file is found", "is incomplete" in text
                 and os.path.isdir(last + ".incomplete"), text[:1000])
    differ = differences(expected, state(case, COLLATED))
    report.check("a run goes on from before a cut file", not differ, differ)


def check_ranks(report, folder):
    """Two, three and five ranks and one, each from what the last ones wrote:
    collated by a thread of its own and without, packed, several ranks a file.
    The objects are those of one rank up to its solver's tolerance."""
    tight = {"p_tolerance": 1e-12, "U_tolerance": 1e-12}
    whole = case_of(folder, "tight", writeInterval=1, writeFormat="ascii",
                    **tight)
    solve(whole, 1, UNCOLLATED, 4)
    case = case_of(folder, "many", writeInterval=1, **tight)
    packed = {"writeCompression": "on"}
    threaded = {"more": "maxThreadFileBufferSize 1e7; maxMasterFileBufferSize "
                "1e7;"}
    for step, (parts, handler, entries) in enumerate(
            (((2, 1), COLLATED, threaded), ((3, 1), MASTER, packed),
             ((5, 1), COLLATED, {**packed, **threaded}), ((1,), COLLATED, {}))):
        name = f"{parts[0]} ranks, {handler}"
        ranks = 1
        # decomposePar -force would put three ranks into processors2
        for old in glob.glob(os.path.join(case.path, "processor*")):
            shutil.rmtree(old)
        case.control(writeCompression=entries.get("writeCompression", "off"),
                     writeFormat="binary" if parts != (1,) else "ascii",
                     OptimisationSwitches="{}")
        if parts != (1,):
            ranks = case.decompose(*parts, options=(
                "-latestTime", "-fileHandler", handler))
        solve(case, ranks, handler, step + 1, "control",
              entries.get("more", ""))
        if ranks > 1:
            case.run("reconstructPar", "-latestTime", "-fileHandler", handler)
        case.run("checkObjects", "-latestTime", "-fileHandler", handler)
        report.check(name, True)
    error = results.difference(whole.path, case.path)
    report.check("one rank goes on from five, three and two", error < 1e-8,
                 f"{error:.2e} of an object's size")


def main(folder):
    """The checks."""
    report = fsiCase.Report()
    report.attempt("one rank", check_serial, report, folder)
    whole = case_of(folder, "whole")
    whole.decompose(2, 1)
    report.attempt("whole run", solve, whole, 2, UNCOLLATED, 4)
    expected = state(whole, UNCOLLATED)
    report.check("the whole run has a state", len(expected) > 6,
                 sorted(expected))
    for pair in PAIRS:
        report.attempt("-".join(pair), check_pair, report, folder, expected,
                       *pair)
    report.attempt("ways", check_ways, report, folder, expected)
    report.attempt("cut", check_cut, report, folder, expected)
    report.attempt("ranks", check_ranks, report, folder)


if __name__ == "__main__":
    main(sys.argv[1])
