#!/usr/bin/env python3
"""One small simulated plot by `loam`, `forest` and `best`: each must be clearly better than the one before it.

The margins are those that several seeds keep (--seeds, for whoever changes a preset):
docs/dev/slam.md has the figures of whole plots.
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
            "wall_mm": 10 * statistics.median(walls), "dbh_rmse_cm": evaluated["dbh_rmse"], "trees": len(matched),
            "seconds": stages["slam"]["seconds"]}


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--bole", required=True, type=pathlib.Path)
    parser.add_argument("--work", required=True, type=pathlib.Path)
    parser.add_argument("--plot", default="demo")
    parser.add_argument("--seeds", type=int, nargs="+", default=[1])
    parser.add_argument("--seconds", type=float, default=40, help="length of the walk")
    args = parser.parse_args()
    for seed in args.seeds:
        scan = args.work / f"scan-{seed}"
        run([args.bole, "simulate", "--plot", args.plot, "--seed", seed, "--most-time", args.seconds, "--out", scan])
        for name in [*PRESETS, "true"]:
            how = {"slam.trajectory": scan / "trajectory.tum"} if name == "true" else {"slam.preset": name}
            print(seed, name, {k: round(v, 3) for k, v in measured(args.bole, scan, args.work / "out", how).items()}, flush=True)
        shutil.rmtree(scan, ignore_errors=True)


if __name__ == "__main__":
    sys.exit(main())
