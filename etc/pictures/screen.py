# SPDX-License-Identifier: GPL-3.0-or-later
"""A screen in memory for etc/render."""

import ctypes
import os
import signal
import subprocess
import sys


def end_with_parent():
    """Lets this process end when its parent does, whatever the reason."""
    death_signal_option = 1  # PR_SET_PDEATHSIG in Linux' prctl.h
    ctypes.CDLL(None).prctl(death_signal_option, signal.SIGTERM)


def start_screen():
    """An X server in memory; VTK's OpenGL needs one. Returns its process."""
    read, write = os.pipe()
    try:
        screen = subprocess.Popen(
            ["Xvfb", "-displayfd", str(write), "-nolisten", "tcp",
             "-screen", "0", "640x480x24"],
            pass_fds=[write], preexec_fn=end_with_parent,
            stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
        )
    except FileNotFoundError:
        sys.exit("etc/render: no Xvfb found. apt-get install xvfb")
    os.close(write)
    with os.fdopen(read) as answer:
        number = answer.readline().strip()
    if not number:
        sys.exit("etc/render: Xvfb did not start")
    os.environ["DISPLAY"] = ":" + number
    return screen
