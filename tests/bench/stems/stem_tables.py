#!/usr/bin/env python3
"""What stems.measure finds on simulated plots, held against their trees, pooled over plots and by class.

    stem_tables.py RUN=SCAN [RUN=SCAN...] [--min-dbh 7.5] [--gate 0.5] [--list] [--goals]

RUN is an output folder of `bole run pipelines/forest_plot.json` (stems.csv, rejected.csv) or of `stem_accuracy out=RUN`,
SCAN the folder of `bole simulate` that was run (trees.csv). Prints for every plot and for all of them together:
completeness, correctness, diameters (bias, RMSE, share and width of 95 % intervals), positions and heights; then the
pooled diameters by class with the share of intervals that hold the truth. With --goals it ends with 1 when an aim of
docs/dev/diameters.md is missed.
"""

import argparse
import csv
import math
import pathlib
import sys

CLASSES = [(7.5, 12.5), (12.5, 17.5), (17.5, 22.5), (22.5, 27.5), (27.5, 200)]


def rows_of(path):
    with open(path, newline="", encoding="utf-8") as file:
        return list(csv.DictReader(file))


def number(row, name):
    text = row.get(name, "")
    return float(text) if text else math.nan


def matched(trees, stems, gate):
    """Pairs by growing distance: one to one, which is enough where stems stand further apart than the gate."""
    offers = []
    for t, tree in enumerate(trees):
        for s, stem in enumerate(stems):
            distance = math.hypot(number(tree, "x_m") - number(stem, "x_m"), number(tree, "y_m") - number(stem, "y_m"))
            difference = abs(number(tree, "dbh_cm") - number(stem, "dbh_cm"))
            if distance <= gate:
                offers.append((distance + difference / 100, t, s))
    pairs, used = {}, set()
    for _, t, s in sorted(offers):
        if t not in pairs and s not in used:
            pairs[t] = s
            used.add(s)
    return pairs, used


class Sample:
    """Errors of matched stems of one plot or of several."""

    def __init__(self):
        self.trees = self.missed = self.false = 0
        self.dbh, self.error, self.half, self.covered, self.dx, self.dy, self.height = [], [], [], [], [], [], []
        self.state = []  # auto, or check where a person is asked to look

    def add(self, tree, stem):
        low, high = number(stem, "dbh_lo_cm"), number(stem, "dbh_hi_cm")
        true = number(tree, "dbh_cm")
        self.dbh.append(true)
        self.error.append(number(stem, "dbh_cm") - true)
        self.half.append((high - low) / 2)
        self.covered.append(low <= true <= high)
        self.state.append(stem.get("state", ""))
        self.dx.append(number(stem, "x_m") - number(tree, "x_m"))
        self.dy.append(number(stem, "y_m") - number(tree, "y_m"))
        if stem.get("height_seen") == "1":
            self.height.append(number(stem, "height_m") - number(tree, "height_m"))

    def part(self, low, high):
        part = Sample()
        for i, dbh in enumerate(self.dbh):
            if low <= dbh < high:
                for name in ("dbh", "error", "half", "covered", "state"):
                    getattr(part, name).append(getattr(self, name)[i])
        return part

    def standardised(self):
        """Root mean square of the errors by the standard deviations that the intervals stand for: 1 where they fit."""
        return rms([1.96 * e / h for e, h in zip(self.error, self.half) if h > 0])

    def extend(self, other):
        self.trees += other.trees
        self.missed += other.missed
        self.false += other.false
        for name in ("dbh", "error", "half", "covered", "dx", "dy", "height", "state"):
            getattr(self, name).extend(getattr(other, name))


def mean(values):
    return sum(values) / len(values) if values else math.nan


def rms(values):
    return math.sqrt(mean([v * v for v in values])) if values else math.nan


def stands_on(stem, thin, gate=0.15, difference=2):
    """Whether a stem is one of the saplings: real, but no tree of the plot."""
    return any(math.hypot(number(t, "x_m") - number(stem, "x_m"), number(t, "y_m") - number(stem, "y_m")) < gate
               and abs(number(t, "dbh_cm") - number(stem, "dbh_cm")) < difference for t in thin)


