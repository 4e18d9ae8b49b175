#!/usr/bin/env python3
"""Tables 2 and 3 of the paper on improved LOAM (SPEC A) in full, with published and measured figures side by side, and the
ablation.

Runs the pipeline forest_plot.json on simulated plots with each preset. Prints tables 2 and 3 for each plot and preset over all
matched trees of all seeds and for all plots pooled, and walls, trajectories and detection as medians over the seeds. The
published figures beside a preset are those of its own system (loam: LOAM, forest: improved LOAM); presets that the paper does not
have get none:

  slam_tables.py --bole build/headless/bin/bole --work DIR --plots plot1 plot2 --presets true loam forest best --seeds 1 2 3
  slam_tables.py --bole ... --work DIR --scans SCANS --budget 60      (SCANS holds folders PLOT-SEED of `bole simulate`)
  slam_tables.py --bole ... --work DIR --plots demo --ablation forest
  slam_tables.py --bole ... --work DIR --rate 10 5 --presets loam loam_paper forest forest_paper
  slam_tables.py --bole ... --work DIR --rate 10 5 --plots demo --seeds 1 --presets loam_paper forest_paper --page PAGE.md

`true` is no preset: the map is made with the true poses, as the floor for walls and diameters.
--page writes the tables into a page, below a list of what was run and what was not. A section "Where the ordering comes from" at its
end is kept.
--rate 5 simulates the recording of the paper: 5 revolutions per second, 0.1 deg between two pulses of a laser. Scans and results
of the two rates have names of their own.

Every finished run stays in DIR as PLOT-SEED-NAME.json and is not run again. A call that was stopped, or whose time was up
(--budget), prints the tables of what is there, and the next call goes on with what is not. Delete a .json to run it anew. Scans
that are made here are deleted after use unless --keep.
"""

import argparse
import concurrent.futures
import csv
import datetime
import json
import math
import os
import pathlib
import shutil
import signal
import statistics
import subprocess
import sys
import threading
import time

REPOSITORY = pathlib.Path(__file__).resolve().parents[3]

PLOTS = ["plot1", "plot2", "plot3", "plot4", "overall"]

# Tables 2 and 3 as printed, rows by measure, columns as PLOTS. The program has the same in modules/evaluation/core/published.cpp; a
# test compares both.
PUBLISHED = {
    "improved LOAM": {
        "position_mean_x": [-0.048, 0.002, 0.027, 0.003, -0.004],
        "position_mean_y": [-0.069, 0.008, -0.001, 0.022, -0.011],
        "position_sigma_x": [0.073, 0.062, 0.096, 0.062, 0.081],
        "position_sigma_y": [0.069, 0.059, 0.075, 0.086, 0.082],
        "position_cov_xy": [-0.001, 0.001, -0.001, -0.001, 0.000],
        "position_sigma_max": [0.077, 0.066, 0.098, 0.089, 0.082],
        "position_rmse_x": [0.087, 0.060, 0.100, 0.062, 0.081],
        "position_rmse_y": [0.097, 0.058, 0.075, 0.089, 0.083],
        "dbh_bias": [0.25, 0.65, 0.28, -0.08, 0.25],
        "dbh_relative_bias": [1.22, 2.42, 1.89, -0.59, 1.18],
        "dbh_rmse": [0.94, 1.07, 0.84, 1.23, 1.03],
        "dbh_relative_rmse": [4.87, 4.02, 5.64, 6.84, 5.53],
    },
    "LOAM": {
        "position_mean_x": [-0.101, -0.046, 0.027, -0.045, -0.040],
        "position_mean_y": [-0.070, 0.002, 0.092, 0.038, 0.017],
        "position_sigma_x": [0.084, 0.112, 0.110, 0.105, 0.113],
        "position_sigma_y": [0.112, 0.148, 0.089, 0.127, 0.133],
        "position_cov_xy": [0.001, -0.002, 0.002, 0.001, 0.003],
        "position_sigma_max": [0.112, 0.148, 0.114, 0.129, 0.140],
        "position_rmse_x": [0.132, 0.118, 0.114, 0.114, 0.120],
        "position_rmse_y": [0.132, 0.144, 0.128, 0.133, 0.134],
        "dbh_bias": [2.47, 2.62, 1.89, 2.58, 2.37],
        "dbh_relative_bias": [12.80, 10.09, 12.46, 14.42, 12.59],
        "dbh_rmse": [3.37, 3.69, 3.86, 3.66, 3.67],
        "dbh_relative_rmse": [17.46, 14.48, 25.08, 20.70, 20.27],
    },
}

