# SPDX-License-Identifier: GPL-3.0-or-later
"""Files of a case: a box of squares, or of cubes, its fields and objects."""

import os

HEADER = """// SPDX-License-Identifier: GPL-3.0-or-later
FoamFile
{{
    version     2.0;
    format      ascii;
    class       {};
    object      {};
}}

"""

FACES = {"left": "(0 4 7 3)", "right": "(1 2 6 5)",
         "bottom": "(0 1 5 4)", "top": "(3 7 6 2)"}

# The other two of a mesh in three dimensions
DEPTH_FACES = {"back": "(0 3 2 1)", "front": "(4 5 6 7)"}

PAIRS = {"x": ("left", "right"), "y": ("bottom", "top"), "z": ("back", "front")}

DEFAULTS = {
    # Lowest corner, then highest; two coordinates each, or three
    "box": (0, 0, 1, 1),
    "cells": (32, 32),
    "grading": "1 1 1",
    "viscosity": 0.01,
    "density": 1,
    "gravity": "(0 0 0)",
    # Velocity of the sides that are not at rest
    "walls": {},
    # Velocity of the fluid at the start
    "velocity": "(0 0 0)",
    # Directions closed by cyclic patches: "x", "y", "z", "xy"...
    "cyclic": "",
    # Open patches: side: (boundary condition of U, of p)
    "open": {},
    "properties": "",
    # Euler or backward
    "time_scheme": "Euler",
    "shapes": "",
    "placements": "",
    "p_tolerance": 1e-7,
    "U_tolerance": 1e-8,
    # Further entries of the solver of U
    "U_controls": "",
}

SCHEMES = """gradSchemes { default Gauss linear; }
divSchemes { default none; div(phi,U) Gauss linear; }
laplacianSchemes { default Gauss linear orthogonal; }
interpolationSchemes { default linear; }
snGradSchemes { default orthogonal; }
"""

SOLUTION = """solvers
{{
    p {{ solver PCG; preconditioner DIC; tolerance {}; relTol 0; }}
    U {{ solver PBiCGStab; preconditioner DILU; tolerance {}; relTol 0; {} }}
}}
PISO {{ }}
"""


class BoxFiles:
    """Writes the files of a case. path: its folder; values: as DEFAULTS."""

    path = None
    values = None

    def file(self, name, text, kind="dictionary"):
        """Writes the file "name" of the case."""
        path = os.path.join(self.path, name)
        os.makedirs(os.path.dirname(path), exist_ok=True)
        with open(path, "w", encoding="ascii") as stream:
            stream.write(HEADER.format(kind, os.path.basename(name)) + text)

    def append(self, name, text):
        """Adds text to the file "name" of the case."""
        with open(os.path.join(self.path, name), "a",
                  encoding="ascii") as stream:
            stream.write(text)

    def write(self):
        """Writes all files but controlDict."""
        v = self.values
        self.mesh()
        self.fields()
        self.file("constant/transportProperties",
                  f"nu [0 2 -1 0 0 0 0] {v['viscosity']};\n")
        self.file("constant/fsiProperties",
                  f"fluidDensity {v['density']};\ngravity {v['gravity']};\n"
                  + v["properties"])
        self.file("system/seedObjectsDict",
                  f"shapes\n{{\n{v['shapes']}\n}}\n"
                  f"placements\n{{\n{v['placements']}\n}}\n")
        self.file("system/fvSchemes", "ddtSchemes { default "
                  f"{v['time_scheme']}; }}\n" + SCHEMES)
        self.file("system/fvSolution",
                  SOLUTION.format(v["p_tolerance"], v["U_tolerance"],
                                  v["U_controls"]))

    def dimensions(self):
        """2 or 3."""
        return len(self.values["cells"])

    def sides(self):
        """Names of the sides and their corners in blockMeshDict."""
        return FACES if self.dimensions() == 2 else {**FACES, **DEPTH_FACES}

    def cyclic_opposite(self, side):
        """The other half of the cyclic that a side belongs to, or None."""
        for axis in self.values["cyclic"]:
            if side in PAIRS[axis]:
                return PAIRS[axis][side == PAIRS[axis][0]]
        return None

    def patch_type(self, side):
        """Entries of a side in blockMeshDict."""
        opposite = self.cyclic_opposite(side)
        if opposite:
            return f"type cyclic; neighbourPatch {opposite};"
        return f"type {'patch' if side in self.values['open'] else 'wall'};"

    def boundary_condition(self, side, field):
        """Entries of a side in 0/U or 0/p."""
        if self.cyclic_opposite(side):
            return "type cyclic;"
        if side in self.values["open"]:
            return self.values["open"][side][field == "p"]
        if field == "p":
            return "type zeroGradient;"
        velocity = self.values["walls"].get(side, "(0 0 0)")
        return f"type fixedValue; value uniform {velocity};"

    def mesh(self):
        """Writes blockMeshDict: one block, in two dimensions one cell thick."""
        n = self.dimensions()
        x0, y0, x1, y1 = (self.values["box"][i] for i in (0, 1, n, n + 1))
        cells = list(self.values["cells"])
        depth = (0, (x1 - x0)/cells[0])
        if n == 3:
            depth = self.values["box"][2::3]
        corners = " ".join(
            f"({x} {y} {z})" for z in depth
            for x, y in ((x0, y0), (x1, y0), (x1, y1), (x0, y1))
        )
        sides = "\n".join(f"{name} {{ {self.patch_type(name)} "
                          f"faces ({face}); }}"
                          for name, face in self.sides().items())
        if n == 2:
            cells.append(1)
            sides += ("\nfrontAndBack { type empty; faces ("
                      + " ".join(DEPTH_FACES.values()) + "); }")
        self.file(
            "system/blockMeshDict",
            f"vertices ({corners});\nblocks\n(\n    hex (0 1 2 3 4 5 6 7) "
            f"({' '.join(map(str, cells))}) "
            f"simpleGrading ({self.values['grading']})\n);\n"
            f"boundary\n(\n{sides}\n);\n"
        )

    def fields(self):
        """Writes p and U: at rest, walls at rest or with a velocity."""
        rest = ("frontAndBack { type empty; }\n"
                if self.dimensions() == 2 else "")
        U, p = ("".join(f"{s} {{ {self.boundary_condition(s, field)} }}\n"
                        for s in self.sides()) + rest for field in "Up")
        text = ("dimensions {};\ninternalField uniform {};\n"
                "boundaryField\n{{\n{}}}\n")
        self.file("0/U", text.format("[0 1 -1 0 0 0 0]",
                                      self.values["velocity"], U),
                  "volVectorField")
        self.file("0/p", text.format("[0 2 -2 0 0 0 0]", 0, p),
                  "volScalarField")
