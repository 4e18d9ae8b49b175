#!/usr/bin/env python3
"""Writes apple_passes.csv: the two passes of ../shared/data/orchard_apple_mtls/gnss_track_first_pass.txt, measured by numpy alone.

The fixes go through a position-velocity Kalman filter first (SPEC E3; 1 cm, 0.3 m/s2, gate of 5 sigma for 2 s), as in steering.navigate. The line is the orthogonal fit to the first stretch whose direction of motion keeps within 10 degrees. A pass is where the direction
is within 10 degrees of the line or of its reverse, less 5 m at its beginning and 3 m at its end. Offsets are positive to the
left of the direction of motion of the pass.
"""

import pathlib
import sys

import numpy as np

RUN_IN_M, RUN_OUT_M, ANGLE_RAD, LOOK_M = 5, 3, np.radians(10), 1.0


def seconds(hhmmss):
    return 3600 * np.floor(hhmmss / 1e4) + 60 * np.floor(hhmmss % 1e4 / 100) + hhmmss % 100


def filtered(t, p, sigma=0.01, acceleration=0.3, gate=5, patience=2):
    """State x, vx, y, vy; the first velocity is that of the first second."""
    later = np.searchsorted(t, t[0] + 1)
    velocity = (p[later] - p[0]) / (t[later] - t[0])
    x = np.array([p[0, 0], velocity[0], p[0, 1], velocity[1]])
    start = np.diag([sigma**2, 1, sigma**2, 1])
    P, H, R = start, np.array([[1, 0, 0, 0], [0, 0, 1, 0]], float), sigma**2 * np.eye(2)
    result, doubted = [p[0]], 0
    for i in range(1, len(t)):
        dt = t[i] - t[i - 1]
        A, Q = np.eye(4), np.zeros((4, 4))
        A[0, 1] = A[2, 3] = dt
        Q[:2, :2] = Q[2:, 2:] = acceleration**2 * np.array([[dt**4 / 4, dt**3 / 2], [dt**3 / 2, dt**2]])
        x, P = A @ x, A @ P @ A.T + Q
        S, innovation = H @ P @ H.T + R, p[i] - x[[0, 2]]
        if innovation @ np.linalg.solve(S, innovation) <= gate**2:
            K, doubted = P @ H.T @ np.linalg.inv(S), 0
            x, P = x + K @ innovation, (np.eye(4) - K @ H) @ P
        else:
            doubted += dt
            if doubted > patience:
                x[[0, 2]], P, doubted = p[i], start, 0
        result.append(x[[0, 2]].copy())
    return np.array(result)


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
    p = filtered(seconds(columns[:, 0]), columns[:, 2:4] - columns[:, 2:4].mean(axis=0))
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
