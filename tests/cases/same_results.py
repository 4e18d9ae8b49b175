#!/usr/bin/env python3
"""Runs thirteen pipelines with one build of bole and keeps their tables; compares two such runs digit for digit.

  same_results.py run --bole build/headless/bin/bole --out BEFORE [--only NAME ...]
  same_results.py compare BEFORE AFTER [--renamed OLD=NEW ...] [--reworded COLUMN ...] [--allow-added]

`run` may be called again: what is done with the same program is not run again. A pipeline whose data is absent is reported and counted.
`compare` ends with exit code 1 where anything differs. --renamed (in both) is for what has another name in AFTER: an option, a file, a column,
or a part of the path of a number in summary.json (`stages.report.metrics=stages.plot.metrics`); --renamed @FILE reads one per line.
`--renamed OLD=` is for what AFTER has no more: an option is not set, a file or column is not looked for.
--reworded is for columns of text: their sentences may change, one for one, but not the numbers in them.
Not compared: text of summary.json, time, memory, paths and versions, and files that hold no table (they are listed).
"""

import argparse
import array
import collections
import hashlib
import json
import math
import pathlib
import re
import shutil
import subprocess
import sys
import time

import result_tables

REPOSITORY = pathlib.Path(__file__).resolve().parents[2]
TIMEOUT_S = 900

# What is simulated: words after `bole`.
RECORDINGS = {
    "plot": ["simulate", "--plot", "sample", "--seed", "1"],
    "second_plot": ["simulate", "--plot", "demo", "--seed", "2"],
    "vineyard": ["simulate", "--plot", "vineyard_short", "--seed", "1", "--sensor", "vlp16", "--carrier", "robot", "--speed", "1.5"],
    "field": ["simulate-field", "--field", "tubes1", "--seed", "1"],
}

# Options of every pipeline whose report takes them. Figures have tests of their own.
EVERYWHERE = {"report.figures": "false"}
WALK = {"scan.file": "{recording}/walk.pcap", "reference_trees.file": "{recording}/trees.csv",
        "reference_path.file": "{recording}/trajectory.tum"}

# name: (document, recording, options)
PIPELINES = {
    "plot_loam": ("forest_plot", "plot", {**WALK, "slam.preset": "loam"}),
    "plot_forest": ("forest_plot", "plot", {**WALK, "slam.preset": "forest"}),
    "plot_lego_loam": ("forest_plot", "plot", {**WALK, "slam.preset": "lego_loam"}),
    "plot_best": ("forest_plot", "second_plot", {**WALK, "slam.preset": "best"}),
    "plot_true_poses": ("forest_plot", "second_plot", {**WALK, "slam.trajectory": "{recording}/trajectory.tum"}),
    "vineyard_orchard": ("forest_plot", "vineyard", {**WALK, "slam.preset": "orchard"}),
    "cloud_pine_plot": ("stem_map_from_cloud", None, {"scan.file": "{data}/tls_pine_plot/pine_plot.laz"}),
    "cloud_large_stems": ("stem_map_from_cloud", None, {"scan.file": "{data}/tls_spanner/TLS_Clip.laz"}),
    "rows_of_sparse_boles": ("rows_from_cloud", None, {"scan.file": "{data}/tls_simulated_boles/model_boles.laz"}),
    "rows_of_one_frame": ("plant_rows_imu", "field", {"scan.file": "{recording}/frame_000.ply", "imu.file": "{recording}/attitude.csv"}),
    "rows_of_hedges": ("hedge_rows", None, {
        "scan.file": "{data}/orchard_apple_mtls/frame_0000.csv", "scan.up": "y", "region.min_x": "-9", "region.max_x": "9",
        "region.min_y": "-3", "region.max_y": "3", "region.min_z": "-0.8", "region.max_z": "2", "voxel.size": "0.05",
        "hedges.step": "0.2", "hedges.direction": "90"}),
    "steering_test": ("steering_test", None, {"drive.repeats": "3"}),
    "steering_track": ("steering_track", None, {"track.file": "{data}/orchard_apple_mtls/gnss_track_first_pass.txt", "errors.run_in": "5"}),
}


# ---- run ----

def renamed_word(word, renames):
    return renames.get(word, word)


def state_of(folder):
    try:
        return json.loads((folder / "state.json").read_text())
    except (OSError, ValueError):
        return {"state": "not run"}


