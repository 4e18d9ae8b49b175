#!/usr/bin/env python3
"""The comparer of results notices one changed digit in every kind of table, and nothing else."""

import contextlib
import io
import json
import pathlib
import shutil
import sqlite3
import stat
import struct
import sys
import tempfile
import unittest
import zlib
from unittest import mock

import result_tables
import same_results

NAME = "steering_test"  # any pipeline without a recording


def write_las(path, x=(100, 200, 300), reflectance=(0.5, 0.25, 1.0), note=b""):
    """LAS 1.2, format 1, with the extra dimension reflectance; `note` is a record of variable length that says something about the file."""
    extra = struct.pack("<2xBB32s156x", 9, 0, b"reflectance")
    records = b"".join(struct.pack("<2x16sHH32x", user, number, len(body)) + body
                       for user, number, body in [(b"LASF_Spec", 4, extra), (b"note", 1, note)][:2 if note else 1])
    size = 28 + 4
    header = bytearray(227)
    header[:4] = b"LASF"
    header[24:26] = bytes([1, 2])
    struct.pack_into("<HIIBHI", header, 94, 227, 227 + len(records), 2 if note else 1, 1, size, len(x))
    struct.pack_into("<6d", header, 131, 0.001, 0.001, 0.001, 0, 0, 0)
    points = b"".join(struct.pack("<iiiHBBbBHdf", v, 2 * v, 3 * v, 7, 1, 2, -5, 0, 1, 0.1 * v, r) for v, r in zip(x, reflectance))
    path.write_bytes(bytes(header) + records + points)


def write_tiff(path, rows):
    """float32, one DEFLATE strip per row, predictor 3."""
    width = len(rows[0])
    strips = []
    for row in rows:
        raw = struct.pack(f"<{width}f", *row)
        planes = b"".join(raw[3 - plane::4] for plane in range(4))
        strips.append(zlib.compress(bytes((b - (planes[i - 1] if i else 0)) & 255 for i, b in enumerate(planes))))
    data = bytearray(8)
    offsets = []
    for strip in strips:
        offsets.append(len(data))
        data += strip
    arrays = {273: (4, offsets), 279: (4, [len(s) for s in strips]), 33550: (12, [0.5, 0.5, 0])}
    entries = [(256, 4, [width]), (257, 4, [len(rows)]), (258, 3, [32]), (259, 3, [8]), (277, 3, [1]), (278, 4, [1]), (317, 3, [3]), (339, 3, [3])]
    entries += [(tag, kind, values) for tag, (kind, values) in arrays.items()]
    packed = []
    for tag, kind, values in sorted(entries):
        body = struct.pack(f"<{len(values)}{result_tables.TIFF_TYPES[kind]}", *values)
        if len(body) > 4:
            where = len(data)
            data += body
            body = struct.pack("<I", where)
        packed.append(struct.pack("<HHI", tag, kind, len(values)) + body.ljust(4, b"\0"))
    struct.pack_into("<2sHI", data, 0, b"II", 42, len(data))
    data += struct.pack("<H", len(packed)) + b"".join(packed) + bytes(4)
    path.write_bytes(data)


def write_geopackage(path, dbh="21.5"):
    path.unlink(missing_ok=True)
    base = sqlite3.connect(path)
    base.executescript(f"""CREATE TABLE gpkg_contents (table_name TEXT, last_change TEXT);
        INSERT INTO gpkg_contents VALUES ('stems', datetime('now'));
        CREATE TABLE stems (fid INTEGER, geom BLOB, dbh_cm REAL); INSERT INTO stems VALUES (1, x'4750', {dbh});""")
    base.close()


SUMMARY = {"bole": "1.0", "seconds": 3.5, "exit_code": 0, "axes": "plot", "stages": [
    {"id": "stems", "type": "stems.measure", "state": "done", "seconds": 1.25, "peak_mib": 12.5, "status": "ok", "message": "2 stems",
     "counts": {"stems": 2}, "metrics": {"dbh_mean": {"value": 21.5, "unit": "cm"}}, "facts": {"beam_mrad": "3.0", "beam_of": "sensor"}}]}


