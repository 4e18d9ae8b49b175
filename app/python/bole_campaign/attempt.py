"""One attempt at one input: `bole run` in a folder of its own, watched, recorded, renamed when whole.

The same for a worker of Dask, a worker process without it, and a task of a job array. What happens to the results is
decided here alone: whoever started the attempt only reads the record.
"""

import csv
import ctypes
import datetime
import errno
import json
import os
import pathlib
import re
import resource
import shutil
import signal
import socket
import subprocess
import sys
import time
import uuid

from . import folders, keys
from .errors import BAD_INPUT, CANCELLED, DONE, FINISHED_EARLY

GIB = 1 << 30
LOOK_EVERY_S = 0.1
PATIENCE_S = 60.0  # for the child of a worker that was killed a moment ago
PATIENCE_AFTER_CANCEL_S = 10.0
DISK_ERRORS = (errno.ENOSPC, errno.EDQUOT, errno.EIO, errno.EROFS)


def now():
    return datetime.datetime.now(datetime.timezone.utc).isoformat(timespec="milliseconds")


def end_with_parent(parent):
    """The kernel kills this process when its parent ends, whatever ends that."""
    ctypes.CDLL(None, use_errno=True).prctl(1, signal.SIGKILL, 0, 0, 0)  # PR_SET_PDEATHSIG
    if os.getppid() != parent:
        sys.exit(CANCELLED)


def anonymous_bytes(pid):
    """What a process holds that is not the content of files; 0 once it has ended."""
    try:
        with open(f"/proc/{pid}/status", encoding="ascii", errors="replace") as file:
            return sum(1024 * int(line.split()[1]) for line in file if line.startswith(("RssAnon:", "RssShmem:")))
    except OSError:
        return 0


def command_of(spec, attempt):
    command = [spec["program"], "run", spec["document"], "--out", str(attempt), "--end-with", str(os.getpid())]
    command += ["--threads", str(spec["threads"])] if spec.get("threads") else []
    command += ["--cache", str(attempt.parent / "cache")] if spec.get("cache") else ["--no-cache"]
    command += ["--accept-partial"] if spec.get("accept_partial") else []
    for name, value in spec["set"].items():
        command += ["--set", f"{name}={value}"]
    return command


def watch(child, spec):
    """Waits for the end. Why it was ended early, or nothing; the resources it took, the exit code."""
    begin, why, asked_at = time.monotonic(), "", None
    limit = int(spec["memory_gib"] * GIB)
    while True:
        pid, status, usage = os.wait4(child.pid, os.WNOHANG)
        if pid:
            child.returncode = os.waitstatus_to_exitcode(status)
            return why, usage, child.returncode
        taken, spent = anonymous_bytes(child.pid), time.monotonic() - begin
        if why == "" and taken > limit:
            why = "memory"
            child.kill()
        elif why == "" and spec.get("time_limit_s") and spent > spec["time_limit_s"]:
            why = "time"
            child.kill()
        elif asked_at is None and spec.get("stop_file") and os.path.exists(spec["stop_file"]):
            asked_at = time.monotonic()
            child.terminate()
        elif asked_at is not None and time.monotonic() - asked_at > PATIENCE_AFTER_CANCEL_S:
            child.kill()
        time.sleep(LOOK_EVERY_S if spent > 2 else 0.01)


def said_by(log):
    """What the program said went wrong."""
    text = log.read_text(encoding="utf-8", errors="replace").replace("\r", "\n") if log.exists() else ""
    lines = [re.sub(r"\x1b\[K", "", line) for line in text.splitlines()]
    told = [line[6:] for line in lines if line.startswith("bole: ") and not line.startswith("bole: the run failed")]
    return " ".join(told) if told else next((line for line in reversed(lines) if line.strip()), "")


def judged(spec, attempt, why, code, findings):
    """State and error of an attempt that was not cancelled."""
    said = said_by(attempt / "log.txt")
    if code == DONE:
        return "done", ""
    if why == "memory" or "out of memory" in said or "bad_alloc" in said:
        return "crashed", f"it needs more than the {spec['memory_gib']:.1f} GiB of memory declared for it (memory_gib)"
    if why == "time":
        return "crashed", f"it took longer than time_limit_s = {spec['time_limit_s']:g}"
    if code < 0:
        return "crashed", f"killed by {signal.Signals(-code).name}"
    if code == BAD_INPUT:
        return "bad_input", said
    if keys.is_partial(findings):  # it holds less than it says: nothing but another file will change that
        return "bad_input", said.replace("(--accept-partial)", '("accept_partial": true)')
    # What has nothing to do with the input may go well another time.
    return "crashed" if any(os.strerror(number) in said for number in DISK_ERRORS) else "failed", said or f"exit code {code}"


def count_rows(table):
    """Rows of a CSV table below its heading; None where there is none."""
    try:
        with open(table, encoding="utf-8-sig", newline="") as file:
            return sum(1 for _ in csv.reader(file)) - 1
    except OSError:
        return None


def facts_of(attempt):
    """What the program wrote about its run."""
    for place in (attempt / "summary.json", attempt / "failed_run" / "summary.json"):
        summary = folders.read_json(place)
        if summary is not None:
            stages = summary.get("stages", [])
            return {
                "verdict": summary.get("verdict", ""),
                "findings": summary.get("findings", []),
                "warnings": sum(len(stage.get("warnings", [])) for stage in stages),
                "stems": count_rows(attempt / "stems.csv"),
                "report": next((file for file in summary.get("files", []) if file.endswith("report.html")), ""),
            }
    return {"verdict": "", "findings": [], "warnings": 0, "stems": None, "report": ""}


