#!/usr/bin/env python3
"""How long a running pipeline takes to stop.

cancel_times.py --bole PROGRAM --cloud FILE --work FOLDER [--runs N] [--pipeline FILE]

Runs the pipeline once in full to learn how long its stages take, then N times more, interrupted twice (which cancels)
at moments spread evenly over the whole of it. Prints a row per run: the stage that was at work, when it was cancelled,
and how long the program took to end from the second interrupt on. Leaves nothing behind.
"""

import argparse
import json
import pathlib
import shutil
import signal
import subprocess
import time


def start(o, out):
    shutil.rmtree(out, ignore_errors=True)
    out.mkdir(parents=True)
    command = [o.bole, "run", o.pipeline, "--out", out, "--set", f"scan.file={o.cloud}"]
    if not o.cache:
        command.append("--no-cache")
    log = open(out / "log.txt", "w", encoding="utf-8")
    return subprocess.Popen([str(c) for c in command], stdout=log, stderr=subprocess.STDOUT)


def stage_at_work(out):
    lines = (out / "log.txt").read_text(encoding="utf-8", errors="replace").splitlines()
    told = [line for line in lines if " % " in line]
    return told[-1].strip() if told else "before the first stage"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--bole", required=True)
    parser.add_argument("--cloud", required=True)
    parser.add_argument("--work", required=True, type=pathlib.Path)
    parser.add_argument("--pipeline", default="pipelines/stem_map_from_cloud.json")
    parser.add_argument("--runs", type=int, default=10)
    parser.add_argument("--seconds", type=float, help="of a full run, when it is known already")
    parser.add_argument("--cache", action="store_true", help="keep results in a cache, as the program does by itself")
    o = parser.parse_args()
    out = o.work / "cancel_times"

    seconds = o.seconds
    if seconds is None:
        started = time.monotonic()
        start(o, out).wait()
        seconds = time.monotonic() - started
        for stage in json.loads((out / "summary.json").read_text(encoding="utf-8"))["stages"]:
            print(f"{stage['id']}: {stage.get('seconds', 0):.1f} s")
    print(f"a run takes {seconds:.1f} s\n\n| cancelled at, s | where | ended after, s |\n|---|---|---|", flush=True)
    worst = 0
    for k in range(o.runs):
        moment = seconds * (k + 0.5) / o.runs
        program = start(o, out)
        try:
            program.wait(timeout=moment)
            print(f"| {moment:.1f} | it was done | |", flush=True)
            continue
        except subprocess.TimeoutExpired:
            pass
        program.send_signal(signal.SIGINT)
        time.sleep(0.3)
        program.send_signal(signal.SIGINT)
        asked = time.monotonic()
        where = stage_at_work(out)
        code = program.wait()
        took = time.monotonic() - asked
        worst = max(worst, took)
        print(f"| {moment:.1f} | {where} | {took:.2f}{'' if code == 3 else f' (exit code {code})'} |", flush=True)
    print(f"\nlongest: {worst:.2f} s")
    shutil.rmtree(out, ignore_errors=True)


if __name__ == "__main__":
    main()
