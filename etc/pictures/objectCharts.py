# SPDX-License-Identifier: GPL-3.0-or-later
"""Charts of etc/plot from the columns of objects.csv, units and means."""

import statistics

import tables

# Units of columns, by their beginning
UNITS = {
    "time": "s", "unwrapped": "m",
    "area": "m$^2$", "volume": "m$^3$", "perimeter": "m", "centroid": "m",
    "velocity": "m/s", "angularVelocity": "rad/s", "force": "N",
    "torque": "N m", "smallestGap": "m", "halfAxis": "m",
    "inclination": "rad", "phase": "rad", "flowAngle": "rad",
    "kineticEnergy": "J", "elasticEnergy": "J", "contactEnergy": "J",
    "deltaT": "s", "maxSpeed": "m/s", "fluidVelocity": "m/s",
    "objectVelocity": "m/s", "areaChange": "-",
    "contactForce": "N", "drivingAcceleration": "m/s$^2$",
    "shearRate": "1/s", "wallStress": "Pa", "fluidStress": "Pa",
    "objectStress": "Pa", "contactStress": "Pa",
    "N1": "Pa", "N2": "Pa", "contactN": "Pa", "stresslet": "N m",
    "contactStressX": "N m", "contactStressY": "N m", "contactStressZ": "N m",
}
# More objects than these are drawn in grey, with their median
NAMED_OBJECTS = 10


def unit_of(name):
    """The unit of a column, for an axis."""
    known = [key for key in UNITS if name.startswith(key)]
    return f"{name} [{UNITS[max(known, key=len)]}]" if known else name


def print_means(lines, names):
    """Prints means of columns, with errors by eight blocks of the second
    half."""
    for name in names:
        values = tables.column(lines, name) or []
        size = len(values)//16
        if size:
            blocks = [statistics.mean(values[-size*(i + 1):len(values)-size*i])
                      for i in range(8)]
            print(f"{name} {statistics.mean(blocks):.4g} +- "
                  f"{statistics.stdev(blocks)/8**0.5:.2g} (second half)")


def mean_square_displacement(axes, lines, name="msd"):
    """Mean of |x - x0|^2 over the objects that were there at first; of msdX,
    msdY and msdZ in one direction."""
    directions = [n for n in tables.columns(lines)
                  if n.startswith("unwrapped" + name[3:])]
    start = {}
    for line in lines:
        start.setdefault(line["object"], line)
    first = min(line["time"] for line in lines)
    times = sorted({line["time"] for line in lines})
    squares = {time: [] for time in times}
    for line in lines:
        origin = start[line["object"]]
        if origin["time"] == first:
            squares[line["time"]].append(
                sum((line[n] - origin[n])**2 for n in directions))
    axes.plot([t - first for t in times if squares[t]],
              [statistics.mean(squares[t]) for t in times if squares[t]])
    axes.set_ylabel("mean-square displacement [m$^2$]")


def object_curves(axes, lines, name, along="time"):
    """A line per object; of many the median as well, over the time."""
    ids = sorted({line["object"] for line in lines})
    many = len(ids) > NAMED_OBJECTS
    for number in ids:
        own = [line for line in lines if line["object"] == number]
        axes.plot(tables.column(own, along), tables.column(own, name),
                  label=None if many else f"{int(number)}", linewidth=1,
                  **({"color": "0.7"} if many else {}))
    if many and along == "time":
        times = sorted({line["time"] for line in lines})
        axes.plot(times, [
            statistics.median(tables.column(
                [line for line in lines if line["time"] == time], name))
            for time in times], color="C0", label="median")
    axes.set_ylabel(unit_of(name))
    if axes.get_legend_handles_labels()[0]:
        axes.legend(title=None if many else "object", ncols=2,
                    fontsize="small")
