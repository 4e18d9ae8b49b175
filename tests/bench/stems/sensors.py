#!/usr/bin/env python3
"""The same plot and walk seen by several scanners: SLAM, diameters and time of the whole chain.

    sensors.py --bole PROGRAM --work FOLDER [--sensors vlp16,os1_128,pandar_xt32,mid360] [--plot demo] [--seeds 1] [--wind 5]

Every scanner walks through the plot as `bole simulate` does it, with an inertial unit of consumer grade where it is a
rosette (Livox) or where --imu says so, and is surveyed by pipelines/forest_plot.json with its presets. Prints error of the
path, tilt of the plot, trees found, bias and RMSE of DBH, the share of 95 % intervals that hold, the verdict and milliseconds per frame.
Results of single runs stay in FOLDER, so that an interrupted table goes on where it stopped.
"""

import argparse
import json
import math
import pathlib
import types

from stem_tables import Sample, judge, mean, rms
from surveys import remove_recording, simulate, survey

ROSETTES = {"mid360", "avia", "horizon"}


def surveyed(options, sensor, seed):
    """Folders of the survey and of the truth of one run; made where they are not there yet."""
    folder = options.work / f"{sensor}_{seed}_{options.wind:g}"
    out = folder / "survey"
    if not (out / "summary.json").exists():
        flags = ["--imu", options.imu or "consumer"] if options.imu or sensor in ROSETTES else []
        flags += ["--wind", options.wind] if options.wind else []
        flags += ["--mount-tilt", options.tilt] if sensor in ROSETTES else []
        flags += ["--max-time", options.seconds] if options.seconds else []
        scan = simulate(options.bole, ["--plot", options.plot, "--seed", seed, "--sensor", sensor, *flags], folder)
        survey(options.bole, scan, [f"reference_trees.file={scan}/trees.csv", f"reference_path.file={scan}/trajectory.tum", *options.set], out)
        if not options.keep:
            remove_recording(scan, out)
    return out, folder / "scan"


def line(sensor, runs, sample):
    stages = [{s["id"]: s for s in json.loads((out / "summary.json").read_text())["stages"]} for out, _ in runs]
    verdicts = sorted({str(json.loads((out / "summary.json").read_text())["verdict"]) for out, _ in runs})
    ate = [s["evaluate"]["metrics"]["ate_rmse"]["value"] for s in stages if "ate_rmse" in s["evaluate"].get("metrics", {})]
    frames = sum(s["slam"]["counts"]["frames"] for s in stages)
    seconds = sum(s["slam"]["seconds"] for s in stages)
    diameters = "" if not sample.error else f"{mean(sample.error):+.2f} / {rms(sample.error):.2f} | {100 * mean(sample.covered):.0f} % within +-{mean(sample.half):.2f}"
    tilt = mean([tilt_deg(out, scan) for out, scan in runs])
    return (f"| {sensor} | {100 * mean(ate):.1f} | {tilt:.3f} | {sample.trees - sample.missed} of {sample.trees}, {sample.false} false | {diameters or ' | '} | "
            f"{', '.join(verdicts)} | {1000 * seconds / max(1, frames):.0f} |")


def poses(file):
    """{time to 1 ms: (x, y, z)} of a TUM file."""
    rows = (row.split() for row in file.read_text(encoding="utf-8").splitlines() if row and not row.startswith("#"))
    return {round(float(row[0]), 3): tuple(map(float, row[1:4])) for row in rows}


def tilt_deg(out, scan):
    """Slope of the plane through the differences in height of the path and its truth: how far z is off the vertical."""
    found, truth = poses(out / "trajectory.tum"), poses(scan / "trajectory.tum")
    rows = [(*truth[t][:2], found[t][2] - truth[t][2]) for t in found.keys() & truth.keys()]
    if len(rows) < 10:
        return math.nan
    x, y, d = (mean(column) for column in zip(*rows))
    xx, xy, yy, xd, yd = (sum(f(*row) for row in rows) for f in (lambda a, b, c: (a - x) ** 2, lambda a, b, c: (a - x) * (b - y), lambda a, b, c: (b - y) ** 2,
                                                                lambda a, b, c: (a - x) * (c - d), lambda a, b, c: (b - y) * (c - d)))
    det = xx * yy - xy * xy
    return math.degrees(math.hypot((yy * xd - xy * yd) / det, (xx * yd - xy * xd) / det))


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--bole", required=True, type=pathlib.Path)
    parser.add_argument("--work", required=True, type=pathlib.Path, help="folder for runs and their logs")
    parser.add_argument("--sensors", default="vlp16,os1_128,pandar_xt32,mid360")
    parser.add_argument("--plot", default="demo")
    parser.add_argument("--seeds", default="1")
    parser.add_argument("--seconds", type=float, help="longest walk")
    parser.add_argument("--wind", type=float, default=0, help="m/s")
    parser.add_argument("--imu", help="grade of an inertial unit for all scanners")
    parser.add_argument("--tilt", type=float, default=180, help="of rosettes, degrees: hanging, a Mid-360 sees the ground")
    parser.add_argument("--set", action="append", default=[], metavar="STAGE.OPTION=VALUE", help="of the survey")
    parser.add_argument("--keep", action="store_true", help="keep recordings and clouds")
    options = parser.parse_args()
    options.work = options.work.resolve()
    matching = types.SimpleNamespace(gate=0.5, min_dbh=7.5, list=False)
    print("| scanner | ATE, cm | tilt, deg | found | DBH bias / RMSE, cm | 95 % interval | verdict | SLAM, ms/frame |\n|---|---|---|---|---|---|---|---|")
    for sensor in options.sensors.split(","):
        runs = [surveyed(options, sensor, int(seed)) for seed in options.seeds.split(",")]
        sample = Sample()
        for out, scan in runs:
            sample.extend(judge(out, scan, matching))
        print(line(sensor, runs, sample), flush=True)


if __name__ == "__main__":
    main()