# Presets of slam.run that stand for a system of the paper.
SYSTEM = {"forest": "improved LOAM", "forest_paper": "improved LOAM", "loam": "LOAM", "loam_paper": "LOAM"}

# Table 2 and table 3: measure, heading, decimals.
TABLE_2 = [("trees", "trees", 0), ("position_mean_x", "mu x, m", 3), ("position_mean_y", "mu y, m", 3),
           ("position_sigma_x", "sigma x, m", 3), ("position_sigma_y", "sigma y, m", 3),
           ("position_cov_xy", "rho xy, m2", 4), ("position_sigma_max", "sigma max, m", 3),
           ("position_rmse_x", "RMSE x, m", 3), ("position_rmse_y", "RMSE y, m", 3)]
TABLE_3 = [("trees", "trees", 0), ("dbh_bias", "BIAS, cm", 2), ("dbh_relative_bias", "relBIAS, %", 2),
           ("dbh_rmse", "RMSE, cm", 2), ("dbh_relative_rmse", "relRMSE, %", 2)]
DIAMETER = [("dbh_interval_coverage", "intervals that hold, %"), ("half_width", "to either side, cm"), ("range_stretch", "walk too short by the stems, %"), ("wall", "wall, mm"), ("pass_spread", "pass spread, mm")]
TRACK = [("ate_rmse", "ATE, m"), ("length_error", "walk too long, %"), ("completeness", "found, %"), ("correctness", "right, %"),
         ("loop_precision", "loop precision, %"), ("loop_pose_precision", "loop poses true, %"),
         ("loop_recall", "loop recall, %"), ("ms_per_frame", "ms/frame"), ("peak_mib", "peak, MiB")]

