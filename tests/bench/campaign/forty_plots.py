#!/usr/bin/env python3
"""Simulated plots by one command, while workers and clients are killed; then overhead and efficiency of the engine.

    forty_plots.py --bole build/headless/bin/bole --work /tmp/forty [--plots 40] [--max-time 12] [--engine local] [--cloud plot.las]

0. With --cloud the inputs are squares of that cloud, for stem_map_from_cloud, instead of simulated captures for forest_plot: quicker.

1. Simulates the plots (a folder that exists is used again), one capture is damaged.
2. Runs them one by one with `bole run`: the tables that are right.
3. Runs the campaign, kills 10 workers and 2 clients at random moments, and compares: exits 1 where a table differs, the bad capture is
   not recorded, or an input was run again after it had ended.
4. Runs it with 1 and with 2 workers of one thread each. Overhead: the share of the time in which no program ran. Efficiency: the
   throughput of 2 workers against twice that of 1. Both are ratios within this run.
5. On paper: 1000 workers, from the times of the tasks and the cost of one task for the client (measured with a program that does nothing).
"""

import argparse
import heapq
import json
import os
import pathlib
import random
import signal
import statistics
import subprocess
import sys
import time


def run(*command):
    return subprocess.run([str(c) for c in command], capture_output=True, text=True)


def make_inputs(args):
    """[{id, set}]; the last is damaged."""
    if not args.cloud:
        simulate(args)
        return [{"id": f"p{i}", "set": {"scan.file": str(args.work / f"scan{i}" / "walk.pcap")}} for i in range(1, args.plots + 1)]
    (cloud,) = json.loads(run(args.bole, "info", "--json", args.cloud).stdout)
    chance = random.Random(args.seed)
    low, high = cloud["min_m"], cloud["max_m"]
    middle, spread = [(low[i] + high[i]) / 2 for i in (0, 1)], [max(0.0, min(20.0, high[i] - low[i]) / 2 - args.side / 2) for i in (0, 1)]
    inputs = []
    for i in range(1, args.plots + 1):
        x, y = (middle[k] + chance.uniform(-spread[k], spread[k]) - args.side / 2 for k in (0, 1))
        inputs.append({"id": f"p{i}", "set": {"scan.file": str(args.cloud), "scan.bounds": f"{x:.2f},{y:.2f},{x + args.side:.2f},{y + args.side:.2f}"}})
    damaged = args.work / "damaged.las"
    damaged.write_bytes(b"no cloud " * 1000)
    inputs[-1]["set"]["scan.file"] = str(damaged)
    return inputs


def simulate(args):
    for i in range(1, args.plots + 1):
        scan = args.work / f"scan{i}"
        if not (scan / "walk.pcap").exists():
            done = run(args.bole, "simulate", "--plot", "demo", "--seed", i, "--max-time", args.max_time, "--out", scan)
            if done.returncode:
                sys.exit(done.stderr)
    bad = args.work / f"scan{args.plots}" / "walk.pcap"
    bad.write_bytes(b"no capture " * 1000)


def write_document(args, **more):
    path = args.work / "campaign.json"
    path.write_text(json.dumps({"pipeline": args.pipeline, "inputs": args.inputs, **more}))
    return path


def single_runs(args):
    """{plot: text of stems.csv}, None of those that give none."""
    tables = {}
    for entry in args.inputs:
        out = args.work / "single" / entry["id"]
        if not (out / "stems.csv").exists():
            sets = [word for name, value in entry["set"].items() for word in ("--set", f"{name}={value}")]
            run(args.bole, "run", args.pipeline, *sets, "--out", out, "--no-cache")
        table = out / "stems.csv"
        tables[entry["id"]] = table.read_text() if table.exists() else None
    return tables


def processes_of(word, mark):
    for entry in pathlib.Path("/proc").iterdir():
        if entry.name.isdigit():
            try:
                if word in (entry / "cmdline").read_bytes().decode(errors="replace").split("\0") and mark.encode() in (entry / "environ").read_bytes():
                    yield int(entry.name)
            except OSError:
                pass


