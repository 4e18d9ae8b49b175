#!/usr/bin/env python3
"""Writes the COPC file of this folder, and such files for tests/bench/peers/clouds_against_peers.py.

    make_fixture.py OUT.copc.laz [POINTS [LEVELS [CAPACITY]]]

Needs copclib and numpy: pip install copclib numpy. The tests need neither. Points lie on a wavy ground and on upright
stems; each node of the octree keeps the first CAPACITY of
them and hands the others down. The branch of the first child of the root has a page of its own.
"""
import sys

import copclib as copc
import numpy as np

SCALE, HALF = 0.001, 16.0
CENTRE = np.array([500016.0, 5400016.0, 116.0])
WKT = 'PROJCS["made for a test",GEOGCS["GRS 1980",DATUM["unknown",SPHEROID["GRS 1980",6378137,298.257222101]],PRIMEM["Greenwich",0],UNIT["degree",0.0174532925199433]],PROJECTION["Transverse_Mercator"],PARAMETER["central_meridian",9],PARAMETER["scale_factor",0.9996],PARAMETER["false_easting",500000],UNIT["metre",1]]'


def make_points(count, rng):
    xyz = np.empty((count, 3))
    xyz[:, :2] = rng.uniform(0, 2 * HALF, (count, 2))
    xyz[:, 2] = 2 + np.sin(xyz[:, 0] / 3) + np.cos(xyz[:, 1] / 4)
    stem = rng.random(count) < 0.4
    angle = rng.uniform(0, 2 * np.pi, stem.sum())
    middle = rng.integers(1, 8, (stem.sum(), 2)) * 4.0
    xyz[stem, :2] = middle + 0.15 * np.c_[np.cos(angle), np.sin(angle)]
    xyz[stem, 2] += rng.uniform(0, 12, stem.sum())
    return xyz + CENTRE - HALF


def write(path, count=3000, levels=4, capacity=60, seed=1):
    rng = np.random.default_rng(seed)
    xyz = make_points(count, rng)
    config = copc.CopcConfigWriter(7, copc.Vector3(SCALE, SCALE, SCALE), copc.Vector3(*(CENTRE - HALF)), WKT)
    config.copc_info.center_x, config.copc_info.center_y, config.copc_info.center_z = CENTRE
    config.copc_info.halfsize = HALF
    config.copc_info.spacing = 2 * HALF / 32
    stored = np.round((xyz - (CENTRE - HALF)) / SCALE).astype(int)
    config.las_header.min = copc.Vector3(*((CENTRE - HALF) + SCALE * stored.min(0)))
    config.las_header.max = copc.Vector3(*((CENTRE - HALF) + SCALE * stored.max(0)))
    writer = copc.FileWriter(str(path), config)
    nodes = {}
    for i in range(count):
        for level in range(levels):
            cell = np.minimum((stored[i] * SCALE / (2 * HALF) * 2**level).astype(int), 2**level - 1)
            points = nodes.setdefault((level, *map(int, cell)), [])
            if level == levels - 1 or len(points) < capacity:
                points.append(i)
                break
    for key in sorted(nodes):
        points = copc.Points(writer.copc_config.las_header)
        for i in nodes[key]:
            p = points.CreatePoint()
            p.x, p.y, p.z = (CENTRE - HALF) + SCALE * stored[i]
            p.intensity = int(i % 60000)
            p.gps_time = 3e8 + 0.01 * i
            p.classification = 2 if i % 3 else 5
            p.return_number, p.number_of_returns = 1, 1 + i % 2
            p.red, p.green, p.blue = int(i % 65536), 257, 514
            points.AddPoint(p)
        shift = key[0] - 1
        own = key[0] >= 1 and all(k >> shift == 0 for k in key[1:])
        writer.AddNode(copc.VoxelKey(*key), points, copc.VoxelKey(1, 0, 0, 0) if own else copc.VoxelKey(0, 0, 0, 0))
    writer.Close()


if __name__ == "__main__":
    write(sys.argv[1], *map(int, sys.argv[2:]))
