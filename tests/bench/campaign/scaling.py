#!/usr/bin/env python3
"""What more workers give a campaign: measured with 1 and 2 on this machine, computed for more from a ledger.

    scaling.py measure --bole BOLE --work DIR --cloud plot.las     1 and 2 workers in turn, beside the programs alone
    scaling.py idle    --bole BOLE --work DIR --survey SURVEY      240 inputs whose program only copies a survey: the cost of the engine
    scaling.py paper   CAMPAIGN [--costs CAMPAIGN]                 1 to 1000 workers on paper

`paper` takes the times of the tasks from campaign.gpkg, and from attempts.jsonl and runs.jsonl what the engine took (of CAMPAIGN, or of
another campaign: that of `idle` has many attempts). It first computes the run itself, so that the model can be compared with what was measured.

The model: one client serves workers one after another, `client` seconds for each task; a worker then needs `task` seconds, and `gap` seconds until
it can begin the next. Planning before and merging after are the client's, in proportion to the inputs. Not in it: a file system that many
workers read at the same time, and machines of different speed.
"""

import argparse
import concurrent.futures
import datetime
import heapq
import json
import os
import pathlib
import random
import resource
import sqlite3
import statistics
import subprocess
import sys
import time

import forty_plots


def seconds_of(text):
    return datetime.datetime.fromisoformat(text).timestamp()


class Ledger:
    """What a folder of a campaign tells about its last run that had work to do."""

    def __init__(self, folder):
        folder = pathlib.Path(folder)
        with sqlite3.connect(f"file:{folder / 'campaign.gpkg'}?mode=ro", uri=True) as db:
            self.tasks = [s for (s,) in db.execute("SELECT seconds FROM inputs WHERE seconds > 0")]
        runs = [json.loads(line) for line in (folder / "runs.jsonl").read_text().splitlines()]
        self.run = next((run for run in reversed(runs) if run["attempts"]), None)
        if self.run is None or not self.tasks:
            sys.exit(f"{folder}: no run has done any work; needed: a campaign that ran to its end")
        self.wall, self.cpu = self.run["wall_s"], self.run["cpu_s"]
        self.workers, inputs = self.run["workers"], self.run["inputs"]
        # All that the client does but wait. While it waits, the scheduler of Dask works in its process.
        scheduler = self.cpu["wait"] if self.run["engine"].startswith("Dask") else 0.0
        self.client = (self.wall["work"] - self.wall["wait"] + scheduler) / self.run["attempts"]
        self.before_and_after = (self.wall["plan"] + self.wall["merge"]) / inputs
        self.gap = max(self._gap(folder), self.client)

    def _gap(self, folder):
        """Mean time from the end of an attempt to the begin of the next on the same worker."""
        begins, ends = [], []
        first, last = seconds_of(self.run["began"]), seconds_of(self.run["ended"])
        for path in folder.glob("tasks/*/attempts.jsonl"):
            for entry in map(json.loads, path.read_text().splitlines()):
                if first <= (moment := seconds_of(entry["time"])) <= last:
                    (begins if entry["event"] == "begin" else ends).append(moment)
        gaps = [begin - end for begin, end in zip(sorted(begins)[self.workers:], sorted(ends))]
        return statistics.mean(gaps) if gaps else 0.0


def makespan(tasks, workers, client, gap):
    """Seconds until the last task ends."""
    free, clock, last = [0.0] * min(workers, len(tasks)), 0.0, 0.0
    for task in tasks:
        clock = max(clock, heapq.heappop(free)) + client
        last = max(last, clock + task)
        heapq.heappush(free, clock + task + gap - client)
    return last


