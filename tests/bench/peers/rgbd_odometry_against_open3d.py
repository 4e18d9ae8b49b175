#!/usr/bin/env python3
"""Camera poses of Bole beside the RGB-D odometry of Open3D on the same views: errors against poses given, and whether depths agree.

  rgbd_odometry_against_open3d.py BUILD_DIR FOLDER [--step 1] [--max 1000] [--set option=value ...]

The folder has the layout of 7-Scenes (frame-NNNNNN.color.jpg, .depth.png, .pose.txt), of TUM RGB-D with associate.txt, that of
slambook2 (color/1.png, pose.txt), or is a simulated seedling (color/, depth/, camera.json without lens distortion, poses.tum). Open3D chains its odometry from view to view (hybrid term: colour and depth); it comes from PyPI
(`pip install open3d` in an environment of its own, whose Python runs this file); without it nothing is run, and this is said.
ATE: root mean square distance after the best rigid motion. Step: median error from one view to the next. Depth: every tenth view
compared with the one ten views before, by the poses: median difference, and share of pixels within 3 cm.
"""

import argparse
import json
import pathlib
import subprocess
import sys
import tempfile
import time

import numpy as np

try:
    import open3d as o3d
except ImportError:
    o3d = None

MOST_DEPTH_M = 4.0


def matrix(values):
    """4 x 4 of tx ty tz qx qy qz qw."""
    t, (x, y, z, w) = values[:3], np.array(values[3:7]) / np.linalg.norm(values[3:7])
    T = np.eye(4)
    T[:3, :3] = [[1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)],
                 [2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)],
                 [2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)]]
    T[:3, 3] = t
    return T


class Views:
    """Files, times, true poses and the camera (fx, fy, cx, cy, units per metre) of a folder."""

    def __init__(self, folder, step, most):
        self.files, self.times, self.truth = [], [], []
        if (folder / "associate.txt").exists():
            self.camera = (517.3, 516.5, 318.6, 255.3, 5000.0)
            rows = np.loadtxt(folder / "groundtruth.txt")
            for line in (folder / "associate.txt").read_text().splitlines():
                moment, color, _, depth = line.split()
                self.add(float(moment), folder / color, folder / depth, matrix(rows[np.argmin(np.abs(rows[:, 0] - float(moment))), 1:]))
        elif (folder / "pose.txt").exists():
            self.camera = (481.2, -480.0, 319.5, 239.5, 5000.0)
            for i, row in enumerate(np.loadtxt(folder / "pose.txt"), 1):
                self.add(i / 30, folder / f"color/{i}.png", folder / f"depth/{i}.png", matrix(row))
        elif (folder / "camera.json").exists():
            told = json.loads((folder / "camera.json").read_text())
            self.camera = tuple(told[k] for k in ("fx", "fy", "cx", "cy", "depth_scale"))
            for row in np.loadtxt(folder / "poses.tum"):
                name = f"{round(30 * row[0]):06d}.png"
                self.add(row[0], folder / "color" / name, folder / "depth" / name, matrix(row[1:]))
        else:
            self.camera = (585.0, 585.0, 320.0, 240.0, 1000.0)
            for i, color in enumerate(sorted(folder.glob("*.color.jpg"))):
                stem = str(color)[:-len(".color.jpg")]
                self.add(i / 30, color, pathlib.Path(stem + ".depth.png"), np.loadtxt(stem + ".pose.txt"))
        for name in ("files", "times", "truth"):
            setattr(self, name, getattr(self, name)[::step][:most])

    def add(self, moment, color, depth, pose):
        self.times.append(moment)
        self.files.append((color, depth))
        self.truth.append(pose)


def aligned_error(found, truth):
    a, b = np.array([T[:3, 3] for T in found]).T, np.array([T[:3, 3] for T in truth]).T
    ma, mb = a.mean(1, keepdims=True), b.mean(1, keepdims=True)
    U, _, Vt = np.linalg.svd((b - mb) @ (a - ma).T)
    R = U @ np.diag([1, 1, np.sign(np.linalg.det(U @ Vt))]) @ Vt
    return float(np.sqrt((((R @ (a - ma) + mb) - b)**2).sum(0).mean()))


def step_errors(found, truth):
    shift, turn = [], []
    for i in range(1, len(found)):
        gap = np.linalg.inv(np.linalg.inv(truth[i - 1]) @ truth[i]) @ np.linalg.inv(found[i - 1]) @ found[i]
        shift.append(np.linalg.norm(gap[:3, 3]))
        turn.append(np.degrees(np.arccos(np.clip((np.trace(gap[:3, :3]) - 1) / 2, -1, 1))))
    return float(np.median(shift)), float(np.median(turn))


def read_depth(views, i):
    raw = np.asarray(o3d.io.read_image(str(views.files[i][1]))).astype(float)
    raw[raw >= 65535] = 0
    z = raw / views.camera[4]
    z[z > MOST_DEPTH_M] = 0
    return z


