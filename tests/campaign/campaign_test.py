#!/usr/bin/env python3
"""Campaigns as a person meets them: documents, results, resume, job arrays. BOLE in the environment is the program."""

import json
import os
import re
import sqlite3
import subprocess
import sys
import time
import unittest
import unittest.mock

from toy import BAD_INPUT, BOLE, CANCELLED, ENGINE, FAILED, FINISHED_EARLY, Toy, signal

LOCAL = ("--engine", "local", "--workers", "2")


class Results(Toy):
    def test_all_results_are_those_of_single_runs(self):
        self.campaign(5)
        told = self.run_all(*LOCAL)
        self.assertIn("5 inputs: 5 done", told)
        expected = [row for i in range(1, 6) for row in self.single(f"p{i}", self.folder / f"trees{i}.csv")]
        self.assertEqual(self.merged(), expected)

    def test_the_ledger_is_a_geopackage_with_stems_and_inputs(self):
        self.campaign(3, bad={2})
        self.run_all(*LOCAL, expect=BAD_INPUT)
        with sqlite3.connect(self.out / "campaign.gpkg") as db:
            self.assertEqual(db.execute("PRAGMA application_id").fetchone()[0], 0x47504B47)
            self.assertEqual({r[0] for r in db.execute("SELECT table_name FROM gpkg_contents WHERE data_type = 'features'")}, {"stems", "inputs"})
            inputs = {r[0]: r[1:] for r in db.execute("SELECT input_id, state, seconds, peak_mib, error FROM inputs")}
            stems = db.execute("SELECT input_id, tree_id, x_m, y_m, dbh_cm, geom FROM stems ORDER BY fid").fetchall()
        self.assertEqual([inputs[p][0] for p in ("p1", "p2", "p3")], ["done", "bad_input", "done"])
        self.assertIn("trees2.csv", inputs["p2"][3])
        self.assertTrue(0 < inputs["p1"][1] < 100 and 20 < inputs["p1"][2] < 4000, inputs["p1"])
        table = [(r["input_id"], float(r["tree_id"]), float(r["x_m"]), float(r["y_m"]), float(r["dbh_cm"])) for r in self.merged()]
        self.assertEqual([row[:5] for row in stems], table)
        sys.path.insert(0, str(ENGINE))
        from bole_campaign.geopackage import coordinates_of

        self.assertEqual([coordinates_of(row[5]) for row in stems], [row[2:4] for row in table])

    def test_the_page_needs_no_other_file_and_shows_the_worst_first(self):
        self.campaign(3, bad={3})
        self.run_all(*LOCAL, expect=BAD_INPUT)
        page = (self.out / "campaign.html").read_text()
        self.assertEqual(re.findall(r'(?:src|@import|<link)[=\s"]+\S+', page), [])
        order = re.findall(r"<tr><td><a href=\"([^\"]+)\">(p\d)<", page)
        self.assertEqual(order[0][1], "p3")
        self.assertEqual({name for _, name in order}, {"p1", "p2", "p3"})
        for target, _ in order:
            self.assertTrue((self.out / target).is_file(), target)

    def test_inputs_with_coordinates_are_on_the_map(self):
        self.campaign(2)
        raw = json.loads((self.folder / "campaign.json").read_text())
        raw["inputs"][0].update(x_m=500100, y_m=4000000)
        raw["inputs"][1].update(x_m=500200, y_m=4000100)
        self.document(raw)
        self.run_all(*LOCAL)
        page = (self.out / "campaign.html").read_text()
        dots = {name: (float(x), float(y)) for x, y, name in re.findall(r'<circle cx="([\d.]+)" cy="([\d.]+)"[^>]*><title>(p\d)', page)}
        self.assertTrue(dots["p1"][0] < dots["p2"][0] and dots["p1"][1] > dots["p2"][1], dots)  # east is right, north is up

    def test_status_is_a_table_and_json(self):
        self.campaign(2)
        self.run_all(*LOCAL)
        told = self.bole("status", self.out)
        self.assertIn("2 inputs: 2 done", told.stdout)
        row = self.status()["p1"]
        self.assertEqual((row["state"], row["attempts"], row["killed"]), ("done", 1, 0))
        self.assertEqual(self.bole("status", self.folder).returncode, BAD_INPUT)


