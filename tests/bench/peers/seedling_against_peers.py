#!/usr/bin/env python3
"""A simulated seedling by Bole and by its peers: camera positions beside COLMAP's sparse model, surface beside Open3D's fused depth.

  seedling_against_peers.py PLANT RESULTS [RESULTS ...] --surface surface_error [--voxel-mm 1] [--work FOLDER]

PLANT comes from `bole simulate-seedling` (camera without lens distortion), each RESULTS from a run of seedling.json on it (trajectory.tum, cloud.ply).
COLMAP (Debian's package `colmap`, on the processor, with the true intrinsics) sees the colour pictures alone; its scale is free, so both are also compared
after the best similarity. Open3D (`pip install open3d` in an environment whose Python runs this file) fuses the same depth pictures with the true poses, so
that its surface has no error of poses. A peer that is absent is left out, and this is said.
"""

import argparse
import json
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import time

import numpy as np

try:
    import open3d as o3d
except ImportError:
    o3d = None

MOST_DEPTH_M = 0.7  # the plant and its pot; what lies behind is not asked for


def positions_of_tum(path):
    """Camera positions in metres by number of the view (30 views per second)."""
    return {round(30 * row[0]): row[1:4] for row in np.loadtxt(path, ndmin=2)}


def aligned_error_mm(found, truth, similarity):
    """Root mean square distance of the positions that both have, after the best rigid or similarity motion."""
    both = sorted(set(found) & set(truth))
    a, b = np.array([found[i] for i in both]).T, np.array([truth[i] for i in both]).T
    a, mb = a - a.mean(1, keepdims=True), b.mean(1, keepdims=True)
    U, S, Vt = np.linalg.svd((b - mb) @ a.T)
    signs = np.array([1, 1, np.sign(np.linalg.det(U @ Vt))])
    scale = (S * signs).sum() / (a * a).sum() if similarity else 1
    return 1000 * float(np.sqrt(((scale * U @ np.diag(signs) @ Vt @ a + mb - b) ** 2).sum(0).mean()))


def show_poses(name, found, truth, seconds=""):
    if len(set(found) & set(truth)) < 3:
        print(f"{name}: fewer than three views have a pose")
        return
    print(f"{name}: {len(found)} of {len(truth)} views; ATE {aligned_error_mm(found, truth, True):.3f} mm by similarity, "
          f"{aligned_error_mm(found, truth, False):.3f} mm rigid{seconds}", flush=True)


def rotation(w, x, y, z):
    return np.array([[1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)], [2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)],
                     [2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)]])


def colmap_positions(plant, camera, work, features):
    """Of the largest model that COLMAP makes, without unit."""
    database, sparse, images = work / "colmap.db", work / "sparse", plant / "color"
    sparse.mkdir(parents=True, exist_ok=True)
    # COLMAP's first pixel ends at 1, ours has its centre at 0.
    intrinsics = ",".join(f"{v:.6f}" for v in (camera["fx"], camera["fy"], camera["cx"] + 0.5, camera["cy"] + 0.5))
    steps = [["feature_extractor", "--database_path", database, "--image_path", images, "--ImageReader.single_camera", 1, "--ImageReader.camera_model", "PINHOLE",
              "--ImageReader.camera_params", intrinsics, "--SiftExtraction.use_gpu", 0, "--SiftExtraction.max_num_features", features],
             ["exhaustive_matcher", "--database_path", database, "--SiftMatching.use_gpu", 0],
             ["mapper", "--database_path", database, "--image_path", images, "--output_path", sparse, "--Mapper.ba_refine_focal_length", 0,
              "--Mapper.ba_refine_principal_point", 0, "--Mapper.ba_refine_extra_params", 0]]
    for step in steps:
        done = subprocess.run(["colmap", *map(str, step)], capture_output=True, text=True, env={**os.environ, "QT_QPA_PLATFORM": "offscreen"})
        if done.returncode != 0:
            print(f"COLMAP {step[0]} failed: {(done.stderr or done.stdout).strip()[-300:]}")
            return {}
    best = {}
    for model in sorted(sparse.iterdir()):
        subprocess.run(["colmap", "model_converter", "--input_path", str(model), "--output_path", str(model), "--output_type", "TXT"], check=True, capture_output=True)
        found = {}
        lines = [line for line in (model / "images.txt").read_text().splitlines() if not line.startswith("#")]
        for line in lines[::2]:
            words = line.split()
            q, t = list(map(float, words[1:5])), np.array(list(map(float, words[5:8])))
            found[int(pathlib.Path(words[9]).stem)] = -rotation(*q).T @ t
        best = found if len(found) > len(best) else best
    return best


