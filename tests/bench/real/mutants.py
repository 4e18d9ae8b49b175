#!/usr/bin/env python3
"""Clouds that are wrong in one way each, made from a simulated plot: each must come out right, or say in words what is wrong.

    mutants.py --bole build/headless/bin/bole --scan SCAN [--cloud OUT/cloud.las] [--keep DIR] [--only NAME ...]

SCAN is the folder of `bole simulate --plot demo --seed 1 --out SCAN`. The cloud is the map with true poses
(`bole run pipelines/forest_plot.json --set scan.file=SCAN/walk.pcap --set slam.trajectory=SCAN/trajectory.tum`), made here unless --cloud names it, cut to the
plot and a margin of 2 m, x, y and z alone, 1 point in --every. The mutants: ground cut away, heights in place of elevations, both, one point in 50, tilted by 5
deg, two registrations 5 cm apart, y up, feet, millimetres, few ground points, litter, slash over hidden ground, stems seen from one side, every point
twice, a tree cut out, cut off 6, 9 and 12 m above the ground, a standing person, a post, a barrel.

A row is right when nine trees of ten that the cloud shows are found, sound or not, the diameters of the sound ones have a bias of at most 0.6 cm and an RMSE of at most 1.2 cm, and the
ground from which breast height counts (z_m) is right to 0.10 m (median over the trees). A height that counts as seen on a sound tree must be right to 1 m or a tenth of it, whichever is more. Where it is not, the verdict must be refused, or look with a finding about the mutant. Else the row is SILENTLY
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
TOP_M, TOP_SHARE = 1.0, 0.1
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
    is the one tree that the cloud shows; `things` are the places (x, y) of what is no tree and must not be sound."""

    def __init__(self, name, points, about=(), back=lambda p: p, normalised=False, only=None, things=()):
        self.name, self.points, self.about, self.back, self.normalised, self.only, self.things = name, points, about, back, normalised, only, things


def column(random, terrain, at, radius, height, points):
    """The surface of an upright round thing, blurred by 8 mm."""
    import numpy
    angle = 2 * math.pi * random.random(points)
    x, y = (at[k] + radius * f(angle) + random.normal(0, 0.008, points) for k, f in enumerate((numpy.cos, numpy.sin)))
    return numpy.column_stack([x, y, terrain.at(x, y) + height * random.random(points)])


def open_places(trees, half):
    """The places of a grid that are furthest from all trees, and 3 m from each other."""
    steps = [0.5 * k for k in range(-int(2 * half) + 3, int(2 * half) - 2)]
    grid = sorted(((x, y) for x in steps for y in steps), key=lambda p: -min(math.hypot(p[0] - t["x"], p[1] - t["y"]) for t in trees))
    places = []
    for p in grid:
        if all(math.hypot(p[0] - q[0], p[1] - q[1]) >= 3 for q in places):
            places.append(p)
    return places


def mutants(points, terrain, trees, half_m):
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
    for cut in (6, 9, 12):
        yield Mutant(f"cut off {cut} m up", points[height < cut], ("cloud_ends",))
    places = open_places(trees, half_m)
    for place, (name, radius, tall) in zip(places, (("standing person", 0.17, 1.75), ("post", 0.06, 2.4), ("barrel", 0.3, 1.0))):
        count = int(2 * math.pi * radius * tall * 2000)
        yield Mutant(name, numpy.concatenate([points, column(random, terrain, place, radius, tall, count)]), ("stems_to_check",), things=[place])


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
    tops = [stems[k]["height"] - here[i]["height"] for i, k in sound.items() if not math.isnan(stems[k]["height"])]
    wrong_tops = sum(abs(stems[k]["height"] - here[i]["height"]) > max(TOP_M, TOP_SHARE * here[i]["height"]) for i, k in sound.items())
    wrong_things = sum(not s["flagged"] and any(math.hypot(s["x"] - x, s["y"] - y) < 0.4 for x, y in mutant.things) for s in stems)
    right = wrong_tops == 0 and wrong_things == 0 and result["code"] == 0 and len(pairs) >= FOUND * len(here) and abs(bias) <= BIAS_CM and rmse <= RMSE_CM and abs(height) <= HEIGHT_M and len(false) <= 1
    about = [f["code"] for f in result["findings"] if f["severity"] != "note" and any(a in f["code"] for a in mutant.about)]
    refused = result["verdict"] == "refused" or (result["code"] != 0 and result["trouble"].startswith("bole: "))
    told = mutant.about and (refused or (result["verdict"] == "look" and bool(about)))
    return {"state": "right" if right else "told" if told else "SILENTLY WRONG", "found": f"{len(pairs)} of {len(here)}", "sound": len(sound), "false": len(false),
            "dbh": f"{bias:+.2f} / {rmse:.2f}" if errors else "", "holding": f"{holding} of {len(pairs)}", "tops": f"{len(tops)}, {wrong_tops}", "height": f"{height:+.2f}" if heights else ""}


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
            scan = next(p for p in (options.scan / "walk.pcap", options.scan / "frames") if p.exists())
            command = [options.bole, "run", measured.REPOSITORY / "pipelines/forest_plot.json", "--no-cache", "--out", folder / "map", "--set", f"scan.file={scan}",
                       "--set", f"slam.trajectory={options.scan}/trajectory.tum", "--set", "report.figures=false", "--set", "report.page=false", "--set", "report.cloud_format=las"]
            subprocess.run([str(c) for c in command], check=True, capture_output=True)
            cloud = folder / "map/cloud.las"
        half = json.loads((options.scan / "recipe.json").read_text())["plot"]["size_m"] / 2
        everything = read_las(cloud)[::options.every]
        kept = everything[(abs(everything[:, 0]) < half + options.margin) & (abs(everything[:, 1]) < half + options.margin)]
        trees = [{"x": float(r["x_m"]), "y": float(r["y_m"]), "dbh": float(r["dbh_cm"]), "height": float(r["height_m"]), "inside": r["in_plot"] == "1"} for r in measured.rows_of(options.scan / "trees.csv")]
        counted = [t for t in trees if t["inside"] and t["dbh"] >= 7.5]
        terrain = Terrain(options.scan / "dem.tif")
        print(f"{1e-6 * len(kept):.1f} million points, {len(counted)} trees\n\n| cloud | state | found | sound | false | DBH of the sound: bias / RMSE, cm | 95 % holds | ground at the stem off, m | tops of the sound: seen, wrong | verdict: findings (notes) |\n|" + "---|" * 10, flush=True)
        wrong = 0
        for mutant in mutants(kept, terrain, counted, half):
            if options.only and not any(mutant.name.startswith(o) for o in options.only):
                continue
            path = folder / (mutant.name.replace(" ", "_").replace(",", "") + ".ply")
            write_ply(path, mutant.points)
            result = measured.survey(options.bole, path, folder / path.stem)
            j = judge(mutant, result, counted, trees, terrain)
            wrong += j["state"] == "SILENTLY WRONG"
            told = f"{result['verdict']}: {measured.codes(result)}" + (f" {result['trouble'][:100]}" if result["trouble"] else "")
            print(f"| {mutant.name} | {j['state']} | {j['found']} | {j['sound']} | {j['false']} | {j['dbh']} | {j['holding']} | {j['height']} | {j['tops']} | {told} |", flush=True)
            if not options.keep:
                path.unlink()
    print(f"\n{wrong} rows are silently wrong")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
