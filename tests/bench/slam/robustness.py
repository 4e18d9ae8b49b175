#!/usr/bin/env python3
"""What a field day brings, simulated with truth: for each case a recording, the SLAM, and whether it mapped or said why not.

  robustness.py --build build/headless --work DIR [--cases gap rain ...] [--seconds 30] [--set option=value ...]

Wants bin/bole and bin/slam_accuracy in the build folder. Recordings stay in DIR and are used again. A case is right when the whole
walk is mapped within the bound of the case, or when the track is given up with a frame and a reason and what was mapped until there
is within the bound. Anything else is a failure of this program (exit status 1): a diverged pose must never be passed on silently.
"""

import argparse
import json
import pathlib
import re
import subprocess
import sys

REPOSITORY = pathlib.Path(__file__).resolve().parents[3]

# Changes to the recipe `demo`.
STEEP = {"name": "steep", "terrain": {"slope_deg": 25}}
SPARSE = {"name": "sparse", "size_m": 32, "buffer_m": 0, "trees": {"count": 10}}
FIELD = {"name": "field", "size_m": 60, "buffer_m": 0, "trees": {"count": 0},
         "understorey": {"shrubs_per_ha": 0, "saplings_per_ha": 0, "grass_per_ha": 4000},
         "terrain": {"undulation_m": 0.1, "rocks_per_ha": 0, "fallen_stems_per_ha": 0, "slope_deg": 1}}

# name: (words, recipe, options of simulate, bound of the ATE in cm, may be given up)
CASES = {
    "plain": ("nothing special", {}, [], 2, False),
    "walking": ("no standing still at the start", {}, ["--stand-still", "0"], 2, False),
    "turn": ("a turn of 360 deg on the spot at 90 deg/s", {}, ["--stand-still", "1", "--turn-on-spot", "360"], 2, False),
    "gap": ("1 s without packets, walking", {}, ["--gap-at", "12", "--gap", "1"], 3, False),
    "gap_turn": ("1 s without packets in the turn on the spot", {},
                 ["--stand-still", "1", "--turn-on-spot", "360", "--gap-at", "3", "--gap", "1"], 3, False),
    "gap_long": ("4 s without packets, walking", {}, ["--gap-at", "12", "--gap", "4"], 3, True),
    "dropped": ("20 % of the points missing", {}, ["--dropouts", "0.2"], 2, False),
    "half": ("60 % of the points missing", {}, ["--dropouts", "0.6"], 3, False),
    "sector": ("a sector of 120 deg missing", {}, ["--blind-sector", "120"], 2, False),
    "companion": ("a person walks round the bearer", {}, ["--companion", "true"], 2, False),
    "rain": ("2 % of the pulses end at drops", {}, ["--rain", "0.02"], 2, False),
    "downpour": ("20 % of the pulses end at drops", {}, ["--rain", "0.2"], 3, True),
    "steep": ("a slope of 25 deg", STEEP, [], 2, False),
    "sparse": ("10 trees on 32 x 32 m", SPARSE, [], 4, True),
    "field": ("a mown field", FIELD, [], 5, True),
    "hurried": ("2 m/s with twice the gait", {}, ["--speed", "2", "--gait", "2"], 3, False),
    "imu": ("an inertial unit of consumer grade", {}, ["--imu", "consumer"], 1, False),
    "imu_hurried": ("2 m/s with twice the gait, consumer unit", {}, ["--speed", "2", "--gait", "2", "--imu", "consumer"], 1.5, False),
    "imu_turn": ("a turn of 360 deg on the spot at 90 deg/s, consumer unit", {},
                 ["--stand-still", "1", "--turn-on-spot", "360", "--imu", "consumer"], 1, False),
    "imu_gap": ("4 s without packets, walking, consumer unit", {}, ["--gap-at", "12", "--gap", "4", "--imu", "consumer"], 3, True),
    "imu_field": ("a mown field, consumer unit", FIELD, ["--imu", "consumer"], 50, True),
    "imu_unknown": ("consumer unit, mount not known, clock 37 ms ahead", {},
                    ["--imu", "consumer", "--imu-mount-known", "false", "--imu-time-offset", "0.037"], 1.5, False),
    "vlp16": ("a VLP-16", {}, ["--sensor", "vlp16"], 4, False),
    "vlp16_field": ("a VLP-16 on a mown field", FIELD, ["--sensor", "vlp16"], 5, True),
}