class Resume(Toy):
    def test_nothing_runs_twice(self):
        self.campaign(3, bad={2})
        self.run_all(*LOCAL, expect=BAD_INPUT)
        self.run_all(*LOCAL, expect=BAD_INPUT)
        self.assertEqual(self.begun()[0], {"p1": 1, "p2": 1, "p3": 1})

    def test_what_changed_runs_again_and_nothing_else(self):
        self.campaign(4)
        self.run_all(*LOCAL)
        os.utime(self.folder / "trees1.csv", (1, 1))  # a new time, the same content
        self.write("trees2.csv", self.trees(5))
        raw = json.loads((self.folder / "campaign.json").read_text())
        raw["inputs"][2]["set"]["report.title"] = "another"
        self.document(raw)
        plan = {row["id"]: row["why"] for row in json.loads(self.bole("plan", self.folder / "campaign.json", "--out", self.out, "--json").stdout) if row["runs"]}
        self.assertEqual(plan, {"p2": "the content of stems.file changed", "p3": "the option report.title changed"})
        before = self.merged()
        self.run_all(*LOCAL)
        self.assertEqual(self.begun()[0], {"p1": 1, "p2": 2, "p3": 2, "p4": 1})
        self.assertEqual([r for r in self.merged() if r["input_id"] == "p2"], self.single("p2", self.folder / "trees2.csv"))
        self.assertEqual([r for r in self.merged() if r["input_id"] != "p2"], [r for r in before if r["input_id"] != "p2"])
        raw["pipeline"] = str(self.write("other.json", (self.folder / "toy.json").read_text().replace('"toy"', '"other"')))
        self.document(raw)
        self.assertEqual(self.bole("plan", self.folder / "campaign.json", "--out", self.out).stdout.count("the pipeline changed"), 4)

    def test_results_that_are_not_current_are_left_out(self):
        self.campaign(2)
        self.run_all(*LOCAL)
        (self.folder / "trees1.csv").unlink()
        self.run_all(*LOCAL, expect=BAD_INPUT)
        self.assertEqual({r["input_id"] for r in self.merged()}, {"p2"})
        self.write("trees1.csv", self.trees(1))
        self.run_all(*LOCAL)
        self.assertEqual({r["input_id"] for r in self.merged()}, {"p1", "p2"})
        self.assertEqual(self.begun()[0]["p1"], 2)  # the result of the first time is current again

    def test_an_input_that_is_added_runs_alone_and_one_that_goes_is_left_out(self):
        self.campaign(3)
        self.run_all(*LOCAL)
        raw = json.loads((self.folder / "campaign.json").read_text())
        self.write("trees9.csv", self.trees(9))
        raw["inputs"] = [raw["inputs"][2], {"id": "a/new one", "set": {"stems.file": "trees9.csv"}}]
        self.document(raw)
        self.run_all(*LOCAL)
        self.assertEqual([r["input_id"] for r in self.merged()][0], "p3")
        self.assertEqual({r["input_id"] for r in self.merged()}, {"p3", "a/new one"})
        self.assertEqual(self.begun()[0]["p3"], 1)


class JobArray(Toy):
    def test_arrays_from_zero_and_from_one_reach_every_input_once(self):
        for first in (0, 1):
            with self.subTest(first=first):
                self.campaign(3)
                self.out = self.folder / f"array{first}"
                for k in range(first, first + 3):
                    self.run_all("--task", k)
                self.assertEqual(self.begun()[0], {"p1": 1, "p2": 1, "p3": 1})
                self.assertEqual({r["input_id"] for r in self.merged()}, {"p1", "p2", "p3"})  # the last one merged
                self.assertTrue((self.out / "campaign.gpkg").exists() and (self.out / "campaign.html").exists())

    def test_the_exit_code_is_that_of_the_input(self):
        self.campaign(3, bad={2})
        self.run_all("--task", 2, expect=BAD_INPUT)
        self.run_all("--task", 1)
        self.assertIn("no task 4", self.run_all("--task", 4, expect=BAD_INPUT))
        self.assertFalse((self.out / "stems.csv").exists())
        self.assertEqual(self.status()["p3"]["state"], "missing")
        merged = self.bole("merge", self.out)
        self.assertEqual(merged.returncode, FAILED, merged.stdout)  # p3 is missing
        self.assertEqual({r["input_id"] for r in self.merged()}, {"p1"})
        self.run_all(*LOCAL, expect=BAD_INPUT)
        self.assertEqual(self.begun()[0], {"p1": 1, "p2": 1, "p3": 1})


