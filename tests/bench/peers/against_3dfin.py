#!/usr/bin/env python3
"""Stems of real and simulated clouds by Bole and by 3DFin, in the same run, beside the lists that come with the clouds.

    against_3dfin.py --bole build/headless/bin/bole --data DATA [--dense CLOUD=TRUTH...] [--threads N] [--list]

DATA holds tls_pine_plot, tls_spanner and tls_simulated_boles. Run it with a Python that has 3DFin (`pip install 3DFin`;
its window library is not needed): 3DFin's own standalone processing is called with its default parameters, normalising
heights itself; where it stops, which it does when clusters are smaller than 1000 points, it is run again with 200, 50
and 20, and the time is that of the run that ended. Without 3DFin the script says so and ends with success. Bole runs pipelines/stem_map_from_cloud.json
with its defaults, tables only. Both start from the LAZ file and end with their tables; user plus system time of the
whole process is compared, and its wall clock. The lists are independent circle fits, no tape: differences are not errors.

--dense adds clouds that both can measure, with known truth: CLOUD is cloud.las of `bole run` on a scan of a dense scanner
(docs/dev/diameters.md), TRUTH the folder of `bole simulate`. It is cut to the plot and a margin of a metre, thinned to one
point in `--every`, and written without rays, times and classes; trees of the plot from 7.5 cm count, and others are stems
inside the plot that belong to no tree.
"""
import argparse
import csv
import json
import math
import os
import pathlib
import resource
import statistics
import subprocess
import sys
import tempfile
import time

REPOSITORY = pathlib.Path(__file__).resolve().parents[3]

CASES = [("pine plot", "tls_pine_plot/pine_plot.laz", "tls_pine_plot/derived_stems_NOT_FIELD.csv"), ("spanner", "tls_spanner/TLS_Clip.laz", "tls_spanner/derived_stems_NOT_FIELD.csv"),
         ("simulated boles", "tls_simulated_boles/model_boles.laz", "tls_simulated_boles/reference_positions.csv")]

PEER = """
import pathlib, sys
import laspy, numpy as np
from three_d_fin.processing.configuration import FinConfiguration, MiscParameters
from three_d_fin.processing.standalone_processing import StandaloneLASProcessing
cloud, out = map(pathlib.Path, sys.argv[1:3])
config = FinConfiguration()
config.expert.number_of_points = int(sys.argv[3])
config.misc = MiscParameters(is_normalized=False, is_noisy=False, export_txt=True, input_file=cloud, output_dir=out)
StandaloneLASProcessing(config).process()
"""


def timed(command, **kwargs):
    before, start = resource.getrusage(resource.RUSAGE_CHILDREN), time.perf_counter()
    done = subprocess.run(command, capture_output=True, text=True, **kwargs)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return done, after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime, time.perf_counter() - start


def rows_of(path):
    with open(path, newline="", encoding="utf-8") as file:
        return list(csv.DictReader(file))


def by_bole(bole, cloud, out):
    command = [bole, "run", REPOSITORY / "pipelines/stem_map_from_cloud.json", "--out", out, "--no-cache", "--set", f"scan.file={cloud}",
               "--set", "report.figures=false", "--set", "report.page=false", "--set", "report.cloud=false"]
    done, cpu, wall = timed([str(c) for c in command])
    if done.returncode != 0:
        return None, cpu, wall, done.stderr.strip().splitlines()[-1]
    return [(float(r["x_m"]), float(r["y_m"]), float(r["dbh_cm"]), r["quality"]) for r in rows_of(out / "stems.csv")], cpu, wall, ""


def by_3dfin(cloud, out, threads):
    for points in (1000, 200, 50, 20):
        result = run_3dfin(cloud, out / str(points), threads, points)
        if result[0] is not None:
            break
    return *result[:3], result[3] or f"clusters of {points} points"


