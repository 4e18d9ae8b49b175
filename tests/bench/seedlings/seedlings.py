#!/usr/bin/env python3
"""Simulated seedlings from views to traits: accuracy by trait, intervals, path, surface, held-out views, time and memory.

    seedlings.py --bole build/headless/bin/bole --work WORK [--seeds 101-120] [--views N] [--simulate "--sensor stereo ..."] [--set STAGE.OPTION=VALUE ...]
                 [--surface build/headless/bin/surface_error] [--method field|paper|tsdf|mvs] [--name NAME]

Every seed is another plant (`bole simulate-seedling --seed N`, made once in WORK/plants) and is surveyed into WORK/NAME: by pipelines/seedling.json (field),
with the paper's encoder, or without a field, from the fused depth (tsdf) or from pictures matched with one another (mvs).
Accuracy is that of the paper, 1 - mean |relative error|. A plant that fails is counted, and its error printed; its traits count as missing.
"""
import argparse
import csv
import json
import math
import pathlib
import re
import subprocess
import time

TRAITS = {"height": "mm", "breadth_length": "mm", "breadth_width": "mm", "stem_diameter": "mm", "leaf_area": "cm2", "stem_volume": "cm3"}
PUBLISHED = {"height": 97.94, "breadth_length": 93.95, "breadth_width": 94.11, "stem_diameter": 97.62}
PIPELINE = pathlib.Path(__file__).resolve().parents[3] / "pipelines/seedling.json"


def numbers(text):
    for part in text.split(","):
        first, _, last = part.partition("-")
        yield from range(int(first), int(last or first) + 1)


def row_of(path):
    with open(path, newline="") as file:
        return next(csv.DictReader(file))


def cell(row, name):
    return float(row[name]) if row.get(name) else math.nan


def simulated(options, seed):
    folder = options.work / "plants" / str(seed)
    if not (folder / "truth/traits.csv").exists():
        command = [options.bole, "simulate-seedling", "--seed", seed, "--out", folder, *options.simulate.split()]
        if options.views:
            command += ["--views", options.views]
        subprocess.run([str(c) for c in command], check=True, stdout=subprocess.DEVNULL)
    return folder


def pipeline_of(options):
    """The document of the method, with the points that it measures."""
    if options.method in ("field", "paper"):
        return PIPELINE
    document = json.loads(PIPELINE.read_text())
    stages = [s for s in document["stages"] if s["id"] != "field"]
    by_id = {s["id"]: s for s in stages}
    points = "fuse.points"
    if options.method == "mvs":
        stages.insert(3, {"id": "match", "type": "plant.match_views", "inputs": {"views": "frames.views", "poses": "poses.poses"}})
        points = "match.points"
    by_id["separate"]["inputs"]["points"] = points
    for name in ("field", "held_out", "progress"):
        by_id["report"]["inputs"].pop(name)
    document["stages"] = stages
    path = options.work / f"{options.method}.json"
    path.write_text(json.dumps(document))
    return path


def surveyed(options, folder, seed):
    out = options.work / options.name / str(seed)
    if not (out / "summary.json").exists():
        settings = [f"frames.folder={folder}", *(["field.encoder=paper"] if options.method == "paper" else []), *options.set]
        command = [options.bole, "run", pipeline_of(options), "--no-cache", "--out", out, *[p for s in settings for p in ("--set", s)]]
        out.mkdir(parents=True, exist_ok=True)
        started = time.monotonic()
        with open(out.with_suffix(".log"), "w") as log:
            code = subprocess.run([str(c) for c in command], stdout=log, stderr=subprocess.STDOUT).returncode
        (out / "seconds.txt").write_text(f"{time.monotonic() - started:.1f} {code}\n")
    return out


def trajectory_error_m(bole, out, truth):
    done = subprocess.run([str(bole), "evaluate", "trajectory", str(out / "trajectory.tum"), str(truth / "poses.tum"), "--json"], capture_output=True, text=True)
    try:
        found = json.loads(done.stdout)
    except json.JSONDecodeError:
        return math.nan
    def search(value):
        if isinstance(value, dict):
            for key, inner in value.items():
                if key == "ate_rmse_m" or key == "ate_rmse":
                    return inner["value"] if isinstance(inner, dict) else inner
                hit = search(inner)
                if hit is not None:
                    return hit
        return None
    hit = search(found)
    return math.nan if hit is None else hit


def surface(program, out, folder):
    """Median error (mm) and F1 (share) of the plant by surface_error, which prints them in its first line."""
    if not program or not (out / "cloud.ply").exists():
        return {}
    done = subprocess.run([str(program), str(out / "cloud.ply"), str(folder)], capture_output=True, text=True)
    found = re.search(r"^plant: .*error median ([0-9.]+) mm.* F1 ([0-9.]+) %", done.stdout, re.MULTILINE)
    return {"median_mm": float(found[1]), "f1": float(found[2]) / 100} if found else {}