def open3d_cloud(plant, camera, voxel_m, path):
    """Points of the fused depth, with the true poses; a point counts that two views have seen."""
    core, cpu = o3d.core, o3d.core.Device("CPU:0")
    intrinsic = core.Tensor(np.array([[camera["fx"], 0, camera["cx"]], [0, camera["fy"], camera["cy"]], [0, 0, 1]]), core.float64)
    grid = o3d.t.geometry.VoxelBlockGrid(("tsdf", "weight", "color"), (core.float32,) * 3, ((1), (1), (3)), voxel_m, 16, 50000, cpu)
    cut = 4.0  # voxels: where the distance from the surface is cut off
    for row in np.loadtxt(plant / "truth/poses.tum", ndmin=2):
        name = f"{round(30 * row[0]):06d}.png"
        color, depth = (o3d.t.io.read_image(str(plant / kind / name)) for kind in ("color", "depth"))
        T = np.eye(4)
        T[:3, :3], T[:3, 3] = rotation(row[7], *row[4:7]), row[1:4]
        extrinsic = core.Tensor(np.linalg.inv(T), core.float64)
        blocks = grid.compute_unique_block_coordinates(depth, intrinsic, extrinsic, float(camera["depth_scale"]), MOST_DEPTH_M, cut)
        grid.integrate(blocks, depth, color, intrinsic, extrinsic, float(camera["depth_scale"]), MOST_DEPTH_M, cut)
    o3d.io.write_point_cloud(str(path), grid.extract_point_cloud(2.0).to_legacy())


def show_surface(name, program, cloud, plant, seconds=""):
    done = subprocess.run([str(program), str(cloud), str(plant)], capture_output=True, text=True)
    first = (done.stdout or done.stderr).strip().splitlines()[:1]
    print(f"{name}: {first[0] if first else 'no surface'}{seconds}", flush=True)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("plant", type=pathlib.Path)
    parser.add_argument("results", type=pathlib.Path, nargs="+")
    parser.add_argument("--surface", type=pathlib.Path, required=True)
    parser.add_argument("--voxel-mm", type=float, default=1)
    parser.add_argument("--features", type=int, default=3000, help="of each picture, for COLMAP (its own default, 8192, takes seven times as long to match)")
    parser.add_argument("--work", type=pathlib.Path, help="kept; else a temporary folder")
    options = parser.parse_args()
    camera = json.loads((options.plant / "camera.json").read_text())
    truth = positions_of_tum(options.plant / "truth/poses.tum")
    with tempfile.TemporaryDirectory() as scratch:
        work = options.work or pathlib.Path(scratch)
        work.mkdir(parents=True, exist_ok=True)
        for out in options.results:
            show_poses(f"Bole, {out.parent.name}", positions_of_tum(out / "trajectory.tum"), truth)
            show_surface(f"Bole, {out.parent.name}", options.surface, out / "cloud.ply", options.plant)
        if shutil.which("colmap"):
            begun = time.perf_counter()
            found = colmap_positions(options.plant, camera, work, options.features)
            show_poses("COLMAP", found, truth, f", {time.perf_counter() - begun:.0f} s")
        else:
            print("COLMAP is absent (package colmap): left out")
        if o3d is not None:
            begun = time.perf_counter()
            open3d_cloud(options.plant, camera, options.voxel_mm / 1000, work / "open3d.ply")
            show_surface("Open3D, fused with true poses", options.surface, work / "open3d.ply", options.plant, f" ({time.perf_counter() - begun:.0f} s)")
        else:
            print("Open3D is absent (pip install open3d): left out")
    return 0


if __name__ == "__main__":
    sys.exit(main())
