"""The key of a task: document, options, content of the inputs, version. A result is current while its key is."""

import hashlib
import json
import os
import pathlib

# What a reader finds by itself beside its file or folder (modules/vtkbridge/file_keys.cpp).
BESIDE = ("imu.csv", "{stem}_imu.csv", "{stem}.json")
BESIDE_FOLDER = ("times.txt", "timestamps.txt")


def digest(data):
    return hashlib.blake2b(data, digest_size=16).hexdigest()


def stamp_of(path):
    """Size, and times of writing and of change: a file of the same stamp is not read again."""
    status = os.stat(path)
    return [status.st_size, status.st_mtime_ns, status.st_ctime_ns]


def digest_of_file(path):
    whole = hashlib.blake2b(digest_size=16)
    with open(path, "rb") as file:
        while block := file.read(1 << 22):
            whole.update(block)
    return whole.hexdigest()


def files_of(path):
    """The files that a path stands for, sorted: of a folder all that are in it, and what belongs to it beside it."""
    path = pathlib.Path(os.path.abspath(path))
    beside = [name.format(stem=path.stem) for name in BESIDE]
    if path.is_file():
        own = [path]
    elif path.is_dir():
        own = [file for file in path.rglob("*") if file.is_file()]
        beside += BESIDE_FOLDER
    else:
        return []
    own += [file for name in beside if (file := path.parent / name).is_file() and file != path]
    return sorted(set(own))


def size_of(path):
    return sum(file.stat().st_size for file in files_of(path))


def content_of(path, known, seen):
    """A hash of all files of a path. `known` and `seen`: {file: [stamp, hash]}, what is known and what was looked at."""
    files = files_of(path)
    if not files:
        return "absent"
    whole = hashlib.blake2b(digest_size=16)
    for file in files:
        name, stamp = str(file), stamp_of(file)
        if name in seen and seen[name][0] == stamp:
            value = seen[name][1]
        elif name in known and known[name][0] == stamp:
            value = known[name][1]
        else:
            try:
                value = digest_of_file(file)
            except OSError:
                value = "unreadable"  # the stage that reads it says so in its own words
        seen[name] = [stamp, value]
        whole.update(f"{os.path.relpath(file, path)}\0{value}\n".encode())
    return whole.hexdigest()


def parts_of(spec, known):
    """What the key is made of, and the files that were looked at."""
    seen = {}
    contents = {name: [content_of(path, known, seen) for path in paths] for name, paths in sorted(spec["files"].items())}
    # The place of a file does not change a result; its ending decides how it is read.
    settings = {name: list(map(os.path.basename, spec["files"][name])) if name in spec["files"] else value for name, value in spec["set"].items()}
    document = spec.get("content")
    if document is None:
        with open(spec["document"], encoding="utf-8") as file:
            document = json.load(file)
    parts = {
        "pipeline": digest(json.dumps(document, sort_keys=True).encode()),
        "options": settings,
        "content": contents,
        "version": spec["version"],
    }
    return parts, seen


def key_of(parts):
    return digest(json.dumps(parts, sort_keys=True).encode())


def is_partial(findings):
    """Whether an input could be read in part only (base/verdict.h)."""
    return any(finding.get("code") == "input_incomplete" for finding in findings)


def why_stale(record, spec):
    """Why a record does not hold for a spec any more; empty where it does."""
    parts, _ = parts_of(spec, record.get("files", {}))
    if key_of(parts) != record["key"]:
        return difference(record["key_parts"], parts)
    if is_partial(record.get("findings", [])) and record.get("accept_partial", False) != spec.get("accept_partial", False):
        return "accept_partial changed"  # to inputs that are whole it makes no difference
    return ""


def difference(before, now):
    """Why a result is not current, in words."""
    reasons = []
    if before["version"] != now["version"]:
        reasons.append(f"Bole {before['version']} made it, this is {now['version']}")
    if before["pipeline"] != now["pipeline"]:
        reasons.append("the pipeline changed")
    for what, text in (("options", "the option {} changed"), ("content", "the content of {} changed")):
        names = sorted(n for n in {*before[what], *now[what]} if before[what].get(n) != now[what].get(n))
        reasons += [text.format(name) for name in names]
    return "; ".join(reasons) or "it changed"
