#!/usr/bin/env python3
"""Nothing lost, nothing twice: workers and clients are killed, programs crash, two clients meet. BOLE is the program."""

import json
import os
import random
import subprocess
import sys
import time
import unittest

from toy import BAD_INPUT, BOLE, DONE, ENGINE, FAILED, Toy, signal


def has_dask():
    """Whether the Python that runs the engine has Dask.distributed."""
    program = os.environ.get("BOLE_PYTHON") or sys.executable
    return subprocess.run([program, "-c", "import distributed"], capture_output=True).returncode == 0


def alive(process_id):
    try:
        with open(f"/proc/{process_id}/stat", encoding="ascii", errors="replace") as file:
            return file.read().rsplit(")", 1)[1].split()[0] != "Z"
    except OSError:
        return False


class Killed(Toy):
    engine = "local"

    def kill_some(self, word, chance):
        """Kills one of the processes of this campaign that have a word among their arguments."""
        found = sorted(self.processes_of(word))
        if not found:
            return False
        victim = chance.choice(found)
        try:
            os.kill(victim, signal.SIGKILL)
        except ProcessLookupError:
            return False
        return True

    def test_killed_workers_and_clients_cost_time_and_nothing_else(self):
        seed = int(os.environ.get("BOLE_TEST_SEED", time.time_ns() % 10**6))
        print(f"seed {seed} ({self.engine})", flush=True)
        chance = random.Random(seed)
        # Chance may kill one input every time: as many tries as there are kills, so that none is given up.
        self.campaign(12, bad={7}, retries=10)
        killed = clients = 0
        client = self.start("--engine", self.engine, "--workers", "2")
        until = time.monotonic() + 200
        while client.poll() is None and time.monotonic() < until:
            time.sleep(chance.uniform(0.05, 0.6))
            # The process that watches an attempt, or the program itself.
            if killed < 10:
                killed += self.kill_some(chance.choice(["attempt", "--no-cache"]), chance)
            if killed > 3 * (clients + 1) and clients < 2:
                client.kill()
                client.wait()
                clients += 1
                client.stdout.read()
                client = self.start("--engine", self.engine, "--workers", "2")
        told = client.stdout.read()
        self.assertEqual(client.wait(), BAD_INPUT, told)
        self.assertGreaterEqual(killed, 5, "too little was killed for a test")
        self.assertEqual(clients, 1 if killed < 7 else 2)
        rows = self.status()
        self.assertEqual({p for p, row in rows.items() if row["state"] != "done"}, {"p7"})
        self.assertEqual(rows["p7"]["state"], "bad_input")
        expected = [row for i in range(1, 13) if i != 7 for row in self.single(f"p{i}", self.folder / f"trees{i}.csv")]
        self.assertEqual(self.merged(), expected)
        begun, ended = self.begun()
        # An attempt may be killed between the rename and its last word; then the result is there and nothing ran again.
        self.assertTrue(all(n <= 1 for n in ended.values()), ended)
        self.assertLessEqual(sum(begun.values()), 12 + 2 * killed + 4 * clients)
        left = [p.name for p in self.out.glob("tasks/*/*") if p.name not in ("done", "failed", "lock", "attempts.jsonl")]
        self.assertEqual(left, [])
        self.assertEqual(self.run_all("--engine", self.engine, expect=BAD_INPUT).count("to run"), 0)
        self.assertEqual(self.begun()[0], begun)

    def freeze(self, input_id):
        """Stops the program that works on an input once it writes, so that it cannot end by itself. Its process id."""
        folder = self.out / "tasks" / input_id
        self.assertTrue(self.wait_for(lambda: any("bole-" in p.name for p in folder.rglob("*")) if folder.exists() else False, every_s=0.001), "nothing is written")
        table = f"stems.file={self.folder}/trees{input_id[1:]}.csv"
        program = next(p for p, arguments in self.processes_of("--no-cache").items() if table in arguments)
        os.kill(program, signal.SIGSTOP)
        return program

    def test_the_program_dies_with_the_worker_and_with_the_client(self):
        self.campaign(1)
        for victim in ("worker", "client"):
            with self.subTest(victim=victim):
                self.out = self.folder / victim
                client = self.start("--engine", self.engine, "--workers", "1")
                program = self.freeze("p1")
                (worker,) = self.processes_of("attempt")
                time.sleep(0.5)
                self.assertTrue(alive(program), "it is not frozen")
                os.kill(worker if victim == "worker" else client.pid, signal.SIGKILL)
                self.assertTrue(self.wait_for(lambda: not alive(program), 10), "the program outlived its worker")
                if victim == "client":
                    self.assertTrue(self.wait_for(lambda: not alive(worker), 10), "the worker outlived its client")
                    self.run_all("--engine", self.engine)
                else:
                    self.assertEqual(client.wait(timeout=60), DONE, client.stdout.read())
                self.assertEqual(self.begun(), ({"p1": 2}, {"p1": 1}))