def merged(base, changes):
    out = dict(base)
    for key, value in changes.items():
        out[key] = merged(out.get(key, {}), value) if isinstance(value, dict) else value
    return out


def recording(arguments, name, recipe, options):
    folder = arguments.work / name
    if (folder / "complete").exists():
        return folder
    folder.mkdir(parents=True, exist_ok=True)
    demo = json.loads((REPOSITORY / "resources/plots/demo.json").read_text())
    (folder / "plot.json").write_text(json.dumps(merged(demo, recipe)))
    command = [arguments.build / "bin/bole", "simulate", "--plot", folder / "plot.json", "--out", folder]
    command += ["--max-time", str(arguments.seconds), *options]
    subprocess.run(command, check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    (folder / "complete").touch()
    return folder


def number(pattern, text):
    found = re.search(pattern, text)
    return float(found.group(1)) if found else None


def judged(arguments, name):
    words, recipe, options, bound_cm, may_end = CASES[name]
    folder = recording(arguments, name, recipe, options)
    command = [arguments.build / "bin/slam_accuracy", f"scan={folder}", "frames=100000", "dense_map=false", *arguments.set]
    run = subprocess.run(command, capture_output=True, text=True)
    text = run.stdout + run.stderr
    ate_cm, worst_cm = number(r"ATE RMSE ([\d.]+) cm", text), number(r"worst ([\d.]+) cm", text)
    mapped, of = number(r"^(\d+) of", text), number(r"^\d+ of (\d+)", text)
    failed, seen = number(r"frames_failed (\d+)", text), number(r"weakest_observability ([\d.e+-]+)", text)
    lost = re.search(r"the track was lost at frame (\d+).*", text)
    within = ate_cm is not None and ate_cm <= bound_cm
    if ate_cm is None:
        reason = text.strip().splitlines()[-1] if text.strip() else "no word"
        verdict, right = "refused: " + reason, may_end and run.returncode == 1 and "slam_accuracy: " in text
    elif lost:
        verdict, right = ("ended: " if within else "ENDED TOO LATE: ") + lost.group(0), within and may_end
    else:
        verdict, right = ("mapped" if within else "DIVERGED"), within
    show = lambda v, digits=1: "-" if v is None else f"{v:.{digits}f}"
    frames = "-" if mapped is None else f"{mapped:.0f} of {of:.0f}"
    print(f"| {words} | {frames} | {show(failed, 0)} | {show(ate_cm)} | {show(worst_cm)} | {show(seen)} | {verdict} |", flush=True)
    return right


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--build", type=pathlib.Path, required=True)
    parser.add_argument("--work", type=pathlib.Path, required=True, help="folder for the recordings")
    parser.add_argument("--cases", nargs="+", default=list(CASES), choices=list(CASES))
    parser.add_argument("--seconds", type=float, default=30, help="length of each recording")
    parser.add_argument("--set", nargs="*", default=[], metavar="OPTION=VALUE", help="options of slam.run")
    arguments = parser.parse_args()
    print("| case | frames mapped | failed | ATE, cm | worst, cm | least observability | verdict |")
    print("|---|---|---|---|---|---|---|")
    right = [judged(arguments, name) for name in arguments.cases]
    print(f"\n{sum(right)} of {len(right)} as they should be")
    return 0 if all(right) else 1


if __name__ == "__main__":
    sys.exit(main())
