#!/usr/bin/env python3
"""steering_track.json on the real receiver logs of ../shared/data/nmea: what can be measured is, and what is wrong is told.

Four of the five logs hold no drive: receivers on a table or a few seconds of motion. They must end with the reason and not with a number.
"""

import argparse
import json
import pathlib
import shutil
import subprocess
import sys

REPOSITORY = pathlib.Path(__file__).resolve().parents[2]
LOGS = REPOSITORY.parent / "shared/data/nmea"
SKIPPED = 77  # what ctest takes for a skipped test

# By log: options, what the run says where it ends without passes (else None), counts of stages, findings.
EXPECTED = {
    "AMOD_AGL3080_20121104_134730.txt": (
        ["errors.run_in=0", "errors.run_out=0", "errors.max_angle=20"], None,
        {"track": {"without_checksum": 2, "talker_GP": None}, "navigate": {"quality_1": 559, "quality_2": 35, "quality_6": 28, "back_in_time": 0}, "errors": {"passes": 1}},
        {"poor_fixes", "fixes_too_poor", "no_lever_arm"}),
    "TrimbleR2SampleData.txt": ([], "straight stretch", {"navigate": {"quality_2": 25, "quality_5": 9}}, set()),
    "gpsd_hemi.log": ([], "straight stretch", {"track": {"without_fix": 194}, "navigate": {"fixes": 21}}, {"fixes_too_poor"}),
    "gpsd_neo-m8n.log": ([], "straight stretch", {"track": {"without_checksum": 2}, "navigate": {"fixes": 23}}, {"fixes_too_poor"}),
    "gpsd_nmea-rtk.log": (["navigate.accept=4"], "straight stretch", {"track": {"talker_GN": None, "talker_GP": None}, "navigate": {"fixes": 18, "poor_fixes": 104}}, {"poor_fixes"}),
}


def run(bole, log, options, out):
    command = [bole, "run", REPOSITORY / "pipelines/steering_track.json", "--out", out, "--no-cache", "--set", f"track.file={LOGS / log}",
               "--set", "report.figures=false"] + [word for option in options for word in ("--set", option)]
    result = subprocess.run([str(c) for c in command], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
    print(f"+ {' '.join(map(str, command))}\n{result.stdout}", flush=True)
    return result


def check(log, bole, work):
    options, refusal, counts, findings = EXPECTED[log]
    out = work / log
    result = run(bole, log, options, out)
    complaints = []
    if refusal is None and result.returncode != 0:
        return [f"{log}: exit code {result.returncode}"]
    if refusal is not None and (result.returncode != 2 or refusal not in result.stdout):
        complaints.append(f"{log}: exit code {result.returncode}, and '{refusal}' is {'' if refusal in result.stdout else 'not '}told")
    summaries = list(out.rglob("summary.json"))
    if len(summaries) != 1:
        return complaints + [f"{log}: {len(summaries)} summaries"]
    stages = {s["id"]: s for s in json.loads(summaries[0].read_text())["stages"]}
    for stage, names in counts.items():
        for name, value in names.items():
            found = stages[stage]["counts"].get(name)
            if found is None or (value is not None and found != value):
                complaints.append(f"{log}: {stage}.{name} is {found}, not {value}")
    told = {f["code"] for s in stages.values() for f in s.get("findings", [])}
    if not findings <= told:
        complaints.append(f"{log}: the findings {sorted(findings - told)} are missing")
    return complaints


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--bole", required=True)
    parser.add_argument("--work", required=True, type=pathlib.Path)
    args = parser.parse_args()
    if not LOGS.exists():
        print(f"SKIPPED: for want of ../shared/data: {LOGS}")
        return SKIPPED
    shutil.rmtree(args.work, ignore_errors=True)
    args.work.mkdir(parents=True)
    complaints = [c for log in EXPECTED for c in check(log, args.bole, args.work)]
    print("\n".join(f"FAIL {c}" for c in complaints))
    if not complaints:
        shutil.rmtree(args.work, ignore_errors=True)
    return 1 if complaints else 0


if __name__ == "__main__":
    sys.exit(main())
