#!/usr/bin/env python3
"""Every number of report.html is in summary.json.

    report_numbers.py OUT [OUT...]       the output folders of runs
    report_numbers.py --self-test OUT    changes one number of the page after the other and expects each to be missed

Rules:
- Each number that a reader sees on the page is looked for in summary.json, rounded to the digits that are printed. Numbers inside
  texts of summary.json (messages, warnings, options, names of measures) count as well.
- A length in metres may be printed in centimetres or millimetres.
- A table with a row per stem, candidate, edit, loop or frame is looked for in its CSV file: TABLES says which one.
- Not looked for are: EXCLUDED (parts of the page that hold no results) and PHRASES (numbers that belong to a definition).
"""

import argparse
import csv
import html.parser
import json
import pathlib
import re
import sys

# Parts of the page that hold no results: the script and the style, drawings and captions (ticks, tree numbers, how a figure is drawn),
# names of files.
EXCLUDED = {"script", "style", "svg", "figcaption", "code"}

# Numbers that belong to a definition, and the day of the run.
PHRASES = [
    r"\b95 %",  # level of every interval
    r"100 thickest stems",  # definition of the dominant height
    r"π/4",
    r"\bn − 1\b",
    r"\(1: as expected\)",  # what sigma0 should be
    r"\b3-D\b",
    r"\d{4}-\d\d-\d\d(T[\d:.]+Z?)?",  # days and times of day
]

# Heading of the first column: the file that holds the table, and the columns of numbers by their headings. A time after the start is
# a difference of two times of the file.
TABLES = {
    ("Tree", "x (m)"): "stems.csv",
    ("Tree", "DBH (cm)"): "stems.csv",
    ("x (m)", "y (m)"): "rejected.csv",
    ("Edit", "What"): "edits.csv",
    ("Frame", "Time after the start (s)"): "odometry.csv",
    ("From (s)", "To (s)"): "loops.csv",
}

# Elements outside tables that tell about single stems, by their class: their numbers may stand in this file too.
LISTS = {"look": "stems.csv", "uncounted": "stems.csv"}

NUMBER = re.compile(r"(?<![\w.])[-+−]?\d+(?:\.\d+)?(?:[eE][-+]?\d+)?")
TO_UNITS = {"m": (1, 100, 1000)}


def numbers_in(text):
    """The numbers of a text as they are printed, with a plain minus; a hyphen between two numbers is no minus."""
    text = re.sub(r"(?<=\d)[–-](?=\d)", " ", text)
    return [m.group(0).replace("−", "-").lstrip("+") for m in NUMBER.finditer(text)]


class Page(html.parser.HTMLParser):
    """The visible texts of a page: `texts` outside tables, each with the file of its list or None, `tables` as lists of rows of cells,
    the first row the headings."""

    def __init__(self):
        super().__init__()
        self.texts, self.tables, self._open, self._lists, self._cell = [], [], [], [], None

    def handle_starttag(self, tag, attributes):
        if tag in {"meta", "img", "br", "input"}:
            return
        self._open.append(tag)
        classes = (dict(attributes).get("class") or "").split()
        self._lists.append(next((LISTS[c] for c in classes if c in LISTS), None))
        if tag == "table":
            self.tables.append([])
        elif tag == "tr":
            self.tables[-1].append([])
        elif tag in {"td", "th"}:
            self._cell = ""

    def handle_endtag(self, tag):
        if tag in self._open:
            while True:
                self._lists.pop()
                if self._open.pop() == tag:
                    break
        if tag in {"td", "th"}:
            self.tables[-1][-1].append(self._cell)
            self._cell = None

    def handle_data(self, data):
        if EXCLUDED & set(self._open):
            return
        if self._cell is not None:
            self._cell += data
        elif data.strip():
            self.texts.append((data.strip(), next((name for name in self._lists if name), None)))


class Known:
    """Numbers that a file holds, and whether a printed number is one of them at its digits."""

    def __init__(self):
        self.values = set()

    def add(self, value, unit=""):
        for factor in TO_UNITS.get(unit, (1,)):
            self.values.add(float(value) * factor)

    def add_text(self, text):
        for number in re.findall(r"\d+(?:\.\d+)?(?:[eE][-+]?\d+)?", text):
            self.values.update((float(number), -float(number)))

    def holds(self, printed):
        decimals = len(printed.split(".")[1]) if "." in printed else 0
        # Half a digit, and what binary fractions add to it where the value lies in the middle.
        reach = 0.5 * 10.0**-decimals * (1 + 1e-9)
        return any(abs(value - float(printed)) <= reach for value in self.values)


