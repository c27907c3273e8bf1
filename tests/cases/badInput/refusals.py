#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Bad input ends seedObjects or fsiPisoFoam in a FOAM FATAL (IO) ERROR that
names the file and the key.

    refusals.py FOLDER

Each line of the tables is a name, what is wrong, and texts of the message.
"""

import os
import re
import sys

import boxFiles
import fsiCase
from refused import refused
import results

SHAPE = ("disc {{ shape {{ {shape} }} material {{ density {density}; E 1e4; "
         "{law} }} {more} }}")
PLACEMENT = "a {{ type {type}; shape disc; objects ({objects}); }}"

GOOD = {"shape": "type circle; radius 0.1;", "density": "1.1", "law": "",
        "more": "", "type": "listed", "objects": "{ centre (0.5 0.5 0); }"}

# Entries of GOOD that are replaced
SEEDING = [
    ("wrong key of a shape", {"more": "colour red;"},
     ("colour", "material")),
    ("wrong key of a material", {"law": "colour red;"},
     ("colour", "density")),
    ("masses of nodes, an entry of earlier versions",
     {"law": "nodeMass uniform;"}, ("nodeMass", "density")),
    ("wrong key of an outline", {"shape": GOOD["shape"] + " colour red;"},
     ("colour", "radius")),
    ("unknown shape", {"shape": "type blob;"}, ("blob", "circle")),
    ("unknown spring law", {"law": "springLaw { type gum; }"},
     ("gum", "Hookean")),
    ("spring law that is no dictionary", {"law": "springLaw Hookean;"},
     ("springLaw", "must be a dictionary")),
    ("unknown motion", {"more": "motion { type jumping; }"},
     ("jumping", "oscillating")),
    ("motion that is no dictionary", {"more": "motion fixed;"},
     ("motion", "must be a dictionary")),
    ("unknown placement", {"type": "heap"}, ("heap", "listed")),
    ("obstacle outside the domain",
     {"objects": "{ centre (1.5 0.5 0); }", "more": "motion { type fixed; }"},
     ("objects", "object 0", "not in the domain")),
    ("objects that turn without end",
     {"objects": "{ centre (0.5 0.5 0); rotation 1e300; }"},
     ("rotation", "1e15")),
    ("objects without a place", {"objects": "{ centre (1e200 0 0); }"},
     ("centre", "1e15")),
    ("absurd velocity",
     {"objects": "{ centre (0.5 0.5 0); velocity (1e200 0 0); }"},
     ("velocity", "1e15")),
    ("overlapping objects",
     {"objects": "{ centre (0.5 0.5 0); } { centre (0.6 0.5 0); }"},
     ("objects", "object 1", "object 0")),
    ("object thinner than 3 h", {"shape": "type circle; radius 0.04;"},
     ("shape", "disc", "3 cells")),
    ("negative density", {"density": "-1"}, ("density", "-1")),
    ("negative radius", {"shape": "type circle; radius -0.1;"},
     ("radius", "-0.1")),
    ("polygon without a file", {"shape": 'type polygon; file "nowhere.csv";'},
     ("nowhere.csv",)),
    ("unreadable polygon", {"shape": 'type polygon; file "bad.csv";'},
     ("bad.csv",)),
    ("polygon of absurd size", {"shape": 'type polygon; file "absurd.csv";'},
     ("absurd.csv", "line 2", "1e15")),
    ("polygon with a word", {"shape": 'type polygon; file "words.dat";'},
     ("words.dat", "line 2", "column y", "'zero'")),
    ("object larger than the domain", {"shape": "type circle; radius 2;"},
     ("shape", "disc", "that of the domain")),
    ("self-crossing polygon", {"shape": 'type polygon; file "crossed.csv";'},
     ("crossed.csv", "cross")),
]

# Text that is added to fsiProperties
PROPERTIES = [
    ("wrong key in fsiProperties", "gravty (0 1 0);", ("gravty", "gravity")),
    ("wrong key of the coupling", "coupling { colour red; }",
     ("colour", "coupling")),
    ("wrong key of the level set", "levelSet { colour red; }",
     ("colour", "bandWidth")),
    ("wrong key of the contact", "contact { colour red; }",
     ("colour", "range")),
    ("wrong key of the contact law", "contact { law { colour red; } }",
     ("colour", "stiffness")),
    ("wrong key of the output", "output { colour red; }",
     ("colour", "output")),
    ("unknown wall", "wall brick;", ("wall", "brick", "openArea")),
    ("unknown coupling", "coupling { type tight; }",
     ("coupling", "tight", "solidImplicit")),
    ("coupling that is no dictionary", "coupling weak;",
     ("coupling", "must be a dictionary")),
    ("contact law that is no dictionary", "contact { law elastic; }",
     ("law", "must be a dictionary")),
    ("unknown load", fsiCase.THESIS + "coupling { type weak; load bale; }",
     ("load", "bale", "wallForce")),
    ("unknown level set", "levelSet { type guessed; }",
     ("levelSet", "guessed", "rebuilt")),
    ("unknown contact law", "contact { law { type glue; } }",
     ("law", "glue", "elastic")),
    ("unknown contact search", "contact { search { type luck; } }",
     ("search", "luck", "surfaceTree")),
    ("unknown driving force", "drivingForce { type wind; }",
     ("drivingForce", "wind", "meanVelocity")),
    ("mean velocity without cyclic patches",
     "drivingForce { type meanVelocity; velocity (1 0 0); }",
     ("velocity", "not cyclic")),
    ("feed at a patch that is not open",
     "boundaries { feed { top { shape disc; rate 1; } } }",
     ("top", "open patch", "left")),
    ("feed at a pattern of names",
     'boundaries { feed { "le.*" { shape disc; rate 1; } } }',
     ("le.*", "open patch", "left")),
    ("march's order", fsiCase.THESIS + "levelSet { type advected; order 3; }",
     ("order", "3", "1 to 2")),
    ("feed of an unknown shape",
     "boundaries { feed { left { shape blob; rate 1; velocity (1 0 0); } } }",
     ("shape", "blob", "disc")),
    ("feed with an unknown entry", "boundaries { feed { left { sort a; } } }",
     ("sort", "areaFraction")),
    ("feed without a rate",
     "boundaries { feed { left { shape disc; velocity (1 0 0); } } }",
     ("rate", "areaFraction")),
    ("feed that moves outward", "boundaries { feed { left { shape disc; "
     "rate 1; velocity (-1 0 0); } } }", ("velocity", "into the domain")),
    ("feed through too narrow a patch", "boundaries { feed { left { shape "
     "disc; rate 1; velocity (1 0 0); sideGap 0.41; } } }",
     ("sideGap", "never fits", "left")),
    ("history of faces, an entry of earlier versions", "faceHistory limited;",
     ("faceHistory", "minWallDistance")),
    ("objects written backwards", "output { objectsEvery -1; }",
     ("objectsEvery", "-1", ">= 0")),
    ("gravity in z", "gravity (0 0 -9.81);", ("gravity", "-9.81", "in z")),
    ("contact over a large range", "contact { range 40; }",
     ("range", "40", "0.01 to 20")),
    ("large margin", "contact { margin 1e9; }", ("margin", "0 to 20")),
    ("large gap", "contact { minimumGap 100; }", ("minimumGap", "to 20")),
    ("roughness", "contact { roughness 1e-5; }", ("roughness", "is rigid")),
    ("wide band", "levelSet { bandWidth 1e9; }", ("bandWidth", "3 to 100")),
    ("distance of many cells", "minWallDistance 10;",
     ("minWallDistance", "to 1")),
    ("too many sweeps", "contact { law { maxSweeps 1e9; } }",
     ("maxSweeps",)),
    ("Morse's width of nothing", "contact { law { type Morse; "
     "adhesionEnergy 1; width 1e-9; } }", ("width", "0.05")),
    ("no stiffness to speak of", "contact { law { stiffness 1e-200; } }",
     ("stiffness", "1e-50")),
    ("absurd gravity", "gravity (0 1e300 0);", ("gravity", "1e15")),
    ("absurd driving", "drivingForce { type acceleration; "
     "acceleration (1e300 0 0); }", ("acceleration", "1e15")),
    ("negative fluid density", "fluidDensity -1;", ("fluidDensity", "-1")),
]


def shapes(changes):
    """Entries shapes and placements of a case."""
    words = {**GOOD, **changes}
    return {"shapes": SHAPE.format(**words),
            "placements": PLACEMENT.format(**words)}


def check_seeding(report, case):
    """What seedObjects refuses."""
    for name, content in (("bad.csv", "a,b\n0,zero\n"),
                          ("crossed.csv", "0,0\n0.2,0.2\n0.2,0\n0,0.2\n"),
                          ("absurd.csv", "0,0\n1e300,0\n0,1e300\n"),
                          ("words.dat", "0 0\n0.2 zero\n0.2 0.2\n")):
        with open(os.path.join(case.path, name), "w",
                  encoding="ascii") as stream:
            stream.write(content)

    for name, changes, texts in SEEDING:
        changes = {k: v.replace('file "', f'file "{case.path}/')
                   for k, v in changes.items()}
        case.values.update(shapes(changes))
        case.write()
        refused(report, name, case, "seedObjects",
                ("FATAL IO ERROR", "seedObjectsDict") + texts)

    case.values.update(shapes({}))
    case.write()
    case.append("system/seedObjectsDict", "placement {}\n")
    refused(report, "misspelled key in seedObjectsDict", case, "seedObjects",
            ("FATAL IO ERROR", "seedObjectsDict", "'placement'", "placements"))


def check_properties(report, case):
    """What fsiPisoFoam refuses in constant/fsiProperties."""
    for name, text, texts in PROPERTIES:
        case.values["properties"] = text + "\n"
        case.write()
        refused(report, name, case, "fsiPisoFoam",
                ("FATAL IO ERROR", "fsiProperties") + texts)
    case.values["properties"] = ""
    case.write()


def check_control(report, case):
    """Time steps and meshes that fsiPisoFoam refuses."""
    for value in ("0", "-0.01"):
        case.control(deltaT=value)
        refused(report, f"time step {value}", case, "fsiPisoFoam",
                ("FATAL IO ERROR", "controlDict", "deltaT"))
    case.control(deltaT=0.01, minDeltaT=1)
    refused(report, "minDeltaT above deltaT", case, "fsiPisoFoam",
            ("FATAL IO ERROR", "controlDict", "'minDeltaT'", "0.01"))
    del case.controls["minDeltaT"]
    case.control(adjustTimeStep="yes", maxTimeError=1e-12, endTime=1)
    refused(report, "maxTimeError that no step can have", case, "fsiPisoFoam",
            ("FATAL ERROR", "maxTimeError", "no matter of speed"))
    del case.controls["maxTimeError"]
    case.control(adjustTimeStep="no", endTime=0.01)

    for kind, name, scheme, valid in (
            ("ddtSchemes", "default", "steadyState", "backward"),
            ("ddtSchemes", "default", "CrankNicolson", "backward"),
            ("divSchemes", "div(phi,U)", "bounded Gauss linear", "as Gauss")):
        case.append("system/fvSchemes", f"{kind} {{ {name} {scheme}; }}\n")
        refused(report, f"{name} {scheme}", case, "fsiPisoFoam",
                ("FATAL IO ERROR", "fvSchemes", scheme.split()[0], valid))
        case.write()

    case.append("system/fvSolution", "solvers { p { solver PGC; } }\n")
    refused(report, "unknown solver of the pressure", case, "fsiPisoFoam",
            ("FATAL IO ERROR", "fvSolution", "PGC", "cartesianMG"))
    case.write()

    os.remove(os.path.join(case.path, "constant/fsiObjects/disc"))
    refused(report, "missing shape", case, "fsiPisoFoam",
            ("FATAL ERROR", "constant/fsiObjects/disc", "seedObjects"))

    case.values["grading"] = "2 1 1"
    case.write()
    case.run("blockMesh")
    for program in ("seedObjects", "fsiPisoFoam"):
        refused(report, f"graded mesh, {program}", case, program,
                ("FATAL ERROR", "polyMesh", "cell", "uniform Cartesian"))


def check_sides(report, folder):
    """A feed through a patch that is on two sides."""
    case = fsiCase.Case(
        os.path.join(folder, "sides"), cells=(32, 32), endTime=0.01,
        open={"left": ("type zeroGradient;",
                       "type fixedValue; value uniform 0;")},
        properties="boundaries { feed { left { shape disc; rate 1; "
                   "velocity (1 0 0); } } }\n", **shapes({}))
    case.write()
    text = results.read(case.path, "system/blockMeshDict")
    right = re.search(r"right \{.*\n", text).group()
    faces = boxFiles.FACES
    text = text.replace(right, "").replace(
        faces["left"], f"{faces['left']} {faces['right']}")
    case.text("system/blockMeshDict", text)
    case.run("blockMesh")
    case.run("seedObjects")
    refused(report, "feed at a patch on two sides", case, "fsiPisoFoam",
            ("FATAL IO ERROR", "fsiProperties", "left", "one side"))


def check_motion(report, folder):
    """An object that moves through the domain in a step."""
    changes = shapes({"type": "listed; velocity (100 0 0)"})
    case = fsiCase.Case(os.path.join(folder, "fast"), cells=(32, 32),
                        deltaT=0.01, endTime=0.01,
                        properties="coupling { type none; }\n", **changes)
    if report.attempt("set-up of a fast object", case.set_up):
        refused(report, "object through the domain in a step", case,
                "fsiPisoFoam",
                ("FATAL ERROR", "Object 0", "32 cells", "deltaT"))


def main(folder):
    """The checks."""
    report = fsiCase.Report()
    case = fsiCase.Case(
        os.path.join(folder, "case"), cells=(32, 32), endTime=0.01,
        open={"left": ("type zeroGradient;",
                       "type fixedValue; value uniform 0;")},
        **shapes({}))
    log = (report.attempt("set-up", case.set_up)
           and report.attempt("good input is accepted", case.run,
                              "fsiPisoFoam"))
    if log:
        report.check("good input is accepted", log.rstrip().endswith("End"),
                     "no End in the log")
        check_seeding(report, case)
        check_properties(report, case)
        check_control(report, case)
    report.attempt("a patch on two sides", check_sides, report, folder)
    check_motion(report, folder)


if __name__ == "__main__":
    main(sys.argv[1])
