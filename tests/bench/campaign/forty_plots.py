#!/usr/bin/env python3
"""Simulated plots by one command, while workers and clients are killed. What the engine costs is measured by scaling.py.

    forty_plots.py --bole build/headless/bin/bole --work /tmp/forty [--plots 40] [--max-time 12] [--engine local] [--cloud plot.las]

0. With --cloud the inputs are squares of that cloud, for stem_map_from_cloud, instead of simulated captures for forest_plot: quicker.

1. Simulates the plots (a folder that exists is used again), one capture is damaged.
2. Runs them one by one with `bole run`: the tables that are right.
3. Runs the campaign, kills 10 workers and 2 clients at random moments, and compares: exits 1 where a table differs, the bad capture is
   not recorded as bad input, or an input was run again after it had ended.
"""

import argparse
import json
import os
import pathlib
import random
import signal
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
    inputs = squares(args)
    damaged = args.work / "damaged.las"
    damaged.write_bytes(b"no cloud " * 1000)
    inputs[-1]["set"]["scan.file"] = str(damaged)
    return inputs


def squares(args):
    """Inputs that are squares of a cloud, at random places near its middle."""
    (cloud,) = json.loads(run(args.bole, "info", "--json", args.cloud).stdout)
    chance = random.Random(args.seed)
    low, high = cloud["min_m"], cloud["max_m"]
    middle, spread = [(low[i] + high[i]) / 2 for i in (0, 1)], [max(0.0, min(20.0, high[i] - low[i]) / 2 - args.side / 2) for i in (0, 1)]
    inputs = []
    for i in range(1, args.plots + 1):
        x, y = (middle[k] + chance.uniform(-spread[k], spread[k]) - args.side / 2 for k in (0, 1))
        inputs.append({"id": f"p{i}", "set": {"scan.file": str(args.cloud), "scan.bounds": f"{x:.2f},{y:.2f},{x + args.side:.2f},{y + args.side:.2f}"}})
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
        found = sorted(processes_of(chance.choice(["attempt", "--no-cache"]), mark))
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
    if bad["state"] != "bad_input" or not bad["error"]:
        wrong.append("the bad capture is not recorded as bad input")
    if code != 2:
        wrong.append(f"exit code {code}")
    print(f"attempts: {sum(row['attempts'] for row in rows.values())} for {len(rows)} inputs")
    return wrong


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
    for line in wrong:
        print("WRONG:", line)
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
