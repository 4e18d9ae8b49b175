#!/usr/bin/env python3
"""Writes apple_passes.csv: the two passes of ../shared/data/orchard_apple_mtls/gnss_track_first_pass.txt, measured by numpy alone.

The line is the orthogonal fit to the first stretch whose direction of motion keeps within 10 degrees. A pass is where the direction
is within 10 degrees of the line or of its reverse, less 5 m at its beginning and 3 m at its end. Offsets are positive to the
left of the direction of motion of the pass.
"""

import pathlib
import sys

import numpy as np

RUN_IN_M, RUN_OUT_M, ANGLE_RAD, LOOK_M = 5, 3, np.radians(10), 1.0


def directions(p):
    """Direction of motion at each fix, between those a metre before and behind it."""
    result = np.full(len(p), np.nan)
    for i in range(len(p)):
        distance = np.hypot(*(p - p[i]).T)
        before = np.flatnonzero(distance[:i] >= LOOK_M)
        behind = np.flatnonzero(distance[i:] >= LOOK_M)
        a = before[-1] if len(before) else 0
        b = i + behind[0] if len(behind) else len(p) - 1
        result[i] = np.arctan2(*(p[b] - p[a])[::-1])
    return result


def off(yaw, wanted):
    return np.abs(np.angle(np.exp(1j * (yaw - wanted))))


def main():
    columns = np.loadtxt(sys.argv[1])
    p = columns[:, 2:4] - columns[:, 2:4].mean(axis=0)
    yaw = directions(p)
    end = next(i for i in range(len(p)) if off(yaw[i], yaw[0]) >= ANGLE_RAD and i > 100)
    stretch = p[:end]
    centre = stretch.mean(axis=0)
    along = np.linalg.svd(stretch - centre, full_matrices=False)[2][0]
    along *= np.sign((stretch[-1] - stretch[0]) @ along)
    left = np.array([-along[1], along[0]])
    heading = np.arctan2(along[1], along[0])
    lines = ["# Made by make_apple_passes.py", "direction,samples,line_mean_m,line_sd_m,line_max_m"]
    for direction in (1, -1):
        fits = np.flatnonzero(off(yaw, heading + (0 if direction > 0 else np.pi)) < ANGLE_RAD)
        longest = max(np.split(fits, np.flatnonzero(np.diff(fits) > 5) + 1), key=len)
        way = direction * ((p[longest[0]:longest[-1] + 1] - centre) @ along)
        kept = p[longest[0]:longest[-1] + 1][(way - way[0] >= RUN_IN_M) & (way[-1] - way >= RUN_OUT_M)]
        offset = direction * ((kept - centre) @ left)
        lines.append(f"{direction},{len(kept)},{offset.mean():.4f},{offset.std():.4f},{np.abs(offset).max():.4f}")
    pathlib.Path(__file__).with_name("apple_passes.csv").write_text("\n".join(lines) + "\n")


if __name__ == "__main__":
    main()
