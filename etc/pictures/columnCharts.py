# SPDX-License-Identifier: GPL-3.0-or-later
"""Charts of etc/plot -column: which tables and lines of one case or of several
they show."""

import os
import sys

import tables
from objectCharts import ObjectChart, mean_square_displacement, unit_of
from runCharts import curve

# Short names of columns
SHORT = {"D": "deformation"}
# Mean-square displacements
MSD = ("msd", "msdX", "msdY", "msdZ")
# A line per object, or per object and place
OF_OBJECTS = ("objects.csv", "followed.csv")
TABLES = (*OF_OBJECTS, "global.csv", "rheology.csv")


def require(lines, case):
    """Ends if a case has no table."""
    if not lines:
        sys.exit("etc/plot: no postProcessing/fsiObjects/*/global.csv with "
                 f"lines in {case}")


def names_of(cases):
    """Names of cases in a legend: of their folders, or the whole paths where
    two folders have one name."""
    short = [os.path.basename(os.path.abspath(case)) for case in cases]
    return short if len(set(short)) == len(cases) else cases


def has(lines, name):
    """Does a table have this column, or vector, of numbers?"""
    values = tables.column(lines, name)
    return bool(values) and not isinstance(values[0], str)


def chosen(cases, option, key, wanted):
    """The lines whose names in a column, such as shape, are wanted."""
    if not wanted:
        return cases
    wanted = wanted.split(",")
    there = sorted({line[key] for lines in cases.values() for line in lines})
    for name in wanted:
        if name not in there:
            sys.exit(f"etc/plot: {option}: no {key} {name}, but "
                     + " ".join(there))
    return {case: [line for line in lines if line[key] in wanted]
            for case, lines in cases.items()}


def with_numbers(cases, wanted):
    """The lines of the objects with these ids."""
    if not wanted:
        return cases
    try:
        ids = {int(word) for word in wanted.split(",")}
    except ValueError:
        sys.exit("etc/plot: -objects takes ids with commas between them, "
                 f"not {wanted}")
    return {case: [line for line in lines if line["object"] in ids]
            for case, lines in cases.items()}


class Study:
    """The tables of one case or of several, and what was asked of them."""

    def __init__(self, options):
        self.options = options
        names = names_of(options.cases)
        self.tables = {
            table: {name: tables.rows(case, table)
                    for name, case in zip(names, options.cases)}
            for table in TABLES}
        for case, lines in zip(options.cases,
                               self.tables["global.csv"].values()):
            require(lines, case)
        if options.places and not any(self.tables["followed.csv"].values()):
            sys.exit("etc/plot: -places: no followed.csv with lines in "
                     + " ".join(options.cases))

    def order(self):
        """Names of the tables; places are those of followed.csv."""
        if self.options.places:
            return sorted(TABLES, key=lambda table: table != "followed.csv")
        return TABLES

    def no_column(self, short):
        """Ends with the columns that there are."""
        there = []
        for table, cases in self.tables.items():
            names = tables.columns([line for lines in cases.values()
                                    for line in lines[:1]])
            more = ["D", *MSD] if table == "objects.csv" else []
            if names:
                there.append(f"{table} has " + " ".join([*names, *more]))
        sys.exit(f"etc/plot: no table has the column {short}. "
                 + "; ".join(there))

    def table_of(self, name):
        """The table with a column, which all cases must have; None if there
        is none."""
        for table in self.order():
            cases = self.tables[table]
            if not any(has(lines, name) for lines in cases.values()):
                continue
            for case, lines in cases.items():
                if not has(lines, name):
                    sys.exit(f"etc/plot: no column {name} in {table} of "
                             f"{case}")
            return table
        return None

    def objects(self, table):
        """The lines of a table that are asked for, by cases."""
        options, cases = self.options, self.tables[table]
        cases = with_numbers(cases, options.objects)
        cases = chosen(cases, "-shapes", "shape", options.shapes)
        if table == "followed.csv":
            cases = chosen(cases, "-places", "place", options.places)
        for case, lines in cases.items():
            if not lines:
                asked = [text for text in (options.objects, options.shapes,
                                           options.places) if text]
                sys.exit(f"etc/plot: no objects {' '.join(asked)} in {table} "
                         f"of {case}")
        return cases

    def object_chart(self, table, name):
        """A column of a table of objects over the time or another column."""
        options = self.options
        along = SHORT.get(options.x, options.x) or "time"
        for case, lines in self.tables[table].items():
            if not has(lines, along):
                sys.exit(f"etc/plot: no column {options.x} in {table} of "
                         f"{case}, which has "
                         + " ".join(tables.columns(lines)))
        return ObjectChart(self.objects(table), name, along,
                           from_start=options.fromStart,
                           named=bool(options.objects),
                           by_shape=bool(options.shapes))

    def chart(self, short):
        """What draws a column."""
        name = SHORT.get(short, short)
        if name in MSD and self.table_of("unwrappedX"):
            cases = self.objects("objects.csv")
            return lambda axes: mean_square_displacement(axes, cases, name)
        table = self.table_of(name)
        if not table:
            self.no_column(short)
        if table in OF_OBJECTS:
            return self.object_chart(table, name)
        return lambda axes: self.step_curves(axes, table, name)

    def step_curves(self, axes, table, name):
        """A column with a line per step: a curve for each case."""
        cases = self.tables[table]
        for case, lines in cases.items():
            curve(axes, lines, name, case)
        axes.set_ylabel(unit_of(name))
        if len(cases) > 1:
            axes.legend(fontsize="small")


def column_charts(options):
    """Charts of the columns that were asked for."""
    study = Study(options)
    return {SHORT.get(short, short): study.chart(short)
            for short in options.column.split(",")}
