"""What the tests of campaigns share: a pipeline of a moment, its inputs, and the program that runs them."""

import csv
import json
import os
import pathlib
import signal
import subprocess
import sys
import tempfile
import time
import unittest

BOLE = pathlib.Path(os.environ["BOLE"]).resolve()
ENGINE = pathlib.Path(__file__).resolve().parents[2] / "app" / "python"
HEADING = "tree_id,x_m,y_m,z_m,dbh_cm,dbh_lo_cm,dbh_hi_cm,height_m,quality,state\n"
STAGES = [
    {"id": "stems", "type": "io.read_table"},
    {"id": "report", "type": "report.plot", "inputs": {"stems": "stems.table"}, "options": {"figures": False}},
]
DONE, FAILED, BAD_INPUT, CANCELLED, FINISHED_EARLY = 0, 1, 2, 3, 4


class Toy(unittest.TestCase):
    """`self.folder` holds a campaign of a few stem tables; self.out is where it runs."""

    def setUp(self):
        self.temporary = tempfile.TemporaryDirectory(prefix="bole_campaign_")
        self.addCleanup(self.temporary.cleanup)
        self.folder = pathlib.Path(self.temporary.name)
        self.out = self.folder / "out"
        self.write("toy.json", json.dumps({"title": "toy", "stages": STAGES}))

    def write(self, name, text):
        path = self.folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, encoding="utf-8")
        return path

    def trees(self, number):
        return HEADING + "".join(f"{i},{5 * i},{number},0,{20 + number + i},19,31,12,good,auto\n" for i in range(1, 2 + number % 3))

    def campaign(self, count=3, bad=(), **more):
        """campaign.json with inputs p1, p2, ...; those in `bad` have no file."""
        for i in range(1, count + 1):
            if i not in bad:
                self.write(f"trees{i}.csv", self.trees(i))
        inputs = [{"id": f"p{i}", "set": {"stems.file": f"trees{i}.csv"}} for i in range(1, count + 1)]
        return self.document({"pipeline": "toy.json", "inputs": inputs, **more})

    def document(self, content):
        return self.write("campaign.json", json.dumps(content))

    def command(self, verb, *arguments):
        return [str(a) for a in (BOLE, "campaign", verb, *arguments)]

    def bole(self, verb, *arguments, **settings):
        return subprocess.run(self.command(verb, *arguments), capture_output=True, text=True, timeout=240, **settings)

    def run_all(self, *arguments, expect=DONE, **settings):
        done = self.bole("run", self.folder / "campaign.json", "--out", self.out, *arguments, **settings)
        self.assertEqual(done.returncode, expect, done.stdout + done.stderr)
        return done.stdout + done.stderr

    def status(self):
        told = self.bole("status", self.out, "--json")
        self.assertEqual(told.returncode, DONE, told.stderr)
        return {row["input_id"]: row for row in json.loads(told.stdout)["inputs"]}

    def begun(self):
        """{input: number of attempts that began}, {input: number that ended well}."""
        begun, ended = {}, {}
        for log in self.out.glob("tasks/*/attempts.jsonl"):
            entries = [json.loads(line) for line in log.read_text().splitlines()]
            begun[log.parent.name] = sum(e["event"] == "begin" for e in entries)
            ended[log.parent.name] = sum(e["event"] == "end" and e["state"] == "done" for e in entries)
        return begun, ended

    def merged(self):
        with open(self.out / "stems.csv", encoding="utf-8", newline="") as file:
            return list(csv.DictReader(file))

    def single(self, input_id, table):
        """The rows of `bole run` alone, as the campaign shows them."""
        out = self.folder / "single" / input_id
        done = subprocess.run([BOLE, "run", self.folder / "toy.json", "--set", f"stems.file={table}", "--out", out, "--no-cache"], capture_output=True, text=True, timeout=60)
        self.assertEqual(done.returncode, DONE, done.stderr)
        with open(out / "stems.csv", encoding="utf-8", newline="") as file:
            return [{"input_id": input_id, **row} for row in csv.DictReader(file)]

    def processes_of(self, word):
        """Processes with this word among their arguments and the output folder in them or their environment: {id: arguments}."""
        found = {}
        for entry in pathlib.Path("/proc").iterdir():
            if entry.name.isdigit():
                try:
                    arguments = (entry / "cmdline").read_bytes().decode(errors="replace").split("\0")
                    mark = (entry / "environ").read_bytes().decode(errors="replace")
                except OSError:
                    continue
                if word in arguments and f"BOLE_TEST_MARK={self.folder}" in mark.split("\0"):
                    found[int(entry.name)] = arguments
        return found

    def marked(self, **more):
        """The environment of a client whose processes processes_of() finds."""
        return {**os.environ, "BOLE_TEST_MARK": str(self.folder), **more}

    def start(self, *arguments, **more):
        client = subprocess.Popen(self.command("run", self.folder / "campaign.json", "--out", self.out, *arguments), stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                                  text=True, env=self.marked(**more), start_new_session=True)
        self.addCleanup(self.end, client)
        return client

    def end(self, client):
        if client.poll() is None:
            client.kill()
            client.wait()
        client.stdout.close()
        self.assertTrue(self.wait_for(lambda: not self.processes_of("run")), "processes outlived their client")

    @staticmethod
    def wait_for(what, seconds=30.0, every_s=0.02):
        until = time.monotonic() + seconds
        while time.monotonic() < until:
            if value := what():
                return value
            time.sleep(every_s)
        return what()

    def fake_program(self, text):
        """A program that is called as bole and does `text` where it is asked to run; all else is the real one's."""
        place = self.write("fake/bole", f"#!{sys.executable}\nimport os, sys, time\nif sys.argv[1] == 'run':\n    out = sys.argv[sys.argv.index('--out') + 1]\n"
                           + "".join(f"    {line}\n" for line in text.splitlines()) + f"os.execv('{BOLE}', ['{BOLE}', *sys.argv[1:]])\n")
        place.chmod(0o755)
        return place

    def run_with(self, program, expect, **settings):
        """The campaign by the Python module, with another program."""
        code = f"import sys; sys.path.insert(0, {str(ENGINE)!r}); import bole_campaign; sys.exit(bole_campaign.run(*sys.argv[1:3], **{settings!r}))"
        done = subprocess.run([sys.executable, "-c", code, self.folder / "campaign.json", self.out], capture_output=True, text=True, timeout=120,
                              env=self.marked(BOLE_PROGRAM=str(program)))
        self.assertEqual(done.returncode, expect, done.stdout + done.stderr)
        return done.stdout + done.stderr


__all__ = ["BAD_INPUT", "BOLE", "CANCELLED", "DONE", "ENGINE", "FAILED", "FINISHED_EARLY", "Toy", "signal"]
