#!/usr/bin/env python3
"""One cloud in tiles: the same stems as the whole, wherever the seams lie. BOLE in the environment is the program."""

import csv
import functools
import json
import os
import pathlib
import sqlite3
import subprocess
import sys
import tempfile
import time
import unittest

import small_forest
from toy import BAD_INPUT, BOLE, DONE, ENGINE, Toy

sys.path.insert(0, str(ENGINE))
from bole_campaign import tile_merging  # noqa: E402

LOCAL = ("--engine", "local", "--workers", "2")
TILE_M = 22.0
# Tiles begin at multiples of their size: 500000 / 22 and 5400000 / 22 are none. Seams at x = 500016 and 500038, y = 5400010 and 5400032.
SEAMS = ((16.0, 10.0, 0.15), (16.02, 20.0, 0.12), (15.99, 25.0, 0.2), (30.0, 10.005, 0.1), (7.0, 32.0, 0.18))
POSITION_M, DIAMETER_CM = 0.001, 0.05


def rows_of(path):
    with open(path, encoding="utf-8-sig", newline="") as file:
        return list(csv.DictReader(file))


@functools.lru_cache(maxsize=1)
def forest():
    """(folder, cloud, stems of the whole), made once."""
    place = tempfile.TemporaryDirectory(prefix="bole_forest_")
    folder = pathlib.Path(place.name)
    small_forest.write_forest(folder / "forest.las", on_seams=SEAMS, gap_m=3.5)
    done = subprocess.run([BOLE, "run", ENGINE.parents[1] / "pipelines" / "stem_map_from_cloud.json", "--set", f"scan.file={folder / 'forest.las'}", "--set", "report.figures=false",
                           "--set", "report.cloud=false", "--out", folder / "whole", "--no-cache"], capture_output=True, text=True, timeout=400)
    if done.returncode != DONE:
        raise RuntimeError(done.stdout + done.stderr)
    return place, folder / "forest.las", rows_of(folder / "whole" / "stems.csv")


class Tiles(Toy):
    def tiled(self, **more):
        self.document({"pipeline": "stem_map_from_cloud", "cloud": str(forest()[1]), "tile_m": TILE_M, "buffer_m": 10, **more})

    def expect_whole(self, tiled):
        """Each stem of the whole once, within the tolerances."""
        whole = forest()[2]
        self.assertGreater(len(whole), 40)
        self.assertEqual(len(tiled), len(whole))
        left = [(float(r["x_m"]), float(r["y_m"]), float(r["dbh_cm"])) for r in tiled]
        for row in whole:
            x, y, d = (float(row[n]) for n in ("x_m", "y_m", "dbh_cm"))
            near = min(left, key=lambda s: (s[0] - x) ** 2 + (s[1] - y) ** 2)
            self.assertLess(max(abs(near[0] - x), abs(near[1] - y)), POSITION_M, row)
            self.assertLess(abs(near[2] - d), DIAMETER_CM, row)
            left.remove(near)

    def test_tiles_give_the_stems_of_the_whole(self):
        self.tiled()
        told = self.run_all(*LOCAL)
        self.expect_whole(self.merged())
        self.assertEqual([int(r["tree_id"]) for r in self.merged()], list(range(1, 1 + len(self.merged()))))
        tiles = {r["input_id"] for r in self.merged()}
        self.assertGreaterEqual(len(tiles), 4, told)
        self.assertTrue(all((self.out / "tiles" / f"{name}.laz").is_file() for name in tiles))
        with sqlite3.connect(self.out / "campaign.gpkg") as db:
            inputs = {r[0]: r[1:] for r in db.execute("SELECT input_id, state, seconds, peak_mib, error, stems FROM inputs")}
            stems = db.execute("SELECT input_id, tree_id, x_m, geom FROM stems ORDER BY fid").fetchall()
        self.assertEqual({r[0] for r in inputs.values()}, {"done"})
        self.assertTrue(tiles <= set(inputs))
        self.assertEqual(sum(r[4] or 0 for r in inputs.values()), len(stems))
        self.assertEqual(sorted(int(r[1]) for r in stems), list(range(1, 1 + len(stems))))
        self.assertIn("svg", (self.out / "campaign.html").read_text())
        # Nothing runs twice, and what changes runs alone.
        begun = self.begun()
        self.run_all(*LOCAL)
        self.assertEqual(self.begun(), begun)
        self.tiled(set={"stems.min_dbh": 4.9})
        self.run_all(*LOCAL)
        self.assertEqual(self.begun()[0]["cut"], 1)

    def test_the_grid_may_lie_anywhere(self):
        self.tiled(shift_m=[TILE_M / 2, TILE_M / 2], cloud_files=False)
        self.run_all(*LOCAL)
        self.expect_whole(self.merged())

    def test_a_client_that_is_killed_costs_time_and_nothing_else(self):
        self.tiled(tile_m=1.5 * TILE_M, cloud_files=False)
        for seconds in (1.0, 6.0):
            client = self.start(*LOCAL)
            time.sleep(seconds)
            client.kill()
            client.wait()
        self.run_all(*LOCAL)
        self.expect_whole(self.merged())
        self.assertTrue(all(n == 1 for n in self.begun()[1].values()), self.begun())

    def test_a_job_array_goes_through_the_phases(self):
        self.tiled(tile_m=1.5 * TILE_M, cloud_files=False)
        for _ in range(2):  # cut; terrain of the first tile
            self.run_all("--task", "1")
        tiles = len(rows_of(self.out / "tasks" / "cut" / "done" / "tiles.csv"))
        for _ in range(3):
            for k in range(1, tiles + 1):
                self.run_all("--task", str(k))
        self.expect_whole(self.merged())


