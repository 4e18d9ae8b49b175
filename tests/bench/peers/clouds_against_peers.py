#!/usr/bin/env python3
"""Compares clouds read by bounds, by resolution and from E57 with laspy and pye57, point for point.

    clouds_against_peers.py BUILD_DIR [FILE...]

BUILD_DIR holds bin/las_dump. COPC files are written by copclib (tests/data/copc/make_fixture.py), E57 files by pye57
(several scans with poses, intensities and colours), and the given files (.las, .laz, .copc.laz, .e57) are added. What a
package is missing for is skipped, with a line that says so.
"""
import json
import pathlib
import subprocess
import sys
import tempfile

try:
    import numpy as np
except ImportError as error:
    print(f"SKIPPED: {error}")
    sys.exit(0)

sys.path.insert(0, str(pathlib.Path(__file__).parents[2] / "data" / "copc"))


def peer(name):
    try:
        return __import__(name)
    except ImportError as error:
        print(f"SKIPPED what needs {name}: {error}")
        return None


laspy, copclib, pye57 = peer("laspy"), peer("copclib"), peer("pye57")
failures = 0


def ours(build, folder, path, bounds="", resolution=0.0):
    out = folder / "ours.json"
    done = subprocess.run([str(build / "bin/las_dump"), "--cloud", str(path), str(out), bounds, str(resolution)], capture_output=True, text=True)
    if done.returncode != 0:
        return None, done.stderr.strip()
    info = json.loads(out.read_text())
    return {name: np.fromfile(f"{out}.{name}", dtype=kind) for name, kind in (info["columns"] or {}).items()}, info


def check(what, good, note=""):
    global failures
    failures += not good
    print(f"{'equal' if good else 'DIFFERENT':10} {what} {note}")


def rows(step, *columns):
    """Coordinates as steps of the grid, and further columns, in an order of their own."""
    table = np.stack([np.asarray(c, dtype=np.float64) / (step[i] if i < 3 else 1) for i, c in enumerate(columns)], axis=1)
    return table[np.lexsort(np.round(table).T[::-1])]


def same(mine, theirs):
    """Within half a step; a cloud of more than 2^23 steps is rounded to float32 (the reader warns), and is compared by that."""
    if mine.shape != theirs.shape:
        return False
    wide = np.ptp(theirs[:, :3], axis=0) if len(theirs) else np.zeros(3)
    tolerance = np.maximum(0.5, wide * 2.0**-24)
    if np.any(tolerance > 0.5):
        return all(np.all(np.abs(np.sort(mine[:, k]) - np.sort(theirs[:, k])) <= tolerance[k]) for k in range(3))
    return np.all(np.abs(mine[:, :3] - theirs[:, :3]) <= tolerance) and np.array_equal(mine[:, 3:], theirs[:, 3:])


def compare_las(build, folder, path):
    """Thirds of the file in the plan, whole, and for COPC by resolution."""
    las = laspy.read(path)
    x, y, z = (np.asarray(v) for v in (las.x, las.y, las.z))
    if len(x) == 0:
        cloud, info = ours(build, folder, path)
        check(path.name, cloud is not None and len(cloud["x"]) == 0, "no points")
        return
    # Less than half a step outside of the grid of the coordinates: no point lies on an edge, and laspy, which rounds bounds to
    # the grid, means the same.
    def edge(values, share, axis, side):
        scale, offset = las.header.scales[axis], las.header.offsets[axis]
        return float((np.round((np.quantile(values, share) - offset) / scale) + 0.4 * side) * scale + offset)

    box = [edge(x, 0.3, 0, -1), edge(y, 0.2, 1, -1), edge(x, 0.6, 0, 1), edge(y, 0.7, 1, 1)]
    inside = (x >= box[0]) & (x <= box[2]) & (y >= box[1]) & (y <= box[3])
    step = np.asarray(las.header.scales)
    text = ",".join(repr(float(v)) for v in box)
    for name, keep, bounds in (("whole", np.ones(len(x), bool), ""), ("bounds", inside, text)):
        cloud, info = ours(build, folder, path, bounds)
        if cloud is None:
            check(f"{path.name} {name}", False, info)
            continue
        mine = rows(step, cloud["x"], cloud["y"], cloud["z"], cloud.get("intensity", np.zeros(len(cloud["x"]))))
        theirs = rows(step, x[keep], y[keep], z[keep], np.asarray(las.intensity)[keep])
        check(f"{path.name} {name}", same(mine, theirs), f"{len(mine)} of {len(x)} points")
    if not path.name.endswith(".copc.laz"):
        return
    with laspy.CopcReader.open(path) as reader:
        spacing = reader.copc_info.spacing
        area = laspy.copc.Bounds(mins=np.array(box[:2]), maxs=np.array(box[2:]))
        for resolution in (2 * spacing, spacing, 0.6 * spacing, 0.5 * spacing, 0.2 * spacing):
            for bounds, query in (("", None), (text, area)):
                theirs = reader.query(bounds=query, resolution=resolution)
                cloud, info = ours(build, folder, path, bounds, resolution)
                if cloud is None:
                    check(f"{path.name} resolution {resolution:g}", len(theirs) == 0, info)
                    continue
                mine = rows(step, cloud["x"], cloud["y"], cloud["z"])
                wanted = rows(step, np.asarray(theirs.x), np.asarray(theirs.y), np.asarray(theirs.z))
                check(f"{path.name} resolution {resolution:g} {'in bounds' if bounds else ''}", same(mine, wanted), f"{len(mine)} points")


