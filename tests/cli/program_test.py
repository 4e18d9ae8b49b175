#!/usr/bin/env python3
"""Runs the program `bole` (its path is the first argument) and looks at output, exit codes and how it takes a Ctrl-C."""

import json
import os
import pathlib
import re
import resource
import signal
import struct
import subprocess
import sys
import tempfile
import time
import unittest

BOLE = pathlib.Path(sys.argv.pop(1)).resolve()
DONE, FAILED, BAD_INPUT, CANCELLED, FINISHED_EARLY = 0, 1, 2, 3, 4
REPOSITORY = pathlib.Path(__file__).resolve().parents[2]
STEMS = "tree_id,x_m,y_m,z_m,dbh_cm,dbh_lo_cm,dbh_hi_cm,height_m,quality,state\n"


class Program(unittest.TestCase):
    def setUp(self):
        self.temporary = tempfile.TemporaryDirectory(prefix="bole_cli_")
        self.addCleanup(self.temporary.cleanup)
        self.folder = pathlib.Path(self.temporary.name)

    def bole(self, *arguments, **settings):
        return subprocess.run([BOLE, *map(str, arguments)], capture_output=True, text=True, timeout=120, **settings)

    def pipeline(self):
        """A pipeline of a moment: a table of stems and its report without figures."""
        self.write("trees.csv", STEMS + "1,0,0,0,20,19,21,12,good,auto\n2,5,0,0,31,30,32,14,good,auto\n")
        stages = [
            {"id": "stems", "type": "io.read_table", "options": {"file": "trees.csv"}},
            {"id": "report", "type": "report.plot", "inputs": {"stems": "stems.table"}, "options": {"figures": False}},
        ]
        return self.write("p.json", json.dumps({"title": "toy", "stages": stages}))

    def names(self, folder):
        return sorted(str(p.relative_to(folder)) for p in folder.rglob("*") if p.is_file() and "cache" not in p.parts)

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

    def test_convert_writes_what_the_ending_says(self):
        lines = "".join(f"{i % 40},{i // 40},{0.01 * i:.2f},{i}\n" for i in range(2000))
        cloud = self.write("cloud.csv", "x,y,z,tree_id\n" + lines)
        before = cloud
        for name, kind in (("a.laz", "LAZ"), ("b.copc.laz", "COPC"), ("c.las", "LAS"), ("d.LAZ", "LAZ")):
            done = self.bole("convert", before, self.folder / name)
            self.assertEqual(done.returncode, DONE, done.stderr)
            (entry,) = json.loads(self.bole("info", "--json", self.folder / name).stdout)
            self.assertEqual((entry["format"], entry["points"]), (kind, 2000))
            for value, expected in zip(entry["max_m"], (39, 49, 19.99), strict=True):
                self.assertAlmostEqual(value, expected, places=4)
            self.assertEqual(entry["arrays"]["tree_id"]["max"], 1999)
            before = self.folder / name
        part = self.folder / "part.laz"
        self.assertEqual(self.bole("convert", self.folder / "b.copc.laz", part, "--bounds", "0,0,9,9").returncode, DONE)
        (entry,) = json.loads(self.bole("info", "--json", part).stdout)
        self.assertEqual(entry["points"], 100)

    def test_convert_refuses_what_it_cannot_do(self):
        cloud = self.write("cloud.csv", "x,y,z\n1,2,3\n4,6,8\n")
        self.assertEqual(self.bole("convert", cloud, self.folder / "a.doc").returncode, BAD_INPUT)
        self.assertEqual(self.bole("convert", cloud, cloud).returncode, BAD_INPUT)
        self.assertIn("x,y,z", cloud.read_text())
        self.assertEqual(self.bole("convert", cloud, self.folder / "a.laz").returncode, DONE)
        whole = (self.folder / "a.laz").read_bytes()
        cut = self.write("cut.laz", whole[:-60])
        done = self.bole("convert", cut, self.folder / "b.laz")
        self.assertNotEqual(done.returncode, DONE)
        self.assertFalse((self.folder / "b.laz").exists())

    def test_info_lists_the_formats(self):
        formats = json.loads(self.bole("info", "--formats", "--json").stdout)
        by_name = {(f["name"], f["stage"]): f for f in formats}
        self.assertEqual(by_name["XYZ", "io.read_cloud"]["endings"], [".xyz", ".txt", ".asc"])
        self.assertTrue(by_name["LAS", "io.read_cloud"]["written"] and not by_name["E57", "io.read_cloud"]["written"])
        self.assertTrue(by_name["folder of frames", "io.read_scan"]["folder"])
        told = self.bole("info", "--formats").stdout
        self.assertEqual(len(told.splitlines()), len(formats))
        self.assertIn("XYZ                      point cloud      .xyz, .txt, .asc", told)
        self.assertNotEqual(self.bole("info").returncode, 0)
        self.assertNotEqual(self.bole("info", "--formats", "a.las").returncode, 0)

    def test_info_goes_on_after_a_file_that_cannot_be_read(self):
        good, bad = self.write("a.xyz", "1 2 3\n4 5 6\n"), self.write("b.las", "a letter")
        done = self.bole("info", "--json", good, bad, good)
        self.assertEqual(done.returncode, BAD_INPUT)
        first, second, third = json.loads(done.stdout)
        self.assertEqual((first["points"], third["points"]), (2, 2))
        self.assertIn("b.las", second["error"])
        self.assertIn("b.las", done.stderr)

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
        self.assertEqual(code, FINISHED_EARLY, told)
        self.assertIn("Finishing with what there is so far", told)
        self.assertIn("walk.pcap", self.names(self.folder / "scan"))
        code, told = self.interrupted(["simulate", "--plot", "demo", "--out", self.folder / "scan2"], [signal.SIGINT, signal.SIGINT])
        if code != FINISHED_EARLY:  # it may have finished before the second came
            self.assertEqual(code, CANCELLED, told)

    def test_a_request_to_terminate_cancels_at_once(self):
        begin = time.monotonic()
        code, told = self.interrupted(["simulate", "--plot", "demo", "--out", self.folder / "scan"], [signal.SIGTERM])
        self.assertEqual(code, CANCELLED, told)
        self.assertLess(time.monotonic() - begin, 30)
        self.assertEqual(list((self.folder / "scan").rglob("*")), [])

    def test_work_that_cannot_finish_early_is_cancelled_at_once(self):
        code, told = self.interrupted(["simulate-field", "--out", self.folder / "field", "--frames", "500"], [signal.SIGINT])
        self.assertEqual(code, CANCELLED, told)
        self.assertIn("Cancelling", told)
        self.assertNotIn("Finishing", told)

    def run_pipeline(self, *more, **settings):
        return self.bole("run", self.pipeline(), "--out", self.folder / "o", *more, **settings)

    def summary(self):
        return json.loads((self.folder / "o" / "summary.json").read_text())

    def test_a_run_gives_its_verdict_and_says_where_the_results_are(self):
        told = self.run_pipeline()
        self.assertEqual(told.returncode, DONE, told.stderr)
        self.assertIn("Verdict: " + self.summary()["verdict"], told.stdout)
        self.assertIn("see report.html", told.stdout)
        self.assertIn(f"Results are in {self.folder / 'o'}", told.stdout)
        self.assertEqual(self.names(self.folder / "o"), sorted(self.summary()["files"]))

    def test_files_that_the_next_run_does_not_write_are_removed(self):
        self.run_pipeline()
        self.assertIn("survey.xlsx", self.names(self.folder / "o"))
        self.assertEqual(self.run_pipeline("--set", "report.tables=false").returncode, DONE)
        self.assertEqual(self.names(self.folder / "o"), ["report.html", "summary.json", "tally.html"])

    def test_foreign_files_are_never_written_over(self):
        out = self.folder / "o"
        out.mkdir()
        mine = self.write("o/stems.csv", "mine")
        told = self.run_pipeline()
        self.assertEqual(told.returncode, BAD_INPUT)
        self.assertIn("stems.csv", told.stderr)
        self.assertIn("--force", told.stderr)
        self.assertNotIn("Results are in", told.stdout)
        self.assertEqual((mine.read_text(), self.names(out)), ("mine", ["stems.csv"]))
        self.assertEqual(self.run_pipeline("--force").returncode, DONE)
        self.assertTrue(mine.read_text().startswith("tree_id"))

    def test_folders_in_the_way_are_refused(self):
        for name in ("stems.csv", "report.html"):
            (self.folder / "o" / name).mkdir(parents=True)
        for more in ([], ["--force"]):
            told = self.run_pipeline(*more)
            self.assertEqual(told.returncode, BAD_INPUT, told.stderr)
            self.assertNotIn("Results are in", told.stdout)

    def test_a_failed_run_leaves_the_survey_before_marked_as_old(self):
        self.run_pipeline()
        before = (self.folder / "o" / "stems.csv").read_bytes()
        self.pipeline()
        broken = self.bole("run", self.folder / "p.json", "--out", self.folder / "o", "--set", f"stems.file={self.write('bad.csv', 'a,b' + chr(10) + '1' + chr(10))}")
        self.assertEqual(broken.returncode, BAD_INPUT)
        self.assertNotIn("Results are in", broken.stdout + broken.stderr)
        self.assertIn("marked as old", broken.stderr)
        out = self.folder / "o"
        self.assertEqual((out / "stems.csv").read_bytes(), before)
        self.assertIn("bad.csv", (out / "FAILED_RUN.txt").read_text())
        self.assertEqual(self.summary()["findings"][0]["code"], "older_survey")
        self.assertIn("Do not sign: a later run into this folder failed", (out / "report.html").read_text())
        self.assertEqual(json.loads((out / "failed_run" / "summary.json").read_text())["verdict"], "refused")
        self.assertEqual(self.run_pipeline().returncode, DONE)
        self.assertFalse((out / "FAILED_RUN.txt").exists() or (out / "failed_run").exists())
        self.assertNotIn("later_run_failed", self.summary())

    def test_what_a_person_typed_into_a_table_is_kept(self):
        self.run_pipeline()
        table = self.folder / "o" / "stems.csv"
        typed = table.read_text().rstrip() + " leans\n"
        table.write_text(typed)
        again = self.run_pipeline()
        self.assertEqual(again.returncode, DONE)
        self.assertIn("stems.csv was changed after Bole wrote it", again.stderr)
        self.assertEqual([path.read_text() for path in table.parent.glob("stems.changed-*.csv")], [typed])
        self.assertNotIn("leans", table.read_text())
        self.assertIn("changed_file_kept", [finding["code"] for finding in self.summary()["findings"]])
        self.assertEqual(self.run_pipeline().returncode, DONE)
        self.assertEqual(len(list(table.parent.glob("stems.changed-*.csv"))), 1)

    @staticmethod
    def small_disk():
        """Files end after 20 kB, as on a disk that is full then."""
        signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
        resource.setrlimit(resource.RLIMIT_FSIZE, (20_000, 20_000))

    def test_an_output_that_cannot_be_written_fails_the_run(self):
        told = self.run_pipeline("--no-cache", preexec_fn=self.small_disk)
        self.assertEqual(told.returncode, FAILED, told.stdout + told.stderr)
        self.assertIn("could not be written", told.stderr)
        self.assertNotIn("Results are in", told.stdout)
        self.assertIn("Verdict: refused", told.stdout)

    def test_what_a_full_disk_keeps_from_being_marked_is_named(self):
        self.run_pipeline("--no-cache")
        page = self.folder / "o" / "report.html"
        self.assertGreater(page.stat().st_size, 20_000)
        told = self.run_pipeline("--no-cache", preexec_fn=self.small_disk)
        self.assertEqual(told.returncode, FAILED, told.stdout + told.stderr)
        self.assertRegex(told.stderr, r"could not be marked as old \(.*report\.html: ")
        self.assertNotIn("Do not sign", page.read_text())
        self.assertFalse((self.folder / "o" / "failed_run").exists())

    def test_a_table_that_no_output_can_be_made_of_is_bad_input(self):
        pipeline = self.pipeline()
        self.write("trees.csv", "tree_id,x_m\n1,5\n")
        told = self.bole("run", pipeline, "--out", self.folder / "o")
        self.assertEqual(told.returncode, BAD_INPUT, told.stdout + told.stderr)
        self.assertIn("no column 'y_m'", told.stderr)
        self.assertIn("input_not_usable", [finding["code"] for finding in self.summary()["findings"]])
        self.assertEqual(self.bole("run", pipeline, "--out", self.folder / "o").returncode, BAD_INPUT)  # not from the cache

    def test_a_full_disk_leaves_no_recording_that_is_cut_off(self):
        told = self.bole("simulate", "--plot", "demo", "--out", self.folder / "scan", preexec_fn=self.small_disk)
        self.assertEqual(told.returncode, FAILED, told.stderr)
        self.assertEqual(list((self.folder / "scan").rglob("*")), [])

    def test_a_cache_that_cannot_be_written_stops_nothing(self):
        told = self.run_pipeline("--cache", self.write("file", "x") / "cache")
        self.assertEqual(told.returncode, DONE, told.stderr)

    def test_the_cache_does_not_trust_the_time_of_a_file(self):
        self.run_pipeline()
        trees = self.folder / "trees.csv"
        times = trees.stat()
        text = trees.read_text().replace("31", "41").replace("30", "40").replace("32", "42")
        trees.write_text(text)
        os.utime(trees, ns=(times.st_atime_ns, times.st_mtime_ns))
        self.bole("run", self.folder / "p.json", "--out", self.folder / "o")
        self.assertIn("41", (self.folder / "o" / "stems.csv").read_text())

    def test_a_pipe_as_input_is_refused(self):
        os.mkfifo(self.folder / "walk.pcap")
        for command in (["survey", self.folder / "walk.pcap"], ["run", "forest_plot", "--set", f"scan.file={self.folder / 'walk.pcap'}"]):
            told = self.bole(*command, "--out", self.folder / "o")
            self.assertEqual(told.returncode, BAD_INPUT, told.stderr)

    def test_a_cloud_that_is_read_in_part_is_refused_unless_accepted(self):
        cloud = self.write("cloud.ply", "ply\nformat ascii 1.0\nelement vertex 100\nproperty float x\nproperty float y\nproperty float z\nend_header\n" + "1 2 3\n" * 8)
        document = self.write("read.json", json.dumps({"stages": [{"id": "scan", "type": "io.read_cloud", "options": {"file": str(cloud)}}]}))
        told = self.bole("run", document, "--out", self.folder / "o")
        self.assertEqual(told.returncode, FAILED, told.stdout)
        self.assertIn("8 %", told.stderr)
        self.assertIn("--accept-partial", told.stderr)
        self.assertIn("input_incomplete", [finding["code"] for finding in self.summary()["findings"]])
        told = self.bole("run", document, "--out", self.folder / "o", "--accept-partial")
        self.assertEqual(told.returncode, DONE, told.stderr)
        self.assertIn("input_incomplete", (self.folder / "o" / "summary.json").read_text())

    def test_shipped_pipelines_go_by_their_name(self):
        told = self.bole("validate", "stem_map_from_cloud", "--set", f"scan.file={self.write('a.xyz', '1 2 3' + chr(10))}")
        self.assertEqual(told.returncode, DONE, told.stderr + told.stdout)
        told = self.bole("run", "stem_map_from_clod", "--out", self.folder / "o")
        self.assertEqual(told.returncode, BAD_INPUT)
        self.assertIn("Did you mean stem_map_from_cloud", told.stderr)
        # A misspelt name is told before a missing --out.
        self.assertIn("Did you mean stem_map_from_cloud", self.bole("run", "stem_map_from_clod").stderr)
        self.assertIn("bole survey", self.bole("run", self.write("plot.xyz", "1 2 3\n")).stderr)

    def test_a_cloud_given_to_run_is_sent_to_survey(self):
        told = self.bole("run", self.write("plot.xyz", "1 2 3\n"), "--out", self.folder / "o")
        self.assertEqual(told.returncode, BAD_INPUT)
        self.assertIn("bole survey", told.stderr)
        self.assertNotIn("JSON text", told.stderr)

    def test_survey_makes_the_pipeline_for_a_file(self):
        told = self.bole("survey", self.write("plot.xyz", "0 0 0\n1 0 0\n0 1 0\n"), "--out", self.folder / "o", "--set", "report.figures=false")
        summary = json.loads((self.folder / "o" / "summary.json").read_text())
        self.assertEqual(summary["stages"][0]["type"], "io.read_cloud")
        self.assertEqual(summary["exit_code"], told.returncode)
        told = self.bole("survey", self.write("letter.md", "dear forester"), "--out", self.folder / "o2")
        self.assertEqual(told.returncode, BAD_INPUT)
        self.assertFalse((self.folder / "o2").exists())
        told = self.bole("survey", self.folder / "gone.ply", "--out", self.folder / "o2")
        self.assertEqual(told.returncode, BAD_INPUT)
        self.assertIn("gone.ply", told.stderr)
        self.assertFalse((self.folder / "o2").exists())

    def test_suggestions(self):
        for arguments, meant in (
            (["runn"], "run"),
            (["evaluate", "stem", "a", "b"], "stems"),
            (["run", "p.json", "--ot", "o"], "--out"),
            (["stages", "stems"], "stems.measure"),
            (["simulate", "--plot", "sampel", "--out", self.folder / "none"], "sample"),
            (["stages", "io.read_clod"], "io.read_cloud"),
            (["run", self.pipeline(), "--out", "o", "--set", "stem.file=x"], "stems"),
            (["run", self.pipeline(), "--out", "o", "--set", "report.figure=x"], "figures"),
        ):
            with self.subTest(arguments=arguments):
                told = self.bole(*arguments)
                self.assertEqual(told.returncode, BAD_INPUT)
                self.assertRegex(told.stderr, "Did you mean.*" + meant)
        self.assertFalse((self.folder / "none").exists())

    def test_pages_of_stages_have_an_example_that_holds(self):
        options = {t["type"]: {o["name"] for o in t["options"]} for t in json.loads(self.bole("stages", "--json").stdout)}
        pages = self.bole("stages", "--markdown").stdout
        examples = re.findall(r"^# (\S+): .*?^```json\n(.*?)^```\n(?:\n```\nbole run (\S+) --set (\S+?)\.(\S+?)=)?", pages, re.M | re.S)
        self.assertEqual({name for name, *_ in examples}, set(options))
        used = 0
        for name, text, pipeline, stage, option in examples:
            with self.subTest(stage=name):
                example = json.loads(text)
                self.assertEqual(example["type"], name)
                if not pipeline:
                    continue
                used += 1
                document = json.loads((REPOSITORY / "pipelines" / f"{pipeline}.json").read_text())
                self.assertIn(example, document["stages"])
                self.assertEqual(stage, example["id"])
                self.assertIn(option, options[name])
        self.assertGreater(used, 40)

    def test_the_home_folder_stands_for_a_tilde(self):
        self.pipeline()
        told = self.bole("run", "~/p.json", "--set", "stems.file=~/trees.csv", "--out=~/o", env={**os.environ, "HOME": str(self.folder)})
        self.assertEqual(told.returncode, DONE, told.stderr)
        self.assertTrue((self.folder / "o" / "stems.csv").exists())
        self.write("cloud.csv", "x,y,z\n1,2,3\n")
        self.assertEqual(self.bole("info", "~/cloud.csv", env={**os.environ, "HOME": str(self.folder)}).returncode, DONE)

    def test_info_shows_numbers_for_people_and_findings_first(self):
        cloud = self.write("cloud.csv", "x,y,z,classification\n-7.9999,2.1,-0.9056,ground\n4,6,8.3,2\n")
        lines = self.bole("info", cloud).stdout.splitlines()
        self.assertTrue(lines[1].startswith("note") and "words_for_numbers" in lines[1], lines[1])
        self.assertIn("bounds                 [-7.9999,2.1,-0.9056,4,6,8.3]", lines)
        self.assertIn("min_m                  [-7.9999,2.1,-0.9056]", lines)

    def test_version(self):
        self.assertRegex(self.bole("--version").stdout, r"^Bole \d+\.\d+")

    def test_completion_in_bash(self):
        script = self.write("completion.bash", self.bole("completion", "bash").stdout)

        def completed(*words):
            line = " ".join(f"'{w}'" for w in words)
            command = f"source {script}; COMP_WORDS=({line}); COMP_CWORD={len(words) - 1}; _bole; printf '%s\\n' \"${{COMPREPLY[@]}}\""
            done = subprocess.run(["bash", "-c", command], capture_output=True, text=True, timeout=20)
            self.assertEqual(done.stderr, "")
            return done.stdout.split()

        self.assertEqual(completed("bole", "sur"), ["survey"])
        self.assertIn("stem_map_from_cloud", completed("bole", "run", "stem"))
        self.assertEqual(completed("bole", "run", "--accept"), ["--accept-partial"])
        self.assertIn("io.read_cloud", completed("bole", "stages", "io."))
        self.assertIn("stems", completed("bole", "evaluate", "s"))
        self.assertIn("circle", completed("bole", "evaluate", "stems", "--plot-shape", ""))
        for shell in ("zsh", "fish"):
            self.assertIn("accept-partial", self.bole("completion", shell).stdout)
        self.assertEqual(self.bole("completion", "tcsh").returncode, BAD_INPUT)

    def test_the_manual_page_and_the_list_of_exit_codes(self):
        page = self.bole("man").stdout
        self.assertTrue(page.startswith(".TH BOLE 1"))
        for part in (".SH EXIT STATUS", "bole survey", "\\-\\-accept\\-partial", "stem_map_from_cloud"):
            self.assertIn(part, page)
        told = self.bole("--help").stdout
        manual = (REPOSITORY / "docs" / "user" / "command-line.md").read_text()
        for line in told[told.index("Exit codes:") :].splitlines()[1:]:
            if line.strip():
                code, meaning = line.strip().split(maxsplit=1)
                self.assertIn(f"| {code} | {meaning} |", manual)


if __name__ == "__main__":
    sys.exit(unittest.main())
