#!/usr/bin/env python3
"""Runs one case: simulates a scan when asked, runs a pipeline on it, and compares what it writes with what is expected.

--expect  STAGE.NAME OP NUMBER, where NAME is a metric or a count of the stage in summary.json: 'evaluate.dbh_rmse<=1.0',
          or STAGE.FACT=='TEXT': "stems.beam_divergence=='0.5 mrad (Dome-64)'"
--table   a table of the run and an expected one, column by column (compare_tables.py):
          'stems.csv = {scan}/trees.csv, nearest x_m y_m within 0.5, dbh_cm 1.5'
"""

import argparse
import json
import pathlib
import re
import shutil
import subprocess
import sys

import report_numbers
from compare_tables import SpecError, compare

SKIPPED = 77  # what ctest takes for a skipped test
SOURCE = pathlib.Path(__file__).resolve().parents[2]
OPERATORS = {"<=": lambda a, b: a <= b, ">=": lambda a, b: a >= b, "==": lambda a, b: a == b}


def run(command):
    print("+", " ".join(map(str, command)), flush=True)
    result = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
    print(result.stdout, flush=True)
    if result.returncode != 0:
        sys.exit(f"exit code {result.returncode}")
    return result.stdout


def value_of(summary, path):
    stage_id, name = path.split(".", 1)
    stage = next((s for s in summary["stages"] if s["id"] == stage_id), None)
    if stage is None:
        sys.exit(f"no stage {stage_id} in the summary")
    if name in stage["metrics"]:
        return stage["metrics"][name]["value"]
    if name in stage["counts"]:
        return stage["counts"][name]
    if name in stage["facts"]:
        return stage["facts"][name]
    known = sorted(stage["metrics"]) + sorted(stage["counts"]) + sorted(stage["facts"])
    sys.exit(f"{stage_id} has no metric, count or fact '{name}'; it has {', '.join(known)}")


def check(summary, expectation):
    match = re.fullmatch(r"([\w.]+)(<=|>=|==)(-?[\d.]+|'[^']*')", expectation)
    if not match:
        sys.exit(f"cannot read the expectation '{expectation}'")
    path, operator, bound = match.groups()
    value = value_of(summary, path)
    if bound.startswith("'"):
        good = operator == "==" and value == bound[1:-1]
    else:
        good = isinstance(value, (int, float)) and OPERATORS[operator](value, float(bound))
    print(f"{'ok  ' if good else 'FAIL'} {path} = {value} (expected {operator} {bound})")
    return good


def check_table(line, out, scan):
    try:
        complaints, told = compare(line, out, scan=scan, source=SOURCE, real=SOURCE.parent / "shared/data")
    except SpecError as e:
        sys.exit(f"{e}")
    print("\n".join(told + [f"FAIL {c}" for c in complaints]))
    return not complaints


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--bole", required=True)
    parser.add_argument("--work", required=True, type=pathlib.Path)
    parser.add_argument("--simulate", nargs=argparse.REMAINDER, help="arguments of --simulator, to the end of the line; {scan} in --set is its folder")
    parser.add_argument("--simulator", default="simulate", help="the command of bole that simulates")
    parser.add_argument("--pipeline", required=True)
    parser.add_argument("--set", action="append", default=[])
    parser.add_argument("--expect", action="append", default=[])
    parser.add_argument("--report-numbers", action="store_true", help="every number of report.html must be in summary.json")
    parser.add_argument("--table", action="append", default=[], help="{scan} is the folder of --simulate, {source} that of the repository, {real} that of the real files")
    parser.add_argument("--keep", action="store_true", help="scan, results and stored stages (WORK/cache) stay for the tests that follow")
    parser.add_argument("--needs", type=pathlib.Path, help="a real file; the case is skipped where it is absent")
    args = parser.parse_args()

    if args.needs and not args.needs.exists():
        print(f"SKIPPED: for want of ../shared/data: {args.needs}")
        return SKIPPED
    shutil.rmtree(args.work, ignore_errors=True)
    scan = args.work / "scan"
    if args.simulate:
        run([args.bole, args.simulator, *args.simulate, "--out", scan])
    command = [args.bole, "run", args.pipeline, "--out", args.work / "out", *(["--cache", args.work / "cache"] if args.keep else ["--no-cache"])]
    for assignment in args.set:
        command += ["--set", assignment.replace("{scan}", str(scan))]
    run(command)
    summary = json.loads((args.work / "out" / "summary.json").read_text())
    good = [check(summary, e) for e in args.expect] + [check_table(t, args.work / "out", scan) for t in args.table]
    if args.report_numbers:
        good.append(report_numbers.passes(args.work / "out"))
    if all(good) and not args.keep:
        shutil.rmtree(args.work, ignore_errors=True)  # recordings are large; a failed case keeps its own
    return 0 if all(good) else 1


if __name__ == "__main__":
    sys.exit(main())
