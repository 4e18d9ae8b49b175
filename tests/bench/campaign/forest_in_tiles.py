#!/usr/bin/python3
"""A forest larger than the memory, in tiles: time per million points and peak, against one a tenth as large.

    tests/bench/campaign/forest_in_tiles.py --bole build/headless/bin/bole --work /tmp/forest --points 50 5

makes a plot (simulated, true poses), repeats it side by side until there are so many million points, measures each
forest with `bole campaign`, and looks whether every copy has the same stems. Needs numpy. Exits 1 where a run fails, a
stem is there twice, the memory is exceeded or the cost does not grow with the points.
"""

import argparse
import csv
import json
import pathlib
import shutil
import struct
import subprocess
import sys
import time

import numpy as np

EXTRA_SIZES = {1: 1, 2: 1, 3: 2, 4: 2, 5: 4, 6: 4, 7: 8, 8: 8, 9: 4, 10: 8}


def run(*command):
    done = subprocess.run([str(c) for c in command], capture_output=True, text=True)
    if done.returncode != 0:
        sys.exit(f"{' '.join(map(str, command))}\n{done.stdout}{done.stderr}")
    return done.stdout


def make_plot(bole, folder, size_m):
    """plot.las: a plot seen by a walk with true poses, cut to a square."""
    plot = folder / "plot.las"
    if plot.exists():
        return plot
    walk, survey = folder / "walk", folder / "survey"
    run(bole, "simulate", "--plot", "plot1", "--seed", 3, "--out", walk)
    pipelines = bole.resolve().parents[3] / "pipelines"
    run(bole, "run", pipelines / "forest_plot.json", "--set", f"scan.file={walk / 'walk.pcap'}", "--set", f"slam.trajectory={walk / 'trajectory.tum'}", "--set", "report.figures=false",
        "--set", "report.cloud_format=las", "--out", survey, "--no-cache")
    header, raw, _ = read_las(survey / "cloud.las")
    scale, offset = np.frombuffer(header, "<f8", 3, 131), np.frombuffer(header, "<f8", 3, 155)
    x, y = (raw[:, 4 * k:4 * k + 4].copy().view("<i4")[:, 0] * scale[k] + offset[k] for k in range(2))
    half = size_m / 2
    write_las(plot, header, raw[(x >= -half) & (x < half) & (y >= -half) & (y < half)])
    return plot


def read_las(path):
    """(header and what else stands before the points, point records as rows of bytes, {sensor axis: (place, type, step)})."""
    data = np.memmap(path, np.uint8, "r")
    head = bytes(data[:375])
    offset, vlrs = struct.unpack_from("<II", head, 96)
    length, count = struct.unpack_from("<H", head, 105)[0], struct.unpack_from("<Q", head, 247)[0]
    header, at = bytes(data[:offset]), struct.unpack_from("<H", head, 94)[0]
    sensor = {}
    for _ in range(vlrs):
        user, number, size = header[at + 2:at + 18].rstrip(b"\0"), *struct.unpack_from("<HH", header, at + 18)
        if user == b"LASF_Spec" and number == 4:
            where = length - sum(EXTRA_SIZES[header[k + 2]] for k in range(at + 54, at + 54 + size, 192))
            for k in range(at + 54, at + 54 + size, 192):
                name, kind, options = header[k + 4:k + 36].rstrip(b"\0").decode(), header[k + 2], header[k + 3]
                if name in ("sensor_x", "sensor_y"):
                    scale = struct.unpack_from("<d", header, k + 112)[0] if options & 8 else 1.0
                    sensor[name[-1]] = (where, np.dtype({6: "<i4", 8: "<i8", 9: "<f4", 10: "<f8"}[kind]), scale)
                where += EXTRA_SIZES[kind]
        at += 54 + size
    return header, np.array(data[offset:offset + length * count]).reshape(count, length), sensor


def add(raw, place, kind, value):
    """Adds to a field of all records."""
    field = raw[:, place:place + kind.itemsize].copy().view(kind)
    raw[:, place:place + kind.itemsize] = (field + np.array(value).astype(kind)).view(np.uint8)


def write_las(path, header, raw):
    head = bytearray(header)
    steps = raw[:, :12].copy().view("<i4")
    low, high = steps.min(0), steps.max(0)
    scale, offset = np.frombuffer(header, "<f8", 3, 131), np.frombuffer(header, "<f8", 3, 155)
    struct.pack_into("<Q", head, 247, len(raw))
    for k in range(3):
        struct.pack_into("<2d", head, 179 + 16 * k, high[k] * scale[k] + offset[k], low[k] * scale[k] + offset[k])
    with open(path, "wb") as file:
        file.write(head)
        file.write(raw.tobytes())


