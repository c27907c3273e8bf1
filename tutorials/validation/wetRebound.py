# SPDX-License-Identifier: GPL-3.0-or-later
"""A sphere that falls on a wall in a liquid and rebounds: its restitution by
the Stokes number.

St* = (density + 0.5 fluid's density) D U/(9 mu) with the speed U of the impact.
Without a fluid the restitution is 1 here. Gondret, Lance and Petit (Phys.
Fluids 14, 643, 2002) and Joseph et al. (J. Fluid Mech. 433, 329, 2001) find no
rebound below a Stokes number of about 10 and nearly the dry restitution above
500. The fit exp(-35/St*) of such data is by Legendre, Daniel and Guiraud (Phys.
Fluids 17, 097105, 2005); its constant is from memory. The tolerance for it is
0.12, from St* 30 on.

Films take the more of the speed, the thinner they get: by ln(g_1/g_2)/St from
one gap to another. The flow has them down to `minimumGap`; contact takes what
is below it, down to `roughness`. Of spheres of 12.7 mm that hit each other in a
liquid, steel beads have a roughness of 272 nm, ones of glass 134 nm, of Delrin
796 nm (data of the script to Nijssen, Ottens and Padding, Powder Technol. 413,
118017, 2022): 2e-5, 1e-5 and 6e-5 of the diameter.

The sphere starts 1.5 diameters above the wall with its terminal speed by Clift,
Grace and Weber (1978), and falls under its weight. U is its largest speed in
the last diameter, and the rebound's speed is taken a tenth of a diameter above
the wall; 0 if the sphere does not come so far.
"""

import math

from common import Case, Row, sphere

# Density of the sphere over the fluid's: steel in water or oil
RATIO = 8

STOKES = (6, 10, 40, 100, 500)

# Of steel beads, in diameters
ROUGHNESS = 2.1e-5

# Gap in diameters at which the rebound's speed is taken
MEASURED = 0.1


def fit(stokes):
    """Restitution over the dry one."""
    return math.exp(-35/stokes)


def rebound(stokes, cells, gap, roughness):
    """Stokes number of the impact, restitution, and minutes. Diameter, speed
    and the fluid's density are about 1; cells: to a diameter; gap: of contact
    in cells; roughness: None if films end there."""
    viscosity = (RATIO + 0.5)/(9*stokes)
    reynolds = 1/viscosity
    drag = 24/reynolds*(1 + 0.1935*reynolds**0.6305)
    case = Case(
        f"wetRebound-{stokes}-{cells}-{gap}-{roughness}",
        box=(-2, 0, -2, 2, 4, 2),
        cells=(4*cells,)*3, viscosity=viscosity,
        gravity=f"(0 {-0.75*drag/(RATIO - 1)!r} 0)",
        shapes=sphere(0.5, f"type rigid; density {RATIO};"),
        placements="a { type listed; shape sphere; objects ({ centre "
                   "(0.011 2.007 0.017); velocity (0 -1 0); }); }",
        properties=f"contact {{ minimumGap {gap}; "
                   + (f"roughness {roughness};" if roughness else "")
                   + " } output { objectsEvery 1; }", deltaT=0.02/cells,
        endTime=2.6, writeInterval=4)
    minutes = case.solve()
    rows = case.objects()
    impact = max(-row["velocityY"] for row in rows
                 if row["centroidY"] < 1.5)
    lowest = min(range(len(rows)), key=lambda i: rows[i]["centroidY"])
    back = [row["velocityY"] for row in rows[lowest:]
            if row["centroidY"] > 0.5 + MEASURED]
    return stokes*impact, back[0]/impact if back else 0, minutes


def rebounds(meshes=(8,), contacts=((0.1, ROUGHNESS), (0.01, ROUGHNESS),
                                    (0.1, 5*ROUGHNESS), (0.1, None))):
    """Gaps and roughness of contact, and Stokes numbers."""
    for cells in meshes:
        for gap, roughness in contacts:
            for stokes in STOKES:
                found, restitution, minutes = rebound(stokes, cells, gap,
                                                      roughness)
                reference = fit(found) if found >= 8 else 0
                known = roughness and (found >= 30 or found < 8)
                rough = f", roughness {roughness:.2g} D" if roughness else ""
                yield Row(f"sphere that rebounds in a liquid, St* {found:.3g}, "
                          f"restitution, contact at {gap} h{rough}",
                          f"D/h = {cells}", reference, restitution,
                          0.12 if known else None, minutes)


LONG = {"wetRebound": rebounds}
