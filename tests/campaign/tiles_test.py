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
from bole_campaign import tile_edits, tile_merging  # noqa: E402

LOCAL = ("--engine", "local", "--workers", "2")
TILE_M = 22.0
# Tiles begin at multiples of their size: 500000 / 22 and 5400000 / 22 are none. Seams at x = 500016 and 500038, y = 5400010 and 5400032.
SEAMS = ((16.0, 10.0, 0.15), (16.02, 20.0, 0.12), (15.99, 25.0, 0.2), (30.0, 10.005, 0.1), (7.0, 32.0, 0.18))
POSITION_M, DIAMETER_CM = 0.001, 0.05


def rows_of(path):
    with open(path, encoding="utf-8-sig", newline="") as file:
        return list(csv.DictReader(file))


def whole(folder, name, *settings):
    """The folder with the results of the cloud as one."""
    words = [BOLE, "run", ENGINE.parents[1] / "pipelines" / "stem_map_from_cloud.json", "--out", folder / name, "--no-cache"]
    for setting in (f"scan.file={folder / 'forest.las'}", "report.figures=false", "report.cloud=false", *settings):
        words += ["--set", setting]
    done = subprocess.run(words, capture_output=True, text=True, timeout=400)
    if done.returncode != DONE:
        raise RuntimeError(done.stdout + done.stderr)
    return folder / name


@functools.lru_cache(maxsize=1)
def forest():
    """(folder, cloud, stems of the whole), made once."""
    place = tempfile.TemporaryDirectory(prefix="bole_forest_")
    folder = pathlib.Path(place.name)
    small_forest.write_forest(folder / "forest.las", on_seams=SEAMS, gap_m=3.5)
    return place, folder / "forest.las", rows_of(whole(folder, "whole") / "stems.csv")


def edit(action, x, y, above_ground_m, size_m, **more):
    z = small_forest.ground_z(x, y) + above_ground_m
    return {"action": action, "centre": [EAST + x, NORTH + y, z], "size_m": size_m, "author": "A. Smith", "reason": f"{action} at {x:g}", **more}


EAST, NORTH = 500000.0, 5400000.0
# Tops that are no part of a tree, by two actions; the top of a tree on a seam that is given to its neighbour in the tile beyond; to one that is not
# there; nothing at all; and on a condition that no point meets.
NEIGHBOUR = [EAST + 7.38, NORTH + 35.88]
EDITS = [edit("to_no_tree", 16, 10, 13, [5, 5, 4]), edit("to_noise", 30, 10, 13, [5, 5, 5]), edit("to_tree", 7, 32, 13, [5, 5, 4], tree=NEIGHBOUR),
         edit("to_tree", 7, 32, 12, [3, 3, 2], tree=[EAST + 7, NORTH + 700]), edit("to_noise", 20, 20, 60, [2, 2, 2]),
         edit("to_no_tree", 16, 20, 1.3, [0.5, 0.5, 0.5], only_tree=NEIGHBOUR)]


class Tiles(Toy):
    def tiled(self, **more):
        self.document({"pipeline": "stem_map_from_cloud", "cloud": str(forest()[1]), "tile_m": TILE_M, "buffer_m": 10, **more})

    def expect_whole(self, tiled, rows=None):
        """Each stem of the whole once, within the tolerances."""
        rows = rows or forest()[2]
        self.assertGreater(len(rows), 40)
        self.assertEqual(len(tiled), len(rows))
        left = [(float(r["x_m"]), float(r["y_m"]), float(r["dbh_cm"])) for r in tiled]
        for row in rows:
            x, y, d = (float(row[n]) for n in ("x_m", "y_m", "dbh_cm"))
            near = min(left, key=lambda s: (s[0] - x) ** 2 + (s[1] - y) ** 2)
            self.assertLess(max(abs(near[0] - x), abs(near[1] - y)), POSITION_M, row)
            self.assertLess(abs(near[2] - d), DIAMETER_CM, row)
            left.remove(near)

    def heights(self, rows):
        return {(round(float(r["x_m"]), 1), round(float(r["y_m"]), 1)): float(r["height_lower_bound_m"]) for r in rows}

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

    def test_points_given_by_hand_count_as_in_the_whole(self):
        self.write("edits.json", json.dumps(EDITS))
        single = whole(forest()[1].parent, "edited", f"points.file={self.folder / 'edits.json'}")
        self.tiled(set={"points.file": "edits.json"}, cloud_files=False)
        told = self.run_all(*LOCAL)
        rows = rows_of(single / "stems.csv")
        self.expect_whole(self.merged(), rows)
        ours, theirs, unedited = self.heights(self.merged()), self.heights(rows), self.heights(forest()[2])
        self.assertEqual({place for place, height in theirs.items() if abs(height - unedited[place]) > 1}, {(500016.0, 5400010.0), (500030.0, 5400010.0), (500007.0, 5400032.0)})
        for place, height in theirs.items():
            self.assertAlmostEqual(ours[place], height, delta=0.02, msg=place)
        edits = rows_of(self.out / "point_edits.csv")
        self.assertEqual([(r["action"], r["outcome"]) for r in edits], [(r["action"], r["outcome"]) for r in rows_of(single / "edits.csv")])
        self.assertEqual([r["outcome"] for r in edits], ["applied", "applied", "applied", "conflict", "conflict", "conflict"])
        self.assertIn("edit 4 of points (to_tree) is not applied", told)
        self.assertIn("no point lies in its selection", edits[4]["message"])
        at = min(self.merged(), key=lambda r: abs(float(r["x_m"]) - NEIGHBOUR[0]) + abs(float(r["y_m"]) - NEIGHBOUR[1]))
        self.assertEqual((edits[2]["tree_id"], edits[2]["author"]), (at["tree_id"], "A. Smith"))
        # An edit that is taken back measures anew what it reaches, and nothing else.
        begun = self.begun()[0]
        self.write("edits.json", json.dumps(EDITS[:2] + EDITS[3:]))
        self.run_all(*LOCAL)
        again = {name for name, n in self.begun()[0].items() if n > begun.get(name, 0) and name.endswith(".ground")}
        self.assertTrue(again, "nothing ran anew")
        self.assertLess(len(again), sum(name.endswith(".ground") for name in begun))

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
        self.refused({**good, "set": {"points.file": "absent.json"}}, "edits of points", "absent.json")
        self.refused({**good, "set": {"points.edits": "{}"}}, "edits of points", "no list of edits")
        pipeline = json.loads((ENGINE.parents[1] / "pipelines" / "stem_map_from_cloud.json").read_text())
        next(stage for stage in pipeline["stages"] if stage["id"] == "points")["options"] = {"file": "half.json"}
        self.write("edited.json", json.dumps(pipeline)), self.write("half.json", '[{"action":')
        self.refused({**good, "pipeline": "edited.json"}, "half.json", "no JSON")
        self.document(good)
        self.assertIn("no LAS, LAZ or COPC file", self.run_all(*LOCAL, expect=BAD_INPUT))


