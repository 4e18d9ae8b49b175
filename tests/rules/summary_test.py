#!/usr/bin/env python3
"""The last line of ./do test counts what ctest wrote."""

import pathlib
import subprocess
import sys
import tempfile
import unittest

SUMMARY = pathlib.Path(__file__).resolve().parents[1] / "summary.py"

PASSED = '<testcase name="{}" status="run"><system-out></system-out></testcase>'
FAILED = '<testcase name="{}" status="fail"><failure message=""/><system-out></system-out></testcase>'
MISSING = '<testcase name="{}" status="notrun"><skipped message="Unable to find executable"/><system-out></system-out></testcase>'
CASE = '<testcase name="{}" status="notrun"><skipped message="SKIP_RETURN_CODE=77"/><system-out>SKIPPED: for want of ../shared/data: /x/y.laz\n</system-out></testcase>'
UNIT = """<testcase name="{}" status="notrun"><skipped message="SKIP_REGULAR_EXPRESSION_MATCHED"/><system-out>[ RUN      ] A.B
/a/b_test.cpp:26: Skipped
{}

[  SKIPPED ] A.B (0 ms)
</system-out></testcase>"""
QT = '<testcase name="{}" status="run"><system-out>SKIP   : Pictures::chinese() no Chinese font\n</system-out></testcase>'


def summary(*files):
    with tempfile.TemporaryDirectory() as folder:
        paths = []
        for i, cases in enumerate(files):
            paths.append(pathlib.Path(folder) / f"{i}.xml")
            paths[-1].write_text(f"<testsuite>{''.join(cases)}</testsuite>")
        answer = subprocess.run([sys.executable, SUMMARY, *paths], capture_output=True, text=True)
        return answer.returncode, answer.stdout.splitlines()


class Summary(unittest.TestCase):
    def test_all_passed(self):
        self.assertEqual(summary([PASSED.format("a")], [PASSED.format("b"), PASSED.format("c")]), (0, ["3 passed, 0 skipped"]))

    def test_skipped_for_want_of_real_files_are_told_apart(self):
        code, lines = summary([PASSED.format("a"), CASE.format("b"), UNIT.format("c", "for want of ../shared/data: /x"),
                               UNIT.format("d", "DISPLAY is set")])
        self.assertEqual((code, lines[-1]), (0, "1 passed, 3 skipped (2 for want of ../shared/data)"))
        self.assertIn("skipped: DISPLAY is set", lines)
        self.assertIn("    d", lines)

    def test_a_failed_and_a_missing_test_fail(self):
        for bad in (FAILED, MISSING):
            code, lines = summary([PASSED.format("a"), bad.format("b")])
            self.assertEqual((code, lines[-1]), (1, "1 passed, 1 failed, 0 skipped"))

    def test_a_skipped_part_of_a_program_is_told(self):
        code, lines = summary([QT.format("desktop.shell")])
        self.assertEqual((code, lines[-1]), (0, "1 passed, 0 skipped"))
        self.assertIn("    part of desktop.shell", lines)

    def test_results_that_are_absent_are_an_error(self):
        answer = subprocess.run([sys.executable, SUMMARY, "/nowhere/tests.xml"], capture_output=True, text=True)
        self.assertEqual(answer.returncode, 1)
        self.assertIn("run the tests first", answer.stderr)


if __name__ == "__main__":
    unittest.main()
