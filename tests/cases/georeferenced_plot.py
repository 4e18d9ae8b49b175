#!/usr/bin/env python3
"""A simulated plot is surveyed and georeferenced by the true coordinates of its targets, and every export is read back.

The truth is turned and shifted onto UTM zone 32. Checked are: easting and northing of every tree in the plot against the
truth, the share of trees within 1.96 position_se_m, and that cloud.las, plot.gpkg, stems.geojson and dem.tif hold the
coordinate system and the same places. The files are read here byte by byte and with sqlite, not by Bole; gdalinfo and
ogrinfo are asked as well where they are installed. Degrees are computed with the series of Krueger (1912).
"""

import argparse
import csv
import json
import math
import pathlib
import shutil
import sqlite3
import struct
import subprocess
import sys

TURN = math.radians(23.5)
EAST, NORTH, HEIGHT = 563210.123, 5412345.678, 431.25
EPSG = 25832


def run(command):
    print("+", " ".join(map(str, command)), flush=True)
    result = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
    print(result.stdout[-3000:], flush=True)
    if result.returncode != 0:
        sys.exit(f"exit code {result.returncode}")
    return result.stdout


def rows(path):
    with open(path, newline="") as file:
        return list(csv.DictReader(file))


def to_global(x, y):
    c, s = math.cos(TURN), math.sin(TURN)
    return EAST + c * x - s * y, NORTH + s * x + c * y


def degrees_of(easting, northing):
    """Latitude and longitude of UTM zone 32 on GRS80, to 1e-9 deg."""
    a, f = 6378137.0, 1 / 298.257222101
    n = f / (2 - f)
    radius = a / (1 + n) * (1 + n**2 / 4 + n**4 / 64)
    beta = [n / 2 - 2 * n**2 / 3 + 37 * n**3 / 96, n**2 / 48 + n**3 / 15, 17 * n**3 / 480]
    delta = [2 * n - 2 * n**2 / 3 - 2 * n**3, 7 * n**2 / 3 - 8 * n**3 / 5, 56 * n**3 / 15]
    xi, eta = northing / (0.9996 * radius), (easting - 500000) / (0.9996 * radius)
    xi0 = xi - sum(b * math.sin(2 * (j + 1) * xi) * math.cosh(2 * (j + 1) * eta) for j, b in enumerate(beta))
    eta0 = eta - sum(b * math.cos(2 * (j + 1) * xi) * math.sinh(2 * (j + 1) * eta) for j, b in enumerate(beta))
    chi = math.asin(math.sin(xi0) / math.cosh(eta0))
    phi = chi + sum(d * math.sin(2 * (j + 1) * chi) for j, d in enumerate(delta))
    return math.degrees(phi), 9 + math.degrees(math.atan2(math.sinh(eta0), math.cos(xi0)))


class Check:
    def __init__(self):
        self.failed = 0

    def __call__(self, good, text):
        print("ok  " if good else "FAIL", text)
        self.failed += not good


def check_stems(check, out, truth):
    errors, inside, of = [], 0, 0
    stems = rows(out / "stems.csv")
    for tree in truth:
        if int(tree["in_plot"]) != 1:
            continue
        e, n = to_global(float(tree["x_m"]), float(tree["y_m"]))
        near = min(stems, key=lambda s: math.hypot(float(s["easting_m"]) - e, float(s["northing_m"]) - n))
        de, dn = float(near["easting_m"]) - e, float(near["northing_m"]) - n
        errors.append(math.hypot(de, dn))
        se = float(near["position_se_m"])
        inside += (abs(de) <= 1.96 * se) + (abs(dn) <= 1.96 * se)
        of += 2
    errors.sort()
    print(f"{len(errors)} trees: error rms {100 * math.sqrt(sum(e * e for e in errors) / len(errors)):.2f} cm, median "
          f"{100 * errors[len(errors) // 2]:.2f} cm, largest {100 * errors[-1]:.2f} cm; {inside} of {of} coordinates within 1.96 se")
    check(errors[-1] < 0.01, "every tree in the plot within 1 cm of its true coordinates")
    check(inside >= 0.92 * of, "at least 92 % of the coordinates within 1.96 position_se_m")
    return stems


