# SPDX-License-Identifier: GPL-3.0-or-later
"""Charts of etc/plot from the columns of objects.csv, units and means."""

import csv
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


def grouped(lines, *names):
    """The lines with each value of the columns, in the order of the values."""
    found = {}
    for line in lines:
        found.setdefault(tuple(line[n] for n in names), []).append(line)
    return dict(sorted(found.items()))


def object_curves(axes, lines, name, along="time"):
    """A line per object; of many the median of each shape as well, over the
    time."""
    objects = grouped(lines, "object")
    many = len(objects) > NAMED_OBJECTS
    for (number,), own in objects.items():
        axes.plot(tables.column(own, along), tables.column(own, name),
                  label=None if many else f"{int(number)}", linewidth=1,
                  **({"color": "0.7"} if many else {}))
    if many and along == "time":
        for (shape,), alike in grouped(lines, "shape").items():
            times = grouped(alike, "time")
            axes.plot([time for time, in times],
                      [statistics.median(tables.column(own, name))
                       for own in times.values()],
                      label=f"median of {shape}")
    axes.set_ylabel(unit_of(name))
    if axes.get_legend_handles_labels()[0]:
        axes.legend(title=None if many else "object", ncols=2,
                    fontsize="small")


def write_extremes(path, lines, name):
    """A line of CSV per object: smallest, mean and largest value of a column,
    and when the object had the smallest and the largest one."""
    with open(path, "w", encoding="ascii", newline="") as stream:
        table = csv.writer(stream)
        table.writerow(["object", "shape", "first", "last", "smallest", "at",
                        "mean", "largest", "largestAt"])
        for (number, shape), own in grouped(lines, "object", "shape").items():
            times = tables.column(own, "time")
            values = tables.column(own, name)
            least, most = values.index(min(values)), values.index(max(values))
            table.writerow(
                [int(number), shape, times[0], times[-1],
                 *(f"{value:.6g}" for value in
                   (values[least], times[least], statistics.mean(values),
                    values[most], times[most]))])
    print(path)
