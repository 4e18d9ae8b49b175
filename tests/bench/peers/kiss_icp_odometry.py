#!/usr/bin/env python3
"""Odometry of Bole beside that of KISS-ICP on the same frames in the same run: time per frame, and agreement with poses given.

  kiss_icp_odometry.py BUILD_DIR KITTI_raw_HDL64 [--frames 50] [--repeat 3] [--set option=value ...]

The folder holds raw sweeps as .pcd (x y z intensity, ring after ring, not de-skewed) and consensus_*.txt, trajectories that other
systems have found (KITTI rows, poses in the middle of the sweeps). Sweeps are read before the clock runs. KISS-ICP comes from
PyPI (`pip install kiss-icp` in an environment of its own, whose Python runs this file); without it only Bole is run, and this is said.
ATE: root mean square distance after the best rigid alignment. RPE: over 1 and 10 frames.
"""

import argparse
import json
import pathlib
import resource
import statistics
import subprocess
import sys
import tempfile
import time

import numpy as np

try:
    from kiss_icp.config import KISSConfig
    from kiss_icp.kiss_icp import KissICP
except ImportError:
    KissICP = None


def read_kitti(path):
    rows = np.loadtxt(path).reshape(-1, 3, 4)
    poses = np.tile(np.eye(4), (len(rows), 1, 1))
    poses[:, :3] = rows
    return poses


def read_sweep(path):
    """Points and times in the sweep, 0 to 1: the rotor turns clockwise and starts behind."""
    data = path.read_bytes()
    head, _, body = data.partition(b"DATA binary\n")
    words = {line.split()[0]: line.split()[1:] for line in head.splitlines() if line and not line.startswith(b"#")}
    n, fields = int(words[b"POINTS"][0]), len(words[b"FIELDS"])
    points = np.frombuffer(body, dtype=np.float32, count=n * fields).reshape(n, fields)[:, :3].astype(np.float64)
    points = points[np.isfinite(points).all(axis=1) & (np.abs(points).sum(axis=1) > 0)]
    return points, 0.5 * (1 - np.arctan2(points[:, 1], points[:, 0]) / np.pi)


def log_so3(R):
    angle = np.arccos(np.clip((np.trace(R) - 1) / 2, -1, 1))
    w = np.array([R[2, 1] - R[1, 2], R[0, 2] - R[2, 0], R[1, 0] - R[0, 1]])
    return w / 2 if angle < 1e-9 else w * angle / (2 * np.sin(angle))


def exp_so3(w):
    angle = np.linalg.norm(w)
    K = np.array([[0, -w[2], w[1]], [w[2], 0, -w[0]], [-w[1], w[0], 0]])
    if angle < 1e-9:
        return np.eye(3) + K
    return np.eye(3) + np.sin(angle) / angle * K + (1 - np.cos(angle)) / angle**2 * K @ K


def half_back(pose, delta):
    """The pose half a sweep before `pose`."""
    half = np.eye(4)
    half[:3, :3] = exp_so3(log_so3(delta[:3, :3]) / 2)
    half[:3, 3] = delta[:3, 3] / 2
    return pose @ np.linalg.inv(half)


def deskews_to_end(config):
    """Whether points are brought to the end of the sweep (1.2 and later) or to its middle."""
    motion = np.eye(4)
    motion[0, 3] = 1
    moved = KissICP(config).preprocessor.preprocess(np.array([[9.0, 0, 0], [9.0, 1, 0]]), np.array([0.0, 1.0]), motion)
    return abs(moved[1, 0] - 9) < 1e-6


def run_kiss(sweeps, deskew):
    config = KISSConfig()
    config.data.deskew = deskew
    config.mapping.voxel_size = config.data.max_range / 100
    at_end = deskew and deskews_to_end(config)
    system, poses = KissICP(config), []
    user, start = resource.getrusage(resource.RUSAGE_SELF).ru_utime, time.perf_counter()
    for points, times in sweeps:
        system.register_frame(points, times)
        poses.append(half_back(system.last_pose, system.last_delta) if at_end else system.last_pose.copy())
    n = len(sweeps)
    wall_ms = 1000 * (time.perf_counter() - start) / n
    return np.array(poses), wall_ms, 1000 * (resource.getrusage(resource.RUSAGE_SELF).ru_utime - user) / n


