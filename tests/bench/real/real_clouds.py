#!/usr/bin/env python3
"""All real clouds that hold trees: stems of Bole, of 3DFin and of a plain circle fit beside the lists that come with the clouds.

    real_clouds.py --bole build/headless/bin/bole --data DATA [--report] [--only NAME ...] [--peers]

DATA holds the folders tls_*, tree_*, iphone_forest, als_ground and isprs_filter. Bole runs pipelines/stem_map_from_cloud.json with its defaults; nothing is
set for a cloud. --report runs it a second time with the report, for the time that it takes. Diameters of the lists are circle fits of other
programs, no tape: differences are not errors. A cloud without a list shows what is found and what is said of it.

--peers adds 3DFin (`pip install 3DFin`, its own standalone processing with its defaults; where it stops because clusters
are small it runs again with 200, 50 and 20 points) and a plain circle fit (ground: lowest points of cells of 0.5 m; slice of 1.2 to 1.4 m; one
circle per group of points, by RANSAC and least squares). They need Python packages (3DFin; laspy and numpy); where these are absent the script says so.
"""
import argparse
import math
import pathlib
import subprocess
import sys
import tempfile
import time

import measured

NOWHERE = math.nan


def tree(dbh, quality=""):
    """A single tree of a README: it has no place in the list."""
    return [{"x": NOWHERE, "y": NOWHERE, "dbh": dbh, "quality": quality}]


def listed(path):
    out = []
    for row in measured.rows_of(path):
        dbh = next((float(v) for k, v in row.items() if k.startswith("dbh_cm") and v), math.nan)
        out.append({"x": float(row["x_m"]), "y": float(row["y_m"]), "dbh": dbh, "quality": row.get("quality", "")})
    return out


def places(*points):
    return [{"x": x, "y": y, "dbh": math.nan, "quality": ""} for x, y in points]


# name, file, list: a CSV beside it, stems of its README, or None where there is none.
CLOUDS = [
    ("pine plot", "tls_pine_plot/pine_plot.laz", "tls_pine_plot/derived_stems_NOT_FIELD.csv"),
    ("spanner", "tls_spanner/TLS_Clip.laz", "tls_spanner/derived_stems_NOT_FIELD.csv"),
    ("simulated boles", "tls_simulated_boles/model_boles.laz", "tls_simulated_boles/reference_positions.csv"),
    ("plantation, 4 trees", "tls_plantation_4trees/tls_plantation_class.csv", places((10.2, 58.0), (13.3, 58.0), (10.2, 60.9), (13.3, 60.9))),
    ("phone, y up", "iphone_forest/trees_on_hill.laz", None),
    ("pine", "tls_pine_plot/pine.laz", tree(25.9)),
    ("spruce", "tls_pine_plot/spruce.laz", tree(26.2)),
    ("treetraits", "tree_treetraits/tree_0744.laz", tree(14.8)),
    ("itsme LAS", "tree_itsme_formats/pc_tree.las", tree(15.1)),
    ("itsme PLY", "tree_itsme_formats/pc_tree.ply", tree(15.1)),
    ("itsme TXT", "tree_itsme_formats/pc_tree.txt", tree(15.1)),
    ("archi 1", "tree_archi_voxr/Tree_1_point_cloud.las", tree(51.6, "poor")),
    ("archi 2", "tree_archi_voxr/Tree_2_point_cloud.las", tree(8.1)),
    ("voxr", "tree_archi_voxr/Tree_t0.asc", tree(11.2)),
    ("adtree 7", "tree_adtree/tree7.xyz", None),
    ("adtree 13", "tree_adtree/tree13.xyz", None),
    ("airborne MixedConifer", "als_ground/MixedConifer.laz", None),
    ("airborne Topography", "als_ground/Topography.laz", None),
    ("airborne AHN3", "als_ground/AHN3.laz", None),
    ("ISPRS 31", "isprs_filter/samp31_ref.las", None),
    ("ISPRS 51", "isprs_filter/samp51_ref.las", None),
]

HEAD = "| cloud | program | found | flagged | extra (flagged) | DBH less list: bias / RMSE, cm (n) | 95 % holds | seconds | with report | verdict: findings (notes) |\n|" + "---|" * 10


