# SPDX-License-Identifier: GPL-3.0-or-later
"""Fixed disc in a channel (Schaefer and Turek 1996)."""

import itertools
import math

import fsiCase
from common import Case, Field, Row, disc, placed

HEIGHT = 0.41
LENGTH = 2.2


def channel(name, cells, peak, coarse=None, **controls):
    """The channel with D/h = cells and the inflow's peak velocity."""
    ny = round(HEIGHT/0.1*cells)
    h = HEIGHT/ny
    nx = round(LENGTH/(0.41/41))*cells//10
    profile = " ".join(
        f"({4*peak*y*(HEIGHT - y)/HEIGHT**2:.10g} 0 0)"
        for y in ((j + 0.5)*h for j in range(ny))
    )
    case = Case(
        name, box=(0, 0, nx*h, HEIGHT), cells=(nx, ny), viscosity=1e-3,
        open={"left": ("type fixedValue; value nonuniform "
                       f"List<vector> {ny} ({profile});",
                       "type zeroGradient;"),
              "right": ("type zeroGradient;",
                        "type fixedValue; value uniform 0;")},
        shapes=disc(0.05, "density 1; E 1e3;", "motion { type fixed; }"),
        placements=placed("disc", (0.2, 0.2)), **controls)
    return case.start_from(coarse) if coarse else case


def pressure_difference(case):
    """Between the front and the back of the disc, from the fluid's cells."""
    p = Field(case, "p")
    h = case.spacing()

    def surface(x, side):
        a, b = (p.at(x + side*s*h, 0.2) for s in (1, 2))
        return 2*a - b

    return surface(0.15, -1) - surface(0.25, 1)


def scales(case, mean):
    """Factor from force to coefficient; the mesh is one cell thick."""
    return 2/(mean**2*0.1*case.spacing())


def steady():
    """DFG 2D-1, Re 20."""
    for wall in ("openArea", "voxel"):
        case = None
        for cells in (10, 20, 40):
            case = channel(
                f"cylinder20-{wall}-{cells}", cells, 0.3, case,
                properties=fsiCase.THESIS + f"wall {wall};", deltaT=0.1/cells,
                endTime=2 if case else 10, writeInterval=2)
            minutes = case.solve()
            last = case.objects()[-1]
            scale = scales(case, 0.2)
            name, grid = f"DFG 2D-1, {wall}", f"D/h = {cells}"
            checked = wall == "openArea" and cells >= 20
            for what, reference, value, tolerance in (
                    ("drag", 5.57953523384, scale*last["forceX"], 0.0558),
                    ("lift", 0.010618948146, scale*last["forceY"], 0.002),
                    ("pressure difference", 0.11752016697,
                     pressure_difference(case), 0.00235)):
                yield Row(f"{name}, {what}", grid, reference, value,
                          tolerance if checked else None, minutes,
                          (f"{name}, {what}", cells))


def risings(times, values):
    """Times at which a series rises through its mean."""
    mean = sum(values)/len(values)
    found = []
    for (s, a), (t, b) in zip(zip(times, values),
                              zip(times[1:], values[1:])):
        if a < mean <= b:
            found.append(s + (t - s)*(mean - a)/(b - a))
    return found


def shedding():
    """DFG 2D-2, Re 100."""
    case = None
    for cells in (10, 20, 40):
        case = channel(
            f"cylinder100-{cells}", cells, 1.5, case,
            properties="output { objectsEvery 1; }", deltaT=0.02/cells,
            endTime=2.5 if case else 8, writeInterval=0.5)
        minutes = case.solve()
        rows = case.objects()
        scale = scales(case, 1)
        # The last second: three periods
        rows = [row for row in rows if row["time"] > rows[-1]["time"] - 1]
        lift = [scale*row["forceY"] for row in rows]
        turns = risings([row["time"] for row in rows], lift)
        strouhal = 0.1*(len(turns) - 1)/(turns[-1] - turns[0])
        checked = cells == 40
        for what, reference, value, tolerance in (
                ("largest drag", 3.23,
                 max(scale*row["forceX"] for row in rows), 0.03*3.23),
                ("largest lift", 0.986571, max(lift), 0.049),
                ("Strouhal number", 0.3, strouhal, 0.01)):
            yield Row(f"DFG 2D-2, {what}", f"D/h = {cells}", reference, value,
                      tolerance if checked else None, minutes,
                      (f"DFG 2D-2, {what}", cells))


def stream(name, cells, frame, part=1, **controls):
    """A disc of diameter 0.25 in a stream of speed 1 between walls that move
    with it, at Re 40; seen from the disc (frame 0) or from the stream (1), with
    a part of the time step."""
    speed = 1 - frame
    n = 4*cells
    return Case(
        f"{name}-{cells}", box=(0, 0, 4, 1), cells=(4*n, n), cyclic="x",
        viscosity=0.25/40, velocity=f"({speed} 0 0)",
        walls={side: f"({speed} 0 0)" for side in ("top", "bottom")},
        shapes=disc(0.125, "density 1; E 1e3;", "motion { type translating; "
                    # A speed of zero is refused
                    f"velocity ({-frame or 1e-12} 0 0); }}"),
        placements=placed("disc", (1.5 + 2*frame, 0.5)),
        properties="output { objectsEvery 1; }",
        deltaT=0.0125/cells/part, endTime=1.5, writeInterval=1.5, **controls)


def translating():
    """Galilean invariance: a disc that moves through fluid at rest has the drag
    of a fixed one in a stream. Mean over t = 1 to 1.5; solids4foam's implicit
    penalty is 5, 3, 1.5 % off at 10, 20, 40 cells per diameter."""
    for cells, tolerance in ((8, 0.015), (16, 0.01)):
        drags, minutes = [], 0
        for frame, name in enumerate(("still", "moving")):
            case = stream(name, cells, frame)
            minutes += case.solve()
            forces = [row["forceX"] for row in case.objects()
                      if row["time"] > 1]
            drags.append(sum(forces)/len(forces))
        yield Row("disc that moves at Re 40, drag over a fixed one's",
                  f"D/h = {cells}", 1, drags[1]/drags[0], tolerance, minutes,
                  ("translating", cells))


def noise(times, values):
    """Root mean square and largest of what a series differs from a straight
    line, over its mean."""
    n = len(values)
    time, mean = sum(times)/n, sum(values)/n
    slope = (sum((t - time)*(x - mean) for t, x in zip(times, values))
             / sum((t - time)**2 for t in times))
    rest = [x - mean - slope*(t - time) for t, x in zip(times, values)]
    return (math.sqrt(sum(x*x for x in rest)/n)/abs(mean),
            max(map(abs, rest))/abs(mean))


def moving_noise(sizes=(8, 16), parts=(1, 4)):
    """Noise of the force on the disc that moves, t = 1 to 1.5, with parts of
    the time step of translating()."""
    for cells, part in itertools.product(sizes, parts):
        case = stream(f"noise-{part}", cells, 1, part)
        minutes = case.solve()
        rows = [row for row in case.objects() if row["time"] > 1]
        rms, peak = noise([row["time"] for row in rows],
                          [row["forceX"] for row in rows])
        for what, value in (("rms", rms), ("largest", peak)):
            yield Row("disc that moves at Re 40, noise of the force over its "
                      f"mean, {what}, dt/{part}", f"D/h = {cells}", 0, value,
                      0.01 if cells == 16 and what == "rms" else None, minutes)


CASES = {"cylinder20": steady, "cylinder100": shedding,
         "translating": translating, "forceNoise": moving_noise}
