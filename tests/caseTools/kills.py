#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs that are killed at random moments go on by themselves and end as the
run without a stop, to the last bit.

    kills.py FOLDER [N]
"""

import os
import random
import shutil
import signal
import subprocess
import sys
import time

import fsiCase
import results
from smallCase import result, small_case

END = "0.2"


def program(case, ranks):
    """What is called."""
    command = ["fsiPisoFoam", "-case", case]
    if ranks == 1:
        return command
    return (["mpirun", "--oversubscribe", "-np", str(ranks)] + command
            + ["-parallel"])


def run(case, ranks, delay=None):
    """Runs, and kills after a delay; True if it came to its end."""
    with open(os.path.join(case, "log"), "ab") as log:
        log.write(b"\n=== start\n")
        log.flush()
        with subprocess.Popen(program(case, ranks), stdout=log, stderr=log,
                              start_new_session=True) as process:
            try:
                process.wait(delay)
            except subprocess.TimeoutExpired:
                os.killpg(process.pid, signal.SIGKILL)
                process.wait()
                return False
    if process.returncode:
        raise RuntimeError("a restart failed: "
                           + results.read(case, "log")[-600:])
    return True


def chain(case, ranks, delays):
    """Restarts until the end; the numbers of kills and of times set aside."""
    kills = 0
    while not run(case, ranks, next(delays)):
        kills += 1
        time.sleep(0.1)
    return kills, results.read(case, "log").count("is incomplete")


def main(folder, count=20):
    """The kills."""
    report = fsiCase.Report()
    dice = random.Random(1)
    kinds = []
    for write_format in ("binary", "ascii"):
        for ranks in (1, 2, 3):
            path = os.path.join(folder, f"{write_format}{ranks}")
            case = small_case(path, writeFormat=write_format, endTime=END)
            if ranks > 1:
                case.decompose(ranks, 1)
            whole = path + "whole"
            shutil.copytree(path, whole)
            start = time.time()
            run(whole, ranks)
            kinds.append((f"{write_format}, ranks {ranks}", path, ranks,
                          time.time() - start))
    total, aside, same = 0, 0, 0
    chains = 0
    while total < int(count):
        name, path, ranks, seconds = kinds[chains % len(kinds)]
        chains += 1
        killed = path + "killed"
        shutil.rmtree(killed, ignore_errors=True)
        shutil.copytree(path, killed)
        delays = iter(lambda s=seconds: dice.uniform(0.2, 0.9)*s, None)
        n_kills, n_aside = chain(killed, ranks, delays)
        total += n_kills
        aside += n_aside
        folders = ([""] if ranks == 1
                   else [f"processor{i}" for i in range(ranks)])
        wrong = []
        for folder_of in folders:
            one, other = (result(os.path.join(c, folder_of, END))
                          for c in (path + "whole", killed))
            wrong += [k for k in one if one[k] != other.get(k)]
        same += not wrong
        if wrong:
            report.check(f"{name}: the same to the last bit", False,
                         str(wrong))
    print(f"    {total} kills in {chains} runs, {aside} times set aside")
    report.check("killed runs end as the run without a stop", same == chains,
                 f"{same} of {chains}")


if __name__ == "__main__":
    main(*sys.argv[1:])
