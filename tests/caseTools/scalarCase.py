# SPDX-License-Identifier: GPL-3.0-or-later
"""Cases with scalars that the flow carries."""

import math
import os

import fsiCase
import results

SIDES = ("left", "right", "bottom", "top", "back", "front")

STEPS = 30

PLANE = """
disc
{
    shape    { type circle; radius 0.15; }
    material { type rigid; density 3; }
}
bar
{
    shape    { type ellipse; semiAxes (0.12 0.24); }
    material { density 2; E 50; }
}
"""

SOLID = """
disc
{
    shape    { type sphere; radius 0.2; }
    material { type rigid; density 3; }
}
bar
{
    shape    { type ellipsoid; semiAxes (0.12 0.24 0.15); }
    material { density 2; E 50; }
}
"""


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


def steps_of(n, *values):
    """A nonuniform list: the values in turn, in equal parts of n cells."""
    size = -(-n//len(values))
    text = " ".join(str(values[i//size]) for i in range(n))
    return f"nonuniform List<scalar> {n} ({text})"


def box(folder, name, solid=False, surfaces="", of_even="",
        values=(1, 0, 2, 0.5), **changes):
    """Bodies that fall and bend in a closed box with a lid that moves, with a
    scalar that starts with values in equal parts and a uniform one."""
    cells = (24, 16, 16) if solid else (48, 32)
    n = cells[0]*cells[1]*(cells[2] if solid else 1)
    z = 0.5 if solid else 0
    return ScalarCase(
        os.path.join(folder, name),
        (("dye", f"diffusivity 1e-3; surfaces {{ {surfaces} }}",
          steps_of(n, *values), {}),
         ("even", f"diffusivity 1e-3; surfaces {{ {of_even} }}", "uniform 3",
          {})),
        box=(0, 0, 0, 1.5, 1, 1) if solid else (0, 0, 1.5, 1), cells=cells,
        viscosity=0.01, p_tolerance=1e-10, walls={"top": "(1 0 0)"},
        gravity="(0 -5 0)", shapes=SOLID if solid else PLANE,
        placements=f"""
        a {{ type listed; shape disc; objects ({{ centre (0.4 0.6 {z}); }}); }}
        b {{ type listed; shape bar; objects ({{ centre (1 0.5 {z}); }}); }}
        """, **{
            "deltaT": 0.01, "endTime": 0.01*STEPS, "writeInterval": STEPS//2,
            "writePrecision": 17, **changes}).set_up()


def amount(case, time, name):
    """The sum of C times the volume that cells hold, exactly rounded."""
    return math.fsum(c*w for c, w in zip(
        results.field(case.path, time, name),
        results.field(case.path, time, name + "Volume")))


def apart(case, other, name):
    """The largest difference of a field at the end of two runs."""
    time = results.times(case.path)[-1]
    return max(abs(a - b) for a, b in zip(
        results.field(case.path, time, name),
        results.field(other.path, time, name)))


def ball(solid, radius=0.25):
    """Shape and placement of a fixed disc or sphere."""
    shape = "sphere" if solid else "circle"
    return {"shapes": f"disc {{ shape {{ type {shape}; radius {radius}; }} "
                      "material { type rigid; density 1; } "
                      "motion { type fixed; } }",
            "placements": "a { type listed; shape disc; "
                          "objects ({ centre (0 0 0); }); }"}


def moves(case):
    """How far an object's node moves, in cells."""
    first, *_, last = results.times(case.path)
    one, two = (results.state(case.path, t) for t in (first, last))
    h = case.values["box"][case.dimensions()]/case.values["cells"][0]
    return max(math.dist(a, b)/h for i in one
               for a, b in zip(one[i][1], two[i][1]))


def keeps(report, folder, solid, surfaces="", beyond=1e-11):
    """Checks that amounts are kept, that a uniform scalar stays so, and that
    values go beyond their bounds by so much at most; on all ranks and after a
    restart. surfaces: of the scalars."""
    name = "solid" if solid else "plane"
    case = box(folder, name, solid, surfaces, surfaces)
    case.run("fsiPisoFoam")
    half, end = results.times(case.path)[1:]
    row = results.table(case.path, "dye.csv")
    print(f"    {name}: {row[-1]}")
    for scalar in ("dye", "even"):
        kept = abs(amount(case, end, scalar)/amount(case, half, scalar) - 1)
        print(f"    {name}: amount of {scalar} changes by {kept:.1e}")
        report.check(f"{name}: amount of {scalar}", kept < 1e-13, f"{kept}")
    first, last = (r["amount"] + sum(v for k, v in r.items() if k[:2] == "in"
                                     and k != "inflow")
                   for r in (row[0], row[-1]))
    table = abs(first/last - 1)
    report.check(f"{name}: amount from the first step on", table < 1e-11,
                 f"{table}")
    uneven = max(abs(c/3 - 1) for c in results.field(case.path, end, "even"))
    report.check(f"{name}: uniform stays so", uneven < 1e-11, f"{uneven}")
    outside = max(-min(r["least"] for r in row),
                  max(r["largest"] for r in row) - 2)
    report.check(f"{name}: bounds", outside < beyond, f"{outside}")
    moved = moves(case)
    report.check(f"{name}: bodies move by a cell", moved > 1, f"{moved}")

    other = box(folder, name + "Restart", solid, surfaces, surfaces,
                endTime=float(half))
    other.run("fsiPisoFoam")
    other.control(endTime=0.01*STEPS, startFrom="latestTime")
    other.run("fsiPisoFoam")
    change = apart(case, other, "dye")
    report.check(f"{name}: restart", change == 0, f"{change}")
    for n in (2, 3):
        other = box(folder, f"{name}{n}", solid, surfaces, surfaces)
        other.run("fsiPisoFoam", ranks=other.decompose(n, 1))
        other.run("reconstructPar", "-latestTime")
        change = apart(case, other, "dye")
        print(f"    {name} on {n} ranks: {change:.1e} apart")
        report.check(f"{name} on {n} ranks", change < 1e-6, f"{change}")