def summary(**changes):
    """The text of summary.json with changes to its one stage."""
    whole = json.loads(json.dumps(SUMMARY))
    whole["stages"][0].update(changes)
    return json.dumps(whole)


def geojson(x):
    return json.dumps({"type": "FeatureCollection", "features": [
        {"type": "Feature", "properties": {"row_id": 1}, "geometry": {"type": "LineString", "coordinates": [[0.5, 1.25], [x, 2]]}}]})


def fill(folder):
    folder.mkdir(parents=True)
    same_results.keep_state(folder, state="done", program="1", words=[], seconds=1)
    (folder / "stems.csv").write_text("tree_id,dbh_cm,reason\n1,21.50,\n2,33.10,12 points are too few\n")
    (folder / "trajectory.tum").write_text("1.000000 0.1 0.2 0.3 0 0 0 1\n")
    (folder / "summary.json").write_text(summary())
    (folder / "ab_lines.geojson").write_text(geojson(7.5))
    (folder / "report.html").write_text("<p>21.5 cm</p>")
    write_las(folder / "cloud.las")
    write_tiff(folder / "dem.tif", [[1.5, 2.25, float("nan")], [-3.125, 4, 1e6]])
    write_geopackage(folder / "plot.gpkg")


class Comparing(unittest.TestCase):
    def setUp(self):
        self.folder = pathlib.Path(tempfile.mkdtemp())
        self.addCleanup(shutil.rmtree, self.folder)
        self.before, self.after = (self.folder / n / NAME for n in ("before", "after"))
        fill(self.before)
        fill(self.after)

    def compare(self, *words):
        out = io.StringIO()
        with contextlib.redirect_stdout(out), mock.patch.object(
                sys, "argv", ["same_results.py", "compare", str(self.before.parent), str(self.after.parent), "--only", NAME, *words]):
            code = same_results.main()
        return code, out.getvalue()

    def expect(self, code, *texts, words=()):
        found, out = self.compare(*words)
        self.assertEqual(found, code, out)
        for text in texts:
            self.assertIn(text, out)

    def test_equal_runs_are_equal(self):
        self.expect(0, "equal (7 files", "files that were not compared: report.html", "1 equal, 0 different")

    def test_values_are_read_as_they_were_written(self):
        points = result_tables.read_las(self.before / "cloud.las")["points"]
        self.assertEqual(list(points["Y"].values()), [200, 400, 600])
        self.assertEqual(list(points["reflectance"].values()), [0.5, 0.25, 1.0])
        pixels = list(result_tables.read_geotiff(self.before / "dem.tif")["pixels"]["value"])
        self.assertEqual(pixels[:2] + pixels[3:], [1.5, 2.25, -3.125, 4, 1e6])

    def test_a_digit_of_a_table(self):
        (self.after / "stems.csv").write_text("tree_id,dbh_cm,reason\n1,21.51,\n2,33.10,12 points are too few\n")
        self.expect(1, "changed: stems.csv: dbh_cm: 1 of 2 rows differ, by 0.01 at most; row 1: 21.50 -> 21.51")

    def test_a_number_that_is_printed_with_fewer_digits(self):
        (self.after / "stems.csv").write_text("tree_id,dbh_cm,reason\n1,21.5,\n2,33.10,12 points are too few\n")
        self.expect(1, "stems.csv: dbh_cm: 1 of 2 rows differ, by 0 at most; row 1: 21.50 -> 21.5")

    def test_a_row_more(self):
        (self.after / "trajectory.tum").write_text("1.000000 0.1 0.2 0.3 0 0 0 1\n" * 2)
        self.expect(1, "trajectory.tum: qw: 1 rows -> 2")

    def test_a_pose(self):
        (self.after / "trajectory.tum").write_text("1.000000 0.1 0.2 0.31 0 0 0 1\n")
        self.expect(1, "trajectory.tum: z_m: 1 of 1 rows differ, by 0.01 at most")

    def test_a_number_of_the_summary(self):
        (self.after / "summary.json").write_text(summary(metrics={"dbh_mean": {"value": 21.6, "unit": "cm"}}))
        self.expect(1, "summary.json: stages.stems.metrics.dbh_mean.value: 1 of 1 rows differ, by 0.1 at most")

    def test_a_state_and_a_number_among_the_facts(self):
        (self.after / "summary.json").write_text(summary(state="failed", facts={"beam_mrad": "3.1"}))
        self.expect(1, "stages.stems.state", "stages.stems.facts.beam_mrad")

    def test_time_memory_and_text_of_the_summary_may_change(self):
        (self.after / "summary.json").write_text(summary(seconds=9, peak_mib=1, message="Two stems.", facts={"beam_mrad": "3.0", "beam_of": "cloud"}))
        self.expect(0)

    def test_a_vertex(self):
        (self.after / "ab_lines.geojson").write_text(geojson(7.25))
        self.expect(1, "ab_lines.geojson, vertices: x: 1 of 2 rows differ, by 0.25 at most")

    def test_a_point(self):
        write_las(self.after / "cloud.las", x=(100, 200, 301))
        self.expect(1, "cloud.las, points: X: 1 of 3 rows differ, by 1 at most; row 3", "cloud.las, points: gps_time")

    def test_an_extra_dimension_of_the_points(self):
        write_las(self.after / "cloud.las", reflectance=(0.5, 0.25, 1.5))
        self.expect(1, "cloud.las, points: reflectance: 1 of 3 rows differ, by 0.5 at most")

    def test_facts_beside_the_points_are_no_difference(self):
        write_las(self.after / "cloud.las", note=b"range noise 1.2 cm")
        self.expect(0)

    def test_a_pixel(self):
        write_tiff(self.after / "dem.tif", [[1.5, 2.25, float("nan")], [-3.0, 4, 1e6]])
        self.expect(1, "dem.tif, pixels: value: 1 of 6 rows differ, by 0.125 at most; row 4")

    def test_a_hole_in_a_raster(self):
        write_tiff(self.after / "dem.tif", [[1.5, 2.25, 2], [-3.125, 4, 1e6]])
        self.expect(1, "dem.tif, pixels: value: 1 of 6 rows differ, 1 of them in words or empty cells")

    def test_an_attribute_of_a_layer(self):
        write_geopackage(self.after / "plot.gpkg", dbh="21.75")
        self.expect(1, "plot.gpkg, stems: dbh_cm: 1 of 1 rows differ, by 0.25 at most")

    def test_a_column_or_file_on_one_side_is_listed_by_itself(self):
        (self.after / "stems.csv").write_text("tree_id,dbh_cm,reason,height_m\n1,21.50,,9\n2,33.10,12 points are too few,8\n")
        (self.before / "loops.csv").write_text("a\n1\n")
        self.expect(1, "only after: stems.csv: height_m", "only before: loops.csv")
        (self.before / "loops.csv").unlink()
        self.expect(1)
        self.expect(0, "only after: stems.csv: height_m", words=["--allow-added"])

    def test_what_only_the_old_run_has_is_never_allowed(self):
        (self.after / "stems.csv").unlink()
        self.expect(1, "only before: stems.csv", words=["--allow-added"])

    def test_new_names(self):
        (self.after / "stems.csv").rename(self.after / "trees.csv")
        (self.after / "trees.csv").write_text((self.after / "trees.csv").read_text().replace("dbh_cm", "diameter_cm"))
        (self.after / "summary.json").write_text(summary(metrics={"mean_dbh": {"value": 21.5, "unit": "cm"}}))
        self.expect(1)
        names = ["--renamed", "stems.csv=trees.csv", "--renamed", "dbh_cm=diameter_cm", "--renamed", "stems.metrics.dbh_mean=stems.metrics.mean_dbh"]
        self.expect(1, "only before: plot.gpkg, stems: diameter_cm", words=names)  # the layer kept the old name
        write = self.folder / "names"
        write.write_text("# renamed on purpose\nstems.csv=trees.csv\n")
        self.expect(1, "trees.csv: dbh_cm", words=["--renamed", f"@{write}"])

    def test_what_is_left_out_on_purpose(self):
        (self.before / "stems.csv").write_text("tree_id,dbh_cm,reason,score\n1,21.50,,9\n2,33.10,12 points are too few,8\n")
        self.expect(1, "only before: stems.csv: score")
        self.expect(0, words=["--renamed", "score="])

    def test_other_words_for_the_same(self):
        (self.after / "stems.csv").write_text("tree_id,dbh_cm,reason\n1,21.50,\n2,33.10,only 12 points\n")
        self.expect(1, "stems.csv: reason: 1 of 2 rows differ, 1 of them in words")
        self.expect(0, words=["--reworded", "reason"])
        (self.after / "stems.csv").write_text("tree_id,dbh_cm,reason\n1,21.50,\n2,33.10,only 13 points\n")
        self.expect(1, words=["--reworded", "reason"])

    def test_two_sentences_that_became_one(self):
        self.assertFalse(same_results.same_but_reworded(["auto", "check"], ["good", "good"]))
        self.assertFalse(same_results.same_but_reworded(["auto", "auto"], ["good", "bad"]))

    def test_absent_data_is_counted_and_a_missing_result_is_a_difference(self):
        same_results.keep_state(self.after, state="absent", missing=["FILE"])
        self.expect(1, "done before, absent after")
        same_results.keep_state(self.before, state="absent", missing=["FILE"])
        self.expect(0, "data was absent in both runs (FILE)", "1 not compared because their data is absent")
        shutil.rmtree(self.after)
        self.expect(1, "not run after")