def keep_state(folder, **state):
    folder.mkdir(parents=True, exist_ok=True)
    (folder / "state.part").write_text(json.dumps(state, indent=1) + "\n")
    (folder / "state.part").replace(folder / "state.json")
    return state


def fingerprint_of_program(bole):
    """Of the program and of the libraries of its build."""
    ldd = subprocess.run(["ldd", str(bole)], capture_output=True, text=True, check=False)
    libraries = [pathlib.Path(p) for p in re.findall(r"=> (/\S+)", ldd.stdout)]
    own = sorted(p.resolve() for p in libraries if bole.parents[1] in p.resolve().parents)
    whole = hashlib.sha256()
    for path in [bole, *own]:
        whole.update(hashlib.sha256(path.read_bytes()).digest())
    return whole.hexdigest()


def executed(words, folder):
    """Runs a program with its output in the folder's log; its exit code, or 124 when it took too long."""
    words = [str(w) for w in words]
    with open(folder / "log.txt", "w", encoding="utf-8") as log:
        log.write("+ " + " ".join(words) + "\n")
        log.flush()
        try:
            return subprocess.run(words, stdout=log, stderr=subprocess.STDOUT, timeout=TIMEOUT_S, check=False).returncode
        except subprocess.TimeoutExpired:
            return 124


def performed(name, folder, program, words, data):
    """Runs the words in a fresh folder unless that is done or a file of `data` is absent; the state that is kept with it."""
    before = state_of(folder)
    missing = [str(path) for path in data if not path.exists()]
    if before["state"] == "done" and before["program"] == program and before["words"] == [str(w) for w in words]:
        print(f"{name:<24} was done before", flush=True)
        return before
    shutil.rmtree(folder, ignore_errors=True)
    if missing:
        print(f"{name:<24} SKIPPED: {', '.join(missing)} absent", flush=True)
        return keep_state(folder, state="absent", missing=missing)
    folder.mkdir(parents=True)
    begun = time.monotonic()
    code = executed(words, folder)
    seconds = round(time.monotonic() - begun, 1)
    if code != 0:
        print(f"{name:<24} FAILED with exit code {code} after {seconds} s: see {folder / 'log.txt'}", flush=True)
        return keep_state(folder, state="failed", exit_code=code)
    print(f"{name:<24} {seconds:.1f} s", flush=True)
    return keep_state(folder, state="done", program=program, words=[str(w) for w in words], seconds=seconds)


def simulated(arguments, name, program):
    """The folder of a recording, which is made where it is not there; None when that failed."""
    if arguments.recordings:
        return arguments.recordings / name
    folder = arguments.out / "recordings" / name
    words = [f"--{renamed_word(w[2:], arguments.renamed)}" if w.startswith("--") else w for w in RECORDINGS[name]]
    state = performed(f"recording {name}", folder, program, [arguments.bole, *words, "--out", folder], [])
    return folder if state["state"] == "done" else None


def run_pipeline(arguments, name, program):
    document, recording, options = PIPELINES[name]
    folder = arguments.out / name
    places = {"data": str(arguments.data)}
    if recording:
        scan = simulated(arguments, recording, program)
        if scan is None:
            return keep_state(folder, state="failed", exit_code=None)
        places["recording"] = str(scan)
    words = [arguments.bole, "run", arguments.pipelines / f"{document}.json", "--out", folder, "--no-cache"]
    data = []
    for option, value in {**options, **EVERYWHERE}.items():
        given = value.format(**places)
        if "{data}" in value:
            data.append(pathlib.Path(given))
        if name_now := renamed_word(option, arguments.renamed):
            words += ["--set", f"{name_now}={given}"]
    return performed(name, folder, program, words, data)


def run(arguments):
    program = fingerprint_of_program(arguments.bole)
    names = arguments.only or list(PIPELINES)
    states = [run_pipeline(arguments, name, program)["state"] for name in names]
    count = collections.Counter(states)
    print(f"{len(names)} pipelines: {count['done']} done, {count['failed']} failed, {count['absent']} skipped because their data is absent")
    return 1 if count["failed"] else 0


# ---- compare ----

def renamed_path(name, renames):
    """The name with every renamed part, parts being what stands between dots."""
    for old, new in renames.items():
        if not new:
            continue
        name = re.sub(rf"(?<![^.]){re.escape(old)}(?![^.])", lambda _: new, name)
    return name


NUMBER = re.compile(r"-?\d+(?:\.\d+)?(?:[eE][-+]?\d+)?")


