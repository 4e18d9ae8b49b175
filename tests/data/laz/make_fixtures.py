#!/usr/bin/env python3
"""Writes the LAZ fixtures of this folder and expected.csv (FNV-1a hash of the uncompressed point records).

Needs numpy and lazrs (the Rust LAZ encoder): pip install lazrs numpy. The tests need neither.
Points are a random walk with steps back, so that every field changes and stays by turns.
"""
import csv
import io
import pathlib
import struct
import sys

import numpy as np

SIZES = [20, 28, 26, 34, 57, 63, 30, 36, 38, 59, 67]
HAS_TIME = {1, 3, 4, 5, 6, 7, 8, 9, 10}
HAS_RGB = {2, 3, 5, 7, 8, 10}
HAS_NIR = {8, 10}
HAS_WAVE = {4, 5, 9, 10}
EXTRA = [("range", 9, "<f4"), ("tree_id", 6, "<i4"), ("amplitude", 4, "<i2"), ("planarity", 1, "u1")]
VARIABLE = 0xFFFFFFFF


def fields(point_format):
    legacy = [("x", "<i4"), ("y", "<i4"), ("z", "<i4"), ("intensity", "<u2"), ("returns", "u1")]
    if point_format < 6:
        out = legacy + [("classification", "u1"), ("scan_angle", "i1"), ("user_data", "u1"), ("source", "<u2")]
    else:
        out = legacy + [("flags", "u1"), ("classification", "u1"), ("user_data", "u1"), ("scan_angle", "<i2"), ("source", "<u2")]
    if point_format in HAS_TIME:
        out.append(("time", "<f8"))
    if point_format in HAS_RGB:
        out += [("red", "<u2"), ("green", "<u2"), ("blue", "<u2")]
    if point_format in HAS_NIR:
        out.append(("nir", "<u2"))
    if point_format in HAS_WAVE:
        out += [("wave_index", "u1"), ("wave_offset", "<u8"), ("wave_size", "<u4"), ("wave_t", "<f4"), ("wave_x", "<f4"), ("wave_y", "<f4"), ("wave_z", "<f4")]
    return out