class Documents(Toy):
    def refused(self, content, *words):
        self.document(content)
        told = self.run_all(expect=BAD_INPUT)
        for word in words:
            self.assertIn(word, told)
        self.assertFalse(self.out.exists(), "a refused document leaves no trace")

    def test_what_is_wrong_is_told_with_a_suggestion(self):
        self.campaign(1)
        good = {"id": "p1", "set": {"stems.file": "trees1.csv"}}
        self.refused({"pipelin": "toy.json", "inputs": [good]}, "'pipelin'", "Did you mean pipeline?")
        self.refused({"pipeline": "toi.json", "inputs": [good]}, "no pipeline 'toi.json'")
        self.refused({"pipeline": "forest_plott", "inputs": [good]}, "Did you mean forest_plot?")
        self.refused({"pipeline": "toy.json"}, "no 'inputs'")
        self.refused({"pipeline": "toy.json", "inputs": []}, "no inputs")
        self.refused({"pipeline": "toy.json", "inputs": [good, good]}, "two inputs have the id 'p1'")
        self.refused({"pipeline": "toy.json", "inputs": [{"set": {}}]}, "input 1", "no id")
        self.refused({"pipeline": "toy.json", "inputs": [{"id": "p", "sets": {}}]}, "'sets'", "Did you mean set?")
        self.refused({"pipeline": "toy.json", "inputs": [{"id": "p", "set": {"stems.fil": "x"}}]}, "stems.fil", "Did you mean stems.file")
        self.refused({"pipeline": "toy.json", "inputs": [good], "set": {"report.titel": "x"}}, "Did you mean report.title")
        self.refused({"pipeline": "toy.json", "inputs": [good], "memory_gib": "much"}, "memory_gib", "'much'")
        self.refused([1], "no JSON object")
        self.write("campaign.json", '{"pipeline": "toy.json",\n "inputs": [}')
        self.assertIn("line 2", self.run_all(expect=BAD_INPUT))
        self.write("campaign.json", '{"pipeline": "toy.json", "pipeline": "toy.json"}')
        self.assertIn("twice", self.run_all(expect=BAD_INPUT))

    def test_inputs_from_a_table_a_folder_and_a_pattern(self):
        for i in (1, 2):
            self.write(f"tables/plot{i}.txt", self.trees(i))
            self.write(f"deep/{i}/trees.csv", self.trees(i))
        self.write("plots.csv", "id;stems.file;report.title\nA;tables/plot1.txt;one\nB;tables/plot2.txt;\n")
        for inputs, ids in ((" plots.csv".strip(), {"A", "B"}), ({"pattern": "tables/plot*.txt"}, {"plot1", "plot2"}), ({"pattern": "deep/*/trees.csv"}, {"1/trees", "2/trees"}),
                            ({"pattern": "deep/**/trees.csv", "option": "stems.file"}, {"1/trees", "2/trees"})):
            with self.subTest(inputs=inputs):
                self.document({"pipeline": "toy.json", "inputs": inputs})
                self.out = self.folder / f"out{len(list(self.folder.glob('out*')))}"
                self.run_all(*LOCAL)
                self.assertEqual({r["input_id"] for r in self.merged()}, ids)
        self.document({"pipeline": "toy.json", "inputs": {"table": "plots.csv", "option": "stems.file", "folders": 1}})
        self.assertIn("Did you mean folder?", self.run_all(expect=BAD_INPUT))
        self.document({"pipeline": "toy.json", "inputs": {"pattern": "nothing*.csv"}})
        self.assertIn("gives no input", self.run_all(expect=BAD_INPUT))
        self.write("plots.csv", "id,stems.file,what\nA,x,y\n")
        self.document({"pipeline": "toy.json", "inputs": "plots.csv"})
        self.assertIn("the column 'what'", self.run_all(expect=BAD_INPUT))

    def test_a_folder_of_clouds(self):
        for i in (1, 2):
            self.write(f"clouds/c{i}.xyz", "".join(f"{x} {y} 0\n" for x in range(20) for y in range(20)))
        self.write("cloud.json", json.dumps({"stages": [{"id": "scan", "type": "io.read_cloud"}]}))
        self.document({"pipeline": "cloud.json", "inputs": {"folder": "clouds"}})
        told = self.run_all(*LOCAL)
        self.assertIn("2 of 2 inputs that are done wrote no stems.csv", told)
        self.assertEqual({r["input_id"] for r in self.status().values()}, {"c1", "c2"})