def run_3dfin(cloud, out, threads, points):
    environment = dict(os.environ)
    if threads:
        environment.update(OMP_NUM_THREADS=str(threads), NUMBA_NUM_THREADS=str(threads), OPENBLAS_NUM_THREADS=str(threads))
    out.mkdir(parents=True)
    done, cpu, wall = timed([sys.executable, "-c", PEER, str(cloud), str(out), str(points)], env=environment)
    tables = sorted(out.glob("*_dbh_and_heights.txt"))
    if done.returncode != 0 or not tables:
        return None, cpu, wall, (done.stderr.strip().splitlines() or ["no table"])[-1]
    stems = []
    for text in tables[0].read_text().splitlines():
        height, dbh, x, y = map(float, text.split()[:4])
        stems.append((x, y, 100 * dbh, "" if dbh > 0 else "not measured"))
    return stems, cpu, wall, ""


def dense_case(cloud, truth, every, folder):
    """The cut cloud, the trees that count, and the trees that do not; stems outside the plot are left out by `inside`."""
    import laspy
    import numpy
    trees = [(float(r["x_m"]), float(r["y_m"]), float(r["dbh_cm"]), "" if r["in_plot"] == "1" and float(r["dbh_cm"]) >= 7.5 else "around") for r in rows_of(truth / "trees.csv")]
    counted = [t for t in trees if not t[3]]
    half = json.loads((truth / "recipe.json").read_text())["plot"]["size_m"] / 2
    full = laspy.read(cloud)
    x, y, z = (numpy.asarray(v) for v in (full.x, full.y, full.z))
    keep = numpy.flatnonzero((abs(x) < half + 1) & (abs(y) < half + 1))[::every]
    cut = laspy.LasData(laspy.LasHeader(point_format=0, version="1.2"))
    cut.header.scales = [0.001, 0.001, 0.001]
    cut.x, cut.y, cut.z = x[keep], y[keep], z[keep]
    path = folder / "cut.las"
    cut.write(path)
    return path, counted, trees, half, len(keep)


def dense_line(program, counted, trees, half, result):
    stems, cpu, wall, trouble = result
    if stems is None:
        return f"| {program} | failed: {trouble} | | | | {cpu:.1f} | {wall:.1f} |"
    pairs = pairs_of(counted, stems, 0.5)
    known = set(pairs_of(trees, stems, 0.5).values()) | set(pairs.values())
    false = [s for k, s in enumerate(stems) if k not in known and max(abs(s[0]), abs(s[1])) < half and s[2] >= 7.5]
    errors = [stems[k][2] - counted[i][2] for i, k in pairs.items() if stems[k][2] > 0]
    dbh = f"{statistics.fmean(errors):+.2f} / {math.sqrt(statistics.fmean([e * e for e in errors])):.2f}" if errors else ""
    return f"| {program} | {len(pairs)} of {len(counted)} | {len(errors)} | {len(false)} | {dbh} | {cpu:.1f} | {wall:.1f} |"


def compare_dense(pair, options):
    cloud, _, truth = pair.partition("=")
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        path, counted, trees, half, points = dense_case(pathlib.Path(cloud), pathlib.Path(truth), options.every, folder)
        print(f"\n{pathlib.Path(truth).name}: {1e-6 * points:.1f} million points\n\n| program | found | with a DBH | false | DBH bias / RMSE, cm | CPU, s | wall, s |\n|---|---|---|---|---|---|---|", flush=True)
        ours = by_bole(options.bole, path, folder / "bole")
        print(dense_line("Bole", counted, trees, half, ours), flush=True)
        theirs = by_3dfin(path, folder / "3dfin", options.threads)
        print(dense_line(f"3DFin, {theirs[3]}" if theirs[0] is not None else "3DFin", counted, trees, half, theirs), flush=True)
        print(f"\nTime of 3DFin by that of Bole: {theirs[1] / ours[1]:.1f} (CPU), {theirs[2] / ours[2]:.1f} (wall)", flush=True)


def pairs_of(reference, stems, gate):
    offers = sorted((math.hypot(r[0] - s[0], r[1] - s[1]), i, k) for i, r in enumerate(reference) for k, s in enumerate(stems))
    pairs, used = {}, set()
    for distance, i, k in offers:
        if distance <= gate and i not in pairs and k not in used:
            pairs[i] = k
            used.add(k)
    return pairs


