#!/usr/bin/env python3
"""Compares a table with an expected one, row by row and column by column, each column within its own tolerance.

A comparison is one line of clauses with commas between them:

  stems.csv = {scan}/trees.csv, nearest x_m y_m within 0.5, dbh_cm 1.5, height_m=total_height_m 5%, missing 1, extra 0

  FOUND = EXPECTED           two CSV files; {name} is filled in by who calls
  key COLUMN...              rows belong together that have the same values there (COLUMN=OTHER as below), or
  nearest COLUMN... within D rows belong together that are nearest to one another, at most D apart
  COLUMN TOLERANCE           largest difference allowed, absolute or in % of what is expected; 0 for words;
                             COLUMN=OTHER where the expected table has another name for it
  where COLUMN=VALUE         only these rows of EXPECTED must be found and are compared; the others may be partners
  missing N, extra N         rows of EXPECTED, rows of FOUND that may be without a partner (default 0)
"""

import csv
import dataclasses
import math
import pathlib
import re


class SpecError(ValueError):
    """A comparison that cannot be read, or that asks for a column or a file that is not there."""


@dataclasses.dataclass
class Column:
    found: str
    expected: str
    tolerance: float
    relative: bool = False


@dataclasses.dataclass
class Comparison:
    found: str
    expected: str
    pair: list  # (found, expected) names of columns
    within: float | None  # None: by key
    columns: list
    where: tuple = ()
    missing: int = 0
    extra: int = 0


def both_names(word):
    found, _, expected = word.partition("=")
    return found, expected or found


def parsed(line):
    clauses = [clause.split() for clause in line.split(",")]
    head = clauses[0]
    if len(head) != 3 or head[1] != "=":
        raise SpecError(f"'{line}' does not begin with FOUND = EXPECTED")
    comparison = Comparison(head[0], head[2], [], None, [])
    for words in clauses[1:]:
        if words[:1] == ["key"] and len(words) > 1:
            comparison.pair = [both_names(w) for w in words[1:]]
        elif words[:1] == ["nearest"] and words[-2:-1] == ["within"] and len(words) > 3:
            comparison.pair, comparison.within = [both_names(w) for w in words[1:-2]], float(words[-1])
        elif len(words) == 2 and words[0] == "where" and "=" in words[1]:
            comparison.where = tuple(words[1].split("=", 1))
        elif len(words) == 2 and words[0] in ("missing", "extra"):
            setattr(comparison, words[0], int(words[1]))
        elif len(words) == 2 and re.fullmatch(r"\d+(\.\d+)?%?", words[1]):
            found, expected = both_names(words[0])
            share = words[1].endswith("%")
            tolerance = float(words[1].rstrip("%")) / (100 if share else 1)
            comparison.columns.append(Column(found, expected, tolerance, share))
        else:
            raise SpecError(f"cannot read '{' '.join(words)}' in '{line}'")
    if not comparison.pair:
        raise SpecError(f"'{line}' does not say which rows belong together: key COLUMN... or nearest COLUMN... within D")
    if not comparison.columns:
        raise SpecError(f"'{line}' compares no column")
    return comparison


def read_table(path):
    """Rows as dictionaries; lines that begin with # are left out."""
    path = pathlib.Path(path)
    if not path.exists():
        raise SpecError(f"there is no table {path}")
    with open(path, newline="", encoding="utf-8-sig") as file:
        reader = csv.DictReader(line for line in file if not line.startswith("#"))
        return list(reader.fieldnames or []), list(reader)


def number(text):
    """None for a cell that is empty or a word."""
    try:
        value = float(text)
    except (TypeError, ValueError):
        return None
    return None if math.isnan(value) else value


