# SPDX-License-Identifier: GPL-3.0-or-later
"""Charts of etc/plot from the columns of objects.csv and followed.csv, units
and means."""

import csv
import statistics

import matplotlib
import tables

# Units of columns, by their beginning
UNITS = {
    "time": "s", "unwrapped": "m",
    "area": "m$^2$", "volume": "m$^3$", "perimeter": "m", "centroid": "m",
    "position": "m",
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
# Columns that a point of a curve keeps
KEYS = ("time", "object", "shape", "place")
# So many colours has matplotlib; more cases take those of a map. Lines of the
# objects or shapes of a case
COLOURS = 10
DASHES = ("-", "--", ":", "-.", (0, (8, 2)), (0, (1, 4)))


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


def mean_square_displacement(axes, cases, name="msd"):
    """Mean of |x - x0|^2 over the objects that were there at first, a curve
    for each case; of msdX, msdY and msdZ in one direction."""
    for case, lines in cases.items():
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
                  [statistics.mean(squares[t]) for t in times if squares[t]],
                  label=case)
    axes.set_ylabel("mean-square displacement [m$^2$]")
    if len(cases) > 1:
        axes.legend(fontsize="small")


def grouped(lines, *names):
    """The lines with each value of the columns, in the order of the values."""
    found = {}
    for line in lines:
        found.setdefault(tuple(line[n] for n in names), []).append(line)
    return dict(sorted(found.items()))


def median(points):
    """The median of the points at each time, over the time."""
    return [{"x": time, "y": statistics.median(p["y"] for p in own)}
            for (time,), own in grouped(points, "time").items()]


def words(kind):
    """A label from an object's number, a shape, a place."""
    return " ".join(f"{int(k)}" if isinstance(k, float) else k for k in kind)


def colour_of(i, count):
    """The colour of a case."""
    return (f"C{i}" if count <= COLOURS
            else matplotlib.colormaps["viridis"](i/(count - 1)))


class ObjectChart:
    """A column of the objects of one case or of several, over the time or
    another column. cases: lines by names of cases; from_start: each curve
    less its first point; named: the objects were chosen by their ids;
    by_shape: tracks have the colours of their shapes."""

    def __init__(self, cases, name, along="time", from_start=False,
                 named=False, by_shape=False):
        self.name, self.along, self.from_start = name, along, from_start
        self.named, self.by_shape = named, by_shape
        first = next(iter(cases.values()))[0]
        self.place = ("place",) if "place" in first else ()
        self.cases = {case: self.points(lines)
                      for case, lines in cases.items()}

    def points(self, lines):
        """Each line's names, and its values on both axes."""
        found, first = [], {}
        for line, x, y in zip(lines, tables.column(lines, self.along),
                              tables.column(lines, self.name)):
            point = {key: line[key] for key in KEYS if key in line}
            if self.from_start:
                x0, y0 = first.setdefault(
                    (line["object"], line.get("place")), (x, y))
                x, y = x if self.along == "time" else x - x0, y - y0
            found.append({**point, "x": x, "y": y})
        return found

    def label(self, name):
        """Of an axis."""
        if name == "time":
            return "time [s]"
        return ("change of " if self.from_start else "") + unit_of(name)

    def __call__(self, axes):
        """Draws the chart."""
        title, curves = (self.of_cases() if len(self.cases) > 1
                         else self.of_objects(*self.cases.values()))
        told = set()
        for points, label, style in curves:
            axes.plot([p["x"] for p in points], [p["y"] for p in points],
                      **{"label": None if label in told else label,
                         "linewidth": 1, **style})
            told.add(label)
        axes.set_xlabel(self.label(self.along))
        axes.set_ylabel(self.label(self.name))
        axes.legend(title=title, ncols=2, fontsize="small")

    def of_objects(self, points):
        """A curve per object; of many the median of each shape as well, over
        the time, and tracks in the colours of their shapes."""
        curves = grouped(points, "object", *self.place)
        shapes = grouped(points, "shape", *self.place)
        many = len(curves) > NAMED_OBJECTS
        if self.along != "time" and (many or self.by_shape):
            return "shape", [(own, words(kind), {"color": f"C{i}"})
                             for i, (kind, alike) in enumerate(shapes.items())
                             for own in grouped(alike, "object").values()]
        if not many:
            return "object", [(own, words(kind), {})
                              for kind, own in curves.items()]
        return None, [
            *((own, None, {"color": "0.7"}) for own in curves.values()),
            *((median(own), "median of " + words(kind), {"linewidth": 1.5})
              for kind, own in shapes.items())]

    def of_cases(self):
        """A colour for each case: of its objects that were chosen, of all its
        tracks, else of the median of each shape."""
        names = ("object" if self.named else "shape", *self.place)
        kinds = list(grouped(sum(self.cases.values(), []), *names))
        curves = []
        for i, (case, points) in enumerate(self.cases.items()):
            for kind, alike in grouped(points, *names).items():
                label = f"{case} {words(kind)}" if len(kinds) > 1 else case
                style = {"color": colour_of(i, len(self.cases)),
                         "linestyle": DASHES[kinds.index(kind) % len(DASHES)]}
                single = self.named or self.along != "time"
                curves += [(own, label, style) for own in (
                    grouped(alike, "object").values() if single
                    else [median(alike)])]
        return None if self.named or self.along != "time" else "median", curves

    def write(self, path):
        """A line of CSV per object: smallest, mean and largest value of the
        column, and when the object had the smallest and the largest one."""
        with open(path, "w", encoding="ascii", newline="") as stream:
            table = csv.writer(stream)
            several = len(self.cases) > 1
            table.writerow([
                *(["case"] if several else []), "object", "shape", *self.place,
                "first", "last", "smallest", "at", "mean", "largest",
                "largestAt"])
            for case, points in self.cases.items():
                for (number, *names), own in grouped(
                        points, "object", "shape", *self.place).items():
                    table.writerow([*([case] if several else []), int(number),
                                    *names, *extremes(own)])
        print(path)


def extremes(points):
    """First and last time; smallest value and its time, mean, largest value
    and its time."""
    times, values = ([p[key] for p in points] for key in ("time", "y"))
    least, most = values.index(min(values)), values.index(max(values))
    return [times[0], times[-1],
            *(f"{value:.6g}" for value in
              (values[least], times[least], statistics.mean(values),
               values[most], times[most]))]
