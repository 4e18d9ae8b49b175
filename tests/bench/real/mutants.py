#!/usr/bin/env python3
"""Clouds that are wrong in one way each, made from a simulated plot: each must come out right, or say in words what is wrong.

    mutants.py --bole build/headless/bin/bole --scan SCAN [--cloud OUT/cloud.las] [--keep DIR] [--only NAME ...]

SCAN is the folder of `bole simulate --plot demo --seed 1 --out SCAN`. The cloud is the map with true poses
(`bole run pipelines/forest_plot.json --set scan.file=SCAN/walk.pcap --set slam.trajectory=SCAN/trajectory.tum`), made here unless --cloud names it, cut to the
plot and a margin of 2 m, x, y and z alone, 1 point in --every. The mutants: ground cut away, heights in place of elevations, both, one point in 50, tilted by 5
deg, two registrations 5 cm apart, y up, feet, millimetres, few ground points, litter, slash over hidden ground, stems seen from one side, every point
twice, a tree cut out.

A row is right when nine trees of ten that the cloud shows are found, sound or not, the diameters of the sound ones have a bias of at most 0.6 cm and an RMSE of at most 1.2 cm, and the
ground from which breast height counts (z_m) is right to 0.10 m (median over the trees). Where it is not, the verdict must be refused, or look with a finding about the mutant. Else the row is SILENTLY
WRONG, and the script exits 1. The cloud as it is must come out right.
"""
import argparse
import json
import math
import pathlib
import statistics
import struct
import subprocess
import sys
import tempfile

import measured

FOUND, BIAS_CM, RMSE_CM, HEIGHT_M = 0.9, 0.6, 1.2, 0.10
FOOT = 0.3048


def read_las(path):
    """x, y, z of an uncompressed LAS file."""
    import numpy
    data = path.read_bytes()
    offset, = struct.unpack_from("<I", data, 96)
    length, = struct.unpack_from("<H", data, 105)
    count, = struct.unpack_from("<Q", data, 247) if data[25] >= 4 else struct.unpack_from("<I", data, 107)
    scale, shift = struct.unpack_from("<3d", data, 131), struct.unpack_from("<3d", data, 155)
    records = numpy.frombuffer(data, numpy.uint8, count * length, offset).reshape(count, length)
    whole = numpy.ascontiguousarray(records[:, :12]).view("<i4")
    return whole * numpy.array(scale) + numpy.array(shift)


def write_ply(path, points):
    import numpy
    header = f"ply\nformat binary_little_endian 1.0\nelement vertex {len(points)}\nproperty double x\nproperty double y\nproperty double z\nend_header\n"
    path.write_bytes(header.encode() + numpy.ascontiguousarray(points, "<f8").tobytes())


class Terrain:
    """The true terrain of the simulation, dem.tif as `bole simulate` writes it: north up, not compressed."""

    def __init__(self, tif):
        import numpy
        data = tif.read_bytes()
        first, = struct.unpack_from("<I", data, 4)
        tags = {}
        for k in range(struct.unpack_from("<H", data, first)[0]):
            tag, kind, count, value = struct.unpack_from("<HHII", data, first + 2 + 12 * k)
            form = {3: "H", 4: "I", 12: "d"}.get(kind)
            inside = count * struct.calcsize("<" + form) <= 4 if form else True
            tags[tag] = [value] if inside else struct.unpack_from(f"<{count}{form}", data, value)
        if tags[259][0] != 1:
            raise ValueError(f"{tif} is compressed")
        width, height, rows = tags[256][0], tags[257][0], tags[278][0]
        strips = [numpy.frombuffer(data, "<f4", min(rows, height - rows * k) * width, offset) for k, offset in enumerate(tags[273])]
        self.z = numpy.concatenate(strips).reshape(height, width)[::-1].astype(float)
        self.step = tags[33550][0]
        self.x0, self.y0 = tags[33922][3] + self.step / 2, tags[33922][4] - (height - 0.5) * self.step

    def at(self, x, y):
        import numpy
        fx, fy = (numpy.asarray(x) - self.x0) / self.step, (numpy.asarray(y) - self.y0) / self.step
        ix, iy = numpy.clip(fx.astype(int), 0, self.z.shape[1] - 2), numpy.clip(fy.astype(int), 0, self.z.shape[0] - 2)
        u, v = numpy.clip(fx - ix, 0, 1), numpy.clip(fy - iy, 0, 1)
        return ((1 - v) * ((1 - u) * self.z[iy, ix] + u * self.z[iy, ix + 1]) + v * ((1 - u) * self.z[iy + 1, ix] + u * self.z[iy + 1, ix + 1]))