def by_key(found, expected, columns):
    def keys(rows, names):
        """Rows by key; one with an empty cell there has no partner."""
        seen = {}
        for i, row in enumerate(rows):
            key = tuple(row[c] if number(row[c]) is None else number(row[c]) for c in names)
            if "" in key:
                continue
            if key in seen:
                raise SpecError(f"two rows have the key {key}")
            seen[key] = i
        return seen

    ours, theirs = keys(found, [c[0] for c in columns]), keys(expected, [c[1] for c in columns])
    return [(ours[k], theirs[k]) for k in theirs if k in ours]


def by_distance(found, expected, columns, within):
    def places(rows, names):
        return [tuple(number(row[c]) for c in names) for row in rows]

    theirs = places(expected, [c[1] for c in columns])
    pairs = [(math.dist(p, q), i, j) for i, p in enumerate(places(found, [c[0] for c in columns]))
             for j, q in enumerate(theirs) if None not in p and None not in q]
    taken, used, result = set(), set(), []
    for distance, i, j in sorted(pairs):
        if distance <= within and i not in taken and j not in used:
            taken.add(i), used.add(j), result.append((i, j))
    return result


def difference(a, b, column):
    """How far a cell is from the expected one: as a share of what is allowed, and in its own unit (None between words)."""
    x, y = number(a), number(b)
    if x is None or y is None:
        same = x is y is None and (a or "").replace("nan", "") == (b or "").replace("nan", "")
        return (0.0 if same else math.inf), None
    off = abs(x - y)
    allowed = column.tolerance * (abs(y) if column.relative else 1)
    if off == 0:
        return 0.0, off
    return (off / allowed if allowed > 0 else math.inf), off


def compare(line, found_folder=".", **names):
    """The complaints, empty where the tables agree, and a line for each column that tells the largest difference."""
    comparison = parsed(line)
    found_columns, found = read_table(pathlib.Path(found_folder) / comparison.found)
    expected_columns, expected = read_table(comparison.expected.format(**names))
    for asked, there, which in (
        ([p[0] for p in comparison.pair] + [c.found for c in comparison.columns], found_columns, comparison.found),
        ([p[1] for p in comparison.pair] + [c.expected for c in comparison.columns] + [*comparison.where[:1]],
         expected_columns, comparison.expected),
    ):
        absent = [c for c in asked if c not in there]
        if absent:
            raise SpecError(f"{which} has no column {', '.join(absent)}; it has {', '.join(there)}")
    wanted = {j for j, row in enumerate(expected) if not comparison.where or row[comparison.where[0]] == comparison.where[1]}
    if not wanted:
        raise SpecError(f"{comparison.expected} has no such rows: nothing would be compared")

    pairs = (by_key(found, expected, comparison.pair) if comparison.within is None else
             by_distance(found, expected, comparison.pair, comparison.within))
    extra = len(found) - len(pairs)
    pairs = [(i, j) for i, j in pairs if j in wanted]
    complaints, told = [], []
    for count, allowed, what in ((len(wanted) - len(pairs), comparison.missing, "missing"),
                                 (extra, comparison.extra, "extra")):
        told.append(f"{comparison.found}: {count} rows {what} ({allowed} allowed)")
        if count > allowed:
            complaints.append(told[-1])
    if not pairs:
        complaints.append(f"{comparison.found}: no row has a partner in {comparison.expected}")
    for column in comparison.columns:
        largest = 0.0
        for i, j in pairs:
            share, off = difference(found[i][column.found], expected[j][column.expected], column)
            largest = max(largest, off or 0.0)
            if share > 1 + 1e-9:  # both are decimal text: a difference of exactly the tolerance is within it
                where = ", ".join(f"{c} {expected[j][c]}" for _, c in comparison.pair)
                complaints.append(f"{comparison.found}: {column.found} is {found[i][column.found] or 'empty'} in place of "
                                  f"{expected[j][column.expected] or 'nothing'} at {where}")
        allowed = f"{100 * column.tolerance:g}%" if column.relative else f"{column.tolerance:g}"
        told.append(f"{comparison.found}: {column.found} off by {largest:.4g} at most ({allowed} allowed, {len(pairs)} rows)")
    return complaints, told
