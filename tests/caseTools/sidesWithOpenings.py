# SPDX-License-Identifier: GPL-3.0-or-later
"""Boxes whose sides have patches on a part of them."""

import itertools

import fsiCase

SIDES = ("left", "right", "bottom", "top", "back", "front")

# Corners of a block, and those of its sides
CORNERS = ((0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0),
           (0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1))
NODES = ((0, 4, 7, 3), (1, 2, 6, 5), (0, 1, 5, 4), (3, 7, 6, 2),
         (0, 3, 2, 1), (4, 5, 6, 7))


class Box(fsiCase.Case):
    """A case with openings: patch: (side, first cells, end of the cells), the
    cells in all directions; "open" has the conditions of each."""

    def __init__(self, path, openings=(), **parameters):
        self.openings = dict(openings)
        super().__init__(path, **parameters)

    def sides(self):
        """All patches, with any values."""
        return [*super().sides(), *self.openings]

    def patch_of(self, number, block):
        """Patch of a side of a block of cells."""
        if SIDES[number] not in super().sides():
            return "frontAndBack"
        for name, (side, first, end) in self.openings.items():
            if side == SIDES[number] and all(
                    a <= low and high <= b for d, (low, high), a, b
                    in zip(range(self.dimensions()), block, first, end)
                    if d != number//2):
                return name
        return SIDES[number]

    def mesh(self):
        """Writes blockMeshDict, with blocks that end where openings do."""
        n, box = self.dimensions(), self.values["box"]
        cells = [*self.values["cells"], 1][:3]
        h = (box[n] - box[0])/cells[0]
        marks = [sorted({0, cells[d], *(
            end[d] for _, *ends in self.openings.values() for end in ends
            if d < n)}) for d in range(3)]
        places = list(itertools.product(*(range(len(m)) for m in marks)))
        points = " ".join(
            "(" + " ".join(str((box[d] if d < n else 0) + h*marks[d][i])
                           for d, i in enumerate(place)) + ")"
            for place in places)
        blocks, patches = "", {}
        for place in places:
            if any(i + 1 == len(m) for i, m in zip(place, marks)):
                continue
            block = [(m[i], m[i + 1]) for i, m in zip(place, marks)]
            names = [str(places.index(tuple(map(sum, zip(place, corner)))))
                     for corner in CORNERS]
            blocks += (f"hex ({' '.join(names)}) "
                       f"({' '.join(str(b - a) for a, b in block)}) "
                       "simpleGrading (1 1 1)\n")
            for number, nodes in enumerate(NODES):
                if block[number//2][number % 2] == (
                        cells[number//2] if number % 2 else 0):
                    patches.setdefault(self.patch_of(number, block), []).append(
                        f"({' '.join(names[i] for i in nodes)})")
        boundary = "\n".join(
            name + " { " + ("type empty;" if name == "frontAndBack" else
                            self.patch_type(name))
            + f" faces ({' '.join(faces)}); }}"
            for name, faces in patches.items())
        self.file("system/blockMeshDict",
                  f"vertices ({points});\nblocks\n(\n{blocks});\n"
                  f"boundary\n(\n{boundary}\n);\n")