def run_bole(build, folder, frames, options):
    with tempfile.TemporaryDirectory() as temporary:
        file = pathlib.Path(temporary) / "poses.txt"
        command = [build / "bin" / "slam_odometry", folder, f"poses={file}", f"frames={frames}", "max_speed=40", *options]
        out = json.loads(subprocess.run(command, check=True, capture_output=True, text=True).stdout)
        for warning in out["warnings"]:
            print("  warning:", warning)
        return read_kitti(file), out["wall_ms"][0], out["user_ms"][0]


def ate_m(estimate, reference):
    a, b = estimate[:, :3, 3], reference[:, :3, 3]
    ca, cb = a.mean(axis=0), b.mean(axis=0)
    U, _, Vt = np.linalg.svd((b - cb).T @ (a - ca))
    R = U @ np.diag([1, 1, np.linalg.det(U @ Vt)]) @ Vt
    return np.sqrt((((a - ca) @ R.T + cb - b) ** 2).sum(axis=1).mean())


def rpe(estimate, reference, step):
    """Root mean square of shift (m) and turn (deg) over `step` frames."""
    shifts, turns = [], []
    for i in range(len(estimate) - step):
        error = np.linalg.inv(np.linalg.inv(reference[i]) @ reference[i + step]) @ np.linalg.inv(estimate[i]) @ estimate[i + step]
        shifts.append(np.linalg.norm(error[:3, 3]))
        turns.append(np.degrees(np.linalg.norm(log_so3(error[:3, :3]))))
    return np.sqrt(np.mean(np.square(shifts))), np.sqrt(np.mean(np.square(turns)))


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("build", type=pathlib.Path)
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("--frames", type=int, default=10**6)
    parser.add_argument("--repeat", type=int, default=3, help="runs of each, in turns; the fastest counts")
    parser.add_argument("--set", nargs="*", default=[], metavar="OPTION=VALUE", help="options of slam.run")
    arguments = parser.parse_args()
    if not any(arguments.folder.glob("*.pcd")):
        print(f"skipped: no .pcd sweeps in {arguments.folder}")
        return 0
    sweeps = [read_sweep(p) for p in sorted(arguments.folder.glob("*.pcd"))[: arguments.frames]]
    references = {p.stem: read_kitti(p) for p in sorted(arguments.folder.glob("consensus_*.txt"))}
    systems = {"Bole": lambda: run_bole(arguments.build, arguments.folder, arguments.frames, arguments.set)}
    if KissICP is None:
        print("KISS-ICP is not installed for this Python: pip install kiss-icp; Bole alone is run")
    else:
        systems["KISS-ICP, de-skew"] = lambda: run_kiss(sweeps, True)
        systems["KISS-ICP"] = lambda: run_kiss(sweeps, False)

    runs = {name: [] for name in systems}
    for _ in range(arguments.repeat):
        for name, system in systems.items():
            runs[name].append(system())
    points = statistics.mean(len(p) for p, _ in sweeps)
    print(f"{len(sweeps)} sweeps of {points:.0f} points, best of {arguments.repeat} runs in turns\n")
    print("| system | ms/frame (wall) | ms/frame (user) |")
    print("|---|---|---|")
    for name, r in runs.items():
        print(f"| {name} | {min(x[1] for x in r):.1f} | {min(x[2] for x in r):.1f} |")
    print("\n| system | against | frames | ATE, cm | RPE 1 frame, cm | RPE 10 frames, cm, deg |")
    print("|---|---|---|---|---|---|")
    all_poses = {name: r[-1][0] for name, r in runs.items()}
    for name, poses in all_poses.items():
        for other, reference in {**references, **all_poses}.items():
            if other == name:
                continue
            n = min(len(poses), len(reference))
            one, ten = rpe(poses[:n], reference[:n], 1), rpe(poses[:n], reference[:n], 10)
            print(f"| {name} | {other} | {n} | {100 * ate_m(poses[:n], reference[:n]):.1f} | {100 * one[0]:.1f} | {100 * ten[0]:.1f}, {ten[1]:.2f} |")
    return 0


if __name__ == "__main__":
    sys.exit(main())
