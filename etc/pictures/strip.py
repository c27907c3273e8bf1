# SPDX-License-Identifier: GPL-3.0-or-later
"""Files of one picture, and of pictures side by side, for etc/render."""

import math
import os

from PIL import Image
from vtkmodules import vtkIOImage

# A row this many times as wide as high is broken, into rows that together are
# at most that many times as wide as high
LONGEST, BROKEN = 8, 3


def as_pillow(image):
    """Pillow's image of VTK's."""
    width, height, _ = image.GetDimensions()
    data = bytes(memoryview(image.GetPointData().GetScalars()))
    # VTK begins at the bottom
    return Image.frombytes("RGB", (width, height), data).transpose(
        Image.Transpose.FLIP_TOP_BOTTOM)


def per_row(count, width, height):
    """How many pictures of this size stand side by side."""
    if count*width <= LONGEST*height:
        return count
    for rows in range(2, count + 1):
        columns = math.ceil(count/rows)
        if columns*width <= BROKEN*rows*height:
            return columns
    return 1


def strip(images):
    """All pictures, row by row; the last may be wider than the others."""
    frames = [as_pillow(image) for image in images]
    width, height = frames[0].size
    columns = per_row(len(frames), width, height)
    places = [(width*(i % columns), height*(i//columns))
              for i in range(len(frames))]
    size = [max(place[d] + frame.size[d]
                for place, frame in zip(places, frames)) for d in (0, 1)]
    sheet = Image.new("RGB", size, "white")
    for place, frame in zip(places, frames):
        sheet.paste(frame, place)
    return sheet


def write_png(image, path):
    """Writes a picture of VTK and tells its name."""
    os.makedirs(os.path.dirname(os.path.abspath(path)), exist_ok=True)
    writer = vtkIOImage.vtkPNGWriter()
    writer.SetFileName(path)
    writer.SetInputData(image)
    writer.Write()
    print(path)
