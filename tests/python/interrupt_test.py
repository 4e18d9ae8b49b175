#!/usr/bin/env python3
"""Ctrl-C and progress of bole.run: in a terminal, in a pipe, in a notebook; results are swapped whole or not at all."""

import os
import pathlib
import pty
import signal
import subprocess
import sys
import tempfile
import threading
import time
import types
import unittest

import bole
import plot

SOON_S = 3.0  # a cancel takes 0.5 s; the machine may be busy

CHILD = """
import sys, bole, plot
pipeline, scan = ("stem_map_from_cloud", plot.plot_points(6)) if sys.argv[1] == "points" else ("forest_plot", sys.argv[1])
def told(stage, fraction, text):
    if fraction >= float(sys.argv[4]):
        print("at", stage, flush=True)
try:
    bole.run(pipeline, scan=scan, out=sys.argv[2], set=plot.QUICK, cache=False, progress=told, on_interrupt=sys.argv[3])
    print("done", flush=True)
except bole.BoleError as error:
    print(type(error).__name__, error.exit_code, error.result.finished_early, len(error.result.stems["tree_id"]) > 0, flush=True)
except KeyboardInterrupt as error:
    print(type(error).__name__, error.exit_code, error.survey_kept, error, flush=True)
"""


def contents(folder):
    return {str(p.relative_to(folder)): p.read_bytes() for p in sorted(folder.rglob("*")) if p.is_file()}


class CtrlC(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory(prefix="bole_python_")
        self.addCleanup(folder.cleanup)
        self.out = pathlib.Path(folder.name) / "out"

    def interrupted(self, stage, action, scan="points", fraction=0.0):
        """(last line, seconds from the signal to the end) of a run that gets SIGINT in a stage."""
        child = subprocess.Popen([sys.executable, "-c", CHILD, str(scan), str(self.out), action, str(fraction)], stdout=subprocess.PIPE, text=True, cwd=plot.TOP / "tests" / "python")
        last = ""
        for line in child.stdout:
            last = line.strip()
            if last == f"at {stage}":
                break
        self.assertEqual(last, f"at {stage}", "the run was over before the signal")
        begin = time.monotonic()
        child.send_signal(signal.SIGINT)
        rest = child.communicate(timeout=60)[0].split("\n")
        return next(line for line in reversed(rest) if line), time.monotonic() - begin

    def test_cancel_is_quick_and_leaves_the_survey_before(self):
        bole.run("stem_map_from_cloud", scan=plot.plot_points(), out=self.out, set=plot.QUICK, cache=False)
        before = contents(self.out)
        for stage in ("scan", "ground", "stems"):
            last, seconds = self.interrupted(stage, "cancel")
            self.assertRegex(last, "^Cancelled 3 True the run was cancelled. The results before are still in .*out, unchanged$")
            self.assertLess(seconds, SOON_S, stage)
            self.assertEqual(contents(self.out), before, stage)

    def test_cancel_of_a_first_run_leaves_nothing(self):
        last, _ = self.interrupted("ground", "cancel")
        self.assertRegex(last, "^Cancelled 3 False .*There are no results")
        self.assertEqual(list(self.out.parent.rglob("*.csv")), [])

    def test_finish_keeps_what_there_is(self):
        scan = self.out.parent / "scan"
        subprocess.run([plot.PROGRAM, "simulate", "--sensor=vlp16", "--max-time=8", f"--out={scan}"], check=True, capture_output=True)
        last, _ = self.interrupted("slam", "finish", scan / "walk.pcap", 0.1)
        self.assertEqual(last, "PartialOutput 4 True True")
        self.assertTrue((self.out / "FINISHED_EARLY.txt").is_file())

    def test_a_function_that_fails_cancels(self):
        def told(*_):
            raise ZeroDivisionError

        with self.assertRaises(ZeroDivisionError):
            bole.run("stem_map_from_cloud", scan=plot.plot_points(), out=self.out, progress=told)
        self.assertFalse((self.out / "stems.csv").exists())

    def test_other_threads_stay_awake(self):
        ticks, ended = [], threading.Event()

        def tick():
            while not ended.wait(0.01):
                ticks.append(time.monotonic())

        thread = threading.Thread(target=tick)
        thread.start()
        begin = time.monotonic()
        bole.run("stem_map_from_cloud", scan=plot.plot_points(2))
        seconds = time.monotonic() - begin
        ended.set()
        thread.join()
        longest = max(b - a for a, b in zip(ticks, ticks[1:]))
        self.assertLess(longest, max(0.5 * seconds, 0.3), "the interpreter was held while the run went on")

    def test_an_exception_of_ctrl_c_is_no_error(self):
        self.assertTrue(issubclass(bole.Cancelled, KeyboardInterrupt))
        self.assertFalse(issubclass(bole.Cancelled, Exception))


class Progress(unittest.TestCase):
    RUN = "import bole, plot; bole.run('stem_map_from_cloud', scan=plot.plot_points(2), progress={})"

    def test_a_pipe_is_silent_unless_asked(self):
        environment = {**os.environ, "PYTHONPATH": os.pathsep.join([os.environ["PYTHONPATH"], str(plot.TOP / "tests" / "python")])}
        told = plot.python(self.RUN.format("None"), env=environment)
        self.assertEqual((told.returncode, told.stdout, told.stderr), (0, "", ""))
        told = plot.python(self.RUN.format("True"), env=environment)
        self.assertRegex(told.stderr, r"(?m)^ground +\[=* *\] +\d+ %")
        self.assertRegex(told.stderr, "stem_map_from_cloud: done after")
        self.assertNotIn("\r", told.stderr)

    def test_a_terminal_has_a_bar(self):
        leader, follower = pty.openpty()
        environment = {**os.environ, "PYTHONPATH": os.pathsep.join([os.environ["PYTHONPATH"], str(plot.TOP / "tests" / "python")])}
        child = subprocess.Popen([sys.executable, "-c", self.RUN.format("None")], stderr=follower, env=environment)
        os.close(follower)
        shown = b""
        while True:
            try:
                shown += os.read(leader, 4096)
            except OSError:
                break
        os.close(leader)
        self.assertEqual(child.wait(), 0)
        self.assertRegex(shown.decode(), r"\r\x1b\[K\w+ +\[=* *\] +\d+ %")
        self.assertTrue(shown.endswith(b"\r\x1b[K"), shown[-80:])

    def test_a_notebook_has_one_line_that_changes(self):
        shown = []

        class Handle:
            def update(self, data, raw):
                shown.append((data["text/plain"], raw))

        def display(data, raw, display_id):
            shown.append((data["text/plain"], raw))
            return Handle()

        module = types.ModuleType("IPython")
        module.get_ipython = lambda: types.SimpleNamespace(kernel=object())
        module.display = types.ModuleType("IPython.display")
        module.display.display = display
        with plot.hidden("IPython", "IPython.display"):
            sys.modules.update({"IPython": module, "IPython.display": module.display})
            bole.run("stem_map_from_cloud", scan=plot.plot_points(2))
        self.assertEqual(shown[0], ("stem_map_from_cloud: starting", True))
        self.assertGreater(len(shown), 2)
        self.assertRegex(shown[-1][0], "stem_map_from_cloud: done after")

    def test_a_function_gets_fractions(self):
        told = []
        bole.run("stem_map_from_cloud", scan=plot.plot_points(2), progress=lambda *words: told.append(words))
        self.assertTrue(told)
        self.assertTrue(all(0 <= fraction <= 1 and isinstance(stage, str) and isinstance(text, str) for stage, fraction, text in told))


if __name__ == "__main__":
    unittest.main()