def depth_agreement(views, poses, gap):
    fx, fy, cx, cy, _ = views.camera
    differences = []
    for i in range(gap, len(poses), gap):
        if poses[i] is None or poses[i - gap] is None:
            continue
        za, zb = read_depth(views, i - gap), read_depth(views, i)
        v, u = np.nonzero(za[::4, ::4])
        v, u = 4 * v, 4 * u
        z = za[v, u]
        p = np.linalg.inv(poses[i]) @ poses[i - gap] @ np.stack([(u - cx) / fx * z, (v - cy) / fy * z, z, np.ones_like(z)])
        with np.errstate(divide="ignore", invalid="ignore"):
            x, y = np.rint(fx * p[0] / p[2] + cx), np.rint(fy * p[1] / p[2] + cy)
        inside = (p[2] > 0.1) & (x >= 0) & (y >= 0) & (x < za.shape[1]) & (y < za.shape[0])
        seen = zb[y[inside].astype(int), x[inside].astype(int)]
        gaps = np.abs(seen - p[2][inside])[seen > 0]
        differences.append(gaps[gaps < 0.3])  # beyond: something else hides it
    if not differences:
        return None
    d = np.concatenate(differences)
    return float(np.median(d)), float((d < 0.03).mean())


def bole_poses(build, folder, views, args):
    with tempfile.TemporaryDirectory() as scratch:
        out = pathlib.Path(scratch) / "poses.tum"
        command = [str(build / "bin/pose_accuracy"), str(folder), f"step={args.step}", f"max={args.max}", f"out={out}", *args.set]
        start = time.perf_counter()
        subprocess.run(command, check=True, stdout=subprocess.DEVNULL)
        seconds = time.perf_counter() - start
        rows = {round(r[0], 6): matrix(r[1:]) for r in np.loadtxt(out, ndmin=2)}
    return [rows.get(round(t, 6)) for t in views.times], seconds


def open3d_poses(views):
    fx, fy, cx, cy, scale = views.camera
    images = []
    for color, depth in views.files:
        c, d = np.asarray(o3d.io.read_image(str(color))), np.asarray(o3d.io.read_image(str(depth))).copy()
        d[d == 65535] = 0
        if fy < 0:  # rows that run upwards
            c, d = c[::-1].copy(), d[::-1].copy()
        images.append(o3d.geometry.RGBDImage.create_from_color_and_depth(o3d.geometry.Image(c), o3d.geometry.Image(d), depth_scale=scale,
                                                                         depth_trunc=MOST_DEPTH_M, convert_rgb_to_intensity=True))
    height, width = np.asarray(images[0].depth).shape
    camera = o3d.camera.PinholeCameraIntrinsic(width, height, fx, abs(fy), cx, height - 1 - cy if fy < 0 else cy)
    start = time.perf_counter()
    poses, lost = [np.eye(4)], 0
    for before, after in zip(images, images[1:]):
        good, T, _ = o3d.pipelines.odometry.compute_rgbd_odometry(after, before, camera, np.eye(4),
                                                                  o3d.pipelines.odometry.RGBDOdometryJacobianFromHybridTerm(),
                                                                  o3d.pipelines.odometry.OdometryOption())
        lost += not good
        poses.append(poses[-1] @ T)
    return poses, time.perf_counter() - start, lost


def show(name, views, poses, seconds, note=""):
    kept = [i for i, T in enumerate(poses) if T is not None]
    found, truth = [poses[i] for i in kept], [views.truth[i] for i in kept]
    shift, turn = step_errors(found, truth)
    depth = depth_agreement(views, poses, 10 if len(poses) > 20 else 1)
    text = f"median {1000 * depth[0]:.1f} mm, {100 * depth[1]:.1f} % within 3 cm" if depth else "none"
    print(f"{name:8s} {len(kept)} of {len(poses)} views  ATE {1000 * aligned_error(found, truth):7.2f} mm  step {1000 * shift:.2f} mm {turn:.3f} deg  "
          f"depth {text}  {seconds:.1f} s{note}")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("build", type=pathlib.Path)
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("--step", type=int, default=1)
    parser.add_argument("--max", type=int, default=1000)
    parser.add_argument("--set", nargs="*", default=[])
    args = parser.parse_args()
    if o3d is None:
        print("Open3D is absent (pip install open3d): skipped")
        return 0
    views = Views(args.folder, args.step, args.max)
    poses, seconds = bole_poses(args.build, args.folder, views, args)
    show("Bole", views, poses, seconds)
    show("given", views, views.truth, 0)
    poses, seconds, lost = open3d_poses(views)
    show("Open3D", views, poses, seconds, f"  {lost} steps failed")
    return 0


if __name__ == "__main__":
    sys.exit(main())
