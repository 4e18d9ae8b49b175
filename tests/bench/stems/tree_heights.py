#!/usr/bin/env python3
"""Heights of a survey beside the truth of its simulation: tops that count as seen, and lower bounds by the reason why a top does not.

    tree_heights.py --stems OUT/stems.csv --truth SCAN/trees.csv

Trees of the plot that are alive; a stem is that of a tree within 0.3 m. A lower bound should not exceed the height.
"""
import argparse
import collections
import csv
import math
import pathlib
import statistics

SAME_TREE_M = 0.3


def rows(path):
    with open(path, newline="", encoding="utf-8") as file:
        return list(csv.DictReader(file))


def stem_of(tree, stems):
    def apart(stem):
        return math.hypot(float(stem["x_m"]) - float(tree["x_m"]), float(stem["y_m"]) - float(tree["y_m"]))

    nearest = min(stems, key=apart, default=None)
    return nearest if nearest is not None and apart(nearest) < SAME_TREE_M else None


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--stems", required=True, type=pathlib.Path)
    parser.add_argument("--truth", required=True, type=pathlib.Path)
    options = parser.parse_args()
    stems = rows(options.stems)
    missed, seen, bounds = 0, [], collections.defaultdict(list)
    for tree in rows(options.truth):
        if tree["in_plot"] != "1" or tree["state"] != "alive":
            continue
        stem = stem_of(tree, stems)
        if stem is None:
            missed += 1
        elif stem["height_seen"] == "1":
            seen.append(float(stem["height_m"]) - float(tree["height_m"]))
        elif stem["height_lower_bound_m"]:
            bounds[stem["top"]].append(float(stem["height_lower_bound_m"]) - float(tree["height_m"]))
    if seen:
        rmse = math.sqrt(statistics.fmean(e * e for e in seen))
        print(f"{len(seen)} tops seen: {statistics.fmean(seen):+.2f} / {rmse:.2f} m, worst {max(map(abs, seen)):.2f} m; {missed} trees missed")
    for why, errors in sorted(bounds.items()):
        too_high = sum(e > 0.5 for e in errors)
        print(f"{len(errors)} lower bounds, {why}: highest {max(errors):+.2f} m, {too_high} exceed the height by more than 0.5 m")


if __name__ == "__main__":
    main()
