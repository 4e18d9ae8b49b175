"""The program bole as a child process: where it is, what it can do, and a run with progress and cancelling. Knows no QGIS."""

import collections
import json
import os
import pathlib
import queue
import re
import shutil
import signal
import subprocess
import threading

# What `bole run` prints into a pipe: "slam:  30 % registering, 12 s left".
PROGRESS = re.compile(r"^(\w+): +(\d+) %")
LINES_KEPT = 30


class ProgramError(Exception):
    """The program is missing, or it ended with an error."""


def find_program():
    """The program: BOLE_PROGRAM if set, else the one in the PATH."""
    program = os.environ.get("BOLE_PROGRAM") or shutil.which("bole")
    if not program:
        raise ProgramError("the program bole was not found in the PATH: install the package bole, or set BOLE_PROGRAM to its place")
    return pathlib.Path(program).resolve()


def find_documents(program):
    """The pipeline documents that come with it: path by name."""
    installed = program.parent.parent / "share" / "bole" / "pipelines"
    of_sources = program.parents[3] / "pipelines" if len(program.parents) > 3 else installed  # build/headless/bin/bole
    folder = installed if installed.is_dir() else of_sources
    return {p.stem: p for p in sorted(folder.glob("*.json"))}


def read_stages(program):
    """The declarations of all stages, by type: title, help, ports, options with default, unit, range and help."""
    told = subprocess.run([program, "stages", "--json"], capture_output=True, text=True, timeout=60)
    if told.returncode != 0:
        raise ProgramError(told.stderr.strip() or f"{program} stages --json ended with {told.returncode}")
    return {stage["type"]: stage for stage in json.loads(told.stdout)}


def interrupt(process, patience=5.0):
    """Cancels: the first interrupt asks bole to finish with what it has, the second one to cancel; then it is ended."""
    for pause in (0.5, patience):
        process.send_signal(signal.SIGINT)
        try:
            process.wait(pause)
            return
        except subprocess.TimeoutExpired:
            pass
    process.kill()
    process.wait()


def run(arguments, stage_ids, on_progress, on_line, is_cancelled):
    """Runs a command. on_progress gets percent of the whole pipeline, on_line all other lines.

    Returns False when it was cancelled; raises ProgramError with the last lines when it failed.
    """
    process = subprocess.Popen([str(a) for a in arguments], stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
                               errors="replace")
    lines = queue.Queue()

    def read():
        for line in process.stdout:
            lines.put(line.rstrip())
        lines.put(None)

    threading.Thread(target=read, daemon=True).start()
    last = collections.deque(maxlen=LINES_KEPT)
    with process:
        while True:
            if is_cancelled():
                interrupt(process)
                return False
            try:
                line = lines.get(timeout=0.1)
            except queue.Empty:
                continue
            if line is None:
                break
            told = PROGRESS.match(line)
            if told and told[1] in stage_ids:
                on_progress(100 * (stage_ids.index(told[1]) + int(told[2]) / 100) / len(stage_ids))
            elif line:
                last.append(line)
                on_line(line)
    code = process.wait()
    if code != 0:
        raise ProgramError(f"bole ended with exit code {code}\n" + "\n".join(last))
    return True


def findings(folder):
    """The verdict of a survey ("sign", "look", "refused", or None) and its findings, from summary.json."""
    path = pathlib.Path(folder) / "summary.json"
    if not path.is_file():
        return None, []
    summary = json.loads(path.read_text(encoding="utf-8"))
    return summary.get("verdict"), summary.get("findings", [])