class AnyOf:
    """Whether one of several holds a number."""

    def __init__(self, holders):
        self.holders = holders

    def holds(self, printed):
        return any(holder.holds(printed) for holder in self.holders)


def add_json(known, node, unit=""):
    if isinstance(node, dict):
        own_unit = node.get("unit", "") if isinstance(node.get("unit", ""), str) else ""
        for key, value in node.items():
            known.add_text(key)
            add_json(known, value, own_unit or ("m" if key.endswith("_m") else ""))
    elif isinstance(node, list):
        for value in node:
            add_json(known, value, unit)
    elif isinstance(node, bool) or node is None:
        pass
    elif isinstance(node, (int, float)):
        known.add(node, unit)
    else:
        known.add_text(str(node))


def known_of_csv(path):
    """By column: the numbers of the file; times also as differences from the first time of the run."""
    known = Known()
    with open(path, newline="", encoding="utf-8-sig") as file:
        rows = list(csv.DictReader(file))
    for row in rows:
        for column, cell in row.items():
            try:
                known.add(cell, "m" if column.endswith("_m") else "")
            except ValueError:
                known.add_text(cell or "")
    return known, rows


def known_of_table(out, name):
    known, rows = known_of_csv(out / name)
    if name in {"odometry.csv", "loops.csv"}:  # the page gives times after the start of the recording
        start = None
        if (out / "odometry.csv").is_file():
            with open(out / "odometry.csv", newline="", encoding="utf-8-sig") as file:
                start = float(next(csv.DictReader(file))["time_s"])
        for row in rows:
            for column in ("time_s", "from_time_s", "to_time_s"):
                if column in row:
                    known.add(float(row[column]) - (start if start is not None else float(rows[0][column])))
    return known


def without_phrases(text):
    for phrase in PHRASES:
        text = re.sub(phrase, " ", text)
    return text


def check(page_text, out, summary):
    """The printed numbers that are missing, each with its place, and how many were looked for."""
    page = Page()
    page.feed(page_text)
    known = Known()
    add_json(known, summary)
    missing, looked_for = [], 0

    def look(text, where, holder):
        nonlocal looked_for
        for number in numbers_in(without_phrases(text)):
            looked_for += 1
            if not holder.holds(number):
                missing.append(f"{number} in '{where}'")

    for text, name in page.texts:
        holders = [known] + ([known_of_table(out, name)] if name else [])
        look(text, text[:90], AnyOf(holders))
    for table in page.tables:
        heading = tuple(table[0][:2])
        holder = known_of_table(out, TABLES[heading]) if heading in TABLES else known
        for row in table:
            for cell in row:
                look(cell, f"{table[0][0]}: {' | '.join(row)[:90]}", holder)
    return missing, looked_for


def self_test(page_text, out, summary):
    """Numbers of the values of the plot, each changed in its last digit: how many of them are noticed."""
    begin, end = page_text.index('<section id="plot">'), page_text.index('<section id="check">')
    cells = [m for m in re.finditer(r'<td class="n">(\d+\.\d{2,})</td>', page_text[begin:end])]
    noticed = 0
    for cell in cells:
        number = cell.group(1)
        other = number[:-1] + str((int(number[-1]) + 5) % 10)
        changed = page_text[: begin + cell.start(1)] + other + page_text[begin + cell.end(1) :]
        noticed += bool(check(changed, out, summary)[0])
    return noticed, len(cells)


def passes(out, with_self_test=True):
    """Whether every number of the page of a run is known; prints what is missing."""
    page_text = (out / "report.html").read_text(encoding="utf-8")
    summary = json.loads((out / "summary.json").read_text(encoding="utf-8"))
    missing, looked_for = check(page_text, out, summary)
    print(f"{out}: {looked_for} numbers on the page, {len(missing)} of them not in summary.json")
    for line in missing:
        print("  " + line)
    good = not missing and looked_for >= 100
    if with_self_test:
        noticed, changed = self_test(page_text, out, summary)
        print(f"{out}: {noticed} of {changed} changed numbers noticed")
        good = good and changed > 0 and noticed >= 0.7 * changed
    return good


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("out", nargs="+", type=pathlib.Path)
    parser.add_argument("--self-test", action="store_true")
    arguments = parser.parse_args()
    good = [passes(out, arguments.self_test) for out in arguments.out]
    sys.exit(0 if all(good) else 1)


if __name__ == "__main__":
    main()
