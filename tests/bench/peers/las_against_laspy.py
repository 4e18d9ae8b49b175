#!/usr/bin/env python3
"""Compares the LAS and LAZ reader and the LAS writer with laspy (and its LAZ backend lazrs), field by field.

    las_against_laspy.py BUILD_DIR [FILE_OR_FOLDER...]

BUILD_DIR holds bin/las_dump. Synthetic files of every point format 0 to 10 are made (random walks and pure noise, plain
and compressed, small and varying chunks, extra bytes, several scanner channels), and the given files are added. Needs
laspy and lazrs in the Python that runs it; without them it says so and ends with success.
"""
import json
import pathlib
import subprocess
import sys
import tempfile
import time

sys.path.insert(0, str(pathlib.Path(__file__).parents[2] / "data" / "laz"))
try:
    import laspy
    import lazrs  # noqa: F401 (laspy uses it)
    import numpy as np
    import make_fixtures as make
except ImportError as error:
    print(f"SKIPPED: {error}; pip install 'laspy[lazrs]'")
    sys.exit(0)

FIELDS = {"intensity": "intensity", "return_number": "return_number", "number_of_returns": "number_of_returns", "user_data": "user_data", "point_source_id": "point_source_id", "time": "gps_time",
          "red": "red", "green": "green", "blue": "blue", "near_infrared": "nir", "synthetic": "synthetic", "key_point": "key_point", "withheld": "withheld", "overlap": "overlap",
          "scanner_channel": "scanner_channel", "scan_direction": "scan_direction_flag", "edge_of_flight_line": "edge_of_flight_line", "classification": "classification"}
STEP = 0.006


def run(program, *args):
    done = subprocess.run([str(program), *map(str, args)], capture_output=True, text=True)
    return done.returncode, done.stdout, done.stderr.strip()


def load(out):
    info = json.loads(out.read_text())
    return info, {name: np.fromfile(f"{out}.{name}", dtype=kind) for name, kind in (info["columns"] or {}).items()}


def compare(las, columns, name):
    """Names of the fields that differ."""
    bad = []
    count = len(las.points)

    def same(column, expected):
        ours = columns.get(column)
        if ours is None:
            return not np.any(expected)  # columns of zeros are left out
        return len(ours) == count and np.array_equal(ours, expected.astype(ours.dtype), equal_nan=ours.dtype.kind == "f")

    dimensions = set(las.point_format.dimension_names)
    for ours, theirs in FIELDS.items():
        if theirs in dimensions and not same(ours, np.asarray(las[theirs])):
            bad.append(ours)
    angle = np.asarray(las["scan_angle"]) * STEP if "scan_angle" in dimensions else np.asarray(las["scan_angle_rank"])
    if not same("scan_angle", angle.astype(np.float32)):
        bad.append("scan_angle")
    for extra in las.point_format.extra_dimensions:
        values = np.asarray(las[extra.name])
        if values.ndim == 1 and extra.name in columns and not same(extra.name, values):
            bad.append(extra.name)
    for k, axis in enumerate("xyz"):
        # The very integers of the file, where float32 offsets can carry them.
        raw = np.asarray(las[axis.upper()]).astype(np.int64)
        steps = (columns[axis] - las.header.offsets[k]) / las.header.scales[k]
        wide = count and int(raw.max()) - int(raw.min()) > 1 << 24
        if not wide and not np.array_equal(np.rint(steps).astype(np.int64), raw):
            bad.append(axis)
    return bad


def check(program, path, folder, failures):
    out = folder / "dump.json"
    copy = folder / "copy.las"
    status, _, message = run(program, path, out, copy)
    las = laspy.read(path)
    if status != 0:
        failures.append(f"{path.name}: {message}")
        return
    info, columns = load(out)
    bad = compare(las, columns, path.name) if info["points"] == len(las.points) else [f"{info['points']} points instead of {len(las.points)}"]
    # What we write, read by laspy.
    again = laspy.read(copy)
    if len(again.points) != len(las.points):
        bad.append("the written file has another number of points")
    else:
        for axis in "xyz":
            if len(las.points) and np.max(np.abs(np.asarray(again[axis]) - columns[axis])) > 1e-7 * max(1.0, np.max(np.abs(columns[axis]))):
                bad.append(f"written {axis}")
        for ours in ("tree_id", "range"):
            if ours in columns and not np.array_equal(np.asarray(again[ours]), columns[ours]):
                bad.append(f"written {ours}")
    failures += [f"{path.name}: {field}" for field in bad]


def synthetic(folder):
    for point_format in range(11):
        walk = make.make_points(point_format, 3000, 7 + point_format)
        extra = make.make_points(point_format, 3000, 70 + point_format, extra=True)
        noise = make.make_points(point_format, 500, 700 + point_format, wild=True)
        if point_format in make.HAS_WAVE and point_format >= 6:
            noise["flags"] &= 0xCF  # see make_points()
        if point_format in make.HAS_TIME:
            noise["time"] = np.nan_to_num(noise["time"])
        cases = {"walk": (walk, {}), "extra": (extra, {"extra": True}), "noise": (noise, {})}
        for name, (points, how) in cases.items():
            (folder / f"{name}{point_format}.las").write_bytes(make.las_bytes(point_format, points, **how))
            (folder / f"{name}{point_format}.laz").write_bytes(make.laz_bytes(point_format, points, 333, **how))
        (folder / f"chunks{point_format}.laz").write_bytes(make.laz_bytes(point_format, walk, 0, chunks=[1, 999, 2, 1500, 498]))
        if point_format in (0, 1):
            (folder / f"old{point_format}.laz").write_bytes(make.laz_bytes(point_format, walk, 500, old=True))


def timings(program, folder):
    points = make.make_points(7, 1_000_000, 5)
    points["flags"] &= 0xCF
    (folder / "big.las").write_bytes(make.las_bytes(7, points))
    (folder / "big.laz").write_bytes(make.laz_bytes(7, points, 50000))
    for name in ("big.las", "big.laz"):
        ours = float(run(program, "--time", folder / name)[1])
        theirs = min(timed(folder / name) for _ in range(3))
        print(f"{name}: {len(points) / ours / 1e6:.1f} M points/s; laspy {len(points) / theirs / 1e6:.1f} M points/s; ratio {theirs / ours:.2f}")


def timed(path):
    start = time.perf_counter()
    las = laspy.read(path)
    # What our reader gives, too: scaled coordinates and one array per field.
    _ = las.xyz
    for name in las.point_format.dimension_names:
        np.array(las[name])
    return time.perf_counter() - start


def main():
    if len(sys.argv) < 2:
        print(__doc__)
        return 2
    program = pathlib.Path(sys.argv[1]) / "bin" / "las_dump"
    failures, files = [], []
    for given in map(pathlib.Path, sys.argv[2:]):
        files += sorted(p for p in given.rglob("*") if p.suffix in (".las", ".laz")) if given.is_dir() else [given]
    with tempfile.TemporaryDirectory() as temporary:
        made = pathlib.Path(temporary) / "made"
        made.mkdir()
        synthetic(made)
        files += sorted(made.iterdir())
        for path in files:
            check(program, path, pathlib.Path(temporary), failures)
        print(f"{len(files)} files compared, {len(failures)} differences")
        print("\n".join(failures))
        timings(program, pathlib.Path(temporary))
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
