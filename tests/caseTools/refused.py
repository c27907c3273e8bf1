# SPDX-License-Identifier: GPL-3.0-or-later
"""Checks that a program refuses what is wrong."""

import results


def refused(report, name, case, program, texts, limit=120):
    """The program must end in an OpenFOAM error that holds those texts, and not
    by a signal."""
    try:
        case.run(program, limit=limit)
    except RuntimeError as error:
        log = results.read(case.path, "log." + program)
        start = log.find("--> FOAM FATAL")
        message = log[start:] if start >= 0 else log[-300:]
        missing = [t for t in texts if t not in message]
        if "ended with -" in str(error):
            missing.append("exit without a signal")
        report.check(name, start >= 0 and not missing,
                     f"no {missing} in: {' '.join(message.split())[:500]}")
    else:
        report.check(name, False, f"{program} accepts it")