def rotation(axis, degrees):
    import numpy
    c, s = math.cos(math.radians(degrees)), math.sin(math.radians(degrees))
    return numpy.array({"x": [[1, 0, 0], [0, c, -s], [0, s, c]], "y": [[c, 0, s], [0, 1, 0], [-s, 0, c]]}[axis])


class Mutant:
    """`back` carries a result's place (x, y, z) to the axes of the plot; `about` are words of the codes of findings that tell of the mutation; `only`
    is the one tree that the cloud shows."""

    def __init__(self, name, points, about=(), back=lambda p: p, normalised=False, only=None):
        self.name, self.points, self.about, self.back, self.normalised, self.only = name, points, about, back, normalised, only


def mutants(points, terrain, trees):
    import numpy
    height = points[:, 2] - terrain.at(points[:, 0], points[:, 1])
    flat = points.copy()
    flat[:, 2] = height
    random = numpy.random.default_rng(1)
    tilt = rotation("x", 3) @ rotation("y", 4)
    half = random.random(len(points)) < 0.5
    best = max((t for t in trees if max(abs(t["x"]), abs(t["y"])) < 5), key=lambda t: t["dbh"])
    near = numpy.hypot(points[:, 0] - best["x"], points[:, 1] - best["y"])
    yield Mutant("as it is", points)
    yield Mutant("ground cut away", points[height > 0.4], ("ground", "terrain", "breast", "air"))
    yield Mutant("normalised", flat, ("normalised", "ground", "terrain"), normalised=True)
    yield Mutant("normalised, ground cut away", flat[height > 0.4], ("normalised", "ground", "terrain", "breast", "air"), normalised=True)
    yield Mutant("1 point in 50", points[random.random(len(points)) < 0.02], ("sparse",))
    yield Mutant("tilted by 5 deg", points @ tilt.T, ("tilt",), back=lambda p: tuple(tilt.T @ numpy.array(p)))
    yield Mutant("two registrations 5 cm apart", points + numpy.where(half[:, None], [0.035, 0.035, 0], 0), ("double", "regist", "passes", "blur"),
                 back=lambda p: (p[0] - 0.0175, p[1] - 0.0175, p[2]))
    yield Mutant("y up", points[:, [0, 2, 1]] * [1, 1, -1], ("up_axis",))
    yield Mutant("x up", points[:, [2, 1, 0]] * [1, 1, -1], ("up_axis",))
    yield Mutant("feet", points / FOOT, ("unit",))
    yield Mutant("millimetres", points * 1000, ("unit",))
    low = height < 0.25
    few = points[~low | (random.random(len(points)) < 0.01)]
    yield Mutant("1 ground point in 100", few, ("ground", "terrain", "breast", "air"))
    litter = points.copy()
    litter[low, 2] += random.random(low.sum()) * 0.3
    yield Mutant("litter 30 cm deep", litter, ("ground", "terrain", "breast", "litter"))
    slash = points[random.random(len(points)) < 0.15] * [1, 1, 0]
    slash[:, :2] += random.normal(0, 0.3, (len(slash), 2))
    slash[:, 2] = terrain.at(slash[:, 0], slash[:, 1]) + 0.6 * random.random(len(slash)) ** 2
    yield Mutant("slash over hidden ground", numpy.concatenate([points[height > 0.1], slash]), ("ground", "terrain", "breast", "litter"))
    nearest = numpy.argmin([numpy.hypot(points[:, 0] - t["x"], points[:, 1] - t["y"]) for t in trees], axis=0)
    beside = points[:, 0] - numpy.array([t["x"] for t in trees])[nearest]
    yield Mutant("seen from one side", points[low | (beside > 0.01)], ("check", "side", "arc", "sparse"))
    yield Mutant("every point twice", numpy.concatenate([points, points]), ("duplicated",))
    yield Mutant("a tree cut out", points[(near < 0.5) & (height > 0.05)], ("single_tree", "ground", "terrain"), only=best)