def check_las(check, path):
    with open(path, "rb") as file:
        data = file.read(200000)
    scale, offset = struct.unpack_from("<3d", data, 131), struct.unpack_from("<3d", data, 155)
    bounds = struct.unpack_from("<6d", data, 179)
    check(abs((bounds[0] + bounds[1]) / 2 - EAST) < 60 and abs((bounds[2] + bounds[3]) / 2 - NORTH) < 60,
          f"cloud.las lies about the plot (x {bounds[1]:.2f} to {bounds[0]:.2f}, y {bounds[3]:.2f} to {bounds[2]:.2f})")
    check(max(scale) <= 0.0001 and all(math.isfinite(o) for o in offset), "cloud.las has a grid of 0.1 mm or finer")
    header_size, count = struct.unpack_from("<H", data, 94)[0], struct.unpack_from("<I", data, 100)[0]
    at, wkt = header_size, ""
    for _ in range(count):
        user, number, length = data[at + 2:at + 18].rstrip(b"\0"), *struct.unpack_from("<HH", data, at + 18)
        if user == b"LASF_Projection" and number == 2112:
            wkt = data[at + 54:at + 54 + length].rstrip(b"\0").decode()
        at += 54 + length
    check(wkt.startswith("PROJCS[") and f'"{EPSG}"' in wkt, "cloud.las names the coordinate system as WKT")
    check(struct.unpack_from("<H", data, 6)[0] & 16, "cloud.las has the bit for WKT")


def geometry_point(blob):
    envelope = {0: 0, 1: 32, 2: 48, 3: 48, 4: 64}[(blob[3] >> 1) & 7]
    return struct.unpack_from("<2d", blob, 8 + envelope + 5)


def check_geopackage(check, path, stems):
    with sqlite3.connect(path) as base:
        layers = dict(base.execute("SELECT table_name, srs_id FROM gpkg_contents WHERE data_type = 'features'"))
        check(set(layers.values()) == {EPSG} and "stems" in layers and "control_points" in layers,
              f"all layers of plot.gpkg have the coordinate system ({layers})")
        found = dict((tree, geometry_point(shape)) for tree, shape in base.execute("SELECT tree_id, geom FROM stems"))
    worst = max(math.hypot(found[int(s["tree_id"])][0] - float(s["easting_m"]), found[int(s["tree_id"])][1] - float(s["northing_m"]))
                for s in stems)
    check(worst < 1e-4, f"stems of plot.gpkg lie at easting_m, northing_m ({worst * 1000:.3f} mm)")


def check_geojson(check, path, stems):
    layer = json.loads(path.read_text())
    check("crs" not in layer or "CRS84" in json.dumps(layer["crs"]), "stems.geojson is in WGS 84")
    by_id = {f["properties"]["tree_id"]: f["geometry"]["coordinates"] for f in layer["features"]}
    worst = 0
    for s in stems:
        latitude, longitude = degrees_of(float(s["easting_m"]), float(s["northing_m"]))
        lon, lat = by_id[int(s["tree_id"])][:2]
        worst = max(worst, abs(lat - latitude) * 111e3, abs(lon - longitude) * 73e3)
    check(worst < 0.001, f"stems.geojson has the degrees of easting and northing ({worst * 1000:.3f} mm)")


