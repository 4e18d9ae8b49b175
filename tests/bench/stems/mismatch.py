#!/usr/bin/env python3
"""DBH where the forest and the scanner are not what stems.measure assumes: a table of ranges.

    mismatch.py --bole PROGRAM --work FOLDER [--seeds 1,2] [--rows PATTERN] [--keep] [--list]

Simulates a small plot with true poses, once as the estimator assumes it and then with one assumption broken after the
other (beam, range noise, bark, form of the stem, gait, angles, clock, wind, water), and with all of them together. Prints
bias and RMSE of DBH and the share of 95 % intervals that hold the truth, by row and over all rows, pooled over seeds.
Results of single runs stay in FOLDER, so that an interrupted table goes on where it stopped.
"""

import argparse
import copy
import fnmatch
import json
import pathlib
import sys
import types

from stem_tables import Sample, judge, mean, rms
from surveys import remove_recording, simulate, survey

# As the estimator assumes it: no bark below the ridges (bark_relief 0), stems hardly out of round, the beam of the file.
PLOT = {
    "name": "mismatch",
    "size_m": 12,
    "buffer_m": 1,
    "layout": {"min_spacing_m": 1.1, "clustering": 0.3},
    "trees": {
        "count": 24,
        "dbh_mean_cm": 19.0,
        "dbh_sd_cm": 7.0,
        "dbh_min_cm": 7.5,
        "dbh_max_cm": 50,
        "conifer_share": 0.3,
        "ovality": 0.02,
        "bark_mm": 0,
    },
    "terrain": {"slope_deg": 6, "undulation_m": 0.4},
    "understorey": {"shrubs_per_ha": 200, "saplings_per_ha": 0, "grass_per_ha": 2000},
}

# Name of the row: (changes of the recipe, options of bole simulate). Fields of the recipe by their path.
ROWS = {
    "as assumed": ({}, {}),
    "beam 1.5 times as wide": ({}, {"divergence": 1.5}),
    "beam 0.67 times as wide": ({}, {"divergence": 0.67}),
    "echoes apart from 0.15 m": ({}, {"pulse-length": 0.15}),
    "noise twice": ({}, {"noise": 2, "laser-bias": 0.002}),
    "noise doubled at edges": ({}, {"noise-growth": 1}),
    "lasers without constants": ({}, {"laser-bias": 0}),
    "lasers off by 8 mm": ({}, {"laser-bias": 0.008}),
    "bark 3 mm deep": ({"trees.bark_mm": 3}, {}),
    "bark 12 mm deep": ({"trees.bark_mm": 12}, {}),
    "bark 3 mm in plates": ({"trees.bark_mm": 3}, {"bark-facets": "true"}),
    "ovality 5 %": ({"trees.ovality": 0.05}, {}),
    "buttresses": ({"trees.buttress_share": 0.5}, {}),
    "leaning stems": ({"trees.leaning_share": 0.5, "trees.lean_sd_deg": 5}, {}),
    "gait twice": ({}, {"gait": 2}),
    "angles off by 0.1 deg": ({}, {"angle-error": 0.1}),
    "clock off by 1 ms": ({}, {"clock-jitter": 0.001}),
    "wind 5 m/s": ({}, {"wind": 5}),
    "wind 10 m/s": ({}, {"wind": 10}),
    "soaked": ({}, {"wet": 1}),
    "operator in the beams": ({}, {"operator-body": "true", "sensor-height": 1.6}),
    "all together": (
        {"trees.bark_mm": 3, "trees.ovality": 0.035, "trees.buttress_share": 0.15, "trees.leaning_share": 0.1},
        {"divergence": 1.25, "noise": 1.5, "noise-growth": 0.5, "gait": 1.5, "angle-error": 0.05, "clock-jitter": 0.0005,
         "wind": 5, "wet": 0.5, "operator-body": "true"},
    ),
}
COSTLY_CM = 0.1

WALK = ["--line-spacing", 5, "--speed", 1.3]


def recipe_with(changes):
    recipe = copy.deepcopy(PLOT)
    for path, value in changes.items():
        group, name = path.split(".")
        recipe[group][name] = value
    return recipe


def measured(options, work, row, seed):
    """Folders of the survey and of the truth of one run; made where they are not there yet."""
    changes, flags = ROWS[row]
    name = "".join(c if c.isalnum() else "_" for c in row) + f"_{seed}"
    folder = work / name
    scan, out = folder / "scan", folder / "survey"
    if not (out / "stems.csv").exists():
        recipe = work / f"{name}.json"
        recipe.write_text(json.dumps(recipe_with(changes)), encoding="utf-8")
        arguments = [part for flag, value in flags.items() for part in (f"--{flag}", value)]
        simulate(options.bole, ["--plot", recipe, "--seed", seed, *WALK, *arguments], folder)
        survey(options.bole, scan, [f"slam.trajectory={scan}/trajectory.tum", *options.set], out)
        if not options.keep:
            remove_recording(scan, out)
    return out, scan


def line(row, sample, base):
    cost = "" if base is None or sample is base else f"{mean(sample.error) - mean(base.error):+.2f}"
    costly = cost and (abs(mean(sample.error) - mean(base.error)) > COSTLY_CM or rms(sample.error) - rms(base.error) > COSTLY_CM)
    found = sample.trees - sample.missed
    return (f"| {'**' + row + '**' if costly else row} | {found} of {sample.trees}, {sample.false} false | {mean(sample.error):+.2f} | {cost} | "
            f"{rms(sample.error):.2f} | {100 * mean(sample.covered):.0f} % within +-{mean(sample.half):.2f} |")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--bole", required=True, type=pathlib.Path)
    parser.add_argument("--work", required=True, type=pathlib.Path, help="folder for runs and their logs")
    parser.add_argument("--seeds", default="1,2")
    parser.add_argument("--rows", default="*", help="only rows whose name fits this pattern")
    parser.add_argument("--set", action="append", default=[], metavar="STAGE.OPTION=VALUE", help="of the survey, for all rows")
    parser.add_argument("--keep", action="store_true", help="keep recordings and clouds")
    parser.add_argument("--list", action="store_true", help="print every tree")
    options = parser.parse_args()
    work = options.work.resolve()
    work.mkdir(parents=True, exist_ok=True)
    seeds = [int(s) for s in options.seeds.split(",")]
    rows = [row for row in ROWS if fnmatch.fnmatch(row, options.rows)]
    if not rows:
        sys.exit(f"no row fits '{options.rows}'; rows: {', '.join(ROWS)}")
    matching = types.SimpleNamespace(gate=0.5, min_dbh=7.5, list=options.list)
    samples = {}
    for row in rows:
        samples[row] = Sample()
        for seed in seeds:
            samples[row].extend(judge(*measured(options, work, row, seed), matching))
        print(f"{row}: done", file=sys.stderr, flush=True)
    base = samples.get("as assumed")
    print("\n| broken | found | bias, cm | less the first row | RMSE, cm | 95 % interval |\n|---|---|---|---|---|---|")
    for row, sample in samples.items():
        print(line(row, sample, base))
    every = [s for s in samples.values() if s.error]
    print(f"| range over all rows | | {min(mean(s.error) for s in every):+.2f} to {max(mean(s.error) for s in every):+.2f} | | "
          f"{min(rms(s.error) for s in every):.2f} to {max(rms(s.error) for s in every):.2f} | "
          f"{100 * min(mean(s.covered) for s in every):.0f} to {100 * max(mean(s.covered) for s in every):.0f} % |")


if __name__ == "__main__":
    main()
