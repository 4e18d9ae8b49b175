#!/usr/bin/env python3
"""Compares the LAZ encoder and the COPC writer with laspy and its LAZ backend lazrs.

    laz_against_lazrs.py BUILD_DIR [FILE_OR_FOLDER...]

BUILD_DIR holds bin/las_dump. Three judgements:
  records   Records of every format that is written (walks, noise in every byte, extremes; 0, 1 and 2 points, and the borders of
            chunks), and of the given files, are compressed by us and decompressed by lazrs: the same bytes, all of them.
  clouds    The given files are read and written as LAS, LAZ and COPC by our writers. laspy finds in LAZ the records of LAS; its
            CopcReader finds in COPC the same records, all of them and within bounds.
  cost      Size and time against lazrs, in one run, in the order ours, theirs, ours, theirs: ratios.
Needs laspy and lazrs in the Python that runs it; without them it says so and ends with success.
"""
import pathlib
import subprocess
import sys
import tempfile
import time

sys.path.insert(0, str(pathlib.Path(__file__).parents[2] / "data" / "laz"))
try:
    import laspy
    import lazrs
    import numpy as np
    import make_fixtures as make
except ImportError as error:
    print(f"SKIPPED: {error}; pip install 'laspy[lazrs]'")
    sys.exit(0)

FORMATS = [0, 1, 2, 3, 6, 7, 8]


def run(program, *args):
    done = subprocess.run([str(program), *map(str, args)], capture_output=True, text=True)
    if done.returncode != 0:
        raise RuntimeError(done.stderr.strip() or f"las_dump ended with {done.returncode}")
    return done.stdout


def rows(points):
    """Point records as bytes, one row each."""
    return np.frombuffer(points.tobytes(), np.uint8).reshape(len(points), points.dtype.itemsize)


def records_of(path):
    return rows(laspy.read(path).points.array)


def extremes(point_format, count, seed):
    """Every field at the ends of its range, by turns."""
    points = make.make_points(point_format, count, seed, extra=True)
    rng = np.random.default_rng(seed)
    for name in points.dtype.names:
        kind = points.dtype[name]
        if kind.kind == "f":
            values = np.array([0, -0.0, np.nan, np.inf, -np.inf, np.finfo(kind).max, np.finfo(kind).tiny, 3e8], kind)
        else:
            limits = np.iinfo(kind)
            values = np.array([limits.min, limits.max, 0, 1, limits.max - 1], kind)
        chosen = rng.random(count) < 0.5
        points[name][chosen] = values[rng.integers(0, len(values), chosen.sum())]
    return points


def made(folder):
    for point_format in FORMATS:
        sets = {f"count{n}": (make.make_points(point_format, n, 3 + n), {}) for n in (1, 2, 49_999, 50_000, 50_001)}
        sets["extra"] = (make.make_points(point_format, 60_000, 70, extra=True), {"extra": True})
        sets["noise"] = (make.make_points(point_format, 60_000, 700, wild=True), {})
        sets["extremes"] = (extremes(point_format, 60_000, 9), {"extra": True})
        for name, (points, how) in sets.items():
            path = folder / f"{name}_{point_format}.las"
            path.write_bytes(make.las_bytes(point_format, points, **how))
            yield path
        path = folder / f"count0_{point_format}.las"
        data = bytearray(make.las_bytes(point_format, make.make_points(point_format, 1, 3)))
        data[107:131] = bytes(24)
        if point_format >= 6:
            data[247:375] = bytes(128)
        path.write_bytes(data[:-make.SIZES[point_format]])
        yield path


def judge_records(program, path, folder):
    packed = folder / "packed.laz"
    run(program, "--pack", path, packed)
    ours = records_of(packed)
    theirs = records_of(path)
    return [] if np.array_equal(ours, theirs) else [f"{path.name}: records"]


def in_order(records):
    return records[np.lexsort(records.T[::-1])] if len(records) else records


