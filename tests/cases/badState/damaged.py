# SPDX-License-Identifier: GPL-3.0-or-later
"""Damaged copies of a case, and times that are not whole."""

import os
import shutil

import fsiCase
import results


def write(path, text):
    """Writes a file."""
    with open(path, "w", encoding="ascii") as stream:
        stream.write(text)


def copy_of(case, folder):
    """A fresh copy of a case."""
    shutil.rmtree(folder, ignore_errors=True)
    shutil.copytree(case, folder)
    return folder


def failure(case, program="fsiPisoFoam", ranks=1):
    """The message of a run that ends in an error; the log of any other."""
    try:
        return fsiCase.run(case, program, ranks=ranks, limit=100)
    except RuntimeError:
        log = results.read(case, "log." + program)
        return log[log.find("--> FOAM FATAL"):]


def check_killed(report, case, folder):
    """A time that is half written is set aside."""
    for name in ("p", "faceHistory", "uniform/fsiObjects/disc"):
        wrong = copy_of(case, os.path.join(folder, "wrong"))
        half = os.path.join(wrong, "0.03")
        shutil.copytree(os.path.join(wrong, "0.02"), half)
        path = os.path.join(half, name)
        write(path, results.read(path)[:1000 if name == "p" else -100])
        log = failure(wrong)
        report.check(f"a time with half of {name} is set aside",
                     "is incomplete" in log and "Time = 0.03" in log
                     and os.path.isdir(half + ".incomplete")
                     and log.rstrip().endswith("End"), log[-300:])
    wrong = copy_of(case, os.path.join(folder, "wrong"))
    shutil.copytree(os.path.join(wrong, "0.02"), os.path.join(wrong, "0.03"))
    shutil.rmtree(os.path.join(wrong, "0.03/uniform"))
    log = failure(wrong)
    report.check("a time without the objects' state is told of",
                 "Time 0.03" in log and "starts from 0.02" in log
                 and log.rstrip().endswith("End"), log[-300:])