def judge(run, scan, options, trees=None):
    """The stems of a run held against the trees of a scan, or against those given in their place."""
    trees = trees or rows_of(scan / "trees.csv")
    saplings = rows_of(scan / "saplings.csv") if (scan / "saplings.csv").exists() else []
    stems = rows_of(run / "stems.csv")
    rejected = rows_of(run / "rejected.csv") if (run / "rejected.csv").exists() else []
    pairs, used = matched(trees, stems, options.gate)
    sample = Sample()
    inside = [(min(number(t, "x_m") for t in trees if t["in_plot"] == "1"), max(number(t, "x_m") for t in trees if t["in_plot"] == "1")),
              (min(number(t, "y_m") for t in trees if t["in_plot"] == "1"), max(number(t, "y_m") for t in trees if t["in_plot"] == "1"))]
    for t, tree in enumerate(trees):
        if tree["in_plot"] != "1" or number(tree, "dbh_cm") < options.min_dbh:
            continue
        sample.trees += 1
        if t in pairs:
            sample.add(tree, stems[pairs[t]])
            if options.list:
                stem = stems[pairs[t]]
                print(f"  {scan.name} {tree['tree_id']:>4} {number(tree, 'dbh_cm'):6.2f} {sample.error[-1]:+.2f} +-{sample.half[-1]:.2f} "
                      f"{'' if sample.covered[-1] else 'OUT'} {stem['reasons']}")
        else:
            sample.missed += 1
            why = [r["reason"] for r in rejected if math.hypot(number(r, "x_m") - number(tree, "x_m"), number(r, "y_m") - number(tree, "y_m")) < options.gate]
            print(f"missed in {scan.name}: tree {tree['tree_id']}, {number(tree, 'dbh_cm'):.1f} cm at {number(tree, 'x_m'):.2f}, {number(tree, 'y_m'):.2f}; {'; '.join(why) or 'no candidate'}")
    for s, stem in enumerate(stems):
        x, y = number(stem, "x_m"), number(stem, "y_m")
        if s in used or number(stem, "dbh_cm") < options.min_dbh or stands_on(stem, saplings):
            continue
        if inside[0][0] <= x <= inside[0][1] and inside[1][0] <= y <= inside[1][1]:
            sample.false += 1
            print(f"false in {scan.name}: {number(stem, 'dbh_cm'):.1f} cm at {x:.2f}, {y:.2f}; {stem['quality']}: {stem['reasons']}")
    return sample


def line(name, s):
    found = s.trees - s.missed
    height = f"{mean(s.height):+.2f} / {rms(s.height):.2f} ({len(s.height)})" if s.height else "none seen"
    return (f"| {name} | {s.trees} | {100 * found / max(1, s.trees):.1f} | {100 * found / max(1, found + s.false):.1f} | {mean(s.error):+.2f} / {rms(s.error):.2f} | "
            f"{100 * mean(s.covered):.1f} % within +-{mean(s.half):.2f} | {100 * mean(s.dx):+.2f}, {100 * mean(s.dy):+.2f} / {100 * rms(s.dx):.2f}, {100 * rms(s.dy):.2f} | {height} |")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("pairs", nargs="+", metavar="RUN=SCAN")
    parser.add_argument("--min-dbh", type=float, default=7.5)
    parser.add_argument("--gate", type=float, default=0.5)
    parser.add_argument("--list", action="store_true", help="print every tree")
    parser.add_argument("--goals", action="store_true", help="end with 1 when an aim is missed")
    options = parser.parse_args()
    pooled, lines = Sample(), []
    for pair in options.pairs:
        run, _, scan = pair.partition("=")
        sample = judge(pathlib.Path(run), pathlib.Path(scan), options)
        lines.append(line(pathlib.Path(scan).name, sample))
        pooled.extend(sample)
    print("\n| plot | trees | found, % | right, % | DBH bias / RMSE, cm | 95 % interval | position x, y: mean / RMSE, cm | height bias / RMSE, m (n) |\n|---|---|---|---|---|---|---|---|")
    print("\n".join(lines))
    print(line("all", pooled))
    print("\n| DBH, cm | trees | bias / RMSE, cm | intervals that hold the truth | standardised error |\n|---|---|---|---|---|")
    shares = [mean(pooled.covered)]
    for low, high in CLASSES:
        part = pooled.part(low, high)
        if part.error:
            shares.append(mean(part.covered))
            print(f"| {low:g} to {high:g} | {len(part.error)} | {mean(part.error):+.2f} / {rms(part.error):.2f} | {100 * mean(part.covered):.1f} % within +-{mean(part.half):.2f} | {part.standardised():.2f} |")
    found = pooled.trees - pooled.missed
    goals = {"completeness >= 99 %": found >= 0.99 * pooled.trees, "correctness >= 99 %": found >= 0.99 * (found + pooled.false), "DBH RMSE <= 0.5 cm": rms(pooled.error) <= 0.5,
             "|DBH bias| <= 0.1 cm": abs(mean(pooled.error)) <= 0.1, "position RMSE <= 1 cm per axis": max(rms(pooled.dx), rms(pooled.dy)) <= 0.01,
             "intervals hold 92 to 98 %, in all and by class": all(0.92 <= s <= 0.98 for s in shares)}
    if pooled.height:
        goals["height RMSE <= 0.5 m"] = rms(pooled.height) <= 0.5
    else:
        print("\nno top was seen: nothing to tell of heights")
    print("\n" + "\n".join(f"{'met' if met else 'MISSED'}: {goal}" for goal, met in goals.items()))
    return 1 if options.goals and not all(goals.values()) else 0


if __name__ == "__main__":
    sys.exit(main())
