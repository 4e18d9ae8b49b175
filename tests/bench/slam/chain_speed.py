#!/usr/bin/env python3
"""How long the whole chain takes, and its parts beside others: what docs/dev/slam.md and diameters.md say of speed, in one call.

  chain_speed.py --build build/headless --work DIR [--only chain foreign odometry cloud peer] [--bole-before PROGRAM]
                 [--kitti FOLDER --kiss-python PYTHON] [--fin-python PYTHON] [--cloud LAS]

Recordings stay in DIR and are used again. On an idle machine with two cores about 12 minutes once they are there.
  chain     pipelines/forest_plot.json with its defaults, report included, on plot4 of seed 1: wall and processor time in all
            and by stage, SLAM in ms per frame, and what came out
  foreign   the same on foreign_plot.json of seed 12 (130 thin stems, another scanner)
  odometry  tests/bench/peers/kiss_icp_odometry.py on raw sweeps; wants a Python with kiss-icp
  cloud     plot_speed on the map of `chain`: from a LAS file to the stem table
  peer      tests/bench/peers/against_3dfin.py on the same map, cut to the plot, without rays; wants a Python with 3DFin and laspy
With --bole-before the chains are run by that program first, in the same sitting.
"""

import argparse
import json
import os
import pathlib
import resource
import subprocess
import sys
import time

REPOSITORY = pathlib.Path(__file__).resolve().parents[3]
STEMS = REPOSITORY / "tests/bench/stems"
PEERS = REPOSITORY / "tests/bench/peers"
RECORDINGS = {
    "chain": ("plot4_1", ["--plot", "plot4", "--seed", "1"], []),
    "foreign": ("foreign_12", ["--plot", STEMS / "foreign_plot.json", "--sensor", STEMS / "foreign_32.json", "--seed", "12",
                               "--laser-bias", "0", "--noise-growth", "1", "--bark-facets", "true"],
                [f"scan.sensor={STEMS / 'foreign_32.json'}"]),
}


def timed(command):
    before, start = resource.getrusage(resource.RUSAGE_CHILDREN), time.perf_counter()
    done = subprocess.run([str(c) for c in command], capture_output=True, text=True)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    if done.returncode != 0:
        sys.exit(f"{' '.join(map(str, command))}\n{done.stderr.strip()}")
    return time.perf_counter() - start, after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime


def recording(bole, work, name):
    folder, words, _ = RECORDINGS[name]
    if not (work / folder / "walk.pcap").exists():
        print(f"simulating {folder}", flush=True)
        timed([bole, "simulate", *words, "--out", work / folder])
    return work / folder


def metric(stage, name):
    value = stage.get("metrics", {}).get(name)
    return value.get("value") if isinstance(value, dict) else value


def chain(bole, work, name, label):
    scan, out = recording(bole, work, name), work / f"out_{name}_{label}"
    sets = [f"scan.file={scan / 'walk.pcap'}", f"reference_trees.file={scan / 'trees.csv'}",
            f"reference_path.file={scan / 'trajectory.tum'}", *RECORDINGS[name][2]]
    wall, processor = timed([bole, "run", REPOSITORY / "pipelines/forest_plot.json", "--no-cache", "--out", out,
                             *[word for s in sets for word in ("--set", s)]])
    summary = json.loads((out / "summary.json").read_text())
    stages = {stage["id"]: stage for stage in summary["stages"]}
    slam = stages["slam"]
    frames = slam["counts"]["frames"]
    print(f"\n{name}, {label}: {wall:.1f} s of wall clock, {processor:.1f} s of the processors, {frames} frames, "
          f"SLAM {1000 * slam['seconds'] / frames:.1f} ms of wall clock a frame\n")
    print("| stage | wall, s |\n|---|---|")
    for key, stage in sorted(stages.items(), key=lambda item: -item[1].get("seconds", 0)):
        if stage.get("seconds", 0) >= 0.05:
            print(f"| {key} | {stage['seconds']:.2f} |")
    parts = {k.removesuffix("_per_frame"): metric(slam, k) for k in slam.get("metrics", {}) if k.endswith("_per_frame")}
    print("\nSLAM, ms a frame (reading and features run beside the rest): " + ", ".join(f"{k} {v:.1f}" for k, v in parts.items()))
    results = ("ate_rmse", "completeness", "correctness", "dbh_bias", "dbh_rmse", "dbh_interval_coverage")
    found = {k: v for k, v in ((k, metric(stages["evaluate"], k)) for k in results) if v is not None}
    print("What came out: " + ", ".join(f"{k} {v:.4g}" for k, v in found.items()), flush=True)


def map_of(bole, work):
    """The map of the part chain as a LAS file: how fast LAZ is decoded is measured elsewhere."""
    found = sorted(work.glob("out_chain_*/cloud.la[sz]"), key=os.path.getmtime)
    if not found:
        sys.exit("the parts cloud and peer want the map of the part chain: run that first")
    las = work / "map.las"
    timed([bole, "convert", found[-1], las])
    return las


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--build", required=True, type=pathlib.Path)
    parser.add_argument("--work", required=True, type=pathlib.Path)
    parser.add_argument("--only", nargs="*", default=["chain", "foreign", "odometry", "cloud", "peer"])
    parser.add_argument("--bole-before", type=pathlib.Path)
    parser.add_argument("--cloud", type=pathlib.Path, help="another LAS file for the part cloud; plot2 of seed 2 has 20 million points")
    parser.add_argument("--kitti", type=pathlib.Path, help="raw sweeps for kiss_icp_odometry.py")
    parser.add_argument("--kiss-python", default=sys.executable)
    parser.add_argument("--fin-python", default=sys.executable)
    options = parser.parse_args()
    bole = options.build / "bin/bole"
    options.work.mkdir(parents=True, exist_ok=True)
    for name in ("chain", "foreign"):
        if name not in options.only:
            continue
        if options.bole_before:
            chain(options.bole_before, options.work, name, "before")
        chain(bole, options.work, name, "now")
    if "odometry" in options.only and options.kitti:
        subprocess.run([options.kiss_python, PEERS / "kiss_icp_odometry.py", options.build, options.kitti], check=True)
    if "cloud" in options.only:
        subprocess.run([options.build / "bin/plot_speed", f"cloud={options.cloud or map_of(bole, options.work)}"], check=True)
    if "peer" in options.only:
        scan = recording(bole, options.work, "chain")
        subprocess.run([options.fin_python, PEERS / "against_3dfin.py", "--bole", bole, "--dense", f"{map_of(bole, options.work)}={scan}"],
                       check=True)
    return 0


if __name__ == "__main__":
    sys.exit(main())