def line(name, program, reference, result, report_seconds=None):
    stems = result["stems"]
    if reference is None:
        flagged = sum(s["flagged"] for s in stems)
        middle = [f"{len(stems)}", f"{flagged}", "", "", ""]
    else:
        c = measured.compared(reference, stems)
        holds = f"{c['holding']} of {c['intervals']}" if c["intervals"] else ""
        middle = [f"{c['found']} of {c['of']}", f"{c['flagged']}", f"{c['extra']} ({c['extra_flagged']})", measured.bias_rmse(c["differences"]), holds]
    told = f"{result['verdict']}: {measured.codes(result)}" if result["verdict"] else ""
    if result["trouble"]:
        told += f" {result['trouble'][:120]}"
    seconds = "" if report_seconds is None else f"{report_seconds:.1f}"
    return f"| {name} | {program} | " + " | ".join(middle) + f" | {result['seconds']:.1f} | {seconds} | {told} |"


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


def by_3dfin(cloud, folder):
    result = {"stems": [], "verdict": "", "findings": [], "trouble": "", "seconds": 0.0}
    for points in (1000, 200, 50, 20):
        out = folder / f"fin{points}"
        out.mkdir(parents=True)
        start = time.perf_counter()
        try:
            done = subprocess.run([sys.executable, "-c", PEER, str(cloud), str(out), str(points)], capture_output=True, text=True, timeout=300)
        except subprocess.TimeoutExpired:
            result["trouble"] = "stopped after 300 s"
            return result
        result["seconds"] = time.perf_counter() - start
        tables = sorted(out.glob("*_dbh_and_heights.txt"))
        if done.returncode == 0 and tables:
            for text in tables[0].read_text().splitlines():
                _, dbh, x, y = map(float, text.split()[:4])
                result["stems"].append({"x": x, "y": y, "dbh": 100 * dbh if dbh > 0 else math.nan, "quality": "", "flagged": not dbh > 0})
            result["trouble"] = "" if points == 1000 else f"clusters of {points} points"
            return result
        result["trouble"] = "stopped: " + (done.stderr.strip().splitlines() or ["no table"])[-1]
    return result


def points_of(path):
    import laspy
    import numpy
    if path.suffix in (".las", ".laz"):
        cloud = laspy.read(path)
        return numpy.column_stack([cloud.x, cloud.y, cloud.z])
    rows = []
    with open(path, encoding="utf-8") as file:
        for text in file:
            try:
                rows.append([float(v) for v in text.replace(",", " ").split()[:3]])
            except ValueError:
                continue
    return numpy.array([r for r in rows if len(r) == 3])


def las_of(path, folder):
    """3DFin reads LAS alone."""
    import laspy
    if path.suffix in (".las", ".laz"):
        return path
    points = points_of(path)
    out = laspy.LasData(laspy.LasHeader(point_format=0, version="1.2"))
    out.header.scales, out.header.offsets = [0.0001] * 3, points.min(0)
    out.x, out.y, out.z = points.T
    target = folder / "cloud.las"
    out.write(target)
    return target


def circle_through(points):
    import numpy
    system = numpy.column_stack([points, numpy.ones(len(points))])
    solution = numpy.linalg.lstsq(system, (points ** 2).sum(1), rcond=None)[0]
    centre = solution[:2] / 2
    return centre, math.sqrt(max(0.0, solution[2] + centre @ centre))


def plain_circle(points, random):
    """RANSAC (2 cm), then least squares of the points within 2 cm, as plain circle fits of tree software do."""
    import numpy
    best, most = None, 0
    for _ in range(200):
        try:
            centre, radius = circle_through(points[random.choice(len(points), 3, replace=False)])
        except numpy.linalg.LinAlgError:
            continue
        if not 0.02 < radius < 0.6:
            continue
        on = abs(numpy.hypot(*(points - centre).T) - radius) < 0.02
        if on.sum() > most:
            best, most = on, on.sum()
    if best is None or most < 5:
        return None
    for _ in range(5):
        centre, radius = circle_through(points[best])
        best = abs(numpy.hypot(*(points - centre).T) - radius) < 0.02
        if best.sum() < 5:
            return None
    return centre, radius, best.mean()


