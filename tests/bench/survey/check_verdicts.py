#!/usr/bin/env python3
"""Does the check of the map tell spoilt plots from good ones?

    check_verdicts.py --bole build/headless/bin/bole [--seeds 31 32 ...] [--work DIR]

Simulates a small plot per seed, surveys it (SLAM, stems), and checks the finished map as it is and spoilt in every way of SPOILS. A good
plot must get the verdict sign; a spoilt one another verdict, with the finding that names the damage. The thresholds of the options were
set on seeds 21 to 23; the default seeds are others. Needs numpy.
"""

import argparse
import csv
import json
import pathlib
import subprocess
import sys

import numpy as np

from las_records import Las

RECIPE = {
    "name": "check", "title": "A plot of 16 m in lanes of 5 m, for the check of the map", "size_m": 16, "buffer_m": 4,
    "layout": {"kind": "natural", "min_spacing_m": 1.4, "clustering": 0.2},
    "trees": {"count": 20, "dbh_mean_cm": 24.0, "dbh_sd_cm": 7.0, "dbh_min_cm": 9, "dbh_max_cm": 60, "conifer_share": 0.3},
    "terrain": {"slope_deg": 5, "aspect_deg": 160, "undulation_m": 0.3},
    "understorey": {"shrubs_per_ha": 200, "saplings_per_ha": 100, "grass_per_ha": 1500},
}
LANES = (-7.5, -2.5, 2.5, 7.5)
WALK = [(0, -1), (-7.5, -7.5), (-7.5, 7.5), (-2.5, 7.5), (-2.5, -7.5), (2.5, -7.5), (2.5, 7.5), (7.5, 7.5), (7.5, -7.5)]
HALF = 8.0  # of the plot
REPOSITORY = pathlib.Path(__file__).resolve().parents[3]


def run(*command):
    done = subprocess.run([str(c) for c in command], capture_output=True, text=True)
    if done.returncode != 0:
        sys.exit(f"{' '.join(map(str, command))}\n{done.stderr[-2000:]}")
    return done


def read_rows(path):
    with open(path, newline="") as file:
        return list(csv.DictReader(file))


def write_rows(path, rows, columns):
    with open(path, "w", newline="") as file:
        out = csv.DictWriter(file, columns)
        out.writeheader()
        out.writerows(rows)


class Survey:
    """A finished survey of a simulated plot in memory, to be spoilt and checked."""

    def __init__(self, folder):
        self.las = Las(folder / "cloud.las")
        self.poses = np.loadtxt(folder / "trajectory.tum")
        self.stems, self.loops = read_rows(folder / "stems.csv"), read_rows(folder / "loops.csv")
        summary = json.loads((folder / "summary.json").read_text())
        frame = next(s for s in summary["stages"] if s["id"] == "frame")
        distance = frame["metrics"]["target_distance"]["value"]
        self.targets = [{"name": "centre", "x_m": 0, "y_m": 0}, {"name": "north", "x_m": 0, "y_m": distance}]
        self.options = {"target_distance": round(distance, 2)}

    @property
    def points(self):
        return self.las.points

    def keep(self, chosen):
        self.las.points = self.las.points[chosen]

    def second_half(self):
        middle = (self.poses[0, 0] + self.poses[-1, 0]) / 2
        return self.points["time"] > middle, self.poses[:, 0] > middle

    def slip(self, x, y, z):
        points, poses = self.second_half()
        for k, by in enumerate((x, y, z)):
            self.las.shift(k, by, points)
            self.poses[poses, 1 + k] += by
        self.points["height_above_ground"][points] += z

    def stems_in_plot(self):
        return [i for i, s in enumerate(self.stems) if max(abs(float(s["x_m"])), abs(float(s["y_m"]))) < HALF - 1]

    def check(self, bole, folder):
        folder.mkdir(parents=True, exist_ok=True)
        self.las.write(folder / "cloud.las")
        np.savetxt(folder / "path.tum", self.poses, fmt="%.7f")
        write_rows(folder / "stems.csv", self.stems, self.stems[0].keys())
        write_rows(folder / "loops.csv", self.loops, LOOP_COLUMNS)
        write_rows(folder / "targets.csv", self.targets, ["name", "x_m", "y_m"])
        document = {"stages": [
            {"id": "cloud", "type": "io.read_cloud", "options": {"file": str(folder / "cloud.las"), "level": "none"}},
            {"id": "path", "type": "io.read_trajectory", "options": {"file": str(folder / "path.tum"), "axes": "plot"}},
            *({"id": name, "type": "io.read_table", "options": {"file": str(folder / f"{name}.csv")}} for name in ("stems", "loops", "targets")),
            {"id": "plot", "type": "survey.plot", "inputs": {"points": "cloud.points"},
             "options": {"shape": "rectangle", "width": 2 * HALF, "length": 2 * HALF, "x": 0, "y": 0}},
            {"id": "check", "type": "survey.check", "options": self.options, "inputs": {
                "points": "cloud.points", "trajectory": "path.trajectory", "stems": "stems.table", "plot": "plot.plot",
                "loops": "loops.table", "targets": "targets.table"}},
            {"id": "report", "type": "report.plot", "options": {"figures": False, "page": False, "tables": False, "cloud": False}, "inputs": {
                "stems": "stems.table", "plot": "plot.plot", "check": "check.findings", "check_cells": "check.cells"}},
        ]}
        (folder / "check_only.json").write_text(json.dumps(document))
        run(bole, "run", folder / "check_only.json", "--no-cache", "--out", folder / "out")
        (folder / "cloud.las").unlink()
        return json.loads((folder / "out/check.json").read_text())