def paper(args):
    times, costs = Ledger(args.campaign), Ledger(args.costs or args.campaign)
    print(f"{len(times.tasks)} tasks, median {statistics.median(times.tasks):.2f} s, from {min(times.tasks):.2f} to {max(times.tasks):.2f} s ({times.run['engine']}, {times.workers} workers)")
    print(f"engine, for one task: client {1000 * costs.client:.1f} ms, gap on the worker {1000 * costs.gap:.0f} ms, before and after {1000 * costs.before_and_after:.1f} ms"
          f" (from {costs.run['attempts']} attempts, {costs.run['engine']})")
    own = makespan(times.tasks, times.workers, times.client, times.gap)
    print(f"check: {times.workers} workers took {times.wall['work']:.1f} s, the model says {own:.1f} s ({100 * (own / times.wall['work'] - 1):+.1f} %)")
    mean = statistics.mean(times.tasks)
    print(f"the client is busy all the time from {(mean + costs.gap) / costs.client:.0f} workers on")
    print(f"{'workers':>8} {'tasks':>8} {'hours':>8} {'efficiency':>11}")
    for workers in args.workers:
        chance, count = random.Random(1), args.tasks_each * workers
        tasks = chance.choices(times.tasks, k=count)
        whole = makespan(tasks, workers, costs.client, costs.gap) + count * costs.before_and_after
        print(f"{workers:>8} {count:>8} {whole / 3600:>8.2f} {100 * sum(tasks) / (workers * whole):>9.1f} %")
    return 0


def processor_seconds():
    """Of all processes of the machine, and of this one with its children that have ended."""
    with open("/proc/stat", encoding="ascii") as file:
        numbers = [int(n) for n in file.readline().split()[1:]]
    own = sum(u.ru_utime + u.ru_stime for u in map(resource.getrusage, (resource.RUSAGE_SELF, resource.RUSAGE_CHILDREN)))
    return (sum(numbers[:3]) + sum(numbers[5:8])) / os.sysconf("SC_CLK_TCK"), own


class Watch:
    """Seconds by the clock, and the share of the processors that other programs took meanwhile."""

    def __enter__(self):
        self.begin, (self.all, self.own) = time.monotonic(), processor_seconds()
        return self

    def __exit__(self, *_):
        every, own = processor_seconds()
        self.wall = time.monotonic() - self.begin
        self.others = max(0.0, every - self.all - (own - self.own)) / (self.wall * os.cpu_count())


def campaign(args, document, out, workers):
    with Watch() as watch:
        forty_plots.run(args.bole, "campaign", "run", document, "--out", out, "--workers", workers, "--engine", args.engine)
    done = Ledger(out)
    if len(done.tasks) != len(args.inputs):
        sys.exit(f"{out}: {len(done.tasks)} of {len(args.inputs)} inputs have a time")
    return watch, 1 - sum(done.tasks) / (workers * watch.wall)


def alone(args, out, workers):
    """The same programs without an engine: what this machine can give at most."""
    def one(entry):
        sets = [word for name, value in entry["set"].items() for word in ("--set", f"{name}={value}")]
        return forty_plots.run(args.bole, "run", args.pipeline, *sets, "--threads", 1, "--no-cache", "--out", out / entry["id"])

    with Watch() as watch, concurrent.futures.ThreadPoolExecutor(workers) as pool:
        list(pool.map(one, args.inputs))
    return watch


def measure(args):
    args.work.mkdir(parents=True, exist_ok=True)
    args.pipeline, args.inputs = "stem_map_from_cloud", forty_plots.squares(args)
    document = forty_plots.write_document(args, threads=1)
    walls, stamp = {}, f"{args.engine}-{int(time.time())}"
    print(f"{'':<18} {'workers':>7} {'s':>7} {'overhead':>9} {'others':>7}")
    for turn in range(args.rounds):
        for workers in (1, 2):
            out = args.work / f"workers{workers}-{stamp}-{turn}"
            watch, overhead = campaign(args, document, out, workers)
            print(f"{'campaign':<18} {workers:>7} {watch.wall:>7.1f} {100 * overhead:>7.1f} % {100 * watch.others:>5.0f} %  {out}", flush=True)
            walls.setdefault(("campaign", workers), []).append(watch.wall)
            watch = alone(args, args.work / f"alone{workers}-{stamp}-{turn}", workers)
            print(f"{'programs alone':<18} {workers:>7} {watch.wall:>7.1f} {'':>9} {100 * watch.others:>5.0f} %", flush=True)
            walls.setdefault(("alone", workers), []).append(watch.wall)
    ratios = {}
    for what in ("campaign", "alone"):
        one, two = (statistics.median(walls[what, workers]) for workers in (1, 2))
        ratios[what] = one / (2 * two)
        print(f"efficiency of 2 against 1, {what}: {100 * ratios[what]:.1f} %")
    print(f"of the efficiency that the machine gives, the engine keeps {100 * ratios['campaign'] / ratios['alone']:.1f} %")
    return 0


