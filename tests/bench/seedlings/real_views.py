#!/usr/bin/env python3
"""Real pictures and clouds of ../shared/data beside what is known of them, as rows of docs/dev/seedlings.md.

    real_views.py --bin build/headless/bin --data ../shared/data --work WORK [--only tum9,lego,...] [--lego-steps 1700] [--lego-seconds 200]

tum9, slambook5, scenes: error of the estimated poses after the best rigid motion (pose_accuracy), against motion capture, rendered
poses and KinectFusion. lego: PSNR of the ten test views, by encoder, and of the grid with and
without the masks (field_run; NeRF reaches 32.5 dB at 800 x 800 after a day).
romi_virtual: a cloud matched from pictures with exact cameras, beside the mesh of the plant. romi_real: poses from 60 photos without
depth beside the positions of the robot. corn: the traits of a cloud given, beside its own extents. phenomenal is a test
(Calibrate.RealCornersOfPhenomenal). A row whose data are absent says so.
"""
import argparse
import csv
import json
import math
import pathlib
import re
import shutil
import subprocess
import time

import numpy as np


def ran(command, log):
    """What a program printed, which is kept in `log`; its seconds."""
    log.parent.mkdir(parents=True, exist_ok=True)
    started = time.monotonic()
    done = subprocess.run([str(c) for c in command], capture_output=True, text=True)
    log.write_text(done.stdout + done.stderr)
    return done.stdout + done.stderr, time.monotonic() - started


def last_words(text):
    lines = [line for line in text.strip().splitlines() if line.strip()]
    return "failed: " + lines[-1][:160] if lines else "failed"


def poses(o, name, folder, *settings):
    text, seconds = ran([o.bin / "pose_accuracy", folder, *settings], o.work / f"{name}.log")
    found = re.search(r"ATE ([0-9.]+) mm.* from view to view median ([0-9.]+) mm ([0-9.]+) deg", text)
    return f"ATE {found[1]} mm; view to view {found[2]} mm, {found[3]} deg ({seconds:.0f} s)" if found else last_words(text)


def without_masks(folder, out):
    """A copy of the views with their transparent parts made white: nothing tells object and background apart any more."""
    from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
    from vtkmodules.vtkCommonDataModel import vtkImageData
    from vtkmodules.vtkIOImage import vtkPNGReader, vtkPNGWriter
    for path in sorted(folder.rglob("*")):
        copy = out / path.relative_to(folder)
        copy.parent.mkdir(parents=True, exist_ok=True)
        if path.suffix != ".png":
            if path.is_file():
                shutil.copy(path, copy)
            continue
        reader = vtkPNGReader()
        reader.SetFileName(str(path))
        reader.Update()
        rgba = vtk_to_numpy(reader.GetOutput().GetPointData().GetScalars()).astype(float)
        alpha = rgba[:, 3:] / 255
        rgb = np.ascontiguousarray(np.rint(alpha * rgba[:, :3] + (1 - alpha) * 255).astype(np.uint8))
        image = vtkImageData()
        image.SetDimensions(reader.GetOutput().GetDimensions())
        image.GetPointData().SetScalars(numpy_to_vtk(rgb))
        writer = vtkPNGWriter()
        writer.SetFileName(str(copy))
        writer.SetInputData(image)
        writer.Write()
    return out


def lego(o, folder):
    rows = []
    for encoder, masks in (("grid", True), ("grid", False), ("hash", True), ("paper", True)):
        name = f"{encoder}{'' if masks else ', no masks'}"
        views = folder if masks else without_masks(folder, o.work / "lego_flat")
        out = o.work / ("lego_" + name.replace(", ", "_").replace(" ", "_"))
        text, seconds = ran([o.bin / "field_run", views, out, f"encoder={encoder}", "background=white", "exposure=false", "refine_poses=false",
                             f"max_seconds={o.lego_seconds}", f"steps={o.lego_steps}"], out.with_suffix(".log"))
        found = re.search(r"held out: ([0-9.]+) dB", text)
        steps = re.search(r"^ +steps ([0-9]+)", text, re.MULTILINE)
        rows.append(f"{name} {found[1]} dB ({steps[1]} steps, {seconds:.0f} s)" if found and steps else f"{name} {last_words(text)}")
    return "; ".join(rows)


def vertices_of_obj(path):
    return np.array([[float(v) for v in line.split()[1:4]] for line in path.open() if line.startswith("v ")])


def points_of_ply(path):
    with path.open("rb") as file:
        names, count = [], 0
        types = {"float": "<f4", "double": "<f8", "uchar": "u1", "ushort": "<u2", "int": "<i4", "short": "<i2"}
        for line in iter(lambda: file.readline().decode("latin-1").strip(), "end_header"):
            if line.startswith("element vertex"):
                count = int(line.split()[2])
            elif line.startswith("property"):
                names.append((line.split()[2], types[line.split()[1]]))
        rows = np.frombuffer(file.read(np.dtype(names).itemsize * count), dtype=np.dtype(names))
    return np.stack([rows["x"], rows["y"], rows["z"]], axis=1).astype(float)


def nearest(of, to):
    """Distance of each point of `of` from the nearest of `to`, in pieces that fit in memory."""
    order = np.empty(len(of))
    for begin in range(0, len(of), 500):
        part = of[begin:begin + 500]
        order[begin:begin + 500] = np.sqrt(((part[:, None, :] - to[None, :, :]) ** 2).sum(axis=2).min(axis=1))
    return order


