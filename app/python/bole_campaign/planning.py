"""What is to be done: every input with its state, and why it would run."""

import os
import pathlib

from . import folders, keys, memory
from .document import TILE_KEYS, Campaign, raw_document
from .errors import bad_input

TO_RUN = ("missing", "changed", "crashed", "retry")


class Plan:
    """`tasks`: the specs that attempt.py takes, in the order of the document; plan.json keeps them for later commands."""

    def __init__(self, out, title, tables, retries, tasks):
        self.out, self.title, self.tables, self.retries, self.tasks = pathlib.Path(out), title, tables, retries, tasks

    @staticmethod
    def of_document(path, out, program, version):
        out, raw = pathlib.Path(os.path.abspath(out)), raw_document(path)
        if any(key in raw for key in TILE_KEYS):
            from . import tile_plan, tiled_document  # which need this module

            return tile_plan.TilePlan.of_campaign(tiled_document.TiledCampaign(path, program, raw), out, program, version).look_through()
        campaign = Campaign(path, program, raw)
        common = {"program": program, "version": version, "document": str(campaign.pipeline.path), "cache": campaign.cache,
                  "accept_partial": campaign.accept_partial, "time_limit_s": campaign.time_limit_s, "threads": campaign.threads}
        tasks = [
            {**common, "id": e["id"], "folder": str(folders.task_folder(out, e["id"])), "set": e["set"], "files": e["files"],
             "memory_gib": memory.declared_gib(e, program), "memory_given": e["memory_gib"] is not None, "x_m": e["x_m"], "y_m": e["y_m"]}
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
        if "tiles" in kept:
            from . import tile_plan

            return tile_plan.TilePlan(pathlib.Path(out), kept["tiles"]).look_through()
        for task in kept["tasks"]:
            task["folder"] = str(folders.task_folder(out, task["id"]))  # the folder may have been moved
        return Plan(out, kept["title"], kept["tables"], kept["retries"], kept["tasks"])

    def keep(self):
        self.out.mkdir(parents=True, exist_ok=True)
        folders.write_json(self.out / "plan.json", {"format": 1, "title": self.title, "tables": self.tables, "retries": self.retries, "tasks": self.tasks})

    rows_are, results = "inputs", ("stems.csv", "campaign.gpkg", "campaign.html")

    def named(self, task, count):
        """What is about to run, in words."""
        return f"{count} inputs"

    def phases(self):
        """The tasks that may run side by side; those of the next phase need the results of the one before."""
        yield self.tasks

    def row_id(self, task):
        """The id of the row that tells about a task."""
        return task["id"]

    def row_of(self, task, running=None):
        from . import states  # which needs this module

        return states.row_of(task, self.out, running)

    def rows(self):
        return [self.row_of(task) for task in self.tasks]

    def task_of_array(self, number):
        """The task with this number, and what it waits for where there is none to run."""
        count = len(self.tasks)
        if number > count:
            raise bad_input(f"there is no task {number}", f"a number up to {count}", "bole campaign plan lists them")
        return self.tasks[(number - 1) % count], ""  # 0 stands for the last

    def is_through(self):
        """Whether every task has been run, well or not."""
        return all(any((pathlib.Path(task["folder"]) / place).exists() for place in ("done", "failed")) for task in self.tasks)

    def merge(self, ledger=None):
        """Writes the tables, the map and the page. Returns the rows of the inputs and what a person should know."""
        from . import merging

        return merging.merge(self, ledger)


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
