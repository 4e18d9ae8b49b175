#!/usr/bin/env python3
"""Tables 2 and 3 of the paper on improved LOAM (SPEC A) with published and measured figures side by side, and the ablation.

Simulates plots, runs the pipeline forest_plot.json on each with each preset, and prints medians over the seeds:

  slam_tables.py --bole build/headless/bin/bole --work DIR --plots plot1 plot2 --presets loam forest best --seeds 1 2 3
  slam_tables.py --bole ... --work DIR --plots demo --ablation forest

Every finished run stays in DIR as PLOT-SEED-NAME.json and is not run again, so the tables can be made in pieces. Scans are
deleted after use unless --keep; --scan PLOT=FOLDER uses one that is there.
"""

import argparse
import json
import pathlib
import shutil
import statistics
import subprocess
import sys

REPOSITORY = pathlib.Path(__file__).resolve().parents[3]

# Published: improved LOAM and plain LOAM (SPEC A).
PUBLISHED = {
    "forest": {
        "position_rmse_x": {"plot1": 0.087, "plot2": 0.060, "plot3": 0.100, "plot4": 0.062},
        "position_rmse_y": {"plot1": 0.097, "plot2": 0.058, "plot3": 0.075, "plot4": 0.089},
        "position_sigma_max": {"plot1": 0.077, "plot2": 0.066, "plot3": 0.098, "plot4": 0.089},
        "dbh_bias": {"plot1": 0.25, "plot2": 0.65, "plot3": 0.28, "plot4": -0.08},
        "dbh_rmse": {"plot1": 0.94, "plot2": 1.07, "plot3": 0.84, "plot4": 1.23},
    },
    "loam": {
        "position_sigma_max": {"plot1": 0.112, "plot2": 0.148, "plot3": 0.114, "plot4": 0.129},
        "dbh_bias": {"plot1": 2.47, "plot2": 2.62, "plot3": 1.89, "plot4": 2.58},
        "dbh_rmse": {"plot1": 3.37, "plot2": 3.69, "plot3": 3.86, "plot4": 3.66},
    },
}

POSITION = [("position_rmse_x", "RMSE x, m"), ("position_rmse_y", "RMSE y, m"), ("position_sigma_max", "sigma max, m")]
DIAMETER = [("dbh_bias", "DBH bias, cm"), ("dbh_rmse", "DBH RMSE, cm"), ("dbh_relative_rmse", "rel. RMSE, %")]
TRACK = [("ate_rmse", "ATE, m"), ("completeness", "found, %"), ("ms_per_frame", "ms/frame")]

# One switch at a time against the preset.
ABLATION = {
    "forest": {
        "forest": {},
        "weights thickness": {"weights": "thickness"},
        "guess by velocity": {"first_guess": "velocity"},
        "de-skewed once": {"deskew": "once"},
        "not de-skewed": {"deskew": "none"},
        "occlusion as LOAM": {"occlusion": "far_side"},
        "loops by odometry": {"loops": "odometry"},
        "no loops": {"loops": "none"},
        "loops by ICP": {"loop_registration": "icp"},
    },
    "best": {
        "best": {},
        "no adjustment": {"refine_rounds": "-1"},
        "no loops": {"loops": "none"},
        "de-skewed twice": {"deskew": "twice"},
        "curvature features": {"features": "curvature"},
        "weights priors": {"weights": "priors"},
    },
    "orchard": {
        "orchard": {},
        "loops by odometry": {"loops": "odometry"},
        "loops by ICP": {"loop_registration": "icp"},
        "no loops": {"loops": "none"},
    },
}


def command(words, log):
    with open(log, "w") as out:
        if subprocess.run([str(w) for w in words], stdout=out, stderr=subprocess.STDOUT).returncode != 0:
            print(f"failed: {' '.join(map(str, words))}\n{log.read_text()[-2000:]}", file=sys.stderr)
            return False
    return True


def simulated(arguments, plot, seed):
    given = dict(s.split("=", 1) for s in arguments.scan)
    if plot in given and seed == arguments.seeds[0]:
        return pathlib.Path(given[plot]), False
    folder = arguments.work / f"scan-{plot}-{seed}"
    if not (folder / "trees.csv").exists():
        command([arguments.bole, "simulate", "--plot", plot, "--seed", seed, "--out", folder],
                arguments.work / "simulate.log")
    return folder, not arguments.keep