def same_but_reworded(before, after):
    """Whether both texts have the same numbers row for row, and each sentence became one other."""
    meaning = {}
    back = {}
    for a, b in zip(before, after):
        if NUMBER.findall(a) != NUMBER.findall(b):
            return False
        old, new = NUMBER.sub("#", a), NUMBER.sub("#", b)
        if meaning.setdefault(old, new) != new or back.setdefault(new, old) != old:
            return False
    return True


def difference(before, after):
    """In words how two columns of one length differ; None where they do not."""
    if isinstance(before, array.array) and isinstance(after, array.array):
        if before.typecode != after.typecode:
            return f"stored as type {before.typecode} before, {after.typecode} after"
        if before.tobytes() == after.tobytes():
            return None
    elif before == after:
        return None
    rows = 0
    words = 0
    greatest = 0.0
    first = None
    for i, (a, b) in enumerate(zip(before, after)):
        x, y = result_tables.number(a), result_tables.number(b)
        if a == b or (not isinstance(a, str) and result_tables.same_number(x, y)):
            continue
        rows += 1
        first = first or f"row {i + 1}: {a} -> {b}"
        if x is None or y is None or not (math.isfinite(x) and math.isfinite(y)):
            words += 1
        else:
            greatest = max(greatest, abs(x - y))
    if rows == 0:
        return None
    text = f"{rows} of {len(before)} rows differ"
    if words < rows:
        text += f", by {greatest:.6g} at most"
    if words:
        text += f", {words} of them in words or empty cells"
    return f"{text}; {first}"


Findings = collections.namedtuple("Findings", "changed removed added tables values")


def compare_layers(file, before, after, renames, reworded, findings):
    for layer in list(dict.fromkeys([*before, *after])):
        where = f"{file}, {layer}" if layer else file
        if layer not in before or layer not in after:
            (findings.added if layer not in before else findings.removed).append(where)
            continue
        old = {renamed_path(name, renames): values for name, values in before[layer].items() if renames.get(name) != ""}
        new = after[layer]
        findings.removed.extend(f"{where}: {name}" for name in old if name not in new)
        findings.added.extend(f"{where}: {name}" for name in new if name not in old)
        for name in [n for n in old if n in new]:
            findings.values.append(len(old[name]))
            if len(old[name]) != len(new[name]):
                findings.changed.append(f"{where}: {name}: {len(old[name])} rows -> {len(new[name])}")
            elif name in reworded and same_but_reworded(old[name], new[name]):
                continue
            elif text := difference(result_tables.values_of(old[name]), result_tables.values_of(new[name])):
                findings.changed.append(f"{where}: {name}: {text}")


def tables_in(folder):
    files = {str(p.relative_to(folder)): p for p in sorted(folder.rglob("*")) if p.is_file() and p.name not in ("state.json", "log.txt")}
    tables = {name: path for name, path in files.items() if result_tables.reader_of(path)}
    return tables, sorted(set(files) - set(tables))


RAW = {".pcap", ".bin", ".time", ".ring"}  # of recordings, compared as bytes


def recording_tables(folder):
    """Truth tables of a recording, and one fingerprint of its raw data. recipe.json repeats the options."""
    raw = hashlib.sha256()
    for path in sorted(p for p in folder.rglob("*") if p.suffix in RAW):
        raw.update(path.relative_to(folder).as_posix().encode())
        raw.update(path.read_bytes())
    tables, _ = tables_in(folder)
    read = {n: result_tables.reader_of(p)(p) for n, p in tables.items() if n not in ("recipe.json",) and "frames" not in pathlib.Path(n).parts}
    return {**read, "raw data": {"": {"sha256": [raw.hexdigest()]}}}


def folder_tables(folder, others):
    tables, others_here = tables_in(folder)
    others.update(others_here)
    return {name: result_tables.reader_of(path)(path) for name, path in tables.items()}


def compare_folders(before, after, read, renames, reworded):
    findings = Findings([], [], [], [], [])
    old = {renames.get(file, file): layers for file, layers in read(before).items() if renames.get(file) != ""}
    new = read(after)
    findings.removed.extend(file for file in old if file not in new)
    findings.added.extend(file for file in new if file not in old)
    for file in [f for f in old if f in new]:
        findings.tables.append(file)
        compare_layers(file, old[file], new[file], renames, reworded, findings)
    return findings


def grouped(lines):
    """The names in a table or a metric of the summary on one line, with their number: a new table has hundreds."""
    groups = collections.Counter(".".join(line.split(".")[:5]) if line.startswith("summary.json: ") else line for line in lines)
    return [f"{name} ({n} numbers)" if n > 1 else name for name, n in groups.items()]


