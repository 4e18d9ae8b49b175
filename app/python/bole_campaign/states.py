"""The state of every input as rows: what the ledger, the page and `bole campaign status` show."""

import pathlib

from . import folders, planning

# The worst first.
ORDER = ("crashed", "failed", "bad_input", "running", "changed", "missing", "done")
VERDICTS = ("refused", "look", "sign", "")


def is_running(task):
    """Whether an attempt holds the lock of the task now."""
    folder = pathlib.Path(task["folder"])
    if not folder.is_dir() or not any(entry.name.startswith("attempt-") for entry in folder.iterdir()):
        return False
    with folders.lock(str(folder / "lock")) as handle:
        return handle is None


def row_of(task, out, running=None):
    """`running`: whether it runs, where the caller knows."""
    record, reason = planning.recorded(task)
    attempts = folders.attempts_of(task["folder"])
    state = "missing" if record is None else "changed" if reason else record["state"]
    if state != "done" and (is_running(task) if running is None else running):
        state = "running"
    record = record or {}
    severities = [f.get("severity") for f in record.get("findings", [])]
    folder = pathlib.Path(task["folder"]).relative_to(out) / ("done" if record.get("state") == "done" else "failed")
    return {
        "input_id": task["id"],
        "state": state,
        "verdict": record.get("verdict", ""),
        "stems": record.get("stems"),
        "seconds": record.get("seconds"),
        "peak_mib": record.get("peak_mib"),
        "memory_gib": record.get("memory_gib", task["memory_gib"]),
        "attempts": len(attempts),
        "killed": sum(1 for a in attempts if a["end"] is None) - (1 if state == "running" else 0),
        "findings": sum(1 for s in severities if s in ("look", "refused")),
        "warnings": record.get("warnings", 0),
        "error": record.get("error", "") or reason,
        "version": record.get("key_parts", {}).get("version", ""),
        "finished": record.get("finished", ""),
        "report": (folder / record["report"]).as_posix() if record.get("report") else "",
        "log": (folder / "log.txt").as_posix() if record.get("host") else "",
        "x_m": task["x_m"],
        "y_m": task["y_m"],
    }


def badness(row):
    return (ORDER.index(row["state"]), VERDICTS.index(row["verdict"]) if row["verdict"] in VERDICTS else 0, -row["findings"], row["input_id"])


def counts_of(rows):
    return {state: n for state in ORDER if (n := sum(1 for row in rows if row["state"] == state))}


def in_words(counts):
    words = {"missing": "to run", "changed": "changed", "bad_input": "bad input"}
    return ", ".join(f"{counts[state]} {words.get(state, state)}" for state in reversed(ORDER) if state in counts) or "no inputs"


def exit_code_of(rows):
    """As of one run: 1 where work is missing or went wrong, 2 where inputs are bad and nothing else is wrong."""
    states = {row["state"] for row in rows}
    return 1 if states - {"done", "bad_input"} else 2 if "bad_input" in states else 0
