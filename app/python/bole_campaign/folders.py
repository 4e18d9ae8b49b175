"""The folder of a campaign, which is its memory: one folder per input, written aside and renamed when whole.

    DIR/plan.json                     the inputs and options as they were planned last
    DIR/tasks/ID/done/                results of the run that went well, with record.json and log.txt
    DIR/tasks/ID/failed/              record.json and log.txt of the last attempt that did not
    DIR/tasks/ID/attempt-*/           an attempt at work, or what a killed one left
    DIR/tasks/ID/attempts.jsonl       every attempt: its begin and its end
    DIR/tasks/ID/lock, DIR/lock       held while an attempt, or a client, is at work
    DIR/runs.jsonl                    every run of the client that came to its end: what it took (costs.py)
    DIR/stems.csv, campaign.gpkg, campaign.html, point_edits.csv (of tiles, where there are any)
"""

import contextlib
import fcntl
import json
import os
import pathlib
import shutil
import time
import urllib.parse

from .errors import failure


def task_folder(out, input_id):
    """Any text may be an id; two ids never share a folder."""
    name = urllib.parse.quote(input_id, safe=" ()+,=@")
    return pathlib.Path(out) / "tasks" / (name.replace(".", "%2E", 1) if name.startswith(".") else name)


def write_json(path, value):
    """In one step: whoever reads finds the file before, or this one."""
    path = pathlib.Path(path)
    draft = path.with_name(f".{path.name}.{os.getpid()}")
    with open(draft, "w", encoding="utf-8") as file:
        json.dump(value, file, indent=1)
        file.flush()
        os.fsync(file.fileno())
    os.replace(draft, path)


def read_json(path):
    """None where there is no such file, or one that a crash of the machine cut off."""
    try:
        with open(path, encoding="utf-8") as file:
            return json.load(file)
    except (FileNotFoundError, NotADirectoryError, json.JSONDecodeError):
        return None


def record_in(folder):
    record = read_json(pathlib.Path(folder) / "record.json")
    return record if isinstance(record, dict) and "state" in record else None


def put_in_place(attempt, place):
    """The folder of an attempt becomes `done` or `failed`. After a crash in between adopt() goes on with it."""
    before = None
    if place.exists():
        before = place.with_name(f"replaced-{attempt.name}")
        os.rename(place, before)
    os.rename(attempt, place)
    if before is not None:
        shutil.rmtree(before, ignore_errors=True)


def adopt(folder):
    """With the lock of a task held: ends renames that were cut off, removes what killed attempts left."""
    folder = pathlib.Path(folder)
    for entry in sorted(folder.iterdir()) if folder.is_dir() else []:
        record = record_in(entry) if entry.name.startswith(("attempt-", "replaced-")) else None
        if entry.name.startswith("attempt-") and record is not None:
            place = folder / ("done" if record["state"] == "done" else "failed")
            standing = record_in(place)
            if standing is None or standing["finished"] < record["finished"]:
                put_in_place(entry, place)
    for entry in sorted(folder.iterdir()) if folder.is_dir() else []:
        if entry.name.startswith("replaced-") and not (folder / "done").exists() and (record := record_in(entry)):
            if record["state"] == "done":
                os.rename(entry, folder / "done")
                continue
        if entry.name.startswith(("attempt-", "replaced-", ".attempt-")):
            shutil.rmtree(entry, ignore_errors=True)


@contextlib.contextmanager
def lock(path, patience_s=0.0):
    """Holds a lock that the system releases when its holder ends in any way; gives None where another holds it."""
    os.makedirs(os.path.dirname(path), exist_ok=True)
    handle = os.open(path, os.O_RDWR | os.O_CREAT, 0o666)
    try:
        until = time.monotonic() + patience_s
        while True:
            try:
                fcntl.flock(handle, fcntl.LOCK_EX | fcntl.LOCK_NB)
                break
            except BlockingIOError:
                if time.monotonic() >= until:
                    yield None
                    return
                time.sleep(0.1)
            except OSError as error:
                raise failure(f"'{path}' cannot be locked: {error.strerror}", "a file system with locks (flock)") from None
        yield handle
    finally:
        os.close(handle)


def attempts_of(folder):
    """Every attempt as {begin, end or None}: those without an end were killed with whoever watched them."""
    attempts = {}
    with contextlib.suppress(FileNotFoundError), open(pathlib.Path(folder) / "attempts.jsonl", encoding="utf-8") as file:
        for line in file:
            with contextlib.suppress(json.JSONDecodeError, KeyError):
                entry = json.loads(line)
                if entry["event"] == "begin":
                    attempts[entry["attempt"]] = {"begin": entry, "end": None}
                elif entry["attempt"] in attempts:
                    attempts[entry["attempt"]]["end"] = entry
    return list(attempts.values())


def note_attempt(folder, **entry):
    with open(pathlib.Path(folder) / "attempts.jsonl", "a", encoding="utf-8") as file:
        file.write(json.dumps(entry) + "\n")


def write_text(path, text):
    """In one step, and only where it is new: a file that is the same is not read again."""
    try:
        if path.read_text(encoding="utf-8") == text:
            return
    except OSError:
        pass
    path.parent.mkdir(parents=True, exist_ok=True)
    draft = path.with_name(f".{path.name}.{os.getpid()}")
    draft.write_text(text, encoding="utf-8")
    os.replace(draft, path)
