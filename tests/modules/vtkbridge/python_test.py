#!/usr/bin/env python3
"""The package bole: classes, a stage joined with a VTK filter, a pipeline from a document."""

import json
import math
import os
import pathlib
import random
import subprocess
import tempfile
import unittest

import bole
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkPolyData


def bumpy_ground():
    """A slope of one in ten with posts of two metres, as a VTK data set."""
    rng = random.Random(3)
    points = vtkPoints()
    for i in range(80):
        for j in range(80):
            x, y = 0.25 * i, 0.25 * j
            points.InsertNextPoint(x, y, 0.1 * x + rng.gauss(0, 0.005))
            if i % 20 == 10 and j % 20 == 10:
                for k in range(20):
                    points.InsertNextPoint(x, y, 0.1 * x + 0.1 * k)
    data = vtkPolyData()
    data.SetPoints(points)
    return data


def listen(target, event, heard):
    """Collects the texts of an event."""

    def observer(_object, _event, text):
        heard.append(text)

    observer.CallDataType = "string0"
    target.AddObserver(event, observer)


class Classes(unittest.TestCase):
    def test_thin_classes_name_their_stage(self):
        named = {}
        for name in dir(bole):
            candidate = getattr(bole, name)
            if name.startswith("vtkBole") and isinstance(candidate, type) and issubclass(candidate, bole.vtkBoleStage):
                named[name] = candidate().GetStageType()
        self.assertEqual(named.pop("vtkBoleStage"), "")
        self.assertEqual(named["vtkBoleSlam"], "slam.run")
        self.assertEqual(named["vtkBoleGroundModel"], "ground.model")
        self.assertEqual(len(set(named.values())), len(named))  # no two classes for one stage
        listing = subprocess.run([os.environ["BOLE"], "stages", "--json"], check=True, capture_output=True, text=True)
        registered = {stage["vtk_class"]: stage["type"] for stage in json.loads(listing.stdout)}
        self.assertGreater(len(registered), 20)
        self.assertEqual(named, registered)


class Stage(unittest.TestCase):
    def test_a_stage_takes_the_data_of_vtk(self):
        ground = bole.vtkBoleGroundModel()
        if not ground.GetNumberOfInputPorts():
            self.skipTest("ground.model is not in this build")
        ground.SetInputDataObject(ground.FindInputPort("points"), bumpy_ground())
        ground.Update()
        self.assertEqual(ground.GetExitCode(), 0, ground.GetErrorText())
        points = ground.GetOutputDataObject(ground.FindOutputPort("points"))
        heights = points.GetPointData().GetArray("height_above_ground")
        found = [heights.GetValue(i) for i in range(heights.GetNumberOfTuples())]
        self.assertAlmostEqual(max(h for h in found if not math.isnan(h)), 1.9, delta=0.15)
        dem = ground.GetOutputDataObject(ground.FindOutputPort("dem"))
        self.assertGreater(dem.GetNumberOfPoints(), 100)
        self.assertIn("status", json.loads(ground.GetReportJSON()))

    def test_errors_are_told(self):
        ground = bole.vtkBoleGroundModel()
        heard = []
        listen(ground, "ErrorEvent", heard)
        self.assertFalse(ground.SetOption("no_such_option", 1.0))
        self.assertTrue(any("no_such_option" in text for text in heard), heard)