def make_forest(bole, plot, folder, millions, size_m):
    """Copies of the plot side by side, with their sensor positions: a LAZ file each. (points, copies)"""
    header, raw, sensor = read_las(plot)
    scale = np.frombuffer(header, "<f8", 3, 131)
    copies = max(1, round(millions * 1e6 / len(raw)))
    columns = max(1, round(copies**0.5))
    copies = columns * -(-copies // columns)
    folder.mkdir(exist_ok=True)
    for i in range(copies):
        packed = folder / f"{i}.laz"
        if packed.exists():
            continue
        out = raw.copy()
        for k, (axis, shift) in enumerate((("x", i % columns * size_m), ("y", i // columns * size_m))):
            add(out, 4 * k, np.dtype("<i4"), round(shift / scale[k]))
            if axis in sensor:
                place, kind, step = sensor[axis]
                add(out, place, kind, shift / step)
        plain = folder / f"{i}.las"
        write_las(plain, header, out)
        run(bole, "convert", plain, packed)
        plain.unlink()
    for left in set(folder.glob("*.laz")) - {folder / f"{i}.laz" for i in range(copies)}:
        left.unlink()
    return copies * len(raw), copies


def alike_in_copies(table, copies, size_m):
    """A stem stands at the same place of every copy, wherever the seams of the tiles lie: how often it was found, and
    how much its diameter varies. Stems near the seams of the copies, where trees are cut, do not count."""
    with open(table, encoding="utf-8") as file:
        rows = list(csv.DictReader(file))
    at = np.array([[float(r["x_m"]), float(r["y_m"])] for r in rows])
    dbh_cm, tiles = np.array([float(r["dbh_cm"] or "nan") for r in rows]), np.array([r["input_id"] for r in rows])
    doubled = sum(int(((np.hypot(*(at[i + 1:] - at[i]).T) < 0.3) & (tiles[i + 1:] != tiles[i])).sum()) for i in range(len(at)))
    within = (at + size_m / 2) % size_m
    waiting = [i for i in range(len(at)) if (np.abs(within[i] - size_m / 2) < size_m / 2 - 2).all()]
    found, spread_cm = [], []
    while waiting:
        near = np.hypot(*(within[waiting] - within[waiting[0]]).T) < 0.15
        of_one = [i for i, same in zip(waiting, near) if same]
        waiting = [i for i, same in zip(waiting, near) if not same]
        found.append(len(of_one))
        if len(of_one) == copies:
            spread_cm.append(np.nanstd(dbh_cm[of_one]))
    return {"places": len(found), "in_every_copy": len(spread_cm), "found_in": sorted(n for n in found if n != copies),
            "dbh_sd_cm": {"median": round(float(np.median(spread_cm)), 3), "95_pct": round(float(np.percentile(spread_cm, 95)), 3)}, "doubled_across_tiles": doubled}


def measure(bole, folder, name, cloud, points, copies, options):
    out, document = folder / name, folder / f"{name}.json"
    shutil.rmtree(out, ignore_errors=True)
    document.write_text(json.dumps({"pipeline": "stem_map_from_cloud", "cloud": str(cloud), "tile_m": options.tile_m, "buffer_m": options.buffer_m, "cloud_files": options.cloud_files}))
    begin = time.monotonic()
    run(bole, "campaign", "run", document, "--out", out, "--engine", "local", "--workers", options.workers, "--memory", options.memory)
    wall = time.monotonic() - begin
    records = [json.loads(p.read_text()) for p in out.glob("tasks/*/done/record.json")]
    by_phase = {}
    for r in records:
        phase = r["input_id"].rsplit(".", 1)[-1]
        spent = by_phase.setdefault(phase, [0.0, 0.0])
        spent[0] += r["cpu_seconds"]
        spent[1] = max(spent[1], r["peak_mib"])
    with open(out / "stems.csv", encoding="utf-8") as file:
        stems = sum(1 for _ in csv.reader(file)) - 1
    millions = points / 1e6
    return {"points": points, "copies": copies, "stems": stems, "tiles": sum(1 for r in records if r["input_id"].endswith(".stems")), "wall_s": round(wall, 1),
            "wall_s_per_million": round(wall / millions, 2), "cpu_s_per_million": round(sum(r["cpu_seconds"] for r in records) / millions, 2),
            "peak_mib": max(r["peak_mib"] for r in records), "alike": alike_in_copies(out / "stems.csv", copies, options.plot_m),
            "phases": {phase: {"cpu_s_per_million": round(cpu / millions, 2), "peak_mib": peak} for phase, (cpu, peak) in sorted(by_phase.items())}}


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--bole", type=pathlib.Path, required=True)
    parser.add_argument("--work", type=pathlib.Path, required=True)
    parser.add_argument("--points", type=float, nargs="+", default=[50, 5], help="millions, the largest first")
    parser.add_argument("--tile-m", type=float, default=50)
    parser.add_argument("--buffer-m", type=float, default=10)
    parser.add_argument("--plot-m", type=float, default=40)
    parser.add_argument("--workers", type=int, default=2)
    parser.add_argument("--memory", type=float, default=6)
    parser.add_argument("--cloud-files", action="store_true")
    options = parser.parse_args()
    options.work.mkdir(parents=True, exist_ok=True)
    plot = make_plot(options.bole, options.work, options.plot_m)
    results = []
    for millions in options.points:
        forest = options.work / f"forest_{millions:g}"
        points, copies = make_forest(options.bole, plot, forest, millions, options.plot_m)
        results.append(measure(options.bole, options.work, f"tiles_{millions:g}", forest / "*.laz", points, copies, options))
        print(json.dumps(results[-1], indent=1), flush=True)
    over = [r for r in results if r["peak_mib"] * options.workers > 1024 * options.memory]
    ratio = max(r["cpu_s_per_million"] for r in results) / min(r["cpu_s_per_million"] for r in results)
    print(f"processor time per million points differs by a factor of {ratio:.2f}; peaks {[r['peak_mib'] for r in results]} MiB")
    return 1 if over or ratio > 1.5 or any(r["alike"]["doubled_across_tiles"] for r in results) else 0


if __name__ == "__main__":
    sys.exit(main())
