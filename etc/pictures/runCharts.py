# SPDX-License-Identifier: GPL-3.0-or-later
"""Charts of etc/plot from the columns of global.csv and rheology.csv."""

import math
import statistics

import tables

BINS = 150
# Viscosities of rheology.csv
VISCOSITIES = ("wallViscosity", "viscosity")


def curve(axes, lines, name, label=None, **options):
    """A column over the time, with its name or another label; False if there
    is no such column, or nothing finite in it."""
    values = tables.column(lines, name)
    if values is None or not any(math.isfinite(v) for v in values):
        return False
    axes.plot(tables.column(lines, "time"),
              [v if math.isfinite(v) else float("nan") for v in values],
              label=label or name, linewidth=1.2, **options)
    return True


def curves(axes, lines, names, label, zeros=False):
    """Several columns in one chart, without those that are zero throughout;
    False if there is none of them."""
    found = [curve(axes, lines, name) for name in names
             if zeros or any(tables.column(lines, name) or ())]
    axes.set_ylabel(label)
    if sum(found) > 1:
        axes.legend()
    return any(found)


def energies(axes, lines):
    """Of all objects."""
    return curves(axes, lines,
                  ("kineticEnergy", "elasticEnergy", "contactEnergy"),
                  "energy [J]")


def gaps(axes, lines):
    """Smallest gap between surfaces, where any is in range."""
    return curves(axes, lines, ("smallestGap",), "smallest gap [m]")


def speeds(axes, lines):
    """Largest, and the mean ones."""
    return curves(axes, lines,
                  ("maxSpeed", "fluidVelocity", "objectVelocity"),
                  "speed [m/s]")


def time_step(axes, lines):
    """The step, and its error where a column tells it."""
    found = curves(axes, lines, ("deltaT",), "time step [s]")
    axes.set_ylim(bottom=0)
    errors = [n for n in tables.columns(lines) if n.endswith("Error")]
    if errors:
        other = axes.twinx()
        other.set_yscale("log")
        for name in errors:
            curve(other, lines, name, color="C1")
        other.set_ylabel(", ".join(errors))
    return found


def volumes(axes, lines):
    """Largest change of an object's volume, in 2D area."""
    return curves(axes, lines, ("areaChange",), "largest |V/V0 - 1|")


def seconds(axes, lines):
    """Parts of the wall-clock time of a step, one upon the other."""
    names = [n for n in tables.columns(lines) if n.endswith("Seconds")]
    size = max(1, math.ceil(len(lines)/BINS))
    parts = [lines[i:i + size] for i in range(0, len(lines), size)]
    if not names:
        return False
    axes.stackplot(
        [statistics.mean(tables.column(part, "time")) for part in parts],
        [[statistics.mean(tables.column(part, n)) for part in parts]
         for n in names],
        labels=[n[:-len("Seconds")] for n in names])
    axes.set_ylabel("wall-clock time of a step [s]")
    axes.legend(ncols=2, fontsize="small")
    return True


def viscosity(axes, lines):
    """Every column with a viscosity."""
    return curves(axes, lines, [n for n in tables.columns(lines)
                                if "iscosity" in n], "viscosity")


def rheology(axes, lines):
    """Viscosities of rheology.csv."""
    return curves(axes, lines, VISCOSITIES, "viscosity")


def stresses(axes, lines):
    """Parts of the stress."""
    return curves(axes, lines, ("wallStress", "fluidStress", "objectStress",
                                "contactStress", "N1", "N2"), "stress [Pa]")


# Charts of rheology.csv
RHEOLOGY = {"rheology": rheology, "stresses": stresses}

CHARTS = {
    "energies": energies, "gaps": gaps, "speeds": speeds,
    "timeStep": time_step, "volumes": volumes, "whereTheTimeGoes": seconds,
    "viscosity": viscosity,
}