LOOP_COLUMNS = "from_time_s,to_time_s,way_m,correction_m,overlap,found_by,x_m,y_m,z_m,qx,qy,qz,qw".split(",")


def lane_left_out(survey, random, lane=None):
    lane = lane if lane is not None else LANES[random.integers(1, 3)]
    end = HALF - 1.5  # the turns between lanes are walked
    survey.keep(~((abs(survey.points["sensor_x"] - lane) < 1.5) & (abs(survey.points["sensor_y"]) < end)))
    survey.poses = survey.poses[~((abs(survey.poses[:, 1] - lane) < 1.5) & (abs(survey.poses[:, 2]) < end))]


def edge_lane_left_out(survey, random):
    lane_left_out(survey, random, LANES[-1])


def slipped_loop(survey, random):
    turn = random.uniform(0, 2 * np.pi)
    survey.slip(0.25 * np.cos(turn), 0.25 * np.sin(turn), 0)


def slip_in_height(survey, random):
    survey.slip(0, 0, 0.10)


def drift(survey, random):
    turn, (begin, end) = random.uniform(0, 2 * np.pi), survey.poses[[0, -1], 0]
    for k, by in enumerate((0.3 * np.cos(turn), 0.3 * np.sin(turn))):
        survey.las.shift(k, by * (survey.points["time"] - begin) / (end - begin))
        survey.poses[:, 1 + k] += by * (survey.poses[:, 0] - begin) / (end - begin)


def tilted_frame(survey, random):
    turn = random.uniform(0, 2 * np.pi)
    for stem in survey.stems:
        azimuth, tangent = np.radians(float(stem["lean_azimuth_deg"])), np.tan(np.radians(float(stem["lean_deg"])))
        x = tangent * np.sin(azimuth) + np.tan(np.radians(2.5)) * np.sin(turn)
        y = tangent * np.cos(azimuth) + np.tan(np.radians(2.5)) * np.cos(turn)
        stem["lean_deg"], stem["lean_azimuth_deg"] = np.degrees(np.arctan(np.hypot(x, y))), np.degrees(np.arctan2(x, y)) % 360


def missing_target(survey, random):
    survey.targets = survey.targets[:1]


def wrong_target(survey, random):
    survey.targets[1]["y_m"] += 0.3


def doubled_walls(survey, random):
    survey.las.shift(0, 0.08, random.random(len(survey.points)) < 0.5)


def hole_in_the_ground(survey, random):
    x, y = random.uniform(-5, 5, 2)
    low = survey.points["height_above_ground"] < 0.5
    survey.keep(~(low & (np.hypot(survey.las.axis(0) - x, survey.las.axis(1) - y) < 2.2)))


def corner_not_scanned(survey, random):
    survey.keep(~((survey.las.axis(0) > 2) & (survey.las.axis(1) > 2)))


def stems_left_out(survey, random):
    thick = [i for i in survey.stems_in_plot() if float(survey.stems[i]["dbh_cm"]) > 15]
    gone = set(random.choice(thick, 3, replace=False))
    survey.stems = [s for i, s in enumerate(survey.stems) if i not in gone]