def stem_curve_errors_mm(out, truth):
    """Height above the soil (mm), error of the diameter (mm) and whether its interval holds, of each diameter in stem.csv."""
    def rows(path):
        with open(path, newline="") as file:
            return list(csv.DictReader(file))
    if not (truth / "stem.csv").exists() or not (out / "stem.csv").exists():
        return []
    true = [(cell(r, "z_m"), cell(r, "diameter_mm")) for r in rows(truth / "stem.csv")]
    base_z_m = cell(row_of(out / "traits.csv"), "base_z_m")
    errors = []
    for r in rows(out / "stem.csv"):
        height_mm, diameter_mm = cell(r, "height_mm"), cell(r, "diameter_mm")
        z_m = base_z_m + height_mm / 1000
        for (below, d1), (above, d2) in zip(true, true[1:]):
            if math.isfinite(diameter_mm) and below <= z_m < above:
                truth_mm = d1 + (z_m - below) / (above - below) * (d2 - d1)
                holds = cell(r, "diameter_lo_mm") <= truth_mm <= cell(r, "diameter_hi_mm")
                errors.append((height_mm, diameter_mm - truth_mm, holds))
    return errors


def mean(values):
    good = [v for v in values if math.isfinite(v)]
    return sum(good) / len(good) if good else math.nan


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--bole", required=True, type=pathlib.Path)
    parser.add_argument("--work", required=True, type=pathlib.Path)
    parser.add_argument("--seeds", default="101-120")
    parser.add_argument("--views", type=int)
    parser.add_argument("--simulate", default="", help="flags of simulate-seedling")
    parser.add_argument("--set", action="append", default=[])
    parser.add_argument("--surface", type=pathlib.Path)
    parser.add_argument("--method", choices=["field", "paper", "tsdf", "mvs"], default="field")
    parser.add_argument("--name", help="folder of the results; the method unless given")
    options = parser.parse_args()
    options.name = options.name or options.method
    errors, covered = {t: [] for t in TRAITS}, {t: [] for t in TRAITS}
    ates, psnrs, seconds, mib, median_mm, f1, curve, failed = [], [], [], [], [], [], [], 0
    print("| plant | " + " | ".join(f"{t.replace('_', ' ')}, %" for t in TRAITS) + " | leaves | ATE, mm | PSNR, dB | surface, mm | F1 at 2 mm | s | MiB |")
    print("|---" * (len(TRAITS) + 8) + "|")
    for seed in numbers(options.seeds):
        folder = simulated(options, seed)
        out, truth = surveyed(options, folder, seed), folder / "truth"
        if not (out / "traits.csv").exists():
            failed += 1
            log = out.with_suffix(".log").read_text().strip().splitlines()
            print(f"| {seed} | failed: {log[-1][:200] if log else ''} |", flush=True)
            continue
        row, true = row_of(out / "traits.csv"), row_of(truth / "traits.csv")
        shown = []
        for trait in TRAITS:
            want = cell(true, f"{trait}_{TRAITS[trait]}")
            got, lo, hi = (cell(row, f"{trait}{part}_{TRAITS[trait]}") for part in ("", "_lo", "_hi"))
            error = (got - want) / want
            holds = lo <= want and not want > hi  # without an upper end the value is a lower bound
            errors[trait].append(abs(error) if math.isfinite(error) else 1.0)
            covered[trait].append(1.0 if holds else 0.0)
            note = " (outside)" if not holds else " (lower bound)" if math.isnan(hi) else ""
            shown.append(f"{100 * error:+.2f}{note}" if math.isfinite(error) else "none")
        summary = json.loads((out / "summary.json").read_text())
        stages = summary["stages"]
        seconds.append(float((out / "seconds.txt").read_text().split()[0]) if (out / "seconds.txt").exists() else sum(s["seconds"] for s in stages))
        mib.append(max(s.get("peak_mib", math.nan) for s in stages))
        ates.append(1000 * trajectory_error_m(options.bole, out, truth))
        field = out / "field.json"
        psnrs.append(json.loads(field.read_text())["psnr_db"] if field.exists() else math.nan)
        curve += stem_curve_errors_mm(out, truth)
        found = surface(options.surface, out, folder)
        median_mm.append(found.get("median_mm", math.nan))
        f1.append(found.get("f1", math.nan))
        leaves = f"{cell(row, 'leaf_count'):.0f} of {cell(true, 'leaf_count'):.0f}"
        print(f"| {seed} | " + " | ".join(shown) + f" | {leaves} | {ates[-1]:.2f} | {psnrs[-1] or math.nan:.1f} | {median_mm[-1]:.2f} | {100 * f1[-1]:.0f} | {seconds[-1]:.0f} | {mib[-1]:.0f} |",
              flush=True)
    if not seconds:
        return
    print("\n| trait | accuracy, % | published, % | intervals that hold, % |\n|---|---|---|---|")
    for trait in TRAITS:
        print(f"| {trait.replace('_', ' ')} | {100 * (1 - mean(errors[trait])):.2f} | {PUBLISHED.get(trait, '')} | {100 * mean(covered[trait]):.0f} |")
    print(f"\n{len(seconds)} plants, {failed} failed; ATE {mean(ates):.2f} mm, PSNR {mean(psnrs):.1f} dB, surface {mean(median_mm):.2f} mm, F1 {100 * mean(f1):.0f} %, "
          f"{mean(seconds):.0f} s (longest {max(seconds):.0f}), {max(mib):.0f} MiB")
    for low, high in ((0, 17), (17, 160), (160, 1000)):
        part = sorted((abs(e), holds) for h, e, holds in curve if low <= h < high)
        if part:
            print(f"stem {low} to {high} mm above the soil: {len(part)} diameters, error median {part[len(part) // 2][0]:.2f} mm, largest {part[-1][0]:.2f} mm, "
                  f"intervals hold {sum(holds for _, holds in part)}")


if __name__ == "__main__":
    main()