class Running(unittest.TestCase):
    def setUp(self):
        self.folder = pathlib.Path(tempfile.mkdtemp())
        self.addCleanup(shutil.rmtree, self.folder)
        self.bole = self.folder / "bole"
        self.make("exit 0")

    def make(self, last):
        """A program that writes down how it was called."""
        self.bole.write_text(f'#!/bin/sh\necho "$@" >> {self.folder}/calls\n{last}\n')
        self.bole.chmod(self.bole.stat().st_mode | stat.S_IXUSR)

    def run_with(self, *words):
        (self.folder / "calls").write_text("")
        out = io.StringIO()
        with contextlib.redirect_stdout(out), mock.patch.object(sys, "argv", [
                "same_results.py", "run", "--bole", str(self.bole), "--out", str(self.folder / "out"), "--data", str(self.folder / "data"), *words]):
            code = same_results.main()
        return code, out.getvalue(), (self.folder / "calls").read_text().splitlines()

    def test_a_second_call_runs_nothing_again(self):
        self.assertEqual(len(self.run_with("--only", "steering_test")[2]), 1)
        code, out, calls = self.run_with("--only", "steering_test")
        self.assertEqual((code, calls), (0, []), out)
        self.assertIn("was done before", out)

    def test_another_program_runs_all_again(self):
        self.run_with("--only", "steering_test")
        self.make("true")
        self.assertEqual(len(self.run_with("--only", "steering_test")[2]), 1)

    def test_absent_data_is_said_and_counted(self):
        code, out, calls = self.run_with("--only", "steering_test", "cloud_pine_plot")
        self.assertEqual((code, len(calls)), (0, 1))
        self.assertIn("pine_plot.laz absent", out)
        self.assertIn("2 pipelines: 1 done, 0 failed, 1 skipped because their data is absent", out)

    def test_a_failure_is_a_failure(self):
        self.make("exit 2")
        code, out, _ = self.run_with("--only", "steering_test")
        self.assertEqual(code, 1)
        self.assertIn("FAILED with exit code 2", out)

    def test_renamed_options(self):
        calls = self.run_with("--only", "steering_test", "--renamed", "drive.repeats=drive.runs")[2]
        self.assertIn("drive.runs=3", calls[0])
        self.assertNotIn("drive.repeats", calls[0])
        self.assertNotIn("=3", self.run_with("--only", "steering_test", "--renamed", "drive.repeats=")[2][0])

    def test_recordings_are_made_once(self):
        calls = self.run_with("--only", "plot_loam", "plot_forest")[2]
        self.assertEqual([c.split()[0] for c in calls], ["simulate", "run", "run"])


if __name__ == "__main__":
    unittest.main()
