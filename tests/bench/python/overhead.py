#!/usr/bin/env python3
"""What bole.run costs beside the program: the same small survey by each, in turn, and the medians.

    PYTHONPATH=build/headless/lib/python tests/bench/python/overhead.py --bole build/headless/bin/bole [--repeats 9]
"""

import argparse
import pathlib
import statistics
import subprocess
import sys
import tempfile
import time

RUN = "import bole; bole.run('stem_map_from_cloud', scan={scan!r}, out={out!r}, cache=False, set={{'report.figures': False}})"


def seconds(work):
    begin = time.perf_counter()
    work()
    return time.perf_counter() - begin


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--bole", required=True)
    parser.add_argument("--repeats", type=int, default=9)
    args = parser.parse_args()
    import bole
    import numpy

    sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "python"))
    import os

    os.environ.setdefault("BOLE_PROGRAM", args.bole)
    from plot import plot_points

    with tempfile.TemporaryDirectory() as folder:
        scan, out = str(pathlib.Path(folder) / "plot.xyz"), str(pathlib.Path(folder) / "out")
        points = plot_points()
        numpy.savetxt(scan, points, "%.4f")
        program = [args.bole, "run", "stem_map_from_cloud", f"--set=scan.file={scan}", "--set=report.figures=false", "--no-cache", "--out", out]
        ways = {
            "bole run": lambda: subprocess.run(program, check=True, capture_output=True),
            "python3 -c 'bole.run(...)'": lambda: subprocess.run([sys.executable, "-c", RUN.format(scan=scan, out=out)], check=True),
            "bole.run in a process that is there": lambda: bole.run("stem_map_from_cloud", scan=scan, out=out, cache=False, set={"report.figures": False}),
            "the same of an array": lambda: bole.run("stem_map_from_cloud", scan=points, out=out, cache=False, set={"report.figures": False}),
            "the same, nothing written": lambda: bole.run("stem_map_from_cloud", scan=points),
            "import bole": lambda: subprocess.run([sys.executable, "-c", "import bole"], check=True),
            "bole --version": lambda: subprocess.run([args.bole, "--version"], check=True, capture_output=True),
        }
        times = {name: [] for name in ways}
        for _ in range(args.repeats):
            for name, work in ways.items():
                times[name].append(seconds(work))
        base = statistics.median(times["bole run"])
        print(f"{len(points)} points, {args.repeats} repeats")
        for name, taken in times.items():
            middle = statistics.median(taken)
            print(f"{name:<38} {middle:7.3f} s  ({min(taken):.3f} to {max(taken):.3f})  {middle - base:+7.3f} s")


if __name__ == "__main__":
    main()
