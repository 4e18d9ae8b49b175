#!/usr/bin/env python3
"""Runs the program `bole` (its path is the first argument) and looks at output, exit codes and how it takes a Ctrl-C."""

import json
import pathlib
import signal
import struct
import subprocess
import sys
import tempfile
import time
import unittest

BOLE = pathlib.Path(sys.argv.pop(1)).resolve()
DONE, FAILED, BAD_INPUT, CANCELLED = 0, 1, 2, 3


class Program(unittest.TestCase):
    def setUp(self):
        self.temporary = tempfile.TemporaryDirectory(prefix="bole_cli_")
        self.addCleanup(self.temporary.cleanup)
        self.folder = pathlib.Path(self.temporary.name)

    def bole(self, *arguments):
        return subprocess.run([BOLE, *map(str, arguments)], capture_output=True, text=True, timeout=120)

    def write(self, name, content):
        path = self.folder / name
        path.write_bytes(content if isinstance(content, bytes) else content.encode())
        return path

    def test_info_of_a_cloud(self):
        cloud = self.write("cloud.csv", "x,y,z,intensity\n1,2,3,10\n4,6,8,20\n")
        described = self.bole("info", "--json", cloud)
        self.assertEqual(described.returncode, DONE, described.stderr)
        (entry,) = json.loads(described.stdout)
        self.assertEqual((entry["kind"], entry["points"], entry["max_m"]), ("cloud", 2, [4, 6, 8]))
        self.assertEqual((entry["arrays"]["intensity"]["min"], entry["arrays"]["intensity"]["max"]), (10, 20))
        self.assertIn("points                 2", self.bole("info", cloud).stdout)

    def test_info_of_a_recording(self):
        frames = self.folder / "frames"
        frames.mkdir()
        for i in range(3):
            (frames / f"{i}.bin").write_bytes(struct.pack("<8f", 3, 0, 0, 1, 0, 4, 0, 2))
        (entry,) = json.loads(self.bole("info", "--json", frames).stdout)
        self.assertEqual((entry["kind"], entry["frames"], entry["points_in_middle_frame"]), ("recording", 3, 2))

    def test_a_capture_is_known_by_its_name_in_capitals(self):
        told = self.bole("info", self.write("WALK.PCAP", "a letter"))
        self.assertEqual(told.returncode, BAD_INPUT)
        self.assertIn("is not a capture", told.stderr)

    def test_evaluate_stems(self):
        header = "tree_id,x_m,y_m,dbh_cm\n"
        measured = self.write("measured.csv", header + "1,0,0,20\n2,5,0,31\n")
        truth = self.write("truth.csv", header + "7,0.1,0,20\n8,5,0,30\n9,9,9,25\n")
        compared = self.bole("evaluate", "stems", measured, truth, "--json")
        self.assertEqual(compared.returncode, DONE, compared.stderr)
        summary = json.loads(compared.stdout)
        self.assertAlmostEqual(summary["completeness"]["value"], 200 / 3, places=3)
        self.assertAlmostEqual(summary["dbh_bias"]["value"], 0.5, places=3)
        self.assertIn("completeness", self.bole("evaluate", "stems", measured, truth).stdout)

    def test_exit_codes(self):
        self.assertEqual(self.bole("version").returncode, DONE)
        self.assertEqual(self.bole("--help").returncode, DONE)
        for arguments in ([], ["nonsense"], ["info"], ["info", self.folder / "absent.las"], ["version", "--nonsense"]):
            with self.subTest(arguments=arguments):
                told = self.bole(*arguments)
                self.assertEqual(told.returncode, BAD_INPUT)
                self.assertTrue(told.stderr.strip())
        told = self.bole("simulate-field", "--out", self.write("file", "x") / "folder")
        self.assertEqual(told.returncode, FAILED, told.stderr)
        self.assertIn("cannot make the folder", told.stderr)

    def interrupted(self, arguments, signals):
        """Exit code and standard error of a run that gets the signals, each half a second after it has told something."""
        program = subprocess.Popen([BOLE, *map(str, arguments)], stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True)
        told = program.stderr.readline()
        for number in signals:
            program.send_signal(number)
            time.sleep(0.5)
        told += program.communicate(timeout=120)[1]
        return program.returncode, told

    def test_the_first_interrupt_finishes_and_the_second_cancels(self):
        code, told = self.interrupted(["simulate", "--plot", "demo", "--out", self.folder / "scan"], [signal.SIGINT])
        self.assertEqual(code, DONE, told)
        self.assertIn("Finishing with what there is so far", told)
        code, told = self.interrupted(["simulate", "--plot", "demo", "--out", self.folder / "scan2"], [signal.SIGINT, signal.SIGTERM])
        if code != DONE:  # it may have finished before the second came
            self.assertEqual(code, CANCELLED, told)

    def test_work_that_cannot_finish_early_is_cancelled_at_once(self):
        code, told = self.interrupted(["simulate-field", "--out", self.folder / "field", "--frames", "500"], [signal.SIGINT])
        self.assertEqual(code, CANCELLED, told)
        self.assertIn("Cancelling", told)
        self.assertNotIn("Finishing", told)


if __name__ == "__main__":
    sys.exit(unittest.main())
