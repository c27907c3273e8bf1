# SPDX-License-Identifier: GPL-3.0-or-later
"""The scenarios of the thesis, section 6, as cases of any size.

1  lid-driven cavity, two stars above and below a band of discs
2  1 x 2 box, inflow at the top, discs above a fixed obstacle, Re 1000
3  2 x 1 channel of biconcave cells in random directions

The thesis keeps the density of the objects for fixed N (table 6.1) and gives
them a size in cells otherwise (table 6.2). Here the part of the seeded region
that they cover is FRACTION in all rows, from which their size follows.
"""

import math
import os

import boxFiles
import fsiCase

# Of the seeded region, covered by discs or cells
FRACTION = {1: 0.25, 2: 0.25, 3: 0.25}

# Box, seeded region (x0, y0, x1, y1), velocity of the fluid, its viscosity
BOX = {1: (0, 0, 1, 1), 2: (0, 0, 1, 2), 3: (0, 0, 2, 1)}
REGION = {1: (0.02, 0.38, 0.98, 0.62), 2: (0.05, 1.1, 0.95, 1.9),
          3: (0.05, 0.05, 1.95, 0.95)}
SPEED = {1: (0, 0), 2: (0, -0.5), 3: (0.5, 0)}
VISCOSITY = {1: 1e-2, 2: 5e-4, 3: 1e-3}

# Area of the biconcave section (theory.md, (3.17)) over its radius squared
BICONCAVE_AREA = 0.891

GAMG = """solvers
{
    p { solver GAMG; smoother GaussSeidel; tolerance 1e-6; relTol 0; }
    pFinal { $p; }
    U { solver smoothSolver; smoother symGaussSeidel;
        tolerance 1e-6; relTol 0; }
}
PISO { nCorrectors 2; pRefCell 0; pRefValue 0; }
"""

FAST = """solvers
{
    p { solver cartesianMG; tolerance 1e-6; relTol 0; }
    U { solver PBiCGStab; preconditioner DILU; tolerance 1e-6; relTol 0; }
}
PISO { pRefCell 0; pRefValue 0; }
"""

# Heavy, stiff objects, closed faces and the thesis's load for the weak
# coupling, which is not stable with others (theory.md, section 5.3), and out of
# reach of contact at the start; soft ones of the fluid's density for the
# default. Gaps in cells
KINDS = {
    "default": {"density": 1000, "E": 2e3, "gap": 1.5, "properties": ""},
    "weak": {"density": 10000, "E": 1e9, "gap": 3.1,
             "properties": fsiCase.THESIS
                           + "coupling { type weak; load nearestCell; }\n"
                           "wall voxel;\n"},
}


def radius(number, objects):
    """Radius of the small objects of a scenario."""
    x0, y0, x1, y1 = REGION[number]
    area = BICONCAVE_AREA if number == 3 else math.pi
    return math.sqrt(FRACTION[number]*(x1 - x0)*(y1 - y0)/(area*objects))


def shapes(number, objects, kind):
    """Entries shapes of seedObjectsDict."""
    material = f"material {{ density {kind['density']}; E {kind['E']}; }}"
    small = "biconcave" if number == 3 else "circle"
    text = (f"small {{ shape {{ type {small}; radius "
            f"{radius(number, objects):.6g}; }} {material} "
            "minimumCells 1.5; }\n")
    if number == 1:
        text += ("star { shape { type star; radius 0.13; amplitude 0.25; "
                 f"points 5; }} {material} }}\n")
    if number == 2:
        text += (f"obstacle {{ shape {{ type circle; radius 0.15; }} {material}"
                 " motion { type fixed; } }\n")
    return text


def placements(number, objects, cells, kind):
    """Entries placements of seedObjectsDict."""
    x0, y0, x1, y1 = REGION[number]
    u, v = SPEED[number]
    gap = kind["gap"]*(BOX[number][2])/cells[0]
    text = ""
    if number == 1:
        text += ("stars { type listed; shape star; objects ("
                 "{ centre (0.5 0.79 0); rotation 18; }"
                 "{ centre (0.5 0.21 0); rotation 54; } ); }\n")
    if number == 2:
        text += ("obstacle { type listed; shape obstacle; objects ("
                 "{ centre (0.5 0.6 0); } ); }\n")
    return text + (
        f"small {{ type random; shape small; number {objects}; seed 1; "
        f"region {{ min ({x0} {y0} 0); max ({x1} {y1} 0); }} "
        f"velocity ({u} {v} 0); velocityPerturbation "
        f"{0.1 if number == 3 else 0}; minimumGap {gap}; wallGap {gap}; "
        "maxAttempts 100000; }\n")


