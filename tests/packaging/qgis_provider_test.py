#!/usr/bin/env python3
"""The parts of the QGIS provider that need no QGIS, with the program `bole` (the argument) and with stand-ins for it."""

import os
import pathlib
import stat
import sys
import tempfile
import threading
import time
import unittest

sys.dont_write_bytecode = True
TOP = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(TOP / "app" / "qgis"))
from bole_provider import pipeline, program  # noqa: E402

BOLE = pathlib.Path(sys.argv.pop()).resolve()
STAGES = program.read_stages(BOLE)


def stand_in(folder, script):
    path = pathlib.Path(folder) / "stand_in"
    path.write_text("#!/bin/bash\n" + script)
    path.chmod(path.stat().st_mode | stat.S_IXUSR)
    return path


class Forms(unittest.TestCase):
    def form(self, name):
        document = pipeline.read_document(program.find_documents(BOLE)[name])
        return document, pipeline.parameters(document, STAGES)

    def test_documents_are_found_beside_the_program(self):
        self.assertIn("stem_map_from_cloud", program.find_documents(BOLE))

    def test_every_option_is_there_once_with_its_help(self):
        for name in program.find_documents(BOLE):
            document, form = self.form(name)
            declared = {f"{s['id']}.{o['name']}" for s in document["stages"] for o in STAGES[s["type"]]["options"] if o["type"] != "json"}
            self.assertEqual({p.option for p in form}, declared, name)
            self.assertEqual(len({p.name for p in form}), len(form), name)
            self.assertTrue(all(p.help for p in form), name)

    def test_the_input_is_asked_for_first_and_must_be_given(self):
        _, form = self.form("stem_map_from_cloud")
        self.assertEqual((form[0].name, form[0].option, form[0].optional), ("INPUT", "scan.file", False))
        self.assertTrue(all(p.optional for p in form[1:]))

    def test_numbers_keep_their_bounds_and_words_leave_the_field_empty(self):
        _, form = self.form("forest_plot")
        by_option = {p.option: p for p in form}
        thickness = by_option["slice.thickness"]
        declared = next(o for o in STAGES["stems.slice"]["options"] if o["name"] == "thickness")
        self.assertEqual((thickness.default, thickness.low, thickness.high), (declared["default"], declared["min"], declared["max"]))
        preset = by_option["slam.keyframe_distance"]
        self.assertIsNone(preset.default)
        self.assertIn("Empty: preset", preset.help)

    def test_only_what_differs_from_the_defaults_is_set(self):
        _, form = self.form("stem_map_from_cloud")
        default = next(p.default for p in form if p.name == "slice__thickness")
        values = {"INPUT": "a b.laz", "slice__thickness": default, "ground__cell": 0.5, "scan__drop_withheld": True, "path__file": "", "stems__range_noise": None}
        arguments = pipeline.command("bole", "p.json", form, values, "out")
        self.assertEqual(arguments[:5], ["bole", "run", "p.json", "--out", "out"])
        self.assertEqual(arguments[5:], ["--set", "scan.file=a b.laz", "--set", "scan.drop_withheld=true", "--set", "ground.cell=0.5"])

    def test_the_program_takes_the_command(self):
        document, form = self.form("stem_map_from_cloud")
        path = program.find_documents(BOLE)["stem_map_from_cloud"]
        with tempfile.TemporaryDirectory() as folder:
            values = {"INPUT": f"{folder}/no_such.laz", "ground__cell": 0.5}
            arguments = pipeline.command(BOLE, path, form, values, f"{folder}/out")
            with self.assertRaises(program.ProgramError) as caught:
                program.run(arguments, pipeline.stage_ids(document), lambda _: None, lambda _: None, lambda: False)
        self.assertIn("no_such.laz", str(caught.exception))


class Runs(unittest.TestCase):
    def run_script(self, script, is_cancelled=lambda: False):
        progress, lines = [], []
        with tempfile.TemporaryDirectory() as folder:
            finished = program.run([stand_in(folder, script)], ["scan", "slam"], progress.append, lines.append, is_cancelled)
        return finished, progress, lines

    def test_progress_counts_over_all_stages(self):
        finished, progress, lines = self.run_script('echo "scan:  50 % reading" >&2; echo "slam: 100 % done, 3 s left" >&2; echo "other:  10 % x"')
        self.assertTrue(finished)
        self.assertEqual(progress, [25.0, 100.0])
        self.assertEqual(lines, ["other:  10 % x"])

    def test_a_failure_carries_the_words_of_the_program(self):
        with self.assertRaisesRegex(program.ProgramError, "(?s)exit code 2.*no tree"):
            self.run_script("echo 'bole: no tree'; exit 2")

    def test_cancelling_interrupts_twice_and_waits(self):
        script = "trap 'n=$((n+1)); [ $n = 2 ] && exit 3' INT\nn=0\nwhile :; do sleep 0.05; done\n"
        event = threading.Event()
        threading.Timer(0.4, event.set).start()
        start = time.monotonic()
        finished, _, _ = self.run_script(script, event.is_set)
        self.assertFalse(finished)
        self.assertLess(time.monotonic() - start, 4)

    def test_a_program_that_does_not_listen_is_ended(self):
        process = program.subprocess.Popen([sys.executable, "-c", "import signal, time; signal.signal(signal.SIGINT, signal.SIG_IGN); print(1, flush=True); time.sleep(60)"],
                                           stdout=program.subprocess.PIPE)
        with process:
            process.stdout.readline()
            program.interrupt(process, patience=0.3)
            self.assertLess(process.poll(), 0)

    def test_a_missing_program_is_said(self):
        before = dict(os.environ)
        os.environ.pop("BOLE_PROGRAM", None)
        os.environ["PATH"] = "/nowhere"
        try:
            with self.assertRaisesRegex(program.ProgramError, "install the package bole"):
                program.find_program()
        finally:
            os.environ.clear()
            os.environ.update(before)


if __name__ == "__main__":
    unittest.main()
