#!/usr/bin/env python3
"""Inputs that cannot be used: how they are recorded, and the exit code of each verb. BOLE in the environment is the program."""

import json
import sys
import unittest

from toy import BAD_INPUT, DONE, FAILED, HEADING, Toy

LOCAL = ("--engine", "local", "--workers", "2")
PLY = "ply\nformat ascii 1.0\nelement vertex 100\nproperty float x\nproperty float y\nproperty float z\nend_header\n"


class BadTables(Toy):
    def test_a_table_that_does_not_fit_is_bad_input(self):
        """Whoever reads the table, the reader or the writers of the results, and whether cells, columns or kinds are wrong."""
        tables = {
            "cells": (HEADING + "1,5,1,0,20\n", "line 2 has 5 cells; needed: 10"),
            "more_cells": (HEADING + "1,5,1,0,20,19,31,12,good,auto,9\n", "line 2 has 11 cells; needed: 10"),
            "columns": ("tree_id,x_m\n1,5\n", "no column 'y_m'"),
            "texts": (HEADING + "1,five,1,0,20,19,31,12,good,auto\n", "column 'x_m' holds text; needed: numbers"),
            "ids": (HEADING + "1.5,5,1,0,20,19,31,12,good,auto\n", "'tree_id' does not hold whole numbers"),
            "empty": ("", "is empty"),
        }
        self.campaign(1)
        for name, (text, _) in tables.items():
            self.write(f"{name}.csv", text)
        inputs = [{"id": name, "set": {"stems.file": f"{name}.csv"}} for name in tables]
        self.document({"pipeline": "toy.json", "inputs": [*inputs, {"id": "good", "set": {"stems.file": "trees1.csv"}}]})
        self.run_all(*LOCAL, expect=BAD_INPUT)
        rows = self.status()
        self.assertEqual({name: rows[name]["state"] for name in tables}, dict.fromkeys(tables, "bad_input"))
        for name, (_, told) in tables.items():
            self.assertIn(told, rows[name]["error"], name)
        self.assertEqual(rows["good"]["state"], "done")
        self.run_all(*LOCAL, "--retry", expect=BAD_INPUT)
        self.assertEqual(set(self.begun()[0].values()), {1})  # the same table is as bad the second time

    def test_a_cloud_with_fewer_points_than_it_says_is_bad_input(self):
        self.write("cloud.json", json.dumps({"stages": [{"id": "scan", "type": "io.read_cloud"}]}))
        self.write("whole.ply", PLY + "1 2 3\n" * 100)
        self.write("cut.ply", PLY + "1 2 3\n" * 8)
        document = {"pipeline": "cloud.json", "tables": [], "inputs": [{"id": name, "set": {"scan.file": f"{name}.ply"}} for name in ("whole", "cut")]}
        self.document(document)
        self.run_all(*LOCAL, expect=BAD_INPUT)
        row = self.status()["cut"]
        self.assertEqual(row["state"], "bad_input")
        self.assertRegex(row["error"], r'8 %.*"accept_partial": true')
        self.document({**document, "accept_partial": True})
        self.assertIn("1 of 2 inputs run", self.bole("plan", self.folder / "campaign.json", "--out", self.out).stdout)
        self.run_all(*LOCAL)
        self.assertEqual((self.status()["cut"]["state"], self.begun()[0]), ("done", {"whole": 1, "cut": 2}))
        self.run_all(*LOCAL)
        self.assertEqual(self.begun()[0], {"whole": 1, "cut": 2})
        self.document(document)
        self.run_all(*LOCAL, expect=BAD_INPUT)
        self.document({**document, "accept_partial": "yes"})
        self.assertIn("accept_partial is 'yes'; needed: true or false", self.run_all(expect=BAD_INPUT))


class ExitCodes(Toy):
    """docs/user/campaigns.md: 0 all done, 1 work is missing or went wrong, 2 inputs are bad and all others are done."""

    def ended_with(self, **codes):
        """The exit code of a campaign whose inputs end with these codes; None: as they do."""
        self.campaign(len(codes))
        raw = json.loads((self.folder / "campaign.json").read_text())
        raw["retries"] = 0
        for entry, name in zip(raw["inputs"], codes):
            entry["id"] = name
        self.document(raw)
        self.out = self.folder / "-".join(f"{name}{code}" for name, code in codes.items())
        ends = {name: code for name, code in codes.items() if code}
        fake = self.fake_program(f"code = next((c for n, c in {ends!r}.items() if '/tasks/' + n + '/' in out), 0)\nif code: sys.stderr.write('bole: it is so\\n'); sys.exit(code)")
        return fake

    def test_the_worst_of_the_inputs_decides(self):
        for expect, codes in ((DONE, {"a": 0, "b": 0}), (BAD_INPUT, {"a": 0, "b": BAD_INPUT}), (BAD_INPUT, {"c": BAD_INPUT, "d": BAD_INPUT}),
                              (FAILED, {"a": 0, "e": FAILED}), (FAILED, {"b": BAD_INPUT, "e": FAILED})):
            with self.subTest(codes=codes):
                program = self.ended_with(**codes)
                self.run_with(program, expect, workers=2, engine="local")
                words = {0: "done", BAD_INPUT: "bad_input", FAILED: "failed"}
                self.assertEqual({name: row["state"] for name, row in self.status().items()}, {name: words[code] for name, code in codes.items()})
                self.assertEqual(self.bole("merge", self.out).returncode, expect)
                self.run_with(program, expect, workers=2, engine="local")  # nothing is left to run; the answer is the same
                runs = [json.loads(line) for line in (self.out / "runs.jsonl").read_text().splitlines()]
                self.assertEqual([(run["attempts"], run["exit_code"]) for run in runs], [(2, expect), (0, expect)])

    def test_a_refused_document_leaves_no_folder_and_a_bad_input_does(self):
        """Both are 2; this tells them apart, and status --json says what became of each input."""
        self.campaign(2, bad={2})
        self.run_all(*LOCAL, expect=BAD_INPUT)
        told = json.loads(self.bole("status", self.out, "--json").stdout)
        self.assertEqual((told["exit_code"], told["counts"]), (BAD_INPUT, {"bad_input": 1, "done": 1}))
        self.out = self.folder / "other"
        self.document({"pipeline": "toy.json"})
        self.run_all(*LOCAL, expect=BAD_INPUT)
        self.assertFalse(self.out.exists())


if __name__ == "__main__":
    sys.exit(unittest.main())