class Scenario(fsiCase.Case):
    """One scenario with a number of small objects and of cells across.

    The step is that of Courant number 0.5 at speed 1."""

    def __init__(self, path, number, width, objects, steps, kind="default"):
        self.number = number
        x0, y0, x1, y1 = BOX[number]
        self.size = (width, round(width*(y1 - y0)/(x1 - x0)))
        self.objects = objects
        self.steps = steps
        step = 0.5*(x1 - x0)/width
        choice = KINDS[kind]
        super().__init__(
            path, box=BOX[number], cells=self.size,
            viscosity=VISCOSITY[number], density=1000,
            gravity="(0 -9.81 0)" if number == 2 else "(0 0 0)",
            walls={"top": "(1 0 0)"} if number == 1 else {},
            properties=choice["properties"],
            shapes=shapes(number, objects, choice),
            placements=placements(number, objects, self.size, choice),
            deltaT=step, endTime=step*(steps + 0.5), timePrecision=10,
            libs='("libFastPoisson.so")',
        )
        self.file("system/fvSolution", FAST)

    def stock(self, path):
        """The same mesh, fields and step for icoFoam with GAMG."""
        other = Stock(path, self)
        other.run("blockMesh")
        return other

    def mesh(self):
        """Open sides of scenarios 2 and 3 are no walls."""
        super().mesh()
        for side in self.open_sides():
            self.replace("system/blockMeshDict", f"{side} {{ type wall;",
                         f"{side} {{ type patch;")

    def open_sides(self):
        """Inflow and outflow."""
        return {1: (), 2: ("top", "bottom"), 3: ("left", "right")}[self.number]

    def fields(self):
        """Inflow with the fluid's velocity, outflow at p = 0."""
        super().fields()
        if self.number == 1:
            return
        inflow, outflow = self.open_sides()
        u, v = SPEED[self.number]
        at_rest = "type fixedValue; value uniform (0 0 0);"
        moving = f"type fixedValue; value uniform ({u} {v} 0);"
        self.replace("0/U", "internalField uniform (0 0 0)",
                     f"internalField uniform ({u} {v} 0)")
        for side in boxFiles.FACES:
            self.replace("0/U", f"{side} {{ {at_rest}", f"{side} {{ {moving}")
        self.replace("0/U", f"{outflow} {{ {moving}",
                     f"{outflow} {{ type zeroGradient;")
        self.replace("0/p", f"{outflow} {{ type zeroGradient;",
                     f"{outflow} {{ type fixedValue; value uniform 0;")

    def replace(self, name, old, new):
        """Replaces a text that must be in a file."""
        path = os.path.join(self.path, name)
        with open(path, encoding="ascii") as stream:
            text = stream.read()
        if old not in text:
            raise ValueError(f"{path} has no '{old}'")
        with open(path, "w", encoding="ascii") as stream:
            stream.write(text.replace(old, new))


class Stock(fsiCase.Case):
    """A scenario's box without objects, by icoFoam."""

    def __init__(self, path, scenario):
        values = {**scenario.values, **scenario.controls,
                  "application": "icoFoam", "shapes": "", "placements": ""}
        self.fluid = scenario
        super().__init__(path, **values)
        self.file("system/fvSolution", GAMG)

    def mesh(self):
        """That of the scenario."""
        self.take("system/blockMeshDict")

    def fields(self):
        """Those of the scenario."""
        self.take("0/U")
        self.take("0/p")

    def take(self, name):
        """Copies a file of the scenario."""
        with open(os.path.join(self.fluid.path, name),
                  encoding="ascii") as stream:
            text = stream.read()
        target = os.path.join(self.path, name)
        os.makedirs(os.path.dirname(target), exist_ok=True)
        with open(target, "w", encoding="ascii") as stream:
            stream.write(text)
