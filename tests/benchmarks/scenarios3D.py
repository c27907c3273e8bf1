# SPDX-License-Identifier: GPL-3.0-or-later
"""The thesis's scenario 2 in three dimensions, as a case of any size: spheres
above a fixed one in a unit cube, inflow at the top, Re 1000.

The thesis does not tell the size of its spheres; here it is one in cells.
"""

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
