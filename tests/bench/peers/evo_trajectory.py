#!/usr/bin/env python3
"""Holds the measures of `bole evaluate trajectory` against those of evo (M. Grupp: evo, on PyPI) on the same files.

  evo_trajectory.py --bole build/headless/bin/bole [ESTIMATE REFERENCE]

TUM files; without them a bent walk with drift, noise and a turned frame is made. Compared are ATE and its rotation with SE(3)
alignment and without, RPE over a number of poses, and RPE over metres of way. Ends with 77 (skipped) where evo is not installed
(pip install evo), with 1 where a figure differs.
"""

import argparse
import copy
import json
import math
import pathlib
import random
import subprocess
import sys
import tempfile

try:
    from evo.core import metrics, sync
    from evo.core.units import Unit
    from evo.tools import file_interface
except ImportError:
    print("skipped: evo is not installed")
    sys.exit(77)


def quaternion(yaw, pitch):
    cy, sy, cp, sp = math.cos(yaw / 2), math.sin(yaw / 2), math.cos(pitch / 2), math.sin(pitch / 2)
    return (-sy * sp, cy * sp, sy * cp, cy * cp)


def write_walks(folder, step_s=0.1, poses=1200):
    """A reference at the estimate's times, so that neither program interpolates."""
    noise = random.Random(7)
    reference, estimate = [], []
    x = y = 0.0
    for i in range(poses):
        yaw = 1.2 * math.sin(0.01 * i)
        x, y = x + 0.1 * math.cos(yaw), y + 0.1 * math.sin(yaw)
        z = 0.3 * math.sin(0.02 * i)
        reference.append((i * step_s, x, y, z, *quaternion(yaw, 0.02 * math.sin(0.3 * i))))
        drift, turn = 1 + 0.002 * math.sin(0.004 * i), 0.4 + 0.00002 * i
        px, py = drift * x + noise.gauss(0, 0.01), drift * y + noise.gauss(0, 0.01)
        estimate.append((i * step_s, px * math.cos(turn) - py * math.sin(turn) + 3, px * math.sin(turn) + py * math.cos(turn) - 1,
                         z + noise.gauss(0, 0.01), *quaternion(yaw + turn + noise.gauss(0, 0.002), 0.02 * math.sin(0.3 * i))))
    for name, rows in (("reference", reference), ("estimate", estimate)):
        (folder / f"{name}.tum").write_text("".join(" ".join(f"{v:.9f}" for v in row) + "\n" for row in rows))
    return folder / "estimate.tum", folder / "reference.tum"


def of_bole(bole, estimate, reference, **options):
    words = [str(bole), "evaluate", "trajectory", str(estimate), str(reference), "--json"]
    for name, value in options.items():
        words += [f"--{name.replace('_', '-')}", str(value)]
    return {name: m["value"] for name, m in json.loads(subprocess.run(words, check=True, capture_output=True).stdout).items()}


def statistics(metric, pair):
    metric.process_data(pair)
    all_of_it = metric.get_all_statistics()
    return {"rmse": all_of_it["rmse"], "mean": all_of_it["mean"], "median": all_of_it["median"], "max": all_of_it["max"],
            "sd": all_of_it["std"]}


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--bole", required=True, type=pathlib.Path)
    parser.add_argument("estimate", nargs="?", type=pathlib.Path)
    parser.add_argument("reference", nargs="?", type=pathlib.Path)
    parser.add_argument("--poses-per-step", type=int, default=10, help="poses of the RPE by time (rpe_step is this times their spacing)")
    parser.add_argument("--distance", type=float, default=5.0, help="metres of the RPE by distance")
    arguments = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        files = (arguments.estimate, arguments.reference) if arguments.reference else write_walks(pathlib.Path(folder))
        reference, estimate = sync.associate_trajectories(file_interface.read_tum_trajectory_file(str(files[1])),
                                                          file_interface.read_tum_trajectory_file(str(files[0])), max_diff=1e-4)
        spacing_s = float((reference.timestamps[-1] - reference.timestamps[0]) / (len(reference.timestamps) - 1))
        options = {"rpe_step": f"{arguments.poses_per_step * spacing_s:.6f}", "rpe_distance": arguments.distance}
        rows = []
        for alignment in ("none", "se3"):
            moved = copy.deepcopy(estimate)
            if alignment == "se3":
                moved.align(reference, correct_scale=False)
            ours = of_bole(arguments.bole, *files, align_trajectory=alignment, **options)
            relation = metrics.PoseRelation
            theirs = {
                "ate": statistics(metrics.APE(relation.translation_part), (reference, moved)),
                "rotation_error": statistics(metrics.APE(relation.rotation_angle_deg), (reference, moved)),
                "rpe_translation": statistics(metrics.RPE(relation.translation_part, arguments.poses_per_step, Unit.frames, all_pairs=True),
                                              (reference, moved)),
                "rpe_rotation": statistics(metrics.RPE(relation.rotation_angle_deg, arguments.poses_per_step, Unit.frames, all_pairs=True),
                                           (reference, moved)),
                "rpe_distance_translation": statistics(
                    metrics.RPE(relation.translation_part, arguments.distance, Unit.meters, rel_delta_tol=0.02, all_pairs=True,
                                pairs_from_reference=True), (reference, moved)),
            }
            for name, figures in theirs.items():
                for kind, value in figures.items():
                    rows.append((alignment, f"{name}_{kind}", ours[f"{name}_{kind}"], value))
    wrong = 0
    print(f"{'alignment':<10}{'measure':<34}{'bole':>14}{'evo':>14}")
    for alignment, name, ours, theirs in rows:
        # By distance evo takes the pose nearest to the distance, Bole the first one beyond it.
        tolerance = 0.03 * theirs if name.startswith("rpe_distance") else 1e-6 + 1e-5 * theirs
        agrees = abs(ours - theirs) <= tolerance
        wrong += not agrees
        print(f"{alignment:<10}{name:<34}{ours:>14.8f}{theirs:>14.8f}{'' if agrees else '   differs'}")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