class KilledWithDask(Killed):
    engine = "dask"

    def start_cluster(self):
        python = os.environ.get("BOLE_PYTHON") or sys.executable
        file = self.folder / "scheduler.json"
        log = open(self.folder / "cluster.log", "ab")
        self.addCleanup(log.close)
        common = {"stdout": log, "stderr": log, "env": self.marked()}
        parts = [subprocess.Popen([python, "-m", "distributed.cli.dask_scheduler", "--port", "0", "--no-dashboard", "--scheduler-file", file], **common)]
        self.assertTrue(self.wait_for(file.exists), "no scheduler")
        for _ in range(2):
            parts.append(subprocess.Popen([python, "-m", "distributed.cli.dask_worker", "--nthreads", "1", "--scheduler-file", file, "--no-dashboard",
                                           "--local-directory", self.folder / "dask"], **common))
        for part in parts:
            self.addCleanup(part.wait)
            self.addCleanup(part.kill)
        return file, parts

    def test_a_cluster_with_a_scheduler_of_its_own(self):
        file, parts = self.start_cluster()
        self.campaign(6, bad={2})
        address = json.loads(file.read_text())["address"]
        told = self.run_all("--scheduler", address, expect=BAD_INPUT)
        self.assertIn("6 inputs: 5 done, 1 bad input", told)
        self.assertEqual({r["input_id"] for r in self.merged()}, {"p1", "p3", "p4", "p5", "p6"})
        # The scheduler is killed under a second campaign; run again on a new one, it goes on.
        self.out = self.folder / "second"
        client = self.start("--scheduler", str(file))
        program = self.freeze("p6")
        self.assertTrue(self.wait_for(lambda: sum(row["state"] == "done" for row in self.status().values()) == 4))
        self.assertTrue(alive(program), "it is not frozen")
        for part in parts:
            part.kill()
            part.wait()
        told = client.communicate(timeout=90)[0]
        self.assertEqual(client.returncode, FAILED, told)
        self.assertIn("scheduler", told)
        self.assertFalse(alive(program), "it outlived its worker")
        file.unlink()
        file, _ = self.start_cluster()
        self.run_all("--scheduler", file, expect=BAD_INPUT)
        self.assertEqual(self.begun()[1], {"p1": 1, "p2": 0, "p3": 1, "p4": 1, "p5": 1, "p6": 1})

    def test_a_scheduler_that_is_not_there_is_told(self):
        self.campaign(1)
        self.assertIn("no scheduler answers at 'tcp://127.0.0.1:9'", self.run_all("--scheduler", "tcp://127.0.0.1:9", expect=FAILED))


class Programs(Toy):
    """The program itself misbehaves."""

    def test_crashes_are_tried_again_a_set_number_of_times(self):
        self.campaign(2, retries=2)
        fake = self.fake_program("if 'stems.file=' + out.split('/tasks/')[0][:-4] + '/trees1.csv' in sys.argv:\n    os.kill(os.getpid(), 11)")
        told = self.run_with(fake, FAILED, engine="local")
        self.assertIn("killed by SIGSEGV", told)
        self.assertEqual(self.begun()[0], {"p1": 3, "p2": 1})
        self.assertEqual(self.status()["p1"]["state"], "crashed")
        self.run_with(BOLE, DONE, engine="local")  # a crash is no property of the input: resume tries again
        self.assertEqual(self.begun(), ({"p1": 4, "p2": 1}, {"p1": 1, "p2": 1}))

    def test_failed_work_is_recorded_and_tried_again_on_request_only(self):
        self.campaign(1)
        fake = self.fake_program("print('bole: the work went wrong', file=sys.stderr)\nsys.exit(1)")
        self.run_with(fake, FAILED, engine="local")
        self.run_with(fake, FAILED, engine="local")
        self.assertEqual(self.begun()[0], {"p1": 1})
        self.assertEqual(self.status()["p1"]["error"], "the work went wrong")
        self.run_with(BOLE, DONE, engine="local", retry=True)
        self.assertEqual(self.begun()[0], {"p1": 2})

    def test_memory_that_is_declared_is_kept_to(self):
        hungry = "data = bytearray(700 << 20)\ntime.sleep(5)"
        self.campaign(1, memory_gib=0.5)
        told = self.run_with(self.fake_program(hungry), FAILED, engine="local")
        self.assertIn("needs more than the 0.5 GiB", told)
        self.assertEqual(self.begun()[0], {"p1": 1})
        self.assertLess(self.status()["p1"]["seconds"], 5)
        # An estimate is doubled instead.
        self.campaign(1)
        self.out = self.folder / "estimated"
        self.run_with(self.fake_program(hungry), DONE, engine="local", memory_gib=4)
        self.assertEqual(self.begun()[0], {"p1": 2})

    def test_no_more_run_at_a_time_than_fit_into_the_memory(self):
        self.campaign(4, memory_gib=1.5)
        at_work = self.folder / "at_work"
        fake = self.fake_program(f"open({str(at_work)!r}, 'a').write('b')\ntime.sleep(0.5)\nopen({str(at_work)!r}, 'a').write('e')")
        self.run_with(fake, DONE, engine="local", workers=4, memory_gib=3.2)
        most = level = 0
        for mark in at_work.read_text():
            level += 1 if mark == "b" else -1
            most = max(most, level)
        self.assertEqual(most, 2)

    def test_a_time_limit_ends_an_input(self):
        self.campaign(1, time_limit_s=1)
        told = self.run_with(self.fake_program("time.sleep(30)"), FAILED, engine="local")
        self.assertIn("time_limit_s", told)
        self.assertEqual(self.begun()[0], {"p1": 1})


