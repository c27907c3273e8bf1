# SPDX-License-Identifier: GPL-3.0-or-later
"""The thesis's scenario 2 in three dimensions, as a case of any size: spheres
above a fixed one in a unit cube, inflow at the top, Re 1000. The thesis does
not tell the size of its spheres; here it is one in cells.

And red cells between plates that shear.
"""

import os

import fsiCase
import scenarios

OBSTACLE = 0.18

SPEED = "(0 -0.5 0)"


class Falling(fsiCase.Case):
    """width^3 cells, soft spheres of "across" cells.

    The step is that of Courant number 0.5 at speed 1."""

    def __init__(self, path, width, objects, steps, across=12):
        self.size = (width,)*3
        self.objects = objects
        h = 1/width
        radius = across*h/2
        step = 0.5*h
        material = "material { type neoHookean; density 1000; E 2e3; }"
        super().__init__(
            path, box=(0, 0, 0, 1, 1, 1), cells=self.size, viscosity=5e-4,
            density=1000, gravity="(0 -9.81 0)", velocity=SPEED,
            open={"top": (f"type fixedValue; value uniform {SPEED};",
                          "type zeroGradient;"),
                  "bottom": ("type zeroGradient;",
                             "type fixedValue; value uniform 0;")},
            shapes="obstacle { shape { type sphere; radius "
                   f"{OBSTACLE}; }} {material} motion {{ type fixed; }} }}\n"
                   f"small {{ shape {{ type sphere; radius {radius:.6g}; }} "
                   f"{material} }}\n",
            placements="obstacle { type listed; shape obstacle; objects "
                       "({ centre (0.5 0.3 0.5); }); }\n"
                       "small { type random; shape small; number "
                       f"{objects}; seed 1; region {{ min (0.02 0.5 0.02); "
                       f"max (0.98 0.98 0.98); }} velocity {SPEED}; "
                       f"minimumGap {1.5*h:.6g}; wallGap {1.5*h:.6g}; "
                       "maxAttempts 100000; }\n",
            deltaT=step, endTime=step*(steps + 0.5), timePrecision=10,
            libs='("libFastPoisson.so")',
        )
        self.file("system/fvSolution", scenarios.FAST)

    def stock(self, path):
        """The same mesh, fields and step for icoFoam with GAMG."""
        other = scenarios.Stock(path, self)
        other.run("blockMesh")
        return other


class RedCells(fsiCase.Case):
    """Red cells of contrast 5 on 29 % of a box of width^2 x 2 width cells of
    half a micrometre, with 5 uN/m, between plates that shear it at 500/s;
    steps of 5 us."""

    def __init__(self, path, width, steps):
        h, step = 0.5e-6, 5e-6
        self.size = (width, width, 2*width)
        self.objects = round(768*(width/100)**3)
        lid = 250*h*width
        preset = os.path.join(os.path.dirname(os.path.abspath(__file__)),
                              "../../etc/caseDicts/redCell")
        super().__init__(
            path, box=(0, 0, 0, *(n*h for n in self.size)), cells=self.size,
            viscosity=1.2e-6, density=1025, cyclic="xz",
            walls={"bottom": f"({-lid:g} 0 0)", "top": f"({lid:g} 0 0)"},
            properties="membranes { kernel 2; }\n"
                       "contact { law { type none; } }\n",
            shapes="cell { shape { type biconcave; radius 3.91e-6; } "
                   f'material {{ #include "{preset}" '
                   "shearModulus 5e-6; } }\n",
            placements="cells { type packed; shape cell; number "
                       f"{self.objects}; seed 1; start small; }}\n",
            p_tolerance=1e-3, U_tolerance=5e-3,
            deltaT=step, endTime=step*(steps + 0.5), timePrecision=10,
            writeFormat="binary",
        )