def figures(summary):
    stages = {s["id"]: s for s in summary["stages"]}
    found = {name: m["value"] for name, m in stages["evaluate"]["metrics"].items()}
    slam = stages["slam"]
    found["ms_per_frame"] = 1000 * slam["seconds"] / max(1, slam["counts"]["frames"])
    found["loops"] = slam["counts"].get("loops", 0)
    return found


def measured(arguments, plot, seed, name, options):
    """The figures of one run; None when it failed."""
    kept = arguments.work / f"{plot}-{seed}-{name.replace(' ', '_')}.json"
    if not kept.exists():
        scan, _ = simulated(arguments, plot, seed)
        out = arguments.work / "run"
        shutil.rmtree(out, ignore_errors=True)
        settings = {"scan.file": scan / "walk.pcap", "reference_trees.file": scan / "trees.csv",
                    "reference_path.file": scan / "trajectory.tum", **{f"slam.{k}": v for k, v in options.items()}}
        words = [arguments.bole, "run", REPOSITORY / "pipelines/forest_plot.json", "--out", out, "--no-cache"]
        for key, value in settings.items():
            words += ["--set", f"{key}={value}"]
        print(f"{plot}, seed {seed}: {name} ...", file=sys.stderr, flush=True)
        if not command(words, arguments.work / "run.log"):
            return None
        kept.write_text(json.dumps(figures(json.loads((out / "summary.json").read_text())), indent=1))
        shutil.rmtree(out, ignore_errors=True)
    return json.loads(kept.read_text())


def median(runs, measure):
    values = [r[measure] for r in runs if r and r.get(measure) is not None]
    return statistics.median(values) if values else None


def cell(value, published=None):
    text = "-" if value is None else f"{value:.3g}"
    return text if published is None else f"{text} ({published:g})"


def print_table(title, columns, rows):
    print(f"\n{title}\n")
    print("| | " + " | ".join(columns) + " |")
    print("|---" * (len(columns) + 1) + "|")
    for name, cells in rows:
        print(f"| {name} | " + " | ".join(cells) + " |")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--bole", type=pathlib.Path, required=True, help="the program")
    parser.add_argument("--work", type=pathlib.Path, required=True, help="folder for scans and results")
    parser.add_argument("--plots", nargs="+", default=["plot1", "plot2", "plot3", "plot4"])
    parser.add_argument("--presets", nargs="+", default=["loam", "forest", "best"])
    parser.add_argument("--seeds", nargs="+", type=int, default=[1, 2, 3])
    parser.add_argument("--ablation", nargs="*", default=[], choices=sorted(ABLATION), help="presets to take apart")
    parser.add_argument("--scan", action="append", default=[], metavar="PLOT=FOLDER", help="scan of the first seed")
    parser.add_argument("--keep", action="store_true", help="keep the scans")
    arguments = parser.parse_args()
    arguments.work.mkdir(parents=True, exist_ok=True)

    variants = {p: {"preset": p} for p in arguments.presets}
    for preset in arguments.ablation:
        for name, options in ABLATION[preset].items():
            variants[preset if not options else f"{preset}, {name}"] = {"preset": preset, **options}
    runs = {}
    for plot in arguments.plots:
        for seed in arguments.seeds:
            for name, options in variants.items():
                runs.setdefault((plot, name), []).append(measured(arguments, plot, seed, name, options))
            scan, remove = arguments.work / f"scan-{plot}-{seed}", not arguments.keep
            if remove:
                shutil.rmtree(scan, ignore_errors=True)

    seeds = f"median of {len(arguments.seeds)} seeds" if len(arguments.seeds) > 1 else f"seed {arguments.seeds[0]}"
    for title, measures in [("Stem positions", POSITION), ("Diameters", DIAMETER), ("Trajectory, detection, time", TRACK)]:
        rows = [(f"{plot}, {name}", [cell(median(r, m), PUBLISHED.get(name, {}).get(m, {}).get(plot)) for m, _ in measures])
                for (plot, name), r in runs.items()]
        print_table(f"{title}: measured on simulated scans, {seeds} (published, field data)", [c for _, c in measures], rows)


if __name__ == "__main__":
    main()