# One switch at a time against the preset.
ABLATION = {
    "forest": {
        "forest": {},
        "weights thickness": {"weights": "thickness"},
        "guess by velocity": {"first_guess": "velocity"},
        "de-skewed once": {"deskew": "once"},
        "not de-skewed": {"deskew": "none"},
        "features as LOAM": {"features": "curvature"},
        "occlusion as LOAM": {"occlusion": "far_side"},
        "loops by odometry": {"loops": "odometry"},
        "no loops": {"loops": "none"},
        "loops by ICP": {"loop_registration": "icp"},
    },
    "best": {
        "best": {},
        "no adjustment": {"refine_iterations": "0"},
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


class OutOfTime(Exception):
    """The time that was given is up, or the call was stopped: print what there is."""


class Clock:
    """No run is begun that would, going by the longest so far, not end within the budget."""

    def __init__(self, budget_min):
        self.end = time.monotonic() + 60 * budget_min if budget_min else math.inf
        self.longest_s = 0

    def begin(self):
        """When a run began."""
        now = time.monotonic()
        if now + self.longest_s > self.end:
            raise OutOfTime
        return now

    def done(self, begun):
        self.longest_s = max(self.longest_s, time.monotonic() - begun)


class Programs:
    """Those that run, to be stopped together."""

    def __init__(self):
        self.running = set()
        self.stopped = False

    def run(self, words, out):
        if self.stopped:
            raise OutOfTime
        process = subprocess.Popen([str(w) for w in words], stdout=out, stderr=subprocess.STDOUT)
        self.running.add(process)
        code = process.wait()
        self.running.discard(process)
        if self.stopped:  # its results are those of a part of the walk
            raise OutOfTime
        return code

    def stop(self):
        self.stopped = True
        for process in list(self.running):
            process.kill()


PROGRAMS = Programs()


def interrupt(*_):
    raise KeyboardInterrupt  # also where the shell has SIGINT ignored


JUDGED = "## Where the ordering comes from"  # heading on a page; what stands from there on is written by hand

SIMULATION = threading.Lock()  # takes all processors, and its scan serves several runs

ENDED_EARLY = 4  # exit code of a run whose track was lost: its results stand, but are not of the whole walk


def command(words, log, accepted=(0,)):
    """The exit code where it is one of those accepted, else None."""
    with open(log, "w") as out:
        code = PROGRAMS.run(words, out)
    if code in accepted:
        return code
    print(f"failed: {' '.join(map(str, words))}\n{log.read_text()[-2000:]}", file=sys.stderr)
    return None


def write_whole(path, text):
    """Whole or not at all, so that a run that was stopped is never taken for one that is finished."""
    part = path.with_suffix(".part")
    part.write_text(text)
    os.replace(part, path)


def at_rate(arguments):
    """What scans and results are called at a rate that is not the usual one."""
    return "" if arguments.rate == 10 else f"-{arguments.rate}hz"


def own_scan(arguments, plot, seed):
    return arguments.work / f"scan-{plot}-{seed}{at_rate(arguments)}"


def simulated(arguments, plot, seed):
    """The folder of the scan, simulated when there is none; None when that failed."""
    given = dict(s.split("=", 1) for s in arguments.scan)
    for name in ([plot] if seed == arguments.seeds[0] else []) + [f"{plot}-{seed}"]:
        if name in given:
            return pathlib.Path(given[name])
    named = f"{plot}-{seed}{at_rate(arguments)}"
    if arguments.scans and (arguments.scans / named / "trees.csv").exists():
        return arguments.scans / named
    folder = own_scan(arguments, plot, seed)
    with SIMULATION:
        if not (folder / "trees.csv").exists():
            shutil.rmtree(folder, ignore_errors=True)
            words = [arguments.bole, "simulate", "--plot", plot, "--seed", seed, "--rotation-rate", arguments.rate, "--out", folder]
            if command(words, arguments.work / "simulate.log") is None:
                return None
    return folder


def rows_of(path):
    if not path.exists():
        return []
    with open(path, newline="") as file:
        return list(csv.DictReader(file))


def numbers(rows, column):
    values = []
    for row in rows:
        try:
            values.append(float(row.get(column) or "nan"))
        except ValueError:
            continue
    return [v for v in values if math.isfinite(v)]


def loop_figures(arguments, out, scan):
    if not rows_of(out / "loops.csv"):
        return {}
    answer = subprocess.run([arguments.bole, "evaluate", "loops", out / "loops.csv", scan / "trajectory.tum", "--json",
                             "--loop-radius", str(arguments.loop_radius)], capture_output=True, text=True)
    if answer.returncode != 0:
        print(f"loops not evaluated: {answer.stderr}", file=sys.stderr)
        return {}
    return {k: v["value"] for k, v in json.loads(answer.stdout).items()}


def figures(arguments, out, scan):
    summary = json.loads((out / "summary.json").read_text())
    stages = {s["id"]: s for s in summary["stages"]}
    found = {name: m["value"] for name, m in stages["evaluate"]["metrics"].items()}
    # Trees that met a reference by chance: the map lies in other axes, or is bent out of them.
    found["other_axes"] = any(f.get("code") == "reference_disagrees" for f in stages["evaluate"].get("findings", []))
    slam = stages["slam"]
    found["ms_per_frame"] = 1000 * slam["seconds"] / max(1, slam["counts"]["frames"])
    found["loops"] = slam["counts"].get("loops", 0)
    found["frames"] = slam["counts"]["frames"]
    found["peak_mib"] = summary["peak_mib"]
    found.update(loop_figures(arguments, out, scan))
    matches = [r for r in rows_of(out / "matches.csv") if r["kind"] == "matched"]
    found["errors"] = [[float(r[c]) for c in ("dx_m", "dy_m", "dbh_error_cm", "ref_dbh_cm")] for r in matches]
    # Wall: robust standard deviation of the distances of points from the surface of the stem, median over the stems of the plot.
    ours = {r["tree_id"] for r in matches}
    stems = [r for r in rows_of(out / "stems.csv") if r["tree_id"] in ours]
    for name, column in [("wall", "wall_cm"), ("wall", "sigma_cm"), ("pass_spread", "pass_spread_cm")]:
        values = numbers(stems, column)
        if values and name not in found:
            found[name] = 10 * statistics.median(values)
    widths = [0.5 * (float(r["dbh_hi_cm"]) - float(r["dbh_lo_cm"])) for r in stems]
    if widths:
        found["half_width"] = statistics.median(widths)
    found["range_stretch"] = stages["stems"]["metrics"].get("range_stretch", {}).get("value")
    return found


# No table needs them.
UNWRITTEN = {"report.cloud": "false", "report.figures": "false", "report.page": "false"}


def kept_figures(arguments, plot, seed, name):
    return arguments.work / f"{plot}-{seed}-{name.replace(' ', '_')}{at_rate(arguments)}.json"


def measured(arguments, plot, seed, name, options, clock):
    """The figures of one run; None when it failed."""
    kept = kept_figures(arguments, plot, seed, name)
    if not kept.exists():
        begun = clock.begin()
        scan = simulated(arguments, plot, seed)
        if scan is None:
            return None
        out = kept.with_suffix(".run")
        shutil.rmtree(out, ignore_errors=True)
        if name == "true":
            options = {"trajectory": scan / "trajectory.tum"}
        settings = {"scan.file": scan / "walk.pcap", "reference_trees.file": scan / "trees.csv",
                    "reference_path.file": scan / "trajectory.tum", **{f"slam.{k}": v for k, v in options.items()}, **UNWRITTEN}
        words = [arguments.bole, "run", REPOSITORY / "pipelines/forest_plot.json", "--out", out, "--no-cache"]
        if arguments.jobs > 1:
            words += ["--threads", max(1, len(os.sched_getaffinity(0)) // arguments.jobs)]
        for key, value in settings.items():
            words += ["--set", f"{key}={value}"]
        print(f"{plot}, seed {seed}, {arguments.rate} Hz: {name} ...", file=sys.stderr, flush=True)
        run_begun = time.monotonic()
        code = command(words, kept.with_suffix(".log"), (0, ENDED_EARLY))
        if code is None:
            return None
        of_run = {"seconds": time.monotonic() - run_begun, "ended_early": code == ENDED_EARLY, **figures(arguments, out, scan)}
        write_whole(kept, json.dumps(of_run, indent=1))
        shutil.rmtree(out, ignore_errors=True)
        kept.with_suffix(".log").unlink(missing_ok=True)
        clock.done(begun)
    return json.loads(kept.read_text())


def median(runs, measure):
    values = [r[measure] for r in runs if r and r.get(measure) is not None]
    return statistics.median(values) if values else None


def pooled(runs):
    """Tables 2 and 3 over all matched trees of these runs, as SPEC A11: covariance divided by n, relBIAS the mean of error /
    reference."""
    errors = [e for r in runs if r for e in r.get("errors", [])]
    if not errors:
        return {}
    n = len(errors)
    x, y, dbh, reference = ([e[k] for e in errors] for k in range(4))
    mean_x, mean_y = sum(x) / n, sum(y) / n
    xx, yy = sum((v - mean_x) ** 2 for v in x) / n, sum((v - mean_y) ** 2 for v in y) / n
    xy = sum((a - mean_x) * (b - mean_y) for a, b in zip(x, y)) / n
    relative = [100 * e / r for e, r in zip(dbh, reference)]

    def rms(values):
        return math.sqrt(sum(v * v for v in values) / n)

    return {"trees": n, "position_mean_x": mean_x, "position_mean_y": mean_y, "position_sigma_x": math.sqrt(xx),
            "position_sigma_y": math.sqrt(yy), "position_cov_xy": xy, "position_rmse_x": rms(x), "position_rmse_y": rms(y),
            "position_sigma_max": math.sqrt((xx + yy) / 2 + math.hypot((xx - yy) / 2, xy)), "dbh_bias": sum(dbh) / n,
            "dbh_rmse": rms(dbh), "dbh_relative_bias": sum(relative) / n, "dbh_relative_rmse": rms(relative)}


def published(preset, measure, plot):
    """Of the system that the preset stands for; None where the paper has no such figure."""
    figures = PUBLISHED.get(SYSTEM.get(preset), {}).get(measure)
    return figures[PLOTS.index(plot)] if figures and plot in PLOTS else None


def cell(value):
    return "-" if value is None else f"{value:.3g}"


def both(value, decimals, printed):
    """Measured, and published in brackets."""
    text = "-" if value is None else f"{value:.{decimals}f}"
    return text if printed is None else f"{text} ({printed:.{min(decimals, 3)}f})"


def table_text(title, columns, rows):
    lines = [f"\n{title}\n", "| | " + " | ".join(columns) + " |", "|---" * (len(columns) + 1) + "|"]
    return "\n".join(lines + [f"| {name} | " + " | ".join(cells) + " |" for name, cells in rows])


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--bole", type=pathlib.Path, required=True, help="the program")
    parser.add_argument("--work", type=pathlib.Path, required=True, help="folder for scans and results")
    parser.add_argument("--plots", nargs="+", default=["plot1", "plot2", "plot3", "plot4"])
    parser.add_argument("--presets", nargs="+", default=["loam", "forest", "best"])
    parser.add_argument("--seeds", nargs="+", type=int, default=[1, 2, 3])
    parser.add_argument("--ablation", nargs="*", default=[], choices=sorted(ABLATION), help="presets to take apart")
    parser.add_argument("--scan", action="append", default=[], metavar="PLOT[-SEED]=FOLDER",
                        help="a scan that is there; without SEED that of the first seed")
    parser.add_argument("--scans", type=pathlib.Path, help="folder with scans that are there, named PLOT-SEED")
    parser.add_argument("--budget", type=float, default=0, metavar="MINUTES", help="begin no run that would end later")
    parser.add_argument("--loop-radius", type=float, default=3, help="metres within which a revisit is right")
    parser.add_argument("--rate", type=int, choices=[5, 10], nargs="+", default=[10],
                        help="revolutions of the scanner per second: 10, or 5 as in the paper (0.1 deg between pulses), or both")
    parser.add_argument("--jobs", type=int, default=1, metavar="N", help="runs at the same time, each with its share of the processors")
    parser.add_argument("--keep", action="store_true", help="keep the scans")
    parser.add_argument("--page", type=pathlib.Path, help="also write the tables into this page")
    arguments = parser.parse_args()
    arguments.work.mkdir(parents=True, exist_ok=True)
    signal.signal(signal.SIGTERM, interrupt)

    variants = {p: {"preset": p} for p in arguments.presets}
    for preset in arguments.ablation:
        for name, options in ABLATION[preset].items():
            variants[preset if not options else f"{preset}, {name}"] = {"preset": preset, **options}
    clock = Clock(arguments.budget)
    of_rate, left = all_runs(arguments, variants, clock)
    text = "\n".join(tables(arguments, rate, variants, whole(runs)) for rate, runs in of_rate.items())
    print(text)
    if left:
        print(f"\n{left} of {left + sum(len(r) for runs in of_rate.values() for r in runs.values())} runs are missing: call again to go on.")
    if arguments.page:
        write_whole(arguments.page, page_text(arguments, variants, of_rate, text))
    return 1 if any(r is None for runs in of_rate.values() for of in runs.values() for r in of) else 0


def whole(runs):
    """Without the runs that lost their track, whose trees are those of a part of the walk, and those whose trees met the reference by chance."""
    return {key: [r for r in of if r and not r.get("ended_early") and not r.get("other_axes")] for key, of in runs.items()}


def all_runs(arguments, variants, clock):
    """The figures of all runs by rate, plot and variant, and how many runs are missing."""
    # Seed by seed and rate by rate, so that a call that is cut short has all plots and presets of the first ones.
    wanted = [(rate, plot, seed, name) for seed in arguments.seeds for rate in arguments.rate for plot in arguments.plots
              for name in variants]
    at = {rate: argparse.Namespace(**{**vars(arguments), "rate": rate}) for rate in arguments.rate}

    def run(rate, plot, seed, name):
        try:
            return measured(at[rate], plot, seed, name, variants[name], clock)
        finally:
            if not arguments.keep and all(kept_figures(at[rate], plot, seed, n).exists() for n in variants):
                shutil.rmtree(own_scan(at[rate], plot, seed), ignore_errors=True)

    of_rate = {rate: {(plot, name): [] for plot in arguments.plots for name in variants} for rate in arguments.rate}
    left = 0
    with concurrent.futures.ThreadPoolExecutor(arguments.jobs) as pool:
        running = [pool.submit(run, *which) for which in wanted]
        for (rate, plot, _, name), future in zip(wanted, running):
            while True:
                try:
                    of_rate[rate][plot, name].append(future.result())
                except OutOfTime:
                    left += 1
                except KeyboardInterrupt:
                    PROGRAMS.stop()  # from now on only what is there
                    continue
                break
    return of_rate, left


def page_text(arguments, variants, of_rate, text):
    """A page that says what was run and what was not, above the tables."""
    words = ["tests/bench/slam/slam_tables.py --bole BOLE --work DIR", "--rate", *arguments.rate, "--plots", *arguments.plots,
             "--seeds", *arguments.seeds, "--presets", *arguments.presets]
    if arguments.ablation:
        words += ["--ablation", *arguments.ablation]
    rows = []
    for rate, runs in of_rate.items():
        for (plot, name), of in runs.items():
            done = whole({0: of})[0]
            lost = [r for r in of if r and r.get("ended_early")]
            state = f"{len(done)} of {len(arguments.seeds)} seeds"
            if lost:
                state += f", {len(lost)} lost the track after " + " and ".join(f"{r['frames']} frames" for r in lost)
            elsewhere = sum(1 for r in of if r and r.get("other_axes") and not r.get("ended_early"))
            if elsewhere:
                state += f", {elsewhere} whose map lies in other axes than the reference"
            if None in of:
                state += f", {of.count(None)} failed"
            seconds = median(done + lost, "seconds")
            rows.append((f"{rate} Hz", [plot, name, state, "-" if seconds is None else f"{seconds / 60:.1f}"]))
    presets = ["loam", "loam_paper", "forest", "forest_paper"]
    full = [(rate, plot, preset) for rate in of_rate for plot in PLOTS[:4] for preset in presets]
    run = {k: [r for r in of_rate[k[0]].get(k[1:], []) if r] for k in full}
    here = [of for of in run.values() if len(of) >= 3]
    in_part = sum(1 for of in here if len(whole({0: of})[0]) < len(of))
    missing = (f"{len(here)} of the {len(full)} sets of the full comparison (plots 1 to 4, three seeds each, "
               f"{', '.join(presets)}, {' and '.join(map(str, of_rate))} Hz) were run.")
    if in_part:
        missing += (f" {in_part} of them are in the tables with fewer seeds: runs that lost the track and maps in other axes say nothing "
                    "of diameters.")
    if len(here) < len(full):
        missing += (" The others were not run. What stands here says whether a preset works and how it compares on these scans; it does "
                    "not say how it compares on the plots of the paper.")
    # What a person wrote about the tables stays.
    before = arguments.page.read_text() if arguments.page.exists() else ""
    if JUDGED in before:
        text += "\n\n" + before[before.index(JUDGED):].rstrip("\n")
    return "\n".join(["# SLAM: tables 2 and 3 of the paper on improved LOAM", "",
                      "The tables of the paper (SPEC A) for presets of `slam.run`, on simulated scans with known truth. Figures in brackets are those",
                      "that the paper published for the same system on its own plots (plot1 to plot4).", "", "```", " ".join(map(str, words)) + f" --page {arguments.page}",
                      "```", "", f"Written by this command on {datetime.date.today()}. It begins no run twice: finished ones stay in `DIR`.", "",
                      "## What was run", "", table_text("", ["plot", "preset", "finished", "minutes per run"], rows).lstrip("\n"), "", missing, "",
                      "## Tables", text, ""])


def paper_rows(variants, runs, plots, table):
    """The rows of table 2 or 3: each plot with each preset, then all plots together."""
    rows = []
    for plot in [*plots, "overall"]:
        for name in variants:
            of = [r for (p, n), r_of in runs.items() if n == name and plot in (p, "overall") for r in r_of]
            figures_of_all = pooled(of)
            if figures_of_all and not (plot == "overall" and len(plots) < 2):
                cells = [both(figures_of_all[m], decimals, published(name, m, plot)) for m, _, decimals in table]
                rows.append((f"{plot}, {name}", cells))
    return rows


def tables(arguments, rate, variants, runs):
    seeds = f"{len(arguments.seeds)} seeds" if len(arguments.seeds) > 1 else f"seed {arguments.seeds[0]}"
    scans = f"simulated scans at {rate} Hz, {seeds}"
    if not any(runs.values()):
        return f"\nNo run of a whole walk at {rate} Hz: no tables."
    out = []
    for title, table in [("Table 2, stem positions", TABLE_2), ("Table 3, diameters", TABLE_3)]:
        out.append(table_text(f"{title}: measured on {scans}, all matched trees (published for the same system, field data)",
                              [c for _, c, _ in table], paper_rows(variants, runs, arguments.plots, table)))
    for title, measures in [("Walls and intervals", DIAMETER), ("Trajectory, detection, time", TRACK)]:
        rows = [(f"{plot}, {name}", [cell(median(r, m)) for m, _ in measures]) for (plot, name), r in runs.items() if any(r)]
        out.append(table_text(f"{title}: median of {scans}", [c for _, c in measures], rows))
    return "\n".join(out)


if __name__ == "__main__":
    sys.exit(main())