def make_points(point_format, count, seed, extra=False, wild=False):
    """A structured array of `count` point records. `wild`: every field is noise of its full range."""
    rng = np.random.default_rng(seed)
    names = fields(point_format) + ([(n, t) for n, _, t in EXTRA] if extra else [])
    points = np.zeros(count, dtype=names)
    if wild:
        raw = rng.integers(0, 256, count * points.dtype.itemsize, dtype=np.uint8)
        points = np.frombuffer(raw.tobytes(), dtype=names).copy()
        return points
    points["x"] = 12_345_000 + np.cumsum(rng.integers(-40, 45, count)) + 3000 * (rng.random(count) < 0.02)
    points["y"] = -2_345_000 + np.cumsum(rng.integers(-60, 60, count))
    points["z"] = 412_000 + np.cumsum(rng.integers(-300, 310, count))
    points["intensity"] = np.clip(900 + np.cumsum(rng.integers(-30, 31, count)), 0, 65535)
    most = 7 if point_format < 6 else 15
    n = rng.choice([1, 1, 1, 2, 3, most], count)
    r = 1 + rng.integers(0, 100, count) % n
    if point_format < 6:
        points["returns"] = r | n << 3 | (rng.random(count) < 0.5).astype(int) << 6 | (rng.random(count) < 0.05).astype(int) << 7
        points["classification"] = rng.choice([1, 2, 5], count) | (rng.random(count) < 0.05).astype(int) << 5 | (rng.random(count) < 0.05).astype(int) << 7
        points["scan_angle"] = np.clip(np.cumsum(rng.integers(-2, 3, count)), -90, 90)
    else:
        channel = np.cumsum(rng.random(count) < 0.15) % 3
        if point_format in HAS_WAVE:
            channel[:] = 0  # lazrs 0.8 does not read back its own wave packets when the channel changes
        points["returns"] = r | n << 4
        points["flags"] = rng.choice([0, 0, 0, 1, 4, 8], count) | channel << 4 | (rng.random(count) < 0.5).astype(int) << 6 | (rng.random(count) < 0.05).astype(int) << 7
        points["classification"] = rng.choice([1, 2, 5, 40, 200], count)
        points["scan_angle"] = np.clip(np.cumsum(rng.integers(-200, 201, count)), -30000, 30000)
    points["user_data"] = rng.choice([0, 0, 0, 7, 9], count)
    points["source"] = 100 + np.cumsum(rng.random(count) < 0.03)
    if point_format in HAS_TIME:
        step = rng.choice([0, 0, 1, 1, 1, 2, -3, 20, 700], count) * 2.5e-6 + (rng.random(count) < 0.02) * 1000.0 - (rng.random(count) < 0.02) * 1e9
        points["time"] = 3.1e8 + np.cumsum(step)
    if point_format in HAS_RGB:
        grey = rng.random(count) < 0.3
        for i, name in enumerate(("red", "green", "blue")):
            walk = (20000 + 3000 * i + np.cumsum(rng.integers(-400, 401, count))) % 65536
            points[name] = np.where(grey & (i > 0), points["red"], walk)
    if point_format in HAS_NIR:
        points["nir"] = (30000 + np.cumsum(rng.integers(-300, 301, count))) % 65536
    if point_format in HAS_WAVE:
        points["wave_index"] = rng.integers(0, 3, count)
        points["wave_size"] = rng.choice([128, 128, 256], count)
        jump = rng.choice([0, 1, 2, 3], count, p=[0.1, 0.6, 0.2, 0.1])
        offset = 60
        for i in range(count):
            offset += [0, int(points["wave_size"][i - 1]), 1000, 1 << 33][jump[i]] if i else 0
            points["wave_offset"][i] = offset
        points["wave_t"] = 1000 * rng.random(count)
        for axis in "xyz":
            points["wave_" + axis] = 1e-4 * rng.standard_normal(count)
    if extra:
        points["range"] = 20 + np.cumsum(0.1 * rng.standard_normal(count))
        points["tree_id"] = rng.integers(0, 4, count)
        points["amplitude"] = np.cumsum(rng.integers(-9, 10, count))
        points["planarity"] = rng.integers(0, 256, count)
    return points


def vlr(user_id, record_id, data, description=""):
    return struct.pack("<H16sHH32s", 0, user_id.encode(), record_id, len(data), description.encode()) + data


def extra_bytes_vlr():
    out = b""
    for name, kind, _ in EXTRA:
        out += struct.pack("<HBB32s4s24s24s24s24s24s32s", 0, kind, 0, name.encode(), b"", b"", b"", b"", b"", b"", b"made up")
    return vlr("LASF_Spec", 4, out, "extra bytes")


def header(point_format, points, record_length, vlrs, compressed, minor=None):
    minor = minor if minor is not None else (4 if point_format >= 6 or record_length > SIZES[point_format] else 3 if point_format >= 4 else 2)
    size = {4: 375, 3: 235}.get(minor, 227)
    scale, offset = (0.001, 0.001, 0.001), (500000.0, 5400000.0, 0.0)
    count = len(points)
    x, y, z = (points[a].astype(np.int64) for a in "xyz")
    box = []
    for k, a in enumerate((x, y, z)):
        box += [a.max() * scale[k] + offset[k], a.min() * scale[k] + offset[k]]
    legacy = point_format < 6
    r = points["returns"] & (7 if legacy else 15)
    by_return = [int((r == i + 1).sum()) for i in range(15)]
    out = struct.pack("<4sHHIHH8sBB32s32sHHHIIBH", b"LASF", 0, 16 if not legacy else 0, 0, 0, 0, b"", 1, minor, b"BOLE", b"make_fixtures.py", 1, 2024, size,
                      size + sum(map(len, vlrs)), len(vlrs), point_format | (0x80 if compressed else 0), record_length)
    out += struct.pack("<I5I", count if legacy else 0, *(by_return[:5] if legacy else [0] * 5))
    out += struct.pack("<12d", *scale, *offset, *box)
    if minor >= 3:
        out += struct.pack("<Q", 0)
    if minor >= 4:
        out += struct.pack("<QIQ15Q", 0, 0, count, *by_return)
    assert len(out) == size
    return out


