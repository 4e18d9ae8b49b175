#!/usr/bin/env python3
"""Stems that were seen in part, in clouds that know nothing of their scanner: do their intervals hold?

    without_rays.py --bole build/headless/bin/bole [--seeds 71 72] [--sensors vlp32c vlp16 ...] [--work DIR]

Simulates the plot `sample` (a walk through the middle, so that most stems are seen from one side), maps it with the true poses, writes
x, y and z alone, and measures that cloud. Prints a row for each sensor and seed, of all stems and of those seen on less than 300 deg
(`arc_deg`). Exits 1 where a verdict is sign although fewer than 85 % of the intervals of the sound stems hold. Needs numpy.
"""
import argparse
import pathlib
import subprocess
import sys
import tempfile

import measured
import mutants

PART_DEG, MIN_HOLDING = 300, 0.85


def cloud_of(bole, sensor, seed, folder):
    scan, points = folder / "scan", folder / "cloud.ply"
    subprocess.run([bole, "simulate", "--plot", "sample", "--seed", str(seed), "--sensor", sensor, "--out", scan], check=True, capture_output=True)
    walk = next((scan / name for name in ("walk.pcap", "walk.bag", "frames") if (scan / name).exists()))
    command = [bole, "run", "forest_plot", "--no-cache", "--out", folder / "map", "--set", f"scan.file={walk}", "--set", f"slam.trajectory={scan}/trajectory.tum",
               "--set", "report.cloud_format=las", "--set", "report.figures=false", "--set", "report.page=false"]
    subprocess.run([str(c) for c in command], check=True, capture_output=True)
    everything = mutants.read_las(folder / "map/cloud.las")
    mutants.write_ply(points, everything[(abs(everything[:, 0]) < 8) & (abs(everything[:, 1]) < 8)])
    return scan, points


def words(pairs):
    if not pairs:
        return "", ""
    holding = sum(s["low"] <= t["dbh"] <= s["high"] for t, s in pairs)
    return measured.bias_rmse([s["dbh"] - t["dbh"] for t, s in pairs]), f"{holding} of {len(pairs)}"


def row_of(bole, sensor, seed, folder):
    """Prints a row; false where it is wrong in silence."""
    scan, cloud = cloud_of(bole, sensor, seed, folder)
    result = measured.survey(bole, cloud, folder / "out")
    arcs = [measured.number(r["arc_deg"]) for r in measured.rows_of(folder / "out/stems.csv") if r.get("state") != "rejected"]
    trees = [{"x": float(r["x_m"]), "y": float(r["y_m"]), "dbh": float(r["dbh_cm"]), "quality": ""} for r in measured.rows_of(scan / "trees.csv") if float(r["dbh_cm"]) >= 7.5]
    found = {i: k for i, k in measured.pairs_of(trees, result["stems"], 0.4).items() if not result["stems"][k]["flagged"]}
    sound = [(trees[i], result["stems"][k]) for i, k in found.items()]
    part = [(trees[i], result["stems"][k]) for i, k in found.items() if arcs[k] < PART_DEG]
    (of_all, all_hold), (of_part, part_hold) = words(sound), words(part)
    print(f"| {sensor} | {seed} | {of_all} | {all_hold} | {of_part} | {part_hold} | {result['verdict']}: {measured.codes(result)} |", flush=True)
    holding = sum(s["low"] <= t["dbh"] <= s["high"] for t, s in sound)
    return result["verdict"] != "sign" or holding >= MIN_HOLDING * len(sound)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--bole", required=True, type=pathlib.Path)
    parser.add_argument("--seeds", type=int, nargs="+", default=[71, 72])
    parser.add_argument("--sensors", nargs="+", default=["vlp32c", "vlp16"])
    parser.add_argument("--work", type=pathlib.Path)
    options = parser.parse_args()
    try:
        import numpy  # noqa: F401
    except ImportError as error:
        print(f"SKIPPED: {error}")
        return 0
    print("| scanner | seed | sound stems: bias / RMSE, cm (n) | 95 % holds | seen on less than 300 deg | 95 % holds | verdict |\n" + "|---" * 7 + "|")
    right = True
    for sensor in options.sensors:
        for seed in options.seeds:
            with tempfile.TemporaryDirectory(dir=options.work) as folder:
                right &= row_of(options.bole.resolve(), sensor, seed, pathlib.Path(folder))
    return 0 if right else 1


if __name__ == "__main__":
    sys.exit(main())
