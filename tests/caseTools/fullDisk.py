#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs whose disk is full at some position: each ends in an error that names
the last complete time, or has written all of its files.

    fullDisk.py FOLDER [N]

The disk is a tmpfs if mounting is allowed. If not, a file can only grow to a
limit (RLIMIT_FSIZE), which stands for the disk.
"""

import os
import random
import resource
import shutil
import signal
import subprocess
import sys

import fsiCase
import results
from smallCase import result, small_case

END = "0.02"

# The system's reason
FULL = "No space left on device"


def size_of(folder):
    """Bytes of the files below a folder, in blocks of 4 kB."""
    return sum(-(-os.path.getsize(os.path.join(parent, name))//4096)*4096
               for parent, _, files in os.walk(folder) for name in files)


def limited(limit):
    """Files of this process may have that many bytes."""
    def apply():
        signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
        resource.setrlimit(resource.RLIMIT_FSIZE, (limit, limit))
    return apply


def mount(folder, size):
    """A tmpfs of that size; False if it may not be."""
    os.makedirs(folder)
    return subprocess.run(
        ["mount", "-t", "tmpfs", "-o", f"size={size}", "tmpfs", folder],
        check=False, stderr=subprocess.DEVNULL).returncode == 0


def run(case, log, limit=None):
    """The status and the log of a run."""
    with open(log, "wb") as stream:
        status = subprocess.run(
            ["fsiPisoFoam", "-case", case], stdout=stream, stderr=stream,
            preexec_fn=limited(limit) if limit else None, timeout=120,
            check=False).returncode
    return status, results.read(log)


def written(case):
    """All that a run writes, but the tables' seconds."""
    found = {}
    for time in results.times(case):
        found.update({f"{time}/{k}": v for k, v
                      in result(os.path.join(case, time)).items()})
    for parent, _, files in os.walk(os.path.join(case, "postProcessing")):
        for name in files:
            with open(os.path.join(parent, name), "rb") as stream:
                data = stream.read()
            key = os.path.relpath(os.path.join(parent, name), case)
            found[key] = data.count(b"\n") if name == "global.csv" else data
    return found


def outcome(base, folder, position, whole):
    """What a run does with the disk full at a position: a word, its log."""
    disk = os.path.join(folder, "disk")
    log = os.path.join(folder, "log.disk")
    start = size_of(base)
    mounted = mount(disk, start + 65536 + position)
    case = os.path.join(disk, "case")
    try:
        shutil.copytree(base, case)
        status, text = run(case, log, None if mounted else 1 + position//50)
        if status == 0:
            found = written(case)
            wrong = [k for k in whole if found.get(k) != whole[k]]
            return ("silent" if wrong else "all written"), " ".join(wrong)
        if mounted and "complete time is" in text and FULL not in text:
            return "guessed", text
        note = ("complete time is" in text or "No time is complete" in text
                or "annot open" in text or "Cannot write" in text)
        clear = status > 0 and "FOAM FATAL" in text
        return ("named" if clear and note
                else "error" if clear else "signal"), text
    finally:
        if mounted:
            subprocess.run(["umount", disk], check=True)
        shutil.rmtree(disk, ignore_errors=True)


def main(folder, count=20):
    """The positions."""
    report = fsiCase.Report()
    case = small_case(os.path.join(folder, "base"), endTime=END)
    base = case.path
    full = os.path.join(folder, "whole")
    shutil.copytree(base, full)
    run(full, os.path.join(folder, "log.whole"))
    whole = written(full)
    room = size_of(full) - size_of(base)
    dice = random.Random(1)
    counts = {}
    for i in range(int(count)):
        position = int(room*(i + dice.random())/int(count))
        word, text = outcome(base, folder, position, whole)
        counts[word] = counts.get(word, 0) + 1
        if word in ("silent", "signal", "error", "guessed"):
            print(f"    {word} at {position}: {' '.join(text[-500:].split())}",
                  flush=True)
    print("    " + ", ".join(f"{n} {word}" for word, n in counts.items()))
    report.check("no full disk is silent", counts.get("silent", 0) == 0,
                 str(counts))
    report.check("no full disk ends in a signal", counts.get("signal", 0) == 0,
                 str(counts))
    report.check("the system's reason is told",
                 counts.get("guessed", 0) == 0, str(counts))
    report.check("full disks are met", counts.get("named", 0) > 0,
                 str(counts))


if __name__ == "__main__":
    main(*sys.argv[1:])