def judge_cloud(program, path, folder):
    bad = []
    for ending in (".las", ".laz", ".copc.laz"):
        run(program, path, folder / "dump.json", folder / f"copy{ending}")
    plain = records_of(folder / "copy.las")
    if not np.array_equal(plain, records_of(folder / "copy.laz")):
        bad.append(f"{path.name}: LAZ")
    headers = [laspy.open(folder / f"copy{ending}").header for ending in (".las", ".laz", ".copc.laz")]
    for other in headers[1:]:
        same = (np.array_equal(other.mins, headers[0].mins) and np.array_equal(other.maxs, headers[0].maxs)
                and np.array_equal(other.number_of_points_by_return, headers[0].number_of_points_by_return)
                and other.global_encoding.gps_time_type == headers[0].global_encoding.gps_time_type
                and other.global_encoding.wkt == headers[0].global_encoding.wkt)
        if not same:
            bad.append(f"{path.name}: header")
    with laspy.CopcReader.open(str(folder / "copy.copc.laz")) as reader:
        points = reader.query()
        if not np.array_equal(in_order(rows(points.array)), in_order(plain)):
            bad.append(f"{path.name}: COPC")
        # Half of the box, and a level that is coarser.
        low, high = headers[0].mins, headers[0].maxs
        # A quarter of a step off the grid, so that no point lies on an edge and rounding decides nothing.
        steps_to_middle = np.floor((high - low) / 2 / headers[0].scales) + 0.25
        half = laspy.copc.Bounds(mins=low - headers[0].scales / 4, maxs=low + steps_to_middle * headers[0].scales)
        part = reader.query(bounds=half)
        steps = plain[:, :12].copy().view(np.int32)
        place = steps * headers[0].scales + headers[0].offsets
        inside = np.all((place >= half.mins) & (place <= half.maxs), axis=1)
        if len(part) != inside.sum():
            bad.append(f"{path.name}: COPC gives {len(part)} of {inside.sum()} points within bounds")
        if reader.root_page is not None and len(plain) > 100_000 and len(reader.query(level=0)) > len(plain) // 2:
            bad.append(f"{path.name}: the root of COPC is not thinned")
    return bad


def lazrs_seconds(path):
    """Compression in memory by lazrs with all threads, and its bytes."""
    points = laspy.read(path).points
    raw = np.frombuffer(points.array.tobytes(), np.uint8)
    vlr = lazrs.LazVlr.new_for_compression(points.point_format.id, points.point_format.num_extra_bytes)
    start = time.perf_counter()
    packed = lazrs.compress_points(vlr, raw, True)
    return time.perf_counter() - start, len(packed)


def judge_cost(program, path, folder):
    ours, theirs = [], []
    for _ in range(3):
        ours.append(float(run(program, "--pack", path, folder / "packed.laz")))
        seconds, size = lazrs_seconds(path)
        theirs.append(seconds)
    with laspy.open(folder / "packed.laz") as file:
        points = file.header.point_count
        own = (folder / "packed.laz").stat().st_size - file.header.offset_to_point_data
    plain = path.stat().st_size
    print(f"{path.name:<24} {points / 1e6:6.2f} M points, {own / plain:5.1%} of LAS, size {own / size:.4f} of theirs, speed {min(theirs) / min(ours):.2f} of theirs "
          f"({points / min(ours) / 1e6:.1f} and {points / min(theirs) / 1e6:.1f} M points/s)", flush=True)
    return [f"{path.name}: {own / size:.3f} of the size of lazrs"] if own > 1.02 * size else []


def main():
    if len(sys.argv) < 2:
        print(__doc__)
        return 2
    program = pathlib.Path(sys.argv[1]) / "bin" / "las_dump"
    given = []
    for name in map(pathlib.Path, sys.argv[2:]):
        given += sorted(p for p in name.rglob("*") if p.suffix in (".las", ".laz")) if name.is_dir() else [name]
    failures, compared = [], 0
    with tempfile.TemporaryDirectory() as place:
        folder = pathlib.Path(place)
        for path in made(folder):
            failures += judge_records(program, path, folder)
            compared += 1
            path.unlink()
        large = []
        for path in given:
            try:
                failures += judge_cloud(program, path, folder)
                plain = folder / f"{path.name.split('.')[0]}.las"
                (folder / "copy.las").rename(plain)
                failures += judge_records(program, plain, folder)
            except (RuntimeError, laspy.errors.LaspyException) as error:
                # Damaged on purpose, or not a point cloud that both read.
                print(f"{path.name}: not compared ({str(error)[:100]})")
                continue
            compared += 1
            large.append(plain) if plain.stat().st_size > 3_000_000 else plain.unlink()
        for point_format, extra in ((1, False), (3, False), (6, True), (7, False)):
            path = folder / f"walk_{point_format}.las"
            points = make.make_points(point_format, 1_000_000, 5, extra=extra)
            path.write_bytes(make.las_bytes(point_format, points, extra=extra))
            large.append(path)
        print(f"{compared} files compared, {len(failures)} differences")
        for path in large:
            failures += judge_cost(program, path, folder)
    print("\n".join(failures))
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