class Documents(Toy):
    def refused(self, content, *words):
        self.document(content)
        told = self.run_all(expect=BAD_INPUT)
        for word in words:
            self.assertIn(word, told)
        self.assertFalse(self.out.exists(), "a refused document leaves no trace")

    def test_what_is_wrong_is_told(self):
        self.write("cloud.las", "no cloud")
        good = {"pipeline": "stem_map_from_cloud", "cloud": "cloud.las", "tile_m": 50, "buffer_m": 10}
        self.refused({**good, "cloud": "clout.las"}, "no file", "clout.las")
        self.refused({**good, "cloud": "*.laz"}, "gives no file")
        self.refused({k: v for k, v in good.items() if k != "cloud"}, "has no 'cloud'")
        self.refused({**good, "tile_m": "big"}, "tile_m", "'big'")
        self.refused({**good, "shift_m": 3}, "shift_m", "two numbers")
        self.refused({**good, "inputs": []}, "'inputs'")
        self.refused({**good, "pipeline": "forest_plot"}, "no single stage io.read_cloud")
        self.refused({**good, "set": {"scan.bounds": "0,0,1,1"}}, "scan.bounds", "The tiles decide")
        self.refused({**good, "set": {"plot.width": 20}}, "plot.width", "not run in tiles")
        self.refused({**good, "set": {"points.file": "edits.json"}}, "points.file", "not run in tiles")
        pipeline = json.loads((ENGINE.parents[1] / "pipelines" / "stem_map_from_cloud.json").read_text())
        next(stage for stage in pipeline["stages"] if stage["id"] == "points")["options"] = {"edits": [{"action": "to_noise", "centre": [1, 2, 3], "size_m": [1, 1, 1]}]}
        self.write("edited.json", json.dumps(pipeline))
        self.refused({**good, "pipeline": "edited.json"}, "edits of points", "not applied in tiles")
        self.document(good)
        self.assertIn("no LAS, LAZ or COPC file", self.run_all(*LOCAL, expect=BAD_INPUT))


class Ownership(unittest.TestCase):
    """Two tiles of 10 m side by side, with buffers of 5 m."""

    LEFT = {"name": "left", "column": 0, "row": 0, "core": [0.0, 0.0, 10.0, 10.0]}
    RIGHT = {"name": "right", "column": 1, "row": 0, "core": [10.0, 0.0, 20.0, 10.0]}

    def measure(self, tile, tree_id, x, y=5.0, dbh=30, arc=360):
        return tile_merging.Measure(tile, {"tree_id": str(tree_id), "x_m": str(x), "y_m": str(y), "dbh_cm": str(dbh), "arc_deg": str(arc)})

    def kept(self, left, right):
        def owner(m):
            return "left" if m.x < 10 else "right"

        groups = tile_merging.groups_of({"left": left, "right": right}, [("left", "right")])
        return sorted((m.tile["name"], m.tree_id) for group in groups if (m := tile_merging.chosen(group, owner)) is not None)

    def test_a_stem_in_a_core_counts_there(self):
        self.assertEqual(self.kept([self.measure(self.LEFT, 1, 9)], [self.measure(self.RIGHT, 1, 9.0004)]), [("left", 1)])

    def test_a_stem_on_the_seam_counts_once(self):
        both = [self.measure(self.LEFT, 1, 9.9999, arc=200)], [self.measure(self.RIGHT, 7, 10.0001, arc=300)]
        self.assertEqual(self.kept(*both), [("right", 7)])
        neither = [self.measure(self.LEFT, 1, 10.0001, arc=200)], [self.measure(self.RIGHT, 7, 9.9999, arc=100)]
        self.assertEqual(self.kept(*neither), [("left", 1)])

    def test_the_upper_edge_belongs_to_the_next_tile(self):
        self.assertEqual(self.kept([self.measure(self.LEFT, 1, 10)], [self.measure(self.RIGHT, 2, 10)]), [("right", 2)])

    def test_what_only_a_buffer_shows_does_not_count(self):
        self.assertEqual(self.kept([self.measure(self.LEFT, 1, 12)], []), [])

    def test_two_stems_that_touch_stay_two(self):
        left = [self.measure(self.LEFT, 1, 9.8), self.measure(self.LEFT, 2, 10.1)]
        right = [self.measure(self.RIGHT, 1, 9.8001), self.measure(self.RIGHT, 2, 10.1001)]
        self.assertEqual(self.kept(left, right), [("left", 1), ("right", 2)])


if __name__ == "__main__":
    unittest.main()
