#!/usr/bin/env python3
"""One small simulated plot by `loam`, `forest` and `best`: each must be clearly better than the one before it. Their comparison by the
pipeline compare_runs must have the figures that each run gave itself.

All three see the same frames. docs/dev/slam.md has the figures of whole plots. Whoever changes a preset looks at more seeds:

  preset_order.py --bole build/headless/bin/bole --work DIR --seeds 1 2 3 4
"""

import argparse
import csv
import json
import pathlib
import shutil
import statistics
import subprocess
import sys

REPOSITORY = pathlib.Path(__file__).resolve().parents[2]
PRESETS = ["loam", "forest", "best"]

# How many times as large a figure of one preset must be as that of the next. Seen on seeds 1 and 2: path 3.0 to 3.7 and 4.0 to 4.4 times,
# wall 1.29 and 1.17; on seed 1 DBH 1.8 times between forest and best. Between loam and forest DBH has no order: what loam does worst, a
# walk that is too short, is taken out of the stems. Its own figure (6.9 times on seed 1) is guarded in its place. The margins leave a
# third, or half of what a figure is larger.
FACTORS = {
    "ate_cm": {"loam": 2.0, "forest": 2.6},
    "wall_mm": {"loam": 1.2, "forest": 1.08},
    "dbh_rmse_cm": {"forest": 1.3},
    "length_error_pct": {"loam": 3.0},
}


def run(command):
    print("+", " ".join(map(str, command)), flush=True)
    result = subprocess.run([str(c) for c in command], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
    if result.returncode != 0:
        sys.exit(f"{result.stdout}\nexit code {result.returncode}")


def rows(path):
    with open(path, newline="") as file:
        return list(csv.DictReader(file))


def measured(bole, scan, out, settings):
    """Figures of one run of the forest pipeline."""
    shutil.rmtree(out, ignore_errors=True)
    settings = {"scan.file": scan / "walk.pcap", "reference_trees.file": scan / "trees.csv",
                "reference_path.file": scan / "trajectory.tum", "plot.width": 16, "plot.length": 16,
                "report.figures": "false", "report.cloud": "false", **settings}
    run([bole, "run", REPOSITORY / "pipelines/forest_plot.json", "--out", out, "--no-cache",
         *(word for key, value in settings.items() for word in ("--set", f"{key}={value}"))])
    summary = json.loads((out / "summary.json").read_text())
    stages = {s["id"]: s for s in summary["stages"]}
    evaluated = {name: m["value"] for name, m in stages["evaluate"]["metrics"].items()}
    matched = {r["tree_id"] for r in rows(out / "matches.csv") if r["kind"] == "matched"}
    walls = [float(r["wall_cm"]) for r in rows(out / "stems.csv") if r["tree_id"] in matched and r["wall_cm"]]
    return {"frames": stages["slam"]["counts"]["frames"], "ate_cm": 100 * evaluated["ate_rmse"],
            "wall_mm": 10 * statistics.median(walls), "dbh_rmse_cm": evaluated["dbh_rmse"],
            "length_error_pct": abs(evaluated["length_error"]), "trees": len(matched),
            "seconds": stages["slam"]["seconds"], "evaluated": evaluated}


# Columns of the comparison, the measure of evaluation.plot, and what the decimals of stems.csv leave open.
COMPARED = [("rmse_x_m", "position_rmse_x", 1e-4), ("rmse_y_m", "position_rmse_y", 1e-4), ("mu_x_m", "position_mean_x", 1e-4),
            ("sigma_max_m", "position_sigma_max", 1e-4), ("dbh_bias_cm", "dbh_bias", 0.01), ("dbh_rmse_cm", "dbh_rmse", 0.01),
            ("dbh_rel_bias_pct", "dbh_relative_bias", 0.05), ("completeness_pct", "completeness", 1e-9),
            ("correctness_pct", "correctness", 1e-9), ("ate_rmse_m", "ate_rmse", 1e-5)]


def differences(bole, work, outs, figures):
    """Where the comparison of the runs says something else than each run did."""
    run([bole, "run", REPOSITORY / "pipelines/compare_runs.json", "--out", work / "comparison", "--no-cache",
         "--set", "runs.folders=" + ",".join(str(o) for o in outs.values()), "--set", "report.figures=false"])
    comparison = json.loads((work / "comparison" / "comparison.json").read_text())
    shutil.rmtree(work / "comparison", ignore_errors=True)
    if len({r["plot"] for r in comparison["runs"]}) != 1 or len(comparison["pairs"]) != 3:
        return ["the three runs are of one plot, and the comparison does not say so"]
    complaints = []
    for name, group in zip(outs, comparison["groups"]):
        if group["system"] != name:
            complaints.append(f"the system of {name} is {group['system']} in the comparison")
        for column, measure, tolerance in COMPARED:
            own = figures[name]["evaluated"][measure]
            if group[column] is None or not abs(group[column] - own) <= tolerance:
                complaints.append(f"{name}: {column} is {group[column]} in the comparison and {own} in the run")
    return complaints


def disorder(figures):
    """What is not in order; each pair of neighbours is told with its factor."""
    complaints = []
    if len({f["frames"] for f in figures.values()}) > 1:
        complaints.append("the presets mapped different numbers of frames")
    for measure, factors in FACTORS.items():
        for worse, better in zip(PRESETS, PRESETS[1:]):
            if worse not in factors:
                continue
            factor = figures[worse][measure] / figures[better][measure]
            print(f"  {measure}: {worse} has {factor:.2f} times that of {better} (at least {factors[worse]} expected)")
            if not factor >= factors[worse]:
                complaints.append(f"{measure}: {worse} {figures[worse][measure]:.4g} and {better} {figures[better][measure]:.4g} "
                                  f"are not {factors[worse]} times apart")
    return complaints


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--bole", required=True, type=pathlib.Path)
    parser.add_argument("--work", required=True, type=pathlib.Path)
    parser.add_argument("--plot", default="demo")
    parser.add_argument("--seeds", type=int, nargs="+", default=[1])
    parser.add_argument("--seconds", type=float, default=40, help="length of the walk")
    args = parser.parse_args()
    complaints = []
    for seed in args.seeds:
        scan = args.work / f"scan-{seed}"
        run([args.bole, "simulate", "--plot", args.plot, "--seed", seed, "--max-time", args.seconds, "--out", scan])
        figures = {}
        outs = {name: args.work / f"out_{name}" for name in PRESETS}
        for name in PRESETS:
            figures[name] = measured(args.bole, scan, outs[name], {"slam.preset": name})
            print(f"seed {seed}, {name}:", ", ".join(f"{k} {v:.4g}" for k, v in figures[name].items() if k != "evaluated"),
                  flush=True)
        complaints += [f"seed {seed}: {c}" for c in disorder(figures) + differences(args.bole, args.work, outs, figures)]
        for folder in [scan, *outs.values()]:
            shutil.rmtree(folder, ignore_errors=True)
    print("\n".join(complaints))
    return 1 if complaints else 0


if __name__ == "__main__":
    sys.exit(main())