def by_circle(path):
    import numpy
    start = time.perf_counter()
    points = points_of(path)
    shift = points.min(0)
    local = points - shift
    cells = numpy.floor(local[:, :2] / 0.5).astype(int)
    ground = numpy.full(cells.max(0) + 1, numpy.inf)
    numpy.minimum.at(ground, tuple(cells.T), local[:, 2])
    # A cell that sees no ground takes the lowest of its neighbours.
    wide = numpy.pad(ground, 2, constant_values=numpy.inf)
    opened = numpy.min([wide[i:i + ground.shape[0], j:j + ground.shape[1]] for i in range(5) for j in range(5)], axis=0)
    height = local[:, 2] - opened[tuple(cells.T)]
    ring = local[(height > 1.2) & (height < 1.4)][:, :2]
    result = {"stems": [], "verdict": "", "findings": [], "trouble": "", "seconds": 0.0}
    random = numpy.random.default_rng(1)
    for group in groups_of(ring):
        fitted = plain_circle(group, random) if 5 <= len(group) and numpy.ptp(group, axis=0).max() < 1.5 else None
        if fitted is not None and fitted[2] > 0.5:
            result["stems"].append({"x": fitted[0][0] + shift[0], "y": fitted[0][1] + shift[1], "dbh": 200 * fitted[1], "quality": "", "flagged": False})
    result["seconds"] = time.perf_counter() - start
    result["trouble"] = "" if result["stems"] else "no stems"
    return result


def groups_of(ring, cell=0.06):
    """Points of touching cells."""
    cells = {}
    for k, place in enumerate(map(tuple, (ring // cell).astype(int))):
        cells.setdefault(place, []).append(k)
    while cells:
        place, members = cells.popitem()
        heap, group = [place], list(members)
        while heap:
            x, y = heap.pop()
            for dx in (-1, 0, 1):
                for dy in (-1, 0, 1):
                    more = cells.pop((x + dx, y + dy), None)
                    if more is not None:
                        heap.append((x + dx, y + dy))
                        group += more
        yield ring[group]


def missing_package(*names):
    for name in names:
        try:
            __import__(name)
        except ImportError as error:
            return str(error)
    return ""


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--bole", required=True, type=pathlib.Path)
    parser.add_argument("--data", required=True, type=pathlib.Path)
    parser.add_argument("--only", nargs="*", default=[], help="clouds whose names begin so")
    parser.add_argument("--report", action="store_true", help="run with the report too, for its time")
    parser.add_argument("--peers", action="store_true", help="3DFin and a plain circle fit too")
    options = parser.parse_args()
    no_circle = missing_package("numpy", "laspy") if options.peers else "not asked for"
    no_fin = missing_package("three_d_fin") if options.peers else "not asked for"
    if options.peers:
        for what, why in (("plain circle", no_circle), ("3DFin", no_fin)):
            if why:
                print(f"SKIPPED {what}: {why}")
    print(HEAD, flush=True)
    for name, file, reference in CLOUDS:
        if options.only and not any(name.startswith(o) for o in options.only):
            continue
        cloud = (options.data / file).resolve()
        if not cloud.exists():
            print(f"| {name} | absent |" + " |" * 8, flush=True)
            continue
        if isinstance(reference, str):
            reference = listed(options.data / reference)
        with tempfile.TemporaryDirectory() as place:
            folder = pathlib.Path(place)
            ours = measured.survey(options.bole, cloud, folder / "bole")
            with_report = measured.survey(options.bole, cloud, folder / "full", report=True)["seconds"] if options.report else None
            print(line(name, "Bole", reference, ours, with_report), flush=True)
            if not no_circle:
                try:
                    print(line(name, "plain circle", reference, by_circle(cloud)), flush=True)
                except Exception as error:  # a peer that fails is a row, not the end
                    print(f"| {name} | plain circle | failed: {error} |" + " |" * 7, flush=True)
            if not no_fin and cloud.suffix != ".ply":
                print(line(name, "3DFin", reference, by_3dfin(las_of(cloud, folder), folder)), flush=True)
    return 0


if __name__ == "__main__":
    sys.exit(main())
