"""What is to be done: every input with its state, and why it would run."""

import os
import pathlib

from . import folders, keys, memory
from .document import Campaign

TO_RUN = ("missing", "changed", "crashed", "retry")


class Plan:
    """`tasks`: the specs that attempt.py takes, in the order of the document; plan.json keeps them for later commands."""

    def __init__(self, out, title, tables, retries, tasks):
        self.out, self.title, self.tables, self.retries, self.tasks = pathlib.Path(out), title, tables, retries, tasks

    @staticmethod
    def of_document(path, out, program, version):
        campaign = Campaign(path, program)
        out = pathlib.Path(os.path.abspath(out))
        common = {"program": program, "version": version, "document": str(campaign.pipeline.path), "cache": campaign.cache,
                  "accept_partial": campaign.accept_partial, "time_limit_s": campaign.time_limit_s, "threads": campaign.threads}
        tasks = [
            {**common, "id": e["id"], "folder": str(folders.task_folder(out, e["id"])), "set": e["set"], "files": e["files"],
             "memory_gib": memory.declared_gib(e), "memory_given": e["memory_gib"] is not None, "x_m": e["x_m"], "y_m": e["y_m"]}
            for e in campaign.inputs
        ]
        return Plan(out, campaign.title, campaign.tables, campaign.retries, tasks)

    @staticmethod
    def of_folder(out):
        """The one that was run last; None where no campaign was."""
        kept = folders.read_json(pathlib.Path(out) / "plan.json")
        if kept is None or kept.get("format") != 1:
            return None
        out = os.path.abspath(out)
        for task in kept["tasks"]:
            task["folder"] = str(folders.task_folder(out, task["id"]))  # the folder may have been moved
        return Plan(out, kept["title"], kept["tables"], kept["retries"], kept["tasks"])

    def keep(self):
        self.out.mkdir(parents=True, exist_ok=True)
        folders.write_json(self.out / "plan.json", {"format": 1, "title": self.title, "tables": self.tables, "retries": self.retries, "tasks": self.tasks})

    def by_id(self):
        return {task["id"]: task for task in self.tasks}


def recorded(task):
    """The record that is current, or the newest with the reason why it is not: (record or None, reason)."""
    reason, stale = "", None
    for place in ("done", "failed"):
        record = folders.record_in(pathlib.Path(task["folder"]) / place)
        if record is None:
            continue
        why = keys.why_stale(record, task)
        if not why:
            return record, ""
        if stale is None or record["finished"] > stale["finished"]:
            stale, reason = record, why
    return stale, reason


def look_at(task, retry=False):
    """(what to do, why, record): done, bad_input and failed stay as they are; those of TO_RUN run."""
    record, reason = recorded(task)
    if record is None:
        return "missing", "it has no result", None
    if reason:
        return "changed", reason, record
    state = record["state"]
    if state == "crashed":
        return "crashed", record["error"], record
    if state == "failed" and retry:
        return "retry", record["error"], record
    return state, record["error"], record
