# SPDX-License-Identifier: GPL-3.0-or-later
"""Cases with scalars that the flow carries."""

import os

import fsiCase

SIDES = ("left", "right", "bottom", "top", "back", "front")


class ScalarCase(fsiCase.Case):
    """A case with scalars. scalars: a tuple of each, its name, its entries in
    fsiProperties, its values inside, and its boundary conditions by side."""

    def __init__(self, path, scalars, **parameters):
        self.scalars = scalars
        entries = "".join(f"{name} {{ {text} }}\n"
                          for name, text, *_ in scalars)
        parameters["properties"] = (parameters.get("properties", "")
                                    + f"scalars\n{{\n{entries}}}\n")
        super().__init__(path, **parameters)

    def write(self):
        """Writes the files of the scalars as well."""
        super().write()
        solvers = []
        for name, _, inside, sides in self.scalars:
            patches = "".join(
                f"{s} {{ "
                + ("type cyclic;" if self.cyclic_opposite(s) else
                   sides.get(s, "type zeroGradient;")) + " }\n"
                for s in self.sides())
            if self.dimensions() == 2:
                patches += "frontAndBack { type empty; }\n"
            self.file(f"0/{name}",
                      f"dimensions [0 0 0 0 0 0 0];\ninternalField {inside};\n"
                      f"boundaryField\n{{\n{patches}}}\n", "volScalarField")
            solvers.append(f"    {name} {{ solver PBiCGStab; preconditioner "
                           "DILU; tolerance 1e-12; relTol 0; }\n")
        path = os.path.join(self.path, "system/fvSolution")
        with open(path, encoding="ascii") as stream:
            text = stream.read()
        with open(path, "w", encoding="ascii") as stream:
            stream.write(text.replace("solvers\n{\n", "solvers\n{\n"
                                      + "".join(solvers)))