def reference_of(path):
    out = []
    for row in rows_of(path):
        dbh = next((float(v) for k, v in row.items() if k.startswith("dbh_cm") and v), math.nan)
        out.append((float(row["x_m"]), float(row["y_m"]), dbh, row.get("quality", "")))
    return out


def line(name, program, reference, stems, cpu, wall, trouble):
    if stems is None:
        return f"| {name} | {program} | failed: {trouble} | | | | {cpu:.1f} | {wall:.1f} |"
    pairs = pairs_of(reference, stems, 0.5)
    differences = [stems[k][2] - reference[i][2] for i, k in pairs.items() if reference[i][3] in ("good", "") and reference[i][2] > 0 and stems[k][2] > 0]
    measured = sum(stems[k][2] > 0 for k in pairs.values())
    dbh = f"{statistics.fmean(differences):+.2f} / {math.sqrt(statistics.fmean([d * d for d in differences])):.2f} ({len(differences)})" if differences else ""
    program += f", {trouble}" if trouble else ""
    return f"| {name} | {program} | {len(pairs)} of {len(reference)} | {measured} | {len(stems) - len(pairs)} | {dbh} | {cpu:.1f} | {wall:.1f} |"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--bole", required=True, type=pathlib.Path)
    parser.add_argument("--data", type=pathlib.Path, help="folder of the real clouds; left out: those of --dense alone")
    parser.add_argument("--dense", action="append", default=[], metavar="CLOUD=TRUTH")
    parser.add_argument("--every", type=int, default=1, help="take one point in so many of the dense clouds")
    parser.add_argument("--threads", type=int, default=2)
    parser.add_argument("--list", action="store_true", help="print every stem of the lists")
    options = parser.parse_args()
    try:
        import three_d_fin  # noqa: F401
    except ImportError as error:
        print(f"SKIPPED: {error}; pip install 3DFin")
        return 0
    for pair in options.dense:
        compare_dense(pair, options)
    if options.data is None:
        return 0
    print("| cloud | program | of the list found | with a DBH | others | DBH less list, good fits: mean / RMS, cm (n) | CPU, s | wall, s |\n|---|---|---|---|---|---|---|---|")
    ratios, details = [], []
    for name, cloud, reference_file in CASES:
        cloud, reference_file = options.data / cloud, options.data / reference_file
        if not cloud.exists():
            print(f"| {name} | absent | | | | | | |")
            continue
        reference = reference_of(reference_file)
        with tempfile.TemporaryDirectory() as folder:
            ours = by_bole(options.bole, cloud.resolve(), pathlib.Path(folder) / "bole")
            theirs = by_3dfin(cloud.resolve(), pathlib.Path(folder) / "3dfin", options.threads)
        print(line(name, "Bole", reference, *ours), flush=True)
        print(line(name, "3DFin", reference, *theirs), flush=True)
        ratios.append(f"{name}: {theirs[1] / ours[1]:.1f} (CPU), {theirs[2] / ours[2]:.1f} (wall)" + (", until it failed" if theirs[0] is None else ""))
        if options.list:
            found = [pairs_of(reference, s[0] or [], 0.5) for s in (ours, theirs)]
            for i, r in enumerate(reference):
                cells = [f"{s[0][p[i]][2]:.1f} {s[0][p[i]][3]}" if i in p else "missed" for s, p in ((ours, found[0]), (theirs, found[1]))]
                details.append(f"| {name} | {r[0]:.2f}, {r[1]:.2f} | {r[2]:.1f} {r[3]} | {cells[0]} | {cells[1]} |")
    print("\nTime of 3DFin by that of Bole: " + "; ".join(ratios))
    if details:
        print("\n| cloud | place, m | list, cm | Bole | 3DFin |\n|---|---|---|---|---|\n" + "\n".join(details))
    return 0


if __name__ == "__main__":
    sys.exit(main())