def stems_twice(survey, random):
    for i in survey.stems_in_plot()[:2]:
        survey.stems.append(dict(survey.stems[i], tree_id=1000 + i, x_m=float(survey.stems[i]["x_m"]) + 0.06))


def wrong_loop(survey, random):
    survey.loops[len(survey.loops) // 2]["x_m"] = float(survey.loops[len(survey.loops) // 2]["x_m"]) + 0.4


# The damage, and the findings of which one must name it.
SPOILS = {
    lane_left_out: {"lane_not_walked"},
    edge_lane_left_out: {"lane_not_walked"},
    slipped_loop: {"stem_passes_apart", "stand_doubled"},
    slip_in_height: {"ground_passes_apart"},
    drift: {"stem_passes_apart", "stand_doubled"},
    tilted_frame: {"frame_tilted"},
    missing_target: {"target_missing"},
    wrong_target: {"target_distance"},
    doubled_walls: {"walls_thick"},
    hole_in_the_ground: {"ground_never_seen"},
    corner_not_scanned: {"plot_partly_empty", "ground_never_seen"},
    stems_left_out: {"stems_left_out"},
    stems_twice: {"stems_overlap"},
    wrong_loop: {"loops_disagree"},
}


def surveyed(bole, seed, work):
    """The folder of the finished survey of a seed; made once."""
    folder = work / f"survey_{seed}"
    if (folder / "summary.json").is_file():
        return folder
    scan = work / f"scan_{seed}"
    (work / "recipe.json").write_text(json.dumps(RECIPE))
    (work / "walk.csv").write_text("x_m,y_m\n" + "".join(f"{x},{y}\n" for x, y in WALK))
    run(bole, "simulate", "--plot", work / "recipe.json", "--seed", seed, "--sensor", "vlp16", "--speed", 1.5, "--walk", work / "walk.csv", "--out", scan)
    run(bole, "run", REPOSITORY / "pipelines/forest_plot.json", "--set", f"scan.file={scan / 'walk.pcap'}", "--set", f"plot.width={2 * HALF}",
        "--set", f"plot.length={2 * HALF}", "--set", "report.figures=false", "--set", "report.page=false", "--set", "report.cloud_format=las", "--no-cache", "--out", folder)
    crop(folder / "cloud.las")
    (scan / "walk.pcap").unlink()
    return folder


def crop(path):
    """Leaves what lies about the plot, and of that every second point: the checks read it many times."""
    las = Las(path)
    chosen = (abs(las.axis(0)) < HALF + 1.5) & (abs(las.axis(1)) < HALF + 1.5)
    las.points = las.points[chosen][::2]
    las.write(path)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--bole", required=True, type=pathlib.Path)
    parser.add_argument("--seeds", type=int, nargs="+", default=list(range(31, 41)))
    parser.add_argument("--all-spoils", action="store_true", help="every damage on every seed, not one damage per seed")
    parser.add_argument("--work", type=pathlib.Path, default=pathlib.Path("check_verdicts"))
    arguments = parser.parse_args()
    arguments.work.mkdir(parents=True, exist_ok=True)
    right, wrong = 0, 0
    spoils = list(SPOILS)
    print(f"{'seed':>4} {'plot':<20} {'verdict':<11} findings")
    for k, seed in enumerate(arguments.seeds):
        folder = surveyed(arguments.bole, seed, arguments.work)
        for spoil in [None, *(spoils if arguments.all_spoils else [spoils[k % len(spoils)]])]:
            survey, name = Survey(folder), "good" if spoil is None else spoil.__name__
            if spoil is not None:
                spoil(survey, np.random.default_rng(seed))
            check = survey.check(arguments.bole, arguments.work / f"check_{seed}_{name}")
            codes = [f["code"] for f in check["findings"] if f["severity"] != "note"]
            ok = check["verdict"] == "sign" if spoil is None else check["verdict"] != "sign" and bool(SPOILS[spoil] & set(codes))
            right, wrong = right + ok, wrong + (not ok)
            print(f"{seed:>4} {name:<20} {check['verdict']:<11} {', '.join(codes)}{'' if ok else '   <-- WRONG'}", flush=True)
    print(f"{right} of {right + wrong} verdicts are right")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