def compare_e57(build, folder, path):
    cloud, info = ours(build, folder, path)
    try:
        file = pye57.E57(str(path))
        scans = [file.read_scan(i, ignore_missing_fields=True, intensity=True, colors=True) for i in range(file.scan_count)]
    except Exception as error:
        check(f"{path.name}", True, f"pye57 refuses it ({str(error).splitlines()[0][:60]}); ours: {info if cloud is None else str(len(cloud['x'])) + ' points'}")
        return
    if cloud is None:
        check(path.name, False, info)
        return
    merged = {key: np.concatenate([s[key] for s in scans]) for key in scans[0]} if scans else {}
    if not merged or len(merged["cartesianX"]) == 0:
        check(path.name, len(cloud["x"]) == 0, "no points")
        return
    equal = len(cloud["x"]) == len(merged["cartesianX"])
    # Offsets are float32: up to 0.1 mm at 1 km.
    worst = max(np.max(np.abs(cloud[a] - merged[f"cartesian{a.upper()}"])) for a in "xyz") if equal else float("nan")
    equal = equal and worst < 1e-4
    if "intensity" in merged and "intensity" in cloud:
        equal = equal and np.allclose(cloud["intensity"], merged["intensity"].astype(np.float32))
    if "colorRed" in merged:
        equal = equal and all(np.array_equal(cloud[c], merged[f"color{c.capitalize()}"].astype(np.uint16) * 257) for c in ("red", "green", "blue"))
    if "sensor_x" in cloud:
        number = np.concatenate([np.full(len(s["cartesianX"]), i) for i, s in enumerate(scans)])
        at = np.array([file.get_header(i).translation for i in range(file.scan_count)])[number]
        d = np.stack([cloud[a] for a in "xyz"], axis=1) - at
        equal = equal and np.allclose(np.linalg.norm(d, axis=1), cloud["range"], atol=1e-3)
    check(path.name, equal, f"{len(cloud['x'])} points of {len(scans)} scans, {worst:.1e} m, rays {'yes' if 'sensor_x' in cloud else 'no'}")


def make_e57(path, poses):
    rng = np.random.default_rng(3)
    with pye57.E57(str(path), mode="w") as file:
        for k, (rotation, translation) in enumerate(poses):
            n = 20000 + 1000 * k
            bearing, distance = rng.uniform(0, 2 * np.pi, n), rng.uniform(1, 30, n)
            data = {"cartesianX": distance * np.cos(bearing), "cartesianY": distance * np.sin(bearing), "cartesianZ": rng.uniform(-1.5, 12, n), "intensity": rng.uniform(0, 1, n)}
            for colour in ("colorRed", "colorGreen", "colorBlue"):
                data[colour] = rng.integers(0, 256, n).astype(np.uint8)
            file.write_scan_raw(data, rotation=np.array(rotation), translation=np.array(translation), name=f"station {k}")


def main():
    build = pathlib.Path(sys.argv[1])
    files = [pathlib.Path(f) for f in sys.argv[2:]]
    with tempfile.TemporaryDirectory() as temporary:
        folder = pathlib.Path(temporary)
        if laspy:
            from shutil import copyfile
            small = folder / "fixture.copc.laz"
            copyfile(pathlib.Path(__file__).parents[2] / "data/copc/octree.copc.laz", small)
            files.append(small)
        if laspy and copclib:
            import make_fixture
            for count, levels, capacity in ((20000, 5, 200), (5000, 3, 5)):
                files.append(folder / f"points{count}.copc.laz")
                make_fixture.write(files[-1], count, levels, capacity)
        if pye57:
            half = np.sqrt(0.5)
            files.append(folder / "stations.e57")
            make_e57(files[-1], [((1, 0, 0, 0), (0, 0, 0)), ((half, 0, 0, half), (12, 3, 0.4)), ((half, 0, half, 0), (-8, 21, 1.5))])
            files.append(folder / "one.e57")
            make_e57(files[-1], [((1, 0, 0, 0), (0, 0, 0))])
        for path in files:
            if path.suffix == ".e57" and pye57:
                compare_e57(build, folder, path)
            elif path.suffix in (".las", ".laz") and laspy:
                compare_las(build, folder, path)
    print("all equal" if failures == 0 else f"{failures} differ")
    return failures != 0


if __name__ == "__main__":
    sys.exit(main())
