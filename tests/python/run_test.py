#!/usr/bin/env python3
"""bole.run: the same results as the program, arrays in and out, errors that say what was found and needed."""

import csv
import gc
import pathlib
import subprocess
import tempfile
import types
import unittest

import bole
import numpy
import plot

SCAN_ONLY = {"stages": [{"id": "scan", "type": "io.read_cloud"}, {"id": "ground", "type": "ground.model", "inputs": {"points": "scan.points"}}]}


def address(array):
    return array.__array_interface__["data"][0]


def pointer(vtk):
    """Where a VTK array has its values."""
    return int(vtk.GetVoidPointer(0).split("_")[1], 16)


class InFolder(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory(prefix="bole_python_")
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)


class Surveys(InFolder):
    """One survey from a file by the program, the same by Python, and by an array."""

    @classmethod
    def setUpClass(cls):
        cls.temporary = tempfile.TemporaryDirectory(prefix="bole_python_")
        cls.place = pathlib.Path(cls.temporary.name)
        cls.file = cls.place / "plot.xyz"
        cls.points = plot.written(plot.plot_points(), cls.file)
        cls.by_file = bole.run("stem_map_from_cloud", scan=cls.file, out=cls.place / "python", set=plot.QUICK, cache=False)
        cls.by_array = bole.run("stem_map_from_cloud", scan=cls.points)

    @classmethod
    def tearDownClass(cls):
        del cls.by_file, cls.by_array
        cls.temporary.cleanup()

    def test_the_program_writes_the_same(self):
        sets = [f"--set={name}={str(value).lower()}" for name, value in {"scan.file": self.file, **plot.QUICK}.items()]
        sets[0] = f"--set=scan.file={self.file}"
        subprocess.run([plot.PROGRAM, "run", "stem_map_from_cloud", *sets, "--no-cache", "--out", self.place / "program"], check=True, capture_output=True)
        theirs, ours = ({p.relative_to(self.place / name) for p in (self.place / name).rglob("*")} for name in ("program", "python"))
        self.assertEqual(theirs, ours)
        for table in ("stems.csv", "plot_values.csv", "sections.csv"):
            self.assertEqual((self.place / "program" / table).read_bytes(), (self.place / "python" / table).read_bytes(), table)

    def test_stems_are_those_of_the_plot(self):
        stems = self.by_file.stems
        self.assertEqual(len(stems["tree_id"]), len(plot.STEMS))
        for x, y, diameter in plot.STEMS:
            nearest = numpy.argmin(numpy.hypot(stems["x_m"] - x, stems["y_m"] - y))
            self.assertAlmostEqual(stems["dbh_cm"][nearest], 100 * diameter, delta=0.6)

    def test_stems_are_those_of_the_table(self):
        with open(self.place / "python" / "stems.csv", encoding="utf-8", newline="") as file:
            rows = list(csv.DictReader(file))
        stems = self.by_file.stems
        self.assertEqual(list(stems), list(rows[0]))
        self.assertEqual([f"{v:.1f}" for v in stems["dbh_cm"]], [f"{float(row['dbh_cm']):.1f}" for row in rows])

    def test_an_array_gives_the_same_as_its_file(self):
        for name, column in self.by_file.stems.items():
            numpy.testing.assert_array_equal(column, self.by_array.stems[name], name)

    def test_result(self):
        result = self.by_file
        self.assertIn(result.verdict, ("sign", "look", "refused"))
        self.assertEqual(result.verdict, result.summary["verdict"])
        self.assertEqual(result.report, self.place / "python" / "report.html")
        self.assertTrue(all(path.is_file() for path in result.files))
        self.assertIn("plot_values", repr(result.tables))
        numpy.testing.assert_array_equal(result.tables["plot_values"]["value"], result.tables["inventory.plot_values"]["value"])
        dem = result.rasters["dem"]
        self.assertEqual(dem.values.shape, (len(dem.y), len(dem.x)))
        middle = dem.values[len(dem.y) // 2, len(dem.x) // 2]
        self.assertAlmostEqual(middle, plot.height(dem.x[len(dem.x) // 2], dem.y[len(dem.y) // 2]), delta=0.05)
        self.assertIn("verdict", repr(result))
        self.assertIn("report.html", result._repr_html_())
        with self.assertRaisesRegex(KeyError, "^this run has no table 'stem'; needed: one of points.point_edits, stems.stems"):
            result.tables["stem"]

    def test_nothing_is_written_without_out(self):
        self.assertIsNone(self.by_array.folder)
        self.assertIsNone(self.by_array.report)
        self.assertEqual(self.by_array.files, [])

    def test_points_are_views(self):
        points = self.by_array.points
        heights = points["height_above_ground"]
        self.assertEqual(address(heights), pointer(points.vtk.GetPointData().GetArray("height_above_ground")))
        self.assertEqual(address(points.offsets), pointer(points.vtk.GetPoints().GetData()))
        # Not of a copy that was made for VTK either: the stages themselves share what they do not change.
        clouds = self.by_array.clouds
        self.assertNotEqual(clouds["ground.points"].vtk, clouds["edit.points"].vtk)
        self.assertTrue(numpy.shares_memory(clouds["ground.points"].offsets, clouds["edit.points"].offsets))
        self.assertTrue(numpy.shares_memory(clouds["ground.points"]["height_above_ground"], clouds["edit.points"]["height_above_ground"]))
        with self.assertRaisesRegex(ValueError, "read-only"):
            heights[0] = 1

    def test_points_as_an_array(self):
        points = self.by_array.points
        numpy.testing.assert_allclose(numpy.asarray(points), self.points, atol=1e-5)
        self.assertEqual(points.origin, (0, 0, 0))
        self.assertTrue(numpy.shares_memory(numpy.asarray(points), points.offsets))  # no copy where the origin is 0
        self.assertIn("tree_id", points)
        with self.assertRaisesRegex(KeyError, "Did you mean tree_id"):
            points["tree_ids"]

    def test_tables_are_views_without_pandas(self):
        with plot.hidden("pandas"):
            stems = bole._results.table_of(self.by_array.vtk("edit.stems"))
        self.assertIsInstance(stems, dict)
        self.assertEqual(address(stems["dbh_cm"]), pointer(self.by_array.vtk("edit.stems").GetColumnByName("dbh_cm")))

    def test_tables_are_frames_where_pandas_is(self):
        before = plot.sys.modules.get("pandas")
        plot.sys.modules["pandas"] = types.SimpleNamespace(DataFrame=lambda columns: ("frame", columns))
        try:
            self.assertEqual(bole._results.table_of(self.by_array.vtk("edit.stems"))[0], "frame")
        finally:
            plot.sys.modules.pop("pandas")
            if before is not None:
                plot.sys.modules["pandas"] = before

    def test_points_outlive_the_result(self):
        points = bole.run(SCAN_ONLY, scan=self.points).points
        heights, copy = points["height_above_ground"], points["height_above_ground"].copy()
        del points
        gc.collect()
        scratch = [numpy.full(len(heights), 7.0, "float32") for _ in range(20)]
        numpy.testing.assert_array_equal(heights, copy)
        del scratch

    def test_points_go_into_another_run(self):
        again = bole.run(SCAN_ONLY, scan=self.by_array.clouds["scan.points"])
        numpy.testing.assert_array_equal(again.points.offsets, self.by_array.points.offsets)


class Arrays(InFolder):
    def ground(self, scan, **more):
        return bole.run(SCAN_ONLY, scan=scan, **more)

    def test_forms_of_a_cloud(self):
        points = plot.plot_points(0.2)
        intensity = numpy.arange(len(points), dtype="uint16")
        records = numpy.zeros(len(points), dtype=[("X", "f8"), ("Y", "f8"), ("Z", "f8"), ("Intensity", "u2")])
        for axis, name in enumerate(("X", "Y", "Z")):
            records[name] = points[:, axis]
        records["Intensity"] = intensity
        frame = types.SimpleNamespace(columns=["x", "y", "z", "intensity"], to_numpy=None)  # as pandas has it
        frame = type("Frame", (), {"columns": frame.columns, "to_numpy": lambda self: None,
                                   "__getitem__": lambda self, name: types.SimpleNamespace(to_numpy=lambda: dict(zip("xyz", points.T), intensity=intensity)[name])})()
        forms = [{"xyz": points, "intensity": intensity}, dict(zip("xyz", points.T), intensity=intensity), records, frame]
        plain = self.ground(points).points
        self.assertNotIn("intensity", plain)
        for form in forms:
            cloud = self.ground(form).clouds["scan.points"]
            numpy.testing.assert_array_equal(cloud.offsets, plain.offsets)
            numpy.testing.assert_array_equal(cloud["intensity"], intensity)

    def test_options_of_the_reader_hold_for_arrays(self):
        points = plot.plot_points(0.2)
        points[0] = numpy.nan
        result = self.ground({"xyz": 100 * points}, set={"scan.unit": "centimetre", "scan.bounds": "0,0,700,700"})
        read = result.clouds["scan.points"].xyz
        self.assertLess(read.max(), 7.5)
        counts = result.summary["stages"][0]["counts"]
        self.assertEqual(counts["dropped_points"], 1)
        self.assertEqual(counts["points"] + counts["points_outside_bounds"], len(points) - 1)
        self.assertEqual(result.summary["stages"][0]["facts"]["format"], "memory")

    def test_large_coordinates_stay_exact(self):
        points = plot.plot_points(0.2) + (500123.25, 5400321.5, 812.125)
        cloud = self.ground(points).clouds["scan.points"]
        self.assertNotEqual(cloud.origin, (0, 0, 0))
        numpy.testing.assert_allclose(cloud.xyz, points, atol=1e-4)

    def test_kinds_of_numbers_and_layouts(self):
        points = plot.plot_points(0.1)
        for form in (points.astype("float32"), numpy.asfortranarray(points), points[::-1][::-1], points.astype(">f8"), points.tolist()):
            numpy.testing.assert_allclose(self.ground(form).clouds["scan.points"].xyz, points, atol=1e-5)

    def test_a_changed_array_is_another_input(self):
        points = plot.plot_points(0.1)
        first = self.ground(points, out=self.folder / "out").clouds["ground.points"].offsets.copy()
        again = self.ground(points, out=self.folder / "out")
        self.assertTrue(all(stage["from_cache"] for stage in again.summary["stages"]))
        points[:, 0] += 1
        moved = self.ground(points, out=self.folder / "out")
        self.assertFalse(any(stage["from_cache"] for stage in moved.summary["stages"]))
        numpy.testing.assert_allclose(moved.points.offsets, first + (1, 0, 0), atol=1e-5)

    def test_a_table_as_reference(self):
        points = plot.plot_points()
        x, y, diameter = map(numpy.array, zip(*plot.STEMS))
        trees = {"tree_id": numpy.arange(1, 7), "x_m": x, "y_m": y, "dbh_cm": 100 * diameter, "species": ["beech"] * 6}
        result = bole.run("stem_map_from_cloud", scan=points, reference_trees=trees)
        evaluation = next(stage for stage in result.summary["stages"] if stage["id"] == "evaluate")
        self.assertEqual(evaluation["counts"]["matched"], 6)
        self.assertLess(evaluation["metrics"]["dbh_rmse"]["value"] if isinstance(evaluation["metrics"]["dbh_rmse"], dict) else evaluation["metrics"]["dbh_rmse"], 0.6)

    def test_arrays_that_do_not_fit(self):
        points = plot.plot_points(0.1)
        for scan, told in (
            (points[:, :2], r"shape \(\d+, 2\); needed: numbers in the shape \(N, 3\)"),
            (numpy.array(["a", "b"]), "needed: numbers in the shape"),
            ({"x": points[:, 0], "y": points[:, 1]}, "columns x, y; needed: x, y and z"),
            ({"xyz": points, "intensity": [1, 2]}, r"column 'intensity' has the type int64 and the shape \(2,\); needed: \d+ numbers"),
            ({"xyz": points, "name": ["a"] * len(points)}, "column 'name'"),
            (42, "needed"),
        ):
            with self.assertRaisesRegex(bole.BadInput, told):
                self.ground(scan)
        with self.assertRaisesRegex(bole.BadInput, "io.read_scan.*needed: the path of its file"):
            bole.run("forest_plot", scan=points)
        with self.assertRaises(bole.BoleError):
            self.ground(numpy.full((100, 3), 1e30))


class Options(InFolder):
    def setUp(self):
        super().setUp()
        self.points = plot.plot_points(0.1)

    def given(self, **more):
        result = bole.run(SCAN_ONLY, scan=self.points, **more)
        return next(stage for stage in result.summary["stages"] if stage["id"] == "ground")["options"]

    def test_ways_to_give_options(self):
        option = next(o for o in bole.stages()["ground.model"].options.values() if isinstance(o.default, float) and o.max and 0 < o.default < o.max)
        name, value = option.name, 0.5 * (option.default + option.max)
        ways = ({"set": {f"ground.{name}": value}}, {f"ground.{name}": value}, {"ground": {name: numpy.float64(value)}}, {"set": {"ground": {name: str(value)}}})
        self.assertEqual([float(self.given(**way)[name]) for way in ways], [value] * 4)

    def test_misspelt_names_are_suggested(self):
        for wrong, name, right in (
            ({"slam.prest": "loam"}, "slam.prest", "preset"), ({"slma.preset": "loam"}, "slma.preset", "slam"), ({"slma": {"preset": "loam"}}, "slma", "slam"),
            ({"preset": "loam"}, "preset", "slam.preset"), ({"otu": "x"}, "otu", "out"), ({"scna": "walk.pcap"}, "scna", "scan"),
        ):
            with self.assertRaises(bole.BadOption) as caught:
                bole.run("forest_plot", **wrong)
            self.assertEqual(caught.exception.option, name)
            self.assertIn(right, caught.exception.suggestions, str(caught.exception))
            self.assertEqual(caught.exception.exit_code, 2)

    def test_values_that_do_not_fit(self):
        with self.assertRaisesRegex(bole.BadOption, "preset.*needed: one of") as caught:
            bole.run("forest_plot", slam={"preset": "best_of_all"})
        self.assertEqual(caught.exception.stage, "slam")
        self.assertTrue(caught.exception.needed)
        with self.assertRaisesRegex(bole.BadInput, "needed"):
            bole.run("forest_plot", slam={"preset": object()})
        with self.assertRaisesRegex(bole.BadInput, "slam is str.*needed: a dict of its options: "):
            bole.run("forest_plot", slam="loam")  # no reader: a text is not the path of its trajectory

    def test_pipelines_that_there_are_not(self):
        with self.assertRaisesRegex(bole.BadInput, "Did you mean forest_plot"):
            bole.run("forest_plott")
        with self.assertRaisesRegex(bole.BadInput, "stem_map_from_cloud"):
            (self.folder / "plot.laz").write_bytes(b"LASF")
            bole.run(self.folder / "plot.laz")
        with self.assertRaisesRegex(bole.BadInput, "stages"):
            bole.run({"stages": [{"id": "a", "type": "no.such"}]})


class Errors(InFolder):
    def test_no_file(self):
        with self.assertRaises(bole.BadInput) as caught:
            bole.run("stem_map_from_cloud", scan=self.folder / "absent.laz", out=self.folder / "out")
        self.assertRegex(str(caught.exception), "absent.laz")
        self.assertIsInstance(caught.exception, ValueError)
        with self.assertRaisesRegex(bole.BadInput, r'set=\{"scan.file": "PATH"\}'):
            bole.run("stem_map_from_cloud")

    def test_a_failed_run_leaves_the_survey_before(self):
        points, out = plot.plot_points(0.3), self.folder / "out"
        pipeline = {"stages": [*SCAN_ONLY["stages"], {"id": "slice", "type": "stems.slice", "inputs": {"points": "ground.points"}}]}
        bole.run(pipeline, scan=points, out=out)
        before = (out / "summary.json").read_bytes()
        with self.assertRaises(bole.BoleError) as caught:
            bole.run(pipeline, scan=points[:3], out=out, cache=False)
        error = caught.exception
        self.assertEqual(error.exit_code, error.summary["exit_code"])
        self.assertTrue(error.survey_kept)
        self.assertEqual(error.results, out / "failed_run")
        self.assertEqual(error.findings[0]["code"], "run_failed")
        self.assertNotEqual(before, b"")

    def test_a_cut_off_file_is_refused_unless_accepted(self):
        points, file = plot.plot_points(0.3), self.folder / "cut.ply"
        header = f"ply\nformat binary_little_endian 1.0\nelement vertex {2 * len(points)}\nproperty float x\nproperty float y\nproperty float z\nend_header\n"
        file.write_bytes(header.encode() + points.astype("<f4").tobytes())
        with self.assertRaisesRegex(bole.Failed, r"accept_partial=True") as caught:
            bole.run(SCAN_ONLY, scan=file)
        self.assertEqual(caught.exception.exit_code, 1)
        result = bole.run(SCAN_ONLY, scan=file, accept_partial=True)
        self.assertIn("input_incomplete", [finding["code"] for finding in result.findings])

    def test_foreign_files_are_left_alone(self):
        out = self.folder / "out"
        out.mkdir()
        (out / "summary.json").write_text("mine")
        with self.assertRaisesRegex(bole.BoleError, "force=True"):
            bole.run(SCAN_ONLY, scan=plot.plot_points(0.1), out=out)
        self.assertEqual((out / "summary.json").read_text(), "mine")
        bole.run(SCAN_ONLY, scan=plot.plot_points(0.1), out=out, force=True)


if __name__ == "__main__":
    unittest.main()