class Pipeline(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        self.out = pathlib.Path(self.folder.name) / "out"
        cloud = pathlib.Path(self.folder.name) / "cloud.xyz"
        data = bumpy_ground()
        cloud.write_text("".join("%.3f %.3f %.3f\n" % data.GetPoint(i) for i in range(data.GetNumberOfPoints())))
        document = {
            "title": "ground only",
            "stages": [
                {"id": "scan", "type": "io.read_cloud", "options": {"file": "cloud.xyz"}},
                {"id": "ground", "type": "ground.model", "inputs": {"points": "scan.points"}},
            ],
        }
        self.path = pathlib.Path(self.folder.name) / "ground.json"
        self.path.write_text(json.dumps(document))
        if not bole.vtkBoleReadCloud().GetNumberOfOutputPorts() or not bole.vtkBoleGroundModel().GetNumberOfInputPorts():
            self.skipTest("io.read_cloud or ground.model is not in this build")

    def pipeline(self):
        pipeline = bole.vtkBolePipeline()
        self.assertTrue(pipeline.LoadDocument(str(self.path)), pipeline.GetErrorText())
        pipeline.SetOutputDirectory(str(self.out))
        return pipeline

    def test_runs_twice(self):
        pipeline = self.pipeline()
        seen = []
        pipeline.AddObserver("ProgressEvent", lambda p, _event: seen.append(p.GetCurrentStage()))
        self.assertEqual(pipeline.Validate(), "")
        self.assertTrue(pipeline.Run(), pipeline.GetErrorText())
        self.assertIn("ground", seen)
        dem = pipeline.GetStage("ground").GetOutputDataObject(1)
        self.assertEqual(dem.GetClassName(), "vtkImageData")
        self.assertGreater(dem.GetNumberOfPoints(), 100)
        summary = json.loads(pipeline.GetSummaryJSON())
        self.assertEqual([s["id"] for s in summary["stages"]], ["scan", "ground"])
        self.assertEqual(summary, json.loads((self.out / "summary.json").read_text()))

        again = self.pipeline()
        self.assertTrue(again.Run(), again.GetErrorText())
        self.assertTrue(all(s["from_cache"] for s in json.loads(again.GetSummaryJSON())["stages"]))
        points = again.GetStage("ground").GetOutputDataObject(0)
        self.assertGreater(points.GetNumberOfPoints(), 6400)
        self.assertIsNotNone(points.GetPointData().GetArray("height_above_ground"))

    def test_takes_data_in_place_of_a_file(self):
        pipeline = self.pipeline()
        self.assertTrue(pipeline.SetOption("scan.file", ""))
        self.assertIn("file is empty", pipeline.Validate())
        self.assertTrue(pipeline.TakeData("scan", bumpy_ground()))
        self.assertEqual(pipeline.Validate(), "")
        self.assertTrue(pipeline.Run(), pipeline.GetErrorText())
        self.assertEqual(pipeline.GetStage("scan").GetOutputDataObject(0).GetNumberOfPoints(), bumpy_ground().GetNumberOfPoints())
        listen(pipeline, "ErrorEvent", [])
        self.assertFalse(pipeline.TakeData("ground", bumpy_ground()))
        self.assertIn("takes no data from memory; needed: a file", pipeline.GetErrorText())
        self.assertTrue(pipeline.TakeData("scan", None))
        self.assertIn("file is empty", pipeline.Validate())

    def test_runs_in_a_thread_of_its_own(self):
        pipeline = self.pipeline()
        heard = []
        pipeline.AddObserver("ProgressEvent", lambda *_: heard.append(1))
        listen(pipeline, "ErrorEvent", [])
        self.assertTrue(pipeline.Start())
        self.assertIsNone(pipeline.GetStage("ground"))
        self.assertFalse(pipeline.SetOption("scan.file", "x"))
        self.assertTrue(pipeline.Wait(60))
        self.assertEqual((heard, pipeline.GetExitCode()), ([], 0))
        self.assertGreater(pipeline.GetStage("ground").GetOutputDataObject(1).GetNumberOfPoints(), 100)
        self.assertEqual(pipeline.GetResultsDirectory(), str(self.out))
        pipeline.SetUseCache(False)
        self.assertTrue(pipeline.SetOption("scan.skip_lines", 1))
        self.assertTrue(pipeline.Start())
        pipeline.Cancel()
        self.assertTrue(pipeline.Wait(60))
        self.assertEqual(pipeline.GetExitCode(), 3)
        self.assertTrue(pipeline.GetSurveyKept())

    def test_errors(self):
        pipeline = self.pipeline()
        heard = []
        listen(pipeline, "ErrorEvent", heard)
        self.assertFalse(pipeline.SetOption("scan.nonsense", "1"))
        self.assertIn("nonsense", pipeline.GetErrorText())
        self.assertTrue(heard)
        self.assertTrue(pipeline.SetOption("scan.file", "/no/such/file.xyz"))
        self.assertFalse(pipeline.Run())
        self.assertEqual(pipeline.GetExitCode(), 2)
        self.assertIn("file.xyz", pipeline.GetErrorText())
        self.assertIsNone(pipeline.GetStage("absent"))


if __name__ == "__main__":
    unittest.main()
