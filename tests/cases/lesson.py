#!/usr/bin/env python3
"""Runs the commands of a lesson in docs/user and compares the numbers in its tables with what they give.

Every code block of the page that names no language is run, one after the other, in one folder. lesson_numbers.py says for each number
that stands in a table of the page where it comes from. A number agrees when it is the program's to the digits that are printed, give or take
one in the last: another processor may round otherwise.
"""

import argparse
import csv
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys

from lesson_numbers import NUMBERS

PAGES = pathlib.Path(__file__).resolve().parents[2] / "docs/user"


def blocks(page):
    """The code blocks that a student types."""
    return [b for language, b in re.findall(r"^```(\w*)\n(.*?)^```", page, re.M | re.S) if not language]


def cells(line):
    return [c.strip().strip("*") for c in line.strip().strip("|").split("|")]


def cell(page, row, heading):
    """The text in the row whose first cell is `row`, below `heading`, of the one table that has both."""
    found = []  # the same number may stand in two tables
    for table in re.findall(r"(?:^\|.*\n)+", page, re.M):
        lines = table.splitlines()
        headings = cells(lines[0])
        if heading in headings:
            found += [cells(line)[headings.index(heading)] for line in lines[2:] if cells(line)[0] == row]
    if len(set(found)) != 1:
        sys.exit(f"the page has {len(found)} cells in row '{row}' below '{heading}'")
    return found[0]


def from_summary(path, name):
    stage_id, key = name.split(".", 1)
    stage = next(s for s in json.loads(path.read_text())["stages"] if s["id"] == stage_id)
    return stage["metrics"][key]["value"] if key in stage["metrics"] else stage["counts"][key]


def from_table(path, where, column):
    with open(path, newline="") as file:
        rows = [r for r in csv.DictReader(file) if all(same(r[k], v) for k, v in where.items())]
    if len(rows) != 1:
        sys.exit(f"{path} has {len(rows)} rows where {where}")
    return float(rows[0][column])


def same(a, b):
    try:
        return float(a) == float(b)
    except ValueError:
        return a == b


def value_of(work, source):
    """FILE NAME of a summary.json, FILE NAME of JSON, or FILE {WHERE} COLUMN of a table."""
    path = work / source[0]
    if len(source) == 3:
        return from_table(path, source[1], source[2])
    if path.name == "summary.json":
        return from_summary(path, source[1])
    value = json.loads(path.read_text())
    for key in source[1].split("/"):
        value = value[key]
    return value


def agrees(text, value):
    match = re.fullmatch(r"([+-]?\d+(?:\.(\d+))?)(?: .*)?", text.replace("−", "-"))
    if not match:
        sys.exit(f"'{text}' is no number")
    if value == int(value) and match.group(2) is None:  # a count
        return float(match.group(1)) == value
    return abs(float(match.group(1)) - value) <= 1.5 * 10 ** -len(match.group(2) or "")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("page")
    parser.add_argument("--bole", required=True, type=pathlib.Path)
    parser.add_argument("--work", required=True, type=pathlib.Path)
    args = parser.parse_args()
    page = (PAGES / f"{args.page}.md").read_text()
    shutil.rmtree(args.work, ignore_errors=True)
    args.work.mkdir(parents=True)
    environment = {**os.environ, "PATH": f"{args.bole.resolve().parent}:{os.environ['PATH']}"}
    commands = blocks(page)
    if not commands:
        sys.exit("the page has no commands")
    for command in commands:
        print(command, flush=True)
        result = subprocess.run(["bash", "-ec", command], cwd=args.work, env=environment, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
        if result.returncode != 0:
            sys.exit(f"{result.stdout}\nexit code {result.returncode}")
    wrong = 0
    for number in NUMBERS[args.page]:
        text = cell(page, number["row"], number["heading"])
        value = number.get("factor", 1) * value_of(args.work, number["from"])
        good = agrees(text, value)
        wrong += not good
        print(f"{'ok  ' if good else 'FAIL'} {number['row']}, {number['heading']}: {text} on the page, {value:.6g} by the program")
    if wrong == 0:
        shutil.rmtree(args.work, ignore_errors=True)
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
