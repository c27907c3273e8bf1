#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Variables of the user in the dictionaries of a case: $name, #include, shared
dictionaries, #eval. What is misspelled is an error all the same."""

import os
import sys

import fsiCase
import refused
import results

PARAMETERS = """
rho 1.2; R 0.12; E 20; nCells 24; inletSpeed 3;
rubber { density $rho; E $E; }
"""

SEEDS = """
#include "parameters"
size 0.1;
common { nodeSpacing 0.04; material { $:rubber; } }
shapes
{
    steel { density 2; }
    small
    {
        $common;
        half { radius #eval{ $:size + 0.02 }; }
        shape { type circle; $half; }
        material { law { viscosity 1; } springLaw { type Maxwell; $..law; } }
        motion { kind free; type $kind; }
    }
    ball
    {
        shape { type circle; radius $R; }
        material { type rigid; $steel; }
    }
}
placements
{
    places { type listed; }
    two
    {
        $places;
        shape small;
        x 0.3;
        objects ({ centre ($x 0.7 0); } { centre (0.7 $x 0); });
    }
    one { $places; shape ball; objects ({ centre (0.7 0.7 0); }); }
}
"""

PROPERTIES = """
#include "../system/parameters"
#includeIfPresent "notThere"
density $rho;
fluidDensity $density;
gravity (0 -1 0);
few { passes 2; }
coupling { mu 3; type solidImplicit; $few; passTolerance #eval{ $mu/1000 }; }
output { "(surfaces|springs)" no; }
"""


def case_in(folder, seeds=SEEDS, properties=PROPERTIES):
    """The case, not seeded."""
    case = fsiCase.Case(folder, cells=(24, 24), deltaT=0.005, endTime=0.015,
                        writeInterval=1, startFrom="latestTime",
                        writePrecision=17)
    case.file("system/parameters", PARAMETERS)
    case.file("system/seedObjectsDict", seeds)
    case.file("constant/fsiProperties", properties)
    case.run("blockMesh")
    return case


def used(report, folder):
    """A run and a restart with all of them."""
    case = case_in(folder)
    case.run("seedObjects")
    case.run("fsiPisoFoam")
    case.control(endTime=0.02)
    case.run("fsiPisoFoam")
    case.run("checkObjects")
    small = results.read(folder, "constant/fsiObjects/small")
    report.check(
        "variables.values",
        "passes 2" not in small and "viscosity" in small
        and "density         1.2;" in small,
        small[:600])


def misspelled(report, folder):
    """Each is refused, by its name and the one that is meant."""
    wrong = {
        "top": ("seedObjects", {"seeds": SEEDS + "placement { }"},
                ["'placement'", "placements"]),
        "nested": ("seedObjects", {"seeds": SEEDS.replace(
            "radius $R;", "radius $R; radios 3;")},
                   ["'radios'", "radius", "seedObjectsDict"]),
        "pattern": ("seedObjects", {"seeds": SEEDS.replace(
            "radius $R;", 'radius $R; "rod.*" 3;')}, ["rod.*"]),
        "properties": ("fsiPisoFoam", {"properties": PROPERTIES + "Gravty 1;"},
                       ["'Gravty'", "gravity", "fsiProperties"]),
        "case": ("fsiPisoFoam", {"properties": PROPERTIES + "CONTACT { }"},
                 ["'CONTACT'", "contact"]),
        "inPart": ("fsiPisoFoam", {"properties": PROPERTIES.replace(
            "$few;", "$few; pases 2;")}, ["'pases'", "passes"]),
    }
    for name, (program, texts, message) in wrong.items():
        case = case_in(os.path.join(folder, name), **texts)
        if program == "fsiPisoFoam":
            case.run("seedObjects")
        refused.refused(report, "variables.misspelled." + name, case, program,
                        message)
    case = case_in(os.path.join(folder, "unused"),
                   properties=PROPERTIES + "colour blue;\ng (0 -9 0);\n")
    case.run("seedObjects")
    log = case.run("fsiPisoFoam")
    report.check("variables.unused",
                 "'colour' in" in log and "'g' in" in log
                 and "'inletSpeed'" not in log and "'density' in" not in log,
                 "no warning of colour alone")


def main():
    report = fsiCase.Report()
    folder = sys.argv[1]
    report.attempt("variables", used, report, os.path.join(folder, "used"))
    report.attempt("misspelled", misspelled, report, folder)
    return report.failures > 0


if __name__ == "__main__":
    sys.exit(main())
