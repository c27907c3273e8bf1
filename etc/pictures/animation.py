# SPDX-License-Identifier: GPL-3.0-or-later
"""Pictures one after the other in a file, for etc/render: a GIF by Pillow, or
Ogg Theora by VTK, which browsers and VLC play."""

import os
import sys

from strip import as_pillow
from vtkmodules import vtkIOOggTheora


class Gif:
    """An animated GIF that repeats for ever."""

    def __init__(self, path, rate):
        self.path, self.rate, self.frames = path, rate, []

    def __enter__(self):
        return self

    def add(self, image):
        self.frames.append(as_pillow(image).quantize())

    def __exit__(self, failure, *_):
        if self.frames and not failure:
            self.frames[0].save(
                self.path, save_all=True, append_images=self.frames[1:],
                duration=round(1000/self.rate), loop=0)


class OggTheora:
    """A film in Ogg Theora."""

    def __init__(self, path, rate):
        self.writer = vtkIOOggTheora.vtkOggTheoraWriter()
        self.writer.SetFileName(path)
        self.writer.SetRate(round(rate))
        self.started = False

    def __enter__(self):
        return self

    def add(self, image):
        self.writer.SetInputData(image)
        if not self.started:
            self.writer.Start()
            self.started = True
        self.writer.Write()

    def __exit__(self, *_):
        if self.started:
            self.writer.End()


def animation_to(path, rate):
    """The writer for the ending of a file name."""
    writers = {".gif": Gif, ".ogv": OggTheora}
    ending = os.path.splitext(path)[1]
    if ending not in writers:
        sys.exit(f"etc/render: -animate needs a file that ends in "
                 f"{' or '.join(writers)}, not {path}")
    if rate < 1:
        sys.exit(f"etc/render: -rate must be >= 1, not {rate}")
    os.makedirs(os.path.dirname(os.path.abspath(path)), exist_ok=True)
    return writers[ending](path, rate)