def run_in(spec, folder, handle):
    """With the lock held: runs the program and gives the record of what became of it, or None when it was cancelled."""
    attempt = folder / f"attempt-{uuid.uuid4().hex[:12]}"
    attempt.mkdir()
    known = {}
    for place in ("done", "failed"):
        known.update((folders.record_in(folder / place) or {}).get("files", {}))
    record = {"input_id": spec["id"], "attempt": attempt.name[8:], "host": socket.gethostname(), "started": now()}
    begin = time.monotonic()
    parts, seen = keys.parts_of(spec, known)
    key = keys.key_of(parts)
    folders.note_attempt(folder, event="begin", attempt=record["attempt"], key=key, time=record["started"], host=record["host"], pid=os.getpid())
    with open(attempt / "log.txt", "wb") as log:
        # Of its own session: Ctrl-C on a terminal goes to all processes of a group, and the client alone decides what it means.
        child = subprocess.Popen(command_of(spec, attempt), stdin=subprocess.DEVNULL, stdout=log, stderr=log, pass_fds=[handle], start_new_session=True)
        # A program that asks for far more than declared is told so by the system before the machine suffers.
        hard = int(1.5 * spec["memory_gib"] * GIB) + GIB
        try:
            resource.prlimit(child.pid, resource.RLIMIT_DATA, (hard, hard))
        except (ProcessLookupError, PermissionError, ValueError):
            pass  # it has ended, or a lower limit holds already
        why, usage, code = watch(child, spec)
    seconds = time.monotonic() - begin
    if code in (CANCELLED, FINISHED_EARLY) or (spec.get("stop_file") and os.path.exists(spec["stop_file"]) and code != DONE):
        folders.note_attempt(folder, event="end", attempt=record["attempt"], time=now(), state="cancelled")
        shutil.rmtree(attempt, ignore_errors=True)
        return None
    facts = facts_of(attempt)
    state, error = judged(spec, attempt, why, code, facts["findings"])
    record.update(state=state, error=error, why=why, exit_code=code, finished=now(), seconds=round(seconds, 3),
                  cpu_seconds=round(usage.ru_utime + usage.ru_stime, 3), peak_mib=round(usage.ru_maxrss / 1024, 1),
                  memory_gib=spec["memory_gib"], threads=spec.get("threads") or 0, key=key, key_parts=parts, files=seen,
                  accept_partial=spec.get("accept_partial", False), **facts)
    folders.write_json(attempt / "record.json", record)
    folders.put_in_place(attempt, folder / ("done" if state == "done" else "failed"))
    if state == "done":
        shutil.rmtree(folder / "failed", ignore_errors=True)
    folders.note_attempt(folder, event="end", attempt=record["attempt"], time=record["finished"], state=state)
    return record


def current(folder, place, spec):
    """The record in `done` or `failed` when its key is the one of this spec, else None."""
    record = folders.record_in(folder / place)
    return None if record is None or keys.why_stale(record, spec) else record


def run_attempt(spec):
    """The record of the input: of this attempt, or of one that came before it and is current. {"state": "busy"} where
    another works on it, {"state": "cancelled"}."""
    folder = pathlib.Path(spec["folder"])
    if spec.get("finish_file") and os.path.exists(spec["finish_file"]):
        return {"input_id": spec["id"], "state": "cancelled"}
    with folders.lock(str(folder / "lock"), PATIENCE_S) as handle:
        if handle is None:
            return {"input_id": spec["id"], "state": "busy"}
        folders.adopt(folder)
        for place, states in (("done", {"done"}), ("failed", {"bad_input"} if spec.get("retry") else {"bad_input", "failed"})):
            record = current(folder, place, spec)
            if record is not None and record["state"] in states:
                return {**record, "before": True}
        return run_in(spec, folder, handle) or {"input_id": spec["id"], "state": "cancelled"}


def record_loss(spec, error):
    """Of an input whose workers were killed each time: nobody but the client is left to tell."""
    folder = pathlib.Path(spec["folder"])
    with folders.lock(str(folder / "lock"), PATIENCE_S) as handle:
        if handle is None:
            return {"input_id": spec["id"], "state": "busy"}
        folders.adopt(folder)
        attempt = folder / f"attempt-{uuid.uuid4().hex[:12]}"
        attempt.mkdir()
        parts, seen = keys.parts_of(spec, {})
        record = {"input_id": spec["id"], "attempt": attempt.name[8:], "state": "crashed", "error": error, "finished": now(), "seconds": 0.0,
                  "peak_mib": 0.0, "memory_gib": spec["memory_gib"], "key": keys.key_of(parts), "key_parts": parts, "files": seen, **facts_of(attempt)}
        folders.write_json(attempt / "record.json", record)
        folders.put_in_place(attempt, folder / "failed")
        return record


def main():
    """As a process of its own: the spec comes from the standard input, the record goes to the standard output."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)  # Ctrl-C is for the client, which tells by the stop file
    spec = json.load(sys.stdin)
    if spec.get("parent"):
        end_with_parent(spec["parent"])
    print(json.dumps(run_attempt(spec)), flush=True)