def tiff_tags(path):
    data = path.read_bytes()
    check_order = {b"II": "<", b"MM": ">"}[data[:2]]
    at = struct.unpack_from(check_order + "I", data, 4)[0]
    tags = {}
    for i in range(struct.unpack_from(check_order + "H", data, at)[0]):
        tag, kind, count = struct.unpack_from(check_order + "HHI", data, at + 2 + 12 * i)
        code, size = {2: ("s", 1), 3: ("H", 2), 4: ("I", 4), 12: ("d", 8)}.get(kind, (None, 0))
        if code is None:
            continue
        place = at + 2 + 12 * i + 8
        if count * size > 4:
            place = struct.unpack_from(check_order + "I", data, place)[0]
        tags[tag] = struct.unpack_from(f"{check_order}{count}{code}", data, place)
    return tags


def check_geotiff(check, path):
    tags = tiff_tags(path)
    keys = tags[34735]
    codes = {keys[i]: keys[i + 3] for i in range(4, len(keys), 4)}
    check(codes.get(3072) == EPSG, f"{path.name} has the coordinate system ({codes.get(3072)})")
    west, north = tags[33922][3:5]
    width, height, cell = tags[256][0], tags[257][0], tags[33550][0]
    check(abs(west + width * cell / 2 - EAST) < 40 and abs(north - height * cell / 2 - NORTH) < 40,
          f"{path.name} lies about the plot (from {west:.2f}, {north:.2f}, {width} x {height} cells of {cell} m)")


def show(check, out):
    for command, file in ((["gdalinfo"], "dem.tif"), (["ogrinfo", "-so", "-al"], "plot.gpkg"), (["ogrinfo", "-so", "-al"], "stems.geojson")):
        if shutil.which(command[0]) is None:
            print(f"{command[0]} is not installed: {file} was only read here")
            continue
        said = subprocess.run([*command, str(out / file)], capture_output=True, text=True).stdout
        check(("WGS 84" if file.endswith("json") else "UTM zone 32N") in said, f"{command[0]} shows the coordinate system of {file}")


def main():
    words = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    words.add_argument("--bole", required=True)
    words.add_argument("--work", required=True, type=pathlib.Path)
    words.add_argument("--pipeline", required=True, type=pathlib.Path)
    words.add_argument("--scan", type=pathlib.Path, help="a simulated plot that is there already")
    words.add_argument("--cache", type=pathlib.Path, help="stages that another run on this plot stored")
    words.add_argument("--set", action="append", default=[])
    options = words.parse_args()
    options.work.mkdir(parents=True, exist_ok=True)
    scan = options.scan or options.work / "scan"
    if options.scan is None:
        run([options.bole, "simulate", "--plot", "demo", "--seed", "1", "--out", scan])
    control = options.work / "control.csv"
    with open(control, "w") as file:
        print("name,easting_m,northing_m,height_m", file=file)
        for target in rows(scan / "targets.csv"):
            e, n = to_global(float(target["x_m"]), float(target["y_m"]))
            print(f"{target['name']},{e:.6f},{n:.6f},{HEIGHT + float(target['z_m']):.6f}", file=file)
    out = options.work / "survey"
    settings = [f"scan.file={scan}/walk.pcap", f"georeference.file={control}", f"georeference.crs=EPSG:{EPSG}",
                "plot.width=16", "plot.length=16", "report.figures=false", *options.set]
    stored = ["--cache", options.cache] if options.cache else []
    run([options.bole, "run", options.pipeline, "--out", out, *stored, "--set", "report.cloud_format=las", *[w for s in settings for w in ("--set", s)]])

    check = Check()
    stems = check_stems(check, out, rows(scan / "trees.csv"))
    check_las(check, out / "cloud.las")
    check_geopackage(check, out / "plot.gpkg", stems)
    check_geojson(check, out / "stems.geojson", stems)
    for grid in ("dem.tif", "slope.tif", "chm.tif"):
        check_geotiff(check, out / grid)
    check("25832" in (out / "report.html").read_text() or "UTM zone 32N" in (out / "report.html").read_text(),
          "report.html names the coordinate system")
    show(check, out)
    sys.exit(1 if check.failed else 0)


if __name__ == "__main__":
    main()