def surveyed(o, name, folder, camera, stages, report):
    """Runs a document of a few stages and returns what the program said, the folder of its results and its seconds."""
    frames = {"id": "frames", "type": "io.read_views", "options": {"folder": str(folder), **({"camera": camera} if camera else {})}}
    last = {"id": "report", "type": "report.plant", "inputs": report, "options": {"figures": False}}
    pipeline = o.work / f"{name}.json"
    pipeline.write_text(json.dumps({"stages": [frames, *stages, last]}))
    text, seconds = ran([o.bin / "bole", "run", pipeline, "--no-cache", "--force", "--out", o.work / name], o.work / f"{name}.log")
    return text, o.work / name, seconds


def romi_virtual(o, folder):
    text, out, seconds = surveyed(o, "romi_virtual", folder, None,
                                  [{"id": "poses", "type": "rgbd.estimate_poses", "inputs": {"views": "frames.views", "given": "frames.poses"}, "options": {"source": "given"}},
                                   {"id": "match", "type": "plant.match_views", "inputs": {"views": "frames.views", "poses": "poses.poses"}, "options": {"max_width": 448}}],
                                  {"points": "match.points", "poses": "poses.poses"})
    cloud = out / "cloud.ply"
    if not cloud.exists():
        return last_words(text)
    points, mesh = points_of_ply(cloud), vertices_of_obj(next(folder.glob("VirtualPlant*/*.obj"))) / 1000
    mesh = np.stack([mesh[:, 0], -mesh[:, 2], mesh[:, 1]], axis=1)  # y is up in the file
    rng = np.random.default_rng(1)
    error = 1000 * nearest(points[rng.permutation(len(points))[:4000]], mesh)
    cover = 1000 * nearest(mesh[rng.permutation(len(mesh))[:4000]], points)
    return (f"{len(points)} points, median {np.median(error):.2f} mm from the vertices of the mesh; {100 * np.mean(cover < 2):.0f} % of the vertices have a "
            f"point within 2 mm ({seconds:.0f} s)")


def similarity_rms(found, truth):
    """Root mean square distance after the best similarity (Umeyama 1991)."""
    a, b = found - found.mean(axis=0), truth - truth.mean(axis=0)
    u, d, vt = np.linalg.svd(b.T @ a)
    sign = np.diag([1, 1, np.sign(np.linalg.det(u @ vt))])
    scale = np.trace(np.diag(d) @ sign) / (a ** 2).sum()
    return math.sqrt((((scale * (u @ sign @ vt @ a.T)).T - b) ** 2).sum(axis=1).mean())


def romi_real(o, folder):
    text, out, seconds = surveyed(o, "romi_real", folder, "1165,1165,719.5,539.5",
                                  [{"id": "poses", "type": "rgbd.estimate_poses", "inputs": {"views": "frames.views"},
                                    "options": {"allow_unscaled": True, "turntable": "no"}}],
                                  {"poses": "poses.poses"})
    if not (out / "trajectory.tum").exists():
        return last_words(text)
    found = {round(30 * row[0]): row[1:4] for row in np.loadtxt(out / "trajectory.tum")}
    robot = {i: json.loads(path.read_text())["approximate_pose"][:3] for i, path in enumerate(sorted((folder / "metadata/images").glob("*.json")))}
    both = sorted(set(found) & set(robot))
    if len(both) < 4:
        return f"{len(found)} of {len(robot)} views have a pose"
    rms = similarity_rms(np.array([found[i] for i in both]), np.array([robot[i] for i in both], dtype=float))
    return f"{len(found)} of {len(robot)} photos have a pose, {rms:.1f} mm from the robot's positions on a circle of 300 mm ({seconds:.0f} s)"


def corn(o, folder):
    out = o.work / "corn"
    text, seconds = ran([o.bin / "bole", "run", "seedling_from_cloud", "--no-cache", "--force", "--set", f"cloud.file={folder / '10.ply'}", "--out", out], o.work / "corn.log")
    if not (out / "traits.csv").exists():
        return last_words(text)
    with open(out / "traits.csv", newline="") as file:
        row = next(csv.DictReader(file))
    points = points_of_ply(folder / "10.ply")
    extent = points.max(axis=0) - points.min(axis=0)
    return f"height {row['height_mm']}, breadth {row['breadth_length_mm']} x {row['breadth_width_mm']} thousandths, {row['leaf_count'] or 'no'} leaves; extent of all points {1000 * extent.max():.0f} ({seconds:.0f} s)"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--bin", required=True, type=pathlib.Path)
    parser.add_argument("--data", required=True, type=pathlib.Path)
    parser.add_argument("--work", required=True, type=pathlib.Path)
    parser.add_argument("--only", default="")
    parser.add_argument("--lego-steps", type=int, default=1700)
    parser.add_argument("--lego-seconds", type=int, default=200)
    o = parser.parse_args()
    o.work = o.work.resolve()
    o.work.mkdir(parents=True, exist_ok=True)
    data = o.data.resolve()
    rows = {"tum9": ("rgbd_tum9", lambda f: poses(o, "tum9", f)),
            "slambook5": ("rgbd_slambook5", lambda f: poses(o, "slambook5", f)),
            "scenes": ("rgbd_7scenes300", lambda f: poses(o, "scenes", f, "step=3")),
            "lego": ("nerf_lego400", lambda f: lego(o, f)),
            "romi_virtual": ("plants_romi/virtual_plant", lambda f: romi_virtual(o, f)),
            "romi_real": ("plants_romi/real_plant", lambda f: romi_real(o, f)),
            "corn": ("plant_corn_sfm", lambda f: corn(o, f))}
    wanted = [name for name in o.only.split(",") if name] or list(rows)
    print("| data | measured |\n|---|---|")
    for name in wanted:
        folder, measure = rows[name]
        shown = measure(data / folder) if (data / folder).exists() else "absent"
        print(f"| `{folder}` | {shown} |", flush=True)


if __name__ == "__main__":
    main()
