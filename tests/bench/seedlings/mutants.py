#!/usr/bin/env python3
"""Folders of views that are wrong in one way each: every one must end in a clear error, or in a finding that names what is wrong.

    mutants.py --bole build/headless/bin/bole --views DIR [--keep WORK] [--only NAME ...] [--set STAGE.OPTION=VALUE ...]

DIR is the folder of `bole simulate-seedling --out DIR`, best a small one. Prints one line per mutant: exit code, verdict, codes of the findings, or the
error. A mutant is silently wrong, and the script exits 1, where the run ends well without a word about it, where the program crashes, or where an error
says neither what was found nor what to do. The folder as it is must end well.
"""
import argparse
import json
import pathlib
import shutil
import struct
import subprocess
import sys
import tempfile
import zlib


def png(width, height, channels, depth_bits, value):
    """A PNG of one value."""
    row = b"\0" + value.to_bytes(depth_bits // 8, "big") * (width * channels)
    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))
    head = struct.pack(">IIBBBBB", width, height, depth_bits, 2 if channels == 3 else 0, 0, 0, 0)
    return b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", head) + chunk(b"IDAT", zlib.compress(row * height)) + chunk(b"IEND", b"")


def images(folder, kind):
    return sorted((folder / kind).iterdir())


def keep(folder, wanted):
    for kind in ("color", "depth"):
        for i, path in enumerate(images(folder, kind)):
            if i not in wanted:
                path.unlink()


def change_camera(folder, **values):
    path = folder / "camera.json"
    camera = json.loads(path.read_text())
    camera.update(values)
    path.write_text(json.dumps(camera))


def camera_of(folder):
    return json.loads((folder / "camera.json").read_text())


def as_it_is(folder):
    pass


def empty(folder):
    keep(folder, set())


def no_images_folder(folder):
    shutil.rmtree(folder / "color")


def one_view(folder):
    keep(folder, {0})


def no_overlap(folder):
    n = len(images(folder, "color"))
    keep(folder, {0, n // 2})


def all_black(folder):
    camera = camera_of(folder)
    for path in images(folder, "color"):
        path.write_bytes(png(camera["width"], camera["height"], 3, 8, 0))


def depth_missing(folder):
    shutil.rmtree(folder / "depth")


def depth_of_nothing(folder):
    camera = camera_of(folder)
    size = camera.get("depth", camera)
    for path in images(folder, "depth"):
        path.write_bytes(png(size["width"], size["height"], 1, 16, 0))


def wrong_scale(folder):
    change_camera(folder, depth_scale=1.1 * camera_of(folder)["depth_scale"])


def scale_of_metres(folder):
    change_camera(folder, depth_scale=1)


def no_camera(folder):
    (folder / "camera.json").unlink()


def camera_of_another_size(folder):
    change_camera(folder, width=camera_of(folder)["width"] * 2)


def focal_length_of_zero(folder):
    change_camera(folder, fx=0)


def distortion_that_folds(folder):
    change_camera(folder, distortion=[-5, 0, 0, 0, 0])


def cut_picture(folder):
    for path in images(folder, "color")[:3]:
        path.write_bytes(path.read_bytes()[:200])


def cut_pictures(folder):
    for path in images(folder, "color"):
        path.write_bytes(path.read_bytes()[:200])


def lying_size(folder):
    for path in images(folder, "color")[:3]:
        data = bytearray(path.read_bytes())
        data[16:24] = struct.pack(">II", 1 << 30, 1 << 30)
        path.write_bytes(data)


def mat_of_another_size(folder):
    path = folder / "mat.json"
    mat = json.loads(path.read_text())
    mat["square_mm"] *= 1.1
    mat["marker_mm"] *= 1.1
    path.write_text(json.dumps(mat))


def mat_that_lies(folder):
    path = folder / "mat.json"
    mat = json.loads(path.read_text())
    mat["squares"] = [0, -3]
    path.write_text(json.dumps(mat))


def poses_of_another_walk(folder):
    path = folder / "poses.tum"
    lines = [line for line in path.read_text().splitlines() if line and not line.startswith("#")]
    rows = [line.split() for line in lines]
    turned = rows[len(rows) // 3:] + rows[:len(rows) // 3]
    path.write_text("".join(" ".join([row[0], *other[1:]]) + "\n" for row, other in zip(rows, turned)))


MUTANTS = [as_it_is, empty, no_images_folder, one_view, no_overlap, all_black, depth_missing, depth_of_nothing, wrong_scale, scale_of_metres, no_camera,
           camera_of_another_size, focal_length_of_zero, distortion_that_folds, cut_picture, cut_pictures, lying_size, mat_of_another_size, mat_that_lies,
           poses_of_another_walk]
GIVEN = {poses_of_another_walk: ["poses.source=given"]}


def judge(mutant, code, summary, text):
    """The line to print, and whether it is silently wrong."""
    if code not in (0, 1, 2, 4):
        return f"exit {code}: crashed or hung", True
    findings = [f for f in (summary or {}).get("findings", []) if f["severity"] != "note"]
    codes = ", ".join(sorted({f["code"] for f in findings}))
    if code in (1, 2):
        error = (summary or {}).get("error") or next((line for line in text.splitlines() if line.startswith("bole:")), "")
        return f"exit {code}: {error[:220] or codes}", "needed" not in error and not findings
    verdict = (summary or {}).get("verdict")
    if mutant is as_it_is:
        return f"exit {code}, {verdict}: {codes}", False
    return f"exit {code}, {verdict}: {codes}", not findings


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--bole", required=True, type=pathlib.Path)
    parser.add_argument("--views", required=True, type=pathlib.Path)
    parser.add_argument("--keep", type=pathlib.Path)
    parser.add_argument("--only", nargs="*")
    parser.add_argument("--set", action="append", default=[])
    options = parser.parse_args()
    pipeline = pathlib.Path(__file__).resolve().parents[3] / "pipelines/seedling.json"
    wrong = 0
    with tempfile.TemporaryDirectory() as temporary:
        work = options.keep or pathlib.Path(temporary)
        for mutant in MUTANTS:
            if options.only and mutant.__name__ not in options.only:
                continue
            folder, out = work / mutant.__name__ / "views", work / mutant.__name__ / "out"
            shutil.rmtree(work / mutant.__name__, ignore_errors=True)
            shutil.copytree(options.views, folder, ignore=shutil.ignore_patterns("truth"))
            mutant(folder)
            settings = [f"frames.folder={folder}", "report.figures=false", *options.set, *GIVEN.get(mutant, [])]
            command = [options.bole, "run", pipeline, "--no-cache", "--out", out, *[p for s in settings for p in ("--set", s)]]
            try:
                done = subprocess.run(command, capture_output=True, text=True, timeout=1500)
                code, text = done.returncode, done.stdout + done.stderr
            except subprocess.TimeoutExpired:
                code, text = 99, ""
            path = out / "summary.json"
            summary = json.loads(path.read_text()) if path.exists() else None
            line, silent = judge(mutant, code, summary, text)
            wrong += silent
            print(f"{'SILENTLY WRONG ' if silent else ''}{mutant.__name__}: {line}", flush=True)
    sys.exit(1 if wrong else 0)


if __name__ == "__main__":
    main()
