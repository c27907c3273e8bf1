# SPDX-License-Identifier: GPL-3.0-or-later
"""The case of capsule.py and lines.py: a capsule in simple shear flow."""

import os

import fsiCase

HALF = 4
VISCOSITY = 20
STEP = 0.02

# A sheet that hardly changes its area. With five cells to the radius and a step
# of 0.02 dt a/(mu h) is 67, where explicit forces need 17
STIFF = {"law": "Skalak", "material": f"areaModulus {200*VISCOSITY/0.3};"}


def shear(case, n, layers):
    """Starts a case with the flow of its walls."""
    size = 2*HALF/n
    rows = "".join(f"({-HALF + (j + 0.5)*size} 0 0)\n"*n for j in range(n))
    name = os.path.join(case.path, "0/U")
    with open(name, encoding="ascii") as stream:
        text = stream.read()
    with open(name, "w", encoding="ascii") as stream:
        stream.write(text.replace(
            "internalField uniform (0 0 0);",
            f"internalField nonuniform List<vector> {layers*n**2}\n(\n"
            f"{rows*layers});"))


def capsule(folder, name, cells=5, capillary=0.3, material="",
            law="neoHookean", modulus="shearModulus", plane=False, **more):
    """The seeded case, with this many cells to the radius."""
    n = 2*HALF*cells
    dims = 2 if plane else 3
    values = {"deltaT": STEP, "endTime": 1, "properties":
              "output { objectsEvery 1; }", "p_tolerance": 1e-5,
              "U_tolerance": 1e-6, **more}
    case = fsiCase.Case(
        os.path.join(folder, name),
        box=(-HALF,)*dims + (HALF,)*dims, cells=(n,)*dims,
        viscosity=VISCOSITY, cyclic="x" if plane else "xz",
        walls={"top": f"({HALF} 0 0)", "bottom": f"({-HALF} 0 0)"},
        shapes="capsule { shape { type "
               f"{'circle' if plane else 'sphere'}; radius 1; }} material {{ "
               f"type membrane; law {law}; density 1; "
               f"{modulus} {VISCOSITY/capillary}; {material} }} }}",
        placements="all { type listed; shape capsule; "
                   "objects ({ centre (0 0 0); }); }", **values)
    shear(case, n, 1 if plane else n)
    return case.set_up()