def killed_campaign(args, document, out):
    mark = f"BOLE_BENCH_MARK={os.getpid()}"
    environment = {**os.environ, "BOLE_BENCH_MARK": str(os.getpid())}
    command = [str(c) for c in (args.bole, "campaign", "run", document, "--out", out, "--workers", 2, "--engine", args.engine)]
    chance = random.Random(args.seed)
    client, kills, clients = subprocess.Popen(command, env=environment, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL), 0, 0
    while client.poll() is None:
        time.sleep(chance.uniform(0.2, 1.8) * args.kill_every)
        found = sorted(processes_of(chance.choice(["attempt", "--end-with"]), mark))
        if kills < 10 and found:
            try:
                os.kill(chance.choice(found), signal.SIGKILL)
                kills += 1
            except ProcessLookupError:
                pass
        if clients < 2 and kills >= 4 * (clients + 1):
            client.kill()
            client.wait()
            clients += 1
            client = subprocess.Popen(command, env=environment, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    print(f"killed: {kills} workers or programs, {clients} clients; exit code {client.returncode}")
    return client.returncode


def check(args, out, tables, code):
    wrong = []
    for plot, table in tables.items():
        place = out / "tasks" / plot / "done" / "stems.csv"
        if (place.read_text() if place.exists() else None) != table:
            wrong.append(f"{plot}: its table differs from the single run")
        entries = [json.loads(line) for line in (out / "tasks" / plot / "attempts.jsonl").read_text().splitlines()]
        if sum(e["event"] == "end" and e["state"] in ("done", "bad_input", "failed") for e in entries) > 1:
            wrong.append(f"{plot}: it was run again after its end")
    rows = {row["input_id"]: row for row in json.loads(run(args.bole, "campaign", "status", out, "--json").stdout)["inputs"]}
    bad = rows[f"p{args.plots}"]
    print(f"tables compared: {sum(t is not None for t in tables.values())}; the bad capture: {bad['state']}, {bad['error']}")
    if bad["state"] not in ("bad_input", "failed") or not bad["error"]:
        wrong.append("the bad capture is not recorded")
    if code not in (1, 2):
        wrong.append(f"exit code {code}")
    print(f"attempts: {sum(row['attempts'] for row in rows.values())} for {len(rows)} inputs")
    return wrong


def timed(args, document, out, workers, plots):
    begin = time.monotonic()
    run(args.bole, "campaign", "run", document, "--out", out, "--workers", workers, "--engine", args.engine)
    wall = time.monotonic() - begin
    seconds = [row["seconds"] for row in json.loads(run(args.bole, "campaign", "status", out, "--json").stdout)["inputs"]]
    return wall, seconds


def cost_of_a_task(args):
    """Seconds of the client for one task, from runs of 40 and of 240 inputs whose program does nothing."""
    fake = args.work / "nothing"
    fake.write_text(f"#!/bin/sh\n[ \"$1\" = run ] && exit 2\nexec {args.bole} \"$@\"\n")
    fake.chmod(0o755)
    engine = pathlib.Path(__file__).resolve().parents[3] / "app" / "python"
    spent = []
    for count in (40, 240):
        document = args.work / "nothing.json"
        document.write_text(json.dumps({"pipeline": "forest_plot", "inputs": [{"id": str(i), "set": {"scan.file": "none"}} for i in range(count)]}))
        code = (f"import sys, time, resource; sys.path.insert(0, {str(engine)!r}); import bole_campaign; t = time.process_time();"
                f"bole_campaign.run({str(document)!r}, {str(args.work / f'nothing{count}-{os.getpid()}')!r}, workers=2, engine={args.engine!r}); print(time.process_time() - t)")
        done = subprocess.run([sys.executable, "-c", code], env={**os.environ, "BOLE_PROGRAM": str(fake)}, capture_output=True, text=True)
        spent.append(float(done.stdout.split()[-1]))
    return (spent[1] - spent[0]) / 200


def on_paper(seconds, cost, workers, tasks):
    """Efficiency of a list schedule in which the client hands out one task after another."""
    chance = random.Random(1)
    free, clock, work = [0.0] * workers, 0.0, 0.0
    for _ in range(tasks):
        clock = max(clock, heapq.heappop(free)) + cost
        length = chance.choice(seconds)
        work += length
        heapq.heappush(free, clock + length)
    return work / (workers * max(free))


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--bole", type=lambda p: pathlib.Path(p).resolve(), required=True)
    parser.add_argument("--work", type=lambda p: pathlib.Path(p).resolve(), required=True)
    parser.add_argument("--plots", type=int, default=40)
    parser.add_argument("--max-time", type=float, default=12)
    parser.add_argument("--cloud", type=lambda p: pathlib.Path(p).resolve())
    parser.add_argument("--side", type=float, default=8, help="of the squares of --cloud, metres")
    parser.add_argument("--engine", choices=("local", "dask"), default="local")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--kill-every", type=float, default=5, help="seconds between kills, on average")
    args = parser.parse_args()
    args.work.mkdir(parents=True, exist_ok=True)
    args.pipeline = "stem_map_from_cloud" if args.cloud else "forest_plot"
    args.inputs = make_inputs(args)
    tables = single_runs(args)
    stamp = f"{args.engine}-{int(time.time())}"
    out = args.work / f"killed-{stamp}"
    wrong = check(args, out, tables, killed_campaign(args, write_document(args), out))
    document = write_document(args, threads=1)
    walls = {}
    for workers in (1, 2):
        walls[workers], seconds = timed(args, document, args.work / f"workers{workers}-{stamp}", workers, args.plots)
        overhead = 1 - sum(seconds) / (workers * walls[workers])
        print(f"{workers} workers: {walls[workers]:.1f} s for {sum(seconds):.1f} s of work, overhead {100 * overhead:.1f} %")
    print(f"efficiency of 2 workers against 1: {100 * walls[1] / (2 * walls[2]):.1f} %")
    cost = cost_of_a_task(args)
    print(f"one task costs the client {1000 * cost:.1f} ms; median task {statistics.median(seconds):.1f} s")
    for workers in (10, 100, 1000):
        print(f"on paper: {workers} workers, {20 * workers} tasks: efficiency {100 * on_paper(seconds, cost, workers, 20 * workers):.1f} %")
    for line in wrong:
        print("WRONG:", line)
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