class TwoClients(Toy):
    def test_a_second_client_is_refused_and_a_job_array_shares(self):
        self.campaign(3)
        seen = self.folder / "seen"  # the first input waits for it, however slow the machine is
        fake = self.fake_program(f"while not os.path.exists({str(seen)!r}): time.sleep(0.05)\ntime.sleep(2)")
        code = f"import sys; sys.path.insert(0, {str(ENGINE)!r}); import bole_campaign; sys.exit(bole_campaign.run(*sys.argv[1:3], workers=1, engine='local'))"
        first = subprocess.Popen([sys.executable, "-c", code, self.folder / "campaign.json", self.out], env=self.marked(BOLE_PROGRAM=str(fake)), stdout=subprocess.PIPE,
                                 stderr=subprocess.STDOUT, text=True)
        self.addCleanup(self.end, first)
        self.assertTrue(self.wait_for(lambda: self.processes_of("--no-cache")))
        told = self.run_all("--engine", "local", expect=FAILED)
        self.assertIn(f"another client works in '{self.out}' (process {first.pid} ", told)
        self.assertIn("running", {row["state"] for row in self.status().values()})
        seen.touch()
        for k in (1, 2, 3):
            self.run_all("--task", k)
        told = first.communicate(timeout=60)[0]
        self.assertEqual(first.returncode, DONE, told)
        self.assertEqual(self.begun()[0], {"p1": 1, "p2": 1, "p3": 1})


class Crashes(Toy):
    """The client or the machine ended between two steps of a rename."""

    def test_renames_that_were_cut_off_are_ended(self):
        self.campaign(3)
        self.run_all("--engine", "local")
        before = self.merged()
        tasks = self.out / "tasks"
        (tasks / "p1/done").rename(tasks / "p1/attempt-0123456789ab")
        (tasks / "p2/done").rename(tasks / "p2/replaced-attempt-0123456789ab")
        (tasks / "p3/attempt-0123456789ab").mkdir()
        (tasks / "p3/attempt-0123456789ab/stems.csv").write_text("half a ta")
        for name in ("stems.csv", "campaign.gpkg"):
            (self.out / name).unlink()
        self.run_all("--engine", "local")
        self.assertEqual(self.begun()[0], {"p1": 1, "p2": 1, "p3": 1})
        self.assertEqual(self.merged(), before)
        self.assertFalse((tasks / "p3/attempt-0123456789ab").exists())

    def test_a_damaged_ledger_is_written_anew(self):
        self.campaign(1)
        self.run_all("--engine", "local")
        (self.out / "campaign.gpkg").write_bytes(b"no database" * 1000)
        self.run_all("--engine", "local")
        self.assertEqual((self.out / "campaign.gpkg").read_bytes()[:15], b"SQLite format 3")


SKIPPED = 77  # what ctest takes for a skipped test

if __name__ == "__main__":
    if "KilledWithDask" in sys.argv and not has_dask():
        print("SKIPPED: Dask.distributed is not installed (package python3-distributed)")
        sys.exit(SKIPPED)
    sys.exit(unittest.main())