def judge(mutant, result, trees, all_trees, terrain):
    """right, told or SILENTLY WRONG, with the numbers."""
    stems = []
    for s in result["stems"]:
        x, y, z = mutant.back((s["x"], s["y"], s["z"]))
        stems.append({**s, "x": x, "y": y, "z": z})
    here = [mutant.only] if mutant.only else trees
    pairs = measured.pairs_of(here, stems, 0.4)
    sound = {i: k for i, k in pairs.items() if not stems[k]["flagged"]}
    errors = [stems[k]["dbh"] - here[i]["dbh"] for i, k in sound.items() if stems[k]["dbh"] > 0]
    heights = [stems[k]["z"] - (0 if mutant.normalised else float(terrain.at(stems[k]["x"], stems[k]["y"]))) for k in pairs.values()]
    holding = sum(stems[k]["low"] <= here[i]["dbh"] <= stems[k]["high"] for i, k in pairs.items())
    bias = statistics.fmean(errors) if errors else math.nan
    rmse = math.sqrt(statistics.fmean([e * e for e in errors])) if errors else math.nan
    height = statistics.median(heights) if heights else math.nan
    false = [s for k, s in enumerate(stems) if k not in pairs.values() and not s["flagged"] and not any(math.hypot(s["x"] - t["x"], s["y"] - t["y"]) < 0.5 for t in all_trees)]
    right = result["code"] == 0 and len(pairs) >= FOUND * len(here) and abs(bias) <= BIAS_CM and rmse <= RMSE_CM and abs(height) <= HEIGHT_M and len(false) <= 1
    about = [f["code"] for f in result["findings"] if f["severity"] != "note" and any(a in f["code"] for a in mutant.about)]
    refused = result["verdict"] == "refused" or (result["code"] != 0 and result["trouble"].startswith("bole: "))
    told = mutant.about and (refused or (result["verdict"] == "look" and bool(about)))
    return {"state": "right" if right else "told" if told else "SILENTLY WRONG", "found": f"{len(pairs)} of {len(here)}", "sound": len(sound), "false": len(false),
            "dbh": f"{bias:+.2f} / {rmse:.2f}" if errors else "", "holding": f"{holding} of {len(pairs)}", "height": f"{height:+.2f}" if heights else ""}


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--bole", required=True, type=pathlib.Path)
    parser.add_argument("--scan", required=True, type=pathlib.Path)
    parser.add_argument("--cloud", type=pathlib.Path)
    parser.add_argument("--every", type=int, default=5)
    parser.add_argument("--margin", type=float, default=2.0)
    parser.add_argument("--only", nargs="*", default=[])
    parser.add_argument("--keep", type=pathlib.Path, help="folder for the clouds and results")
    options = parser.parse_args()
    try:
        import numpy  # noqa: F401
    except ImportError as error:
        print(f"SKIPPED: {error}")
        return 0
    with tempfile.TemporaryDirectory() as place:
        folder = options.keep or pathlib.Path(place)
        folder.mkdir(parents=True, exist_ok=True)
        cloud = options.cloud
        if cloud is None:
            command = [options.bole, "run", measured.REPOSITORY / "pipelines/forest_plot.json", "--no-cache", "--out", folder / "map", "--set", f"scan.file={options.scan}/walk.pcap",
                       "--set", f"slam.trajectory={options.scan}/trajectory.tum", "--set", "report.figures=false", "--set", "report.page=false", "--set", "report.cloud_format=las"]
            subprocess.run([str(c) for c in command], check=True, capture_output=True)
            cloud = folder / "map/cloud.las"
        half = json.loads((options.scan / "recipe.json").read_text())["plot"]["size_m"] / 2
        everything = read_las(cloud)[::options.every]
        kept = everything[(abs(everything[:, 0]) < half + options.margin) & (abs(everything[:, 1]) < half + options.margin)]
        trees = [{"x": float(r["x_m"]), "y": float(r["y_m"]), "dbh": float(r["dbh_cm"]), "inside": r["in_plot"] == "1"} for r in measured.rows_of(options.scan / "trees.csv")]
        counted = [t for t in trees if t["inside"] and t["dbh"] >= 7.5]
        terrain = Terrain(options.scan / "dem.tif")
        print(f"{1e-6 * len(kept):.1f} million points, {len(counted)} trees\n\n| cloud | state | found | sound | false | DBH of the sound: bias / RMSE, cm | 95 % holds | ground at the stem off, m | verdict: findings (notes) |\n|" + "---|" * 9, flush=True)
        wrong = 0
        for mutant in mutants(kept, terrain, counted):
            if options.only and not any(mutant.name.startswith(o) for o in options.only):
                continue
            path = folder / (mutant.name.replace(" ", "_").replace(",", "") + ".ply")
            write_ply(path, mutant.points)
            result = measured.survey(options.bole, path, folder / path.stem)
            j = judge(mutant, result, counted, trees, terrain)
            wrong += j["state"] == "SILENTLY WRONG"
            told = f"{result['verdict']}: {measured.codes(result)}" + (f" {result['trouble'][:100]}" if result["trouble"] else "")
            print(f"| {mutant.name} | {j['state']} | {j['found']} | {j['sound']} | {j['false']} | {j['dbh']} | {j['holding']} | {j['height']} | {told} |", flush=True)
            if not options.keep:
                path.unlink()
    print(f"\n{wrong} rows are silently wrong")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