class EditsOfPoints(unittest.TestCase):
    """Which tiles an edit may reach, and what is told of it."""

    def test_the_box_of_each_form(self):
        box = tile_edits.box_around
        self.assertEqual(box({"centre": [10, 20, 0], "size_m": [4, 2, 9]}), (8, 19, 12, 21))
        self.assertEqual(box({"centre": [10, 20, 0], "size_m": [6, 8, 9], "turn_deg": 30}), (5, 15, 15, 25))
        self.assertEqual(box({"path": [[0, 0, 1], [4, 2, 1]], "radius_m": 0.5}), (-0.5, -0.5, 4.5, 2.5))
        flat, upright = [[0, 0, 1], [4, 0, 1], [4, 3, 1]], [[0, 0, 0], [4, 0, 0], [4, 0, 3]]
        self.assertEqual(box({"outline": flat}), (0, 0, 4, 3))
        self.assertIsNone(box({"outline": upright}))
        self.assertEqual(box({"outline": upright, "depth_m": [-1, 2]}), (0, -2, 4, 2))
        self.assertIsNone(box({"outline": flat, "eye": [0, 0, 9]}))
        self.assertEqual(box({"outline": upright, "within": [[1, -5, 0], [9, 5, 2]]}), (1, -5, 9, 5))
        for wrong in ({"path": 3, "radius_m": 1}, {"centre": [1], "size_m": [1, 1, 1]}, {"outline": [[0, 0, 0]] * 3}, {}):
            self.assertIsNone(box(wrong), wrong)
        self.assertTrue(tile_edits.meets((8, 19, 12, 21), [12, 0, 20, 20], 0) and not tile_edits.meets((8, 19, 12, 21), [13, 0, 20, 20], 0.5))

    def told(self, *rows, waiting=(), action="to_tree"):
        named = [({"name": f"t{k}"}, dict(zip(("points", "given", "lacks"), row))) for k, row in enumerate(rows)]
        return tile_edits.outcome({"action": action}, named, list(waiting), 10)

    def test_what_became_of_it(self):
        self.assertEqual(self.told((5, 5, ""), (0, 0, "tree")), ("applied", "5 points selected"))
        self.assertEqual(self.told((5, 0, ""), action="to_noise")[0], "applied")
        self.assertEqual(self.told((5, 0, ""))[1], "no point of its selection meets its condition")
        self.assertEqual(self.told((0, 0, ""), (0, 0, "tree"))[1], "no point lies in its selection")
        self.assertIn("3 of 8 points lie in tiles that do not see its tree (t1)", self.told((5, 5, ""), (3, 0, "tree"))[1])
        self.assertEqual(self.told((5, 5, ""), (3, 0, "tree of the condition"))[0], "applied")  # no point there can be of it
        for lacks in ("tree", "tree of the condition"):
            self.assertIn("not among the stems", self.told((5, 0, lacks))[1])
        state, message = self.told((5, 5, ""), waiting=["t7"])
        self.assertEqual(state, "open")
        self.assertIn("t7", message)


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