def idle(args):
    """A campaign of a program that does next to nothing, for `paper --costs`."""
    args.work.mkdir(parents=True, exist_ok=True)
    nothing = args.work / "nothing"
    files = " ".join(str(args.survey / name) for name in ("stems.csv", "plot.gpkg", "summary.json")) if args.survey else ""
    work = f'exec cp {files} "$4"' if files else "exit 0"  # bole run DOCUMENT --out FOLDER ...
    nothing.write_text(f'#!/bin/sh\nif [ "$1" = run ]; then {work}; fi\nexec {args.bole} "$@"\n')
    nothing.chmod(0o755)
    document = args.work / "nothing.json"
    document.write_text(json.dumps({"pipeline": "forest_plot", "tables": ["stems.csv"] if args.survey else [], "inputs": [{"id": str(i), "set": {"scan.file": "none"}} for i in range(args.plots)]}))
    out = args.work / f"nothing-{args.engine}-{int(time.time())}"
    engine = pathlib.Path(__file__).resolve().parents[3] / "app" / "python"
    code = f"import sys; sys.path.insert(0, {str(engine)!r}); import bole_campaign; bole_campaign.run({str(document)!r}, {str(out)!r}, workers=2, engine={args.engine!r})"
    subprocess.run([os.environ.get("BOLE_PYTHON", sys.executable), "-c", code], env={**os.environ, "BOLE_PROGRAM": str(nothing)}, stdout=subprocess.DEVNULL, check=True)
    costs = Ledger(out)
    print(f"{out}: client {1000 * costs.client:.1f} ms, gap {1000 * costs.gap:.0f} ms, before and after {1000 * costs.before_and_after:.1f} ms")
    return 0


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    verbs = parser.add_subparsers(required=True)

    def verb(name, function, plots):
        command = verbs.add_parser(name)
        command.set_defaults(function=function)
        if plots:
            command.add_argument("--bole", type=lambda p: pathlib.Path(p).resolve(), required=True)
            command.add_argument("--work", type=lambda p: pathlib.Path(p).resolve(), required=True)
            command.add_argument("--plots", type=int, default=plots)
            command.add_argument("--engine", choices=("local", "dask"), default="local")
        return command

    command = verb("measure", measure, 20)
    command.add_argument("--cloud", type=lambda p: pathlib.Path(p).resolve(), required=True)
    command.add_argument("--side", type=float, default=8, help="of the squares of the cloud, metres")
    command.add_argument("--seed", type=int, default=1)
    command.add_argument("--rounds", type=int, default=3)
    verb("idle", idle, 240).add_argument("--survey", type=lambda p: pathlib.Path(p).resolve(), help="folder of a survey that every input gives, to be put together")
    command = verb("paper", paper, 0)
    command.add_argument("campaign")
    command.add_argument("--costs")
    command.add_argument("--workers", type=int, nargs="+", default=[1, 2, 10, 100, 300, 1000])
    command.add_argument("--tasks-each", type=int, default=20, help="tasks for each worker")
    args = parser.parse_args()
    return args.function(args)


if __name__ == "__main__":
    sys.exit(main())