def print_findings(name, findings, allow_added):
    good = not findings.changed and not findings.removed and (allow_added or not findings.added)
    verdict = "equal" if good else "DIFFERENT"
    print(f"{name:<24} {verdict} ({len(findings.tables)} files, {sum(findings.values)} values)")
    for title, lines in (("changed", findings.changed), ("only before", grouped(findings.removed)),
                         ("only after", grouped(findings.added))):
        for line in lines:
            print(f"    {title}: {line}")
    return good


def compare_one(arguments, name, folders, read):
    """'equal', 'different', 'absent' or 'missing', printed."""
    states = [state_of(f)["state"] for f in folders]
    if states == ["done", "done"]:
        findings = compare_folders(*folders, read, arguments.renamed, arguments.reworded)
        return "equal" if print_findings(name, findings, arguments.allow_added) else "different"
    if set(states) <= {"absent"}:
        print(f"{name:<24} NOT COMPARED: its data was absent in both runs ({', '.join(state_of(folders[0])['missing'])})")
        return "absent"
    print(f"{name:<24} NOT COMPARED: {states[0]} before, {states[1]} after")
    return "missing"


def compare(arguments):
    others = set()
    outcomes = []
    names = arguments.only or list(PIPELINES)
    recordings = dict.fromkeys(PIPELINES[name][1] for name in names if PIPELINES[name][1])
    for recording in recordings:
        folders = [f / "recordings" / recording for f in (arguments.before, arguments.after)]
        if folders[1].exists():  # not where `run --recordings` took those of another run
            outcomes.append(compare_one(arguments, f"recording {recording}", folders, recording_tables))
    for name in names:
        folders = [f / name for f in (arguments.before, arguments.after)]
        outcomes.append(compare_one(arguments, name, folders, lambda folder: folder_tables(folder, others)))
    count = collections.Counter(outcomes)
    if others:
        print(f"files that were not compared: {', '.join(sorted(others))}")
    print(f"{len(names)} pipelines and {len(outcomes) - len(names)} recordings: {count['equal']} equal, {count['different']} different, "
          f"{count['missing']} without a result, {count['absent']} not compared because their data is absent")
    return 1 if count["different"] or count["missing"] else 0


def assignments(words):
    out = {}
    for word in words:
        lines = pathlib.Path(word[1:]).read_text(encoding="utf-8").splitlines() if word.startswith("@") else [word]
        for line in lines:
            if line.strip() and not line.startswith("#"):
                old, separator, new = line.strip().partition("=")
                if not separator or not old:
                    sys.exit(f"--renamed takes OLD=NEW or OLD=; '{line}' is neither")
                out[old] = new
    return out


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    commands = parser.add_subparsers(dest="command", required=True)
    runs = commands.add_parser("run", help="run the pipelines and keep their tables")
    runs.add_argument("--bole", type=pathlib.Path, required=True, help="the program")
    runs.add_argument("--out", type=pathlib.Path, required=True, help="folder for the results")
    runs.add_argument("--data", type=pathlib.Path, default=REPOSITORY.parent / "shared/data", help="folder of the real files")
    runs.add_argument("--pipelines", type=pathlib.Path, default=REPOSITORY / "pipelines", help="folder of the documents")
    runs.add_argument("--recordings", type=pathlib.Path, help="simulate nothing: take the folder `recordings` of another run")
    compares = commands.add_parser("compare", help="compare two runs")
    compares.add_argument("before", type=pathlib.Path)
    compares.add_argument("after", type=pathlib.Path)
    compares.add_argument("--reworded", action="append", default=[], metavar="COLUMN", help="a column whose sentences may change")
    compares.add_argument("--allow-added", action="store_true", help="what only AFTER has is listed, but is no difference")
    for command in (runs, compares):
        command.add_argument("--renamed", action="append", default=[], metavar="OLD=[NEW]", help="what has another name in AFTER, or none")
        command.add_argument("--only", nargs="+", choices=PIPELINES, metavar="NAME", help=f"of {', '.join(PIPELINES)}")
    arguments = parser.parse_args()
    arguments.renamed = assignments(arguments.renamed)
    if arguments.command == "compare":
        return compare(arguments)
    arguments.bole = arguments.bole.resolve()
    arguments.out = arguments.out.resolve()
    return run(arguments)


if __name__ == "__main__":
    sys.exit(main())
