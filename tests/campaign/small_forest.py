"""A small forest as a LAS file, made without any library: ground with relief, round stems, some crowns."""

import math
import random
import struct

STEP = 0.001


def ground_z(x, y):
    return 400 + 0.05 * x + 0.03 * y + 0.3 * math.sin(x / 6) * math.cos(y / 9)


def stems_of(size_m, seed, on_seams=(), gap_m=2.5):
    """[(x, y, radius)]: at random with at least gap_m between them, after those at given places."""
    chance, stems = random.Random(seed), [(x, y, r) for x, y, r in on_seams]
    for _ in range(4000):
        x, y, r = chance.uniform(2, size_m - 2), chance.uniform(2, size_m - 2), chance.uniform(0.08, 0.22)
        if all((x - a) ** 2 + (y - b) ** 2 > gap_m**2 for a, b, _ in stems):
            stems.append((x, y, r))
    return stems


def points_of(size_m, stems, seed):
    chance = random.Random(seed)
    uniform, gauss = chance.uniform, chance.gauss
    for i in range(int(size_m / 0.12) ** 2):
        x, y = uniform(0, size_m), uniform(0, size_m)
        yield x, y, ground_z(x, y) + gauss(0, 0.01)
    for x, y, r in stems:
        z0 = ground_z(x, y)
        lean, towards = uniform(0, 0.03), uniform(0, 2 * math.pi)
        for _ in range(int(5000 * r / 0.15)):
            h, a = uniform(0, 5), uniform(0, 2 * math.pi)
            rho = r * (1 - 0.02 * (h - 1.3)) + gauss(0, 0.006)
            yield x + lean * h * math.cos(towards) + rho * math.cos(a), y + lean * h * math.sin(towards) + rho * math.sin(a), z0 + h
        for _ in range(900):
            h = uniform(5, 14)
            spread, a = (14 - h) / 9 * 2.0 * math.sqrt(uniform(0, 1)), uniform(0, 2 * math.pi)
            yield x + spread * math.cos(a), y + spread * math.sin(a), z0 + h


def write_las(path, points, origin=(500000.0, 5400000.0, 0.0)):
    """Format 0 of LAS 1.2, in steps of a millimetre. Returns the number of points."""
    records, low, high = bytearray(), [1 << 31] * 3, [-(1 << 31)] * 3
    pack = struct.Struct("<iiiHBBbBH").pack
    count = 0
    for p in points:
        v = [round(c / STEP) for c in p]
        low, high = [min(a, b) for a, b in zip(low, v)], [max(a, b) for a, b in zip(high, v)]
        records += pack(*v, 0, 9, 1, 0, 0, 0)
        count += 1
    header = bytearray(227)
    header[0:4], header[24], header[25] = b"LASF", 1, 2
    struct.pack_into("<HI", header, 94, 227, 227)
    struct.pack_into("<BHI", header, 104, 0, 20, count)
    struct.pack_into("<I", header, 111, count)
    struct.pack_into("<6d", header, 131, STEP, STEP, STEP, *origin)
    for k in range(3):
        struct.pack_into("<2d", header, 179 + 16 * k, high[k] * STEP + origin[k], low[k] * STEP + origin[k])
    with open(path, "wb") as file:
        file.write(header)
        file.write(records)
    return count


def write_forest(path, size_m=44.0, seed=1, on_seams=(), gap_m=2.5):
    stems = stems_of(size_m, seed, on_seams, gap_m)
    write_las(path, points_of(size_m, stems, seed + 1))
    return stems