def las_bytes(point_format, points, extra=False):
    vlrs = [extra_bytes_vlr()] if extra else []
    return header(point_format, points, points.dtype.itemsize, vlrs, False) + b"".join(vlrs) + points.tobytes()


def packing_record(point_format, extra_size, chunk_size, old=False):
    """The LAZ record. `old`: version 1 of the pointwise algorithms."""
    version = 3 if point_format >= 6 else (1 if old else 2)
    if point_format < 6:
        items = [(6, 20, version)] + ([(7, 8, version)] if point_format in HAS_TIME else []) + ([(8, 6, version)] if point_format in HAS_RGB else [])
        items += ([(9, 29, 1)] if point_format in HAS_WAVE else []) + ([(0, extra_size, version)] if extra_size else [])
    else:
        items = [(10, 30, 3)] + ([(12, 8, 3)] if point_format in HAS_NIR else [(11, 6, 3)] if point_format in HAS_RGB else [])
        items += ([(13, 29, 3)] if point_format in HAS_WAVE else []) + ([(14, extra_size, 3)] if extra_size else [])
    out = struct.pack("<HHBBHIIqqH", 3 if point_format >= 6 else 2, 0, 3, 4, 0, 0, chunk_size, -1, -1, len(items))
    return out + b"".join(struct.pack("<HHH", *item) for item in items)


def laz_bytes(point_format, points, chunk_size, extra=False, old=False, chunks=None):
    """`chunks`: numbers of points, for chunks of varying size."""
    import lazrs

    record = packing_record(point_format, points.dtype.itemsize - SIZES[point_format], VARIABLE if chunks else chunk_size, old)
    vlrs = ([extra_bytes_vlr()] if extra else []) + [vlr("laszip encoded", 22204, record, "LAZ")]
    out = io.BytesIO()
    out.write(header(point_format, points, points.dtype.itemsize, vlrs, True) + b"".join(vlrs))
    compressor = lazrs.LasZipCompressor(out, lazrs.LazVlr(record))
    if chunks:
        at = 0
        for size in chunks:
            compressor.compress_many(np.frombuffer(points[at:at + size].tobytes(), np.uint8))
            compressor.finish_current_chunk()
            at += size
    else:
        compressor.compress_many(np.frombuffer(points.tobytes(), np.uint8))
    compressor.done()
    return out.getvalue()


def fnv(data):
    value = 0xCBF29CE484222325
    for byte in data:
        value = (value ^ byte) * 0x100000001B3 & 0xFFFFFFFFFFFFFFFF
    return value


def main():
    folder = pathlib.Path(sys.argv[1]) if len(sys.argv) > 1 else pathlib.Path(__file__).parent
    rows = []
    cases = [(f"format{f}", f, {}) for f in range(11)]
    cases += [("format3_extra", 3, {"extra": True}), ("format7_extra", 7, {"extra": True}), ("format6_variable", 6, {"chunks": [150, 30, 1, 119]}), ("format1_old", 1, {"old": True})]
    for name, point_format, how in cases:
        points = make_points(point_format, 300, 100 + point_format, extra=how.get("extra", False))
        (folder / f"{name}.laz").write_bytes(laz_bytes(point_format, points, 70, **how))
        rows.append([f"{name}.laz", point_format, len(points), points.dtype.itemsize, f"{fnv(points.tobytes()):016x}"])
    with open(folder / "expected.csv", "w", newline="") as file:
        csv.writer(file, lineterminator="\n").writerows([["file", "point_format", "points", "record_length", "fnv1a"]] + rows)


if __name__ == "__main__":
    main()