class Memory(Toy):
    def test_every_format_of_clouds_has_an_estimate(self):
        sys.path.insert(0, str(ENGINE))
        from bole_campaign import memory, program

        endings = program.cloud_endings(str(BOLE))
        self.assertLessEqual({".las", ".laz", ".copc.laz", ".pts", ".asc", ".xyz", ".txt", ".csv", ".bin"}, set(endings))
        self.assertEqual(set(memory.FACTORS) - set(endings.values()), set(), "formats that there are not")
        for ending, name in endings.items():
            self.assertEqual(memory.factor_of(f"a/B{ending.upper()}", str(BOLE)), memory.FACTORS.get(name, memory.FACTOR_OF_CLOUDS), ending)
        for other in ("walk.pcap", "frames", "bag.mcap", "track.nmea"):
            self.assertIsNone(memory.factor_of(other, str(BOLE)), other)
        cloud = self.write("cloud.asc", "1 2 3\n" * 1000)
        entry = {"memory_gib": None, "files": {"scan.file": [str(cloud)]}}
        self.assertEqual(memory.declared_gib(entry, str(BOLE)), round(memory.BASE_GIB + 3.0 * 6000 / memory.GIB, 2))
        self.assertEqual(memory.declared_gib({**entry, "memory_gib": 2.5}, str(BOLE)), 2.5)


class PathLists(Toy):
    def test_every_path_of_a_list_is_resolved_and_belongs_to_the_key(self):
        sys.path.insert(0, str(ENGINE))
        from bole_campaign import document, keys, program

        declared = {"io.several": {"folders": {"type": "path", "choices": [","]}}}
        self.write("several.json", json.dumps({"stages": [{"id": "runs", "type": "io.several"}]}))
        for name in ("a/x", "b/x"):
            self.write(name, name)
        self.document({"pipeline": "several.json", "inputs": [{"id": "p", "set": {"runs.folders": "a, b"}}]})
        with unittest.mock.patch.object(program, "stage_options", lambda _: declared):
            (entry,) = document.Campaign(self.folder / "campaign.json", "bole").inputs
        self.assertEqual(entry["set"]["runs.folders"], f"{self.folder}/a,{self.folder}/b")
        spec = {**entry, "document": str(self.folder / "several.json"), "version": "1"}
        before, known = keys.parts_of(spec, {})
        self.assertEqual(keys.parts_of(spec, known)[0], before)
        self.write("b/x", "something else")
        self.assertEqual(keys.difference(before, keys.parts_of(spec, known)[0]), "the content of runs.folders changed")


class Interrupts(Toy):
    # It ends early when the signal reaches it, as bole run does.
    SLOW = "import signal\nsignal.signal(signal.SIGINT, lambda *_: sys.exit(4))\ntime.sleep(3)"

    def interrupted(self, *signals):
        """As a terminal and Jupyter do it: all processes of the group get an interrupt."""
        self.campaign(4)
        fake = self.fake_program(self.SLOW)
        code = f"import sys; sys.path.insert(0, {str(ENGINE)!r}); import bole_campaign; sys.exit(bole_campaign.run(*sys.argv[1:3], workers=1, engine='local'))"
        client = subprocess.Popen([sys.executable, "-c", code, self.folder / "campaign.json", self.out], env=self.marked(BOLE_PROGRAM=str(fake)), stdout=subprocess.PIPE,
                                  stderr=subprocess.STDOUT, text=True, start_new_session=True)
        self.addCleanup(self.end, client)
        self.assertTrue(self.wait_for(lambda: self.processes_of("--no-cache")))
        time.sleep(0.5)  # until it listens
        for number in signals:
            os.killpg(client.pid, number) if number == signal.SIGINT else client.send_signal(number)
            time.sleep(0.5)
        told = client.communicate(timeout=60)[0]
        return client.returncode, told

    def test_the_first_interrupt_lets_inputs_end_and_keeps_them(self):
        code, told = self.interrupted(signal.SIGINT)
        self.assertEqual(code, FINISHED_EARLY, told)
        self.assertEqual(sorted(row["state"] for row in self.status().values()), ["done", "missing", "missing", "missing"])
        self.assertEqual(len({r["input_id"] for r in self.merged()}), 1)

    def test_the_second_interrupt_and_a_request_to_terminate_cancel(self):
        for signals in ((signal.SIGINT, signal.SIGINT), (signal.SIGTERM,)):
            with self.subTest(signals=signals):
                begin = time.monotonic()
                code, told = self.interrupted(*signals)
                self.assertEqual(code, CANCELLED, told)
                self.assertLess(time.monotonic() - begin, 20)
                self.assertEqual({row["state"] for row in self.status().values()}, {"missing"})
                self.assertEqual(list(self.out.glob(".*")), [])
        self.run_all(*LOCAL)
        self.assertEqual(self.begun()[1], {f"p{i}": 1 for i in range(1, 5)})


if __name__ == "__main__":
    sys.exit(unittest.main())
