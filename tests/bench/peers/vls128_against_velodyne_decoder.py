#!/usr/bin/env python3
"""Compares the reader of VLS-128 captures with velodyne_decoder, point for point.

    vls128_against_velodyne_decoder.py BUILD_DIR

BUILD_DIR holds bin/scan_dump. The packets are written here, from the manual (63-9483): random ranges, ten revolutions per
second, single and dual return. Compared are the number of points, and the places of those whose ring and range no other
point shares.

velodyne_decoder 3.0 and later adds to the height of each point that of its laser on the axis, -58.63 mm * tan(elevation): the
beams cross 58.63 mm in front of the axis (calib_db.cpp). Bole and velodyne_pointcloud do not. Points of lasers more than about
11 degrees from the horizontal get another range by it, so they find no partner, or by chance a wrong one. Near points of the
other lasers differ in direction. Together they are 2 to 3 % of the pairs.

Needs velodyne-decoder and numpy in the Python that runs it; without them it says so and ends with success.
"""
import json
import pathlib
import struct
import subprocess
import sys
import tempfile

try:
    import numpy as np
    import velodyne_decoder as vd
except ImportError as error:
    print(f"SKIPPED: {error}; pip install velodyne-decoder")
    sys.exit(0)

SEQUENCE_S = 53.3e-6
FLAGS = (0xEEFF, 0xDDFF, 0xCCFF, 0xBBFF)
MAX_DISTANCE = 1.2e-3  # of the range: azimuths are rounded to 0.01 degrees at each end of the interpolation, 0.06 degrees between the conventions


def write_capture(path, seconds, dual):
    random = np.random.default_rng(3)
    out = [struct.pack("<IHHiIII", 0xA1B2C3D4, 2, 4, 0, 0, 65535, 1)]
    sequences = 1 if dual else 3
    for packet in range(int(seconds / (SEQUENCE_S * sequences))):
        payload = b""
        start_s = packet * sequences * SEQUENCE_S
        for s in range(sequences):
            azimuth = int(round((start_s + s * SEQUENCE_S) * 36000 * 10)) % 36000
            for bank in range(4):
                for echo in range(2 if dual else 1):
                    block = struct.pack("<HH", FLAGS[bank], azimuth)
                    for counts in random.integers(1000, 30000, 32):
                        block += struct.pack("<HB", counts, 1 + echo)
                    payload += block
        payload = payload.ljust(1200, b"\0") + struct.pack("<IBB", int(start_s * 1e6), 0x39 if dual else 0x37, 0xA1)
        frame = b"\2" * 12 + b"\x08\x00" + struct.pack(">BBHHHBBHII", 0x45, 0, 20 + 8 + 1206, 0, 0, 64, 17, 0, 0x0A000001, 0x0A000002) + struct.pack(">HHHH", 2368, 2368, 8 + 1206, 0) + payload
        out.append(struct.pack("<IIII", int(start_s), int(start_s % 1 * 1e6), len(frame), len(frame)) + frame)
    path.write_bytes(b"".join(out))


def unique_places(rings, points):
    """Index of each point by its ring and range, of those that no other point shares."""
    counts = np.rint(np.linalg.norm(points.astype(float), axis=1) / 0.004).astype(np.int64)
    keys = rings.astype(np.int64) * 1_000_000 + counts
    _, first, number = np.unique(keys, return_index=True, return_counts=True)
    return {int(keys[i]): int(i) for i in first[number == 1]}


def compare(dump, dual):
    with tempfile.TemporaryDirectory() as folder:
        capture = pathlib.Path(folder) / "walk.pcap"
        write_capture(capture, 0.35, dual)
        done = subprocess.run([str(dump), str(capture), f"{folder}/ours", "max_range=1000", "keep_partial_frames=true"], capture_output=True, text=True)
        if done.returncode != 0:
            return done.stderr.strip()
        ours = json.loads(done.stdout)
        points = np.fromfile(f"{folder}/ours.positions", dtype=np.float32).reshape(-1, 3)
        rings = np.fromfile(f"{folder}/ours.rings", dtype=np.uint16)
        theirs = [(time, cloud) for time, cloud in vd.read_pcap(str(capture), vd.Config(model=vd.Model.AlphaPrime, cut_angle=None, max_range=400), as_pcl_structs=True)]
    if ours["sensor"] != "vls128":
        return f"taken for {ours['sensor']}"
    cloud = np.concatenate([c for _, c in theirs])
    their_points = np.column_stack([cloud["x"], cloud["y"], cloud["z"]])
    if abs(len(points) - len(their_points)) > 0.01 * len(points):
        return f"{len(points)} points, velodyne_decoder has {len(their_points)}"
    mine, other = unique_places(rings, points), unique_places(cloud["ring"], their_points)
    common = [(mine[k], other[k]) for k in mine.keys() & other.keys()]
    a, b = np.array(common).T
    distance = np.linalg.norm(points[a] - their_points[b], axis=1) / np.linalg.norm(points[a], axis=1)
    good = np.median(distance)
    share = np.mean(distance < MAX_DISTANCE)
    print(f"{'dual' if dual else 'single'}: {len(points)} and {len(their_points)} points, {len(common)} with the same ring and range; distance over range: median {good * 1e3:.3f}, 99 % {np.quantile(distance, 0.99) * 1e3:.3f} per mille")
    return None if len(common) > 0.5 * len(points) and share > 0.97 else f"{(1 - share) * 100:.1f} % of the points differ"


def main():
    errors = [e for e in (compare(pathlib.Path(sys.argv[1]) / "bin" / "scan_dump", dual) for dual in (False, True)) if e]
    print("\n".join(errors) or "equal")
    return 1 if errors else 0


if __name__ == "__main__":
    sys.exit(main())
