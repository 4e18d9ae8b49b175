"""Campaigns: one pipeline on many inputs, on this machine, a Dask cluster or a job array (docs/user/campaigns.md).

    import bole
    code = bole.campaign.run("campaign.json", out="survey", workers=4)
    for row in bole.campaign.status("survey"):
        print(row["input_id"], row["state"], row["error"])

The engine is the one of `bole campaign`: what one of them began, the other goes on with. A document is a path, or a dict, which is kept
as campaign.json in the folder of the campaign. Throws BadInput and Failed; Ctrl-C works as on the command line.
"""

import json
import os
import pathlib

import bole_campaign
from bole_campaign.errors import CampaignError

from . import _native
from ._errors import translated

__all__ = ["CampaignError", "merge", "plan", "run", "status"]


def _place(document, out):
    """The path of a document. Relative paths in a dict are taken from the working directory, as the engine looks there too."""
    if not isinstance(document, dict):
        return document
    folder = pathlib.Path(out)
    folder.mkdir(parents=True, exist_ok=True)
    path = folder / "campaign.json"
    path.write_text(json.dumps(document, indent=1) + "\n", encoding="utf-8")
    return path


def _asked(function, *arguments, **more):
    with translated():
        os.environ.setdefault("BOLE_PROGRAM", _native.program())  # the engine starts the program of this package
        return function(*arguments, **more)


def plan(document, out, retry=False):
    """What a run would do: [{task, id, why, runs, memory_gib, set}]."""
    return _asked(bole_campaign.plan, _place(document, out), out, retry=retry)


def run(document, out, workers=None, scheduler=None, task=None, memory_gib=None, engine="auto", retry=False):
    """Runs what is missing or changed, and puts the tables together. From the main thread.

    workers      inputs that run at the same time on this machine (None: as many as fit)
    scheduler    address of a Dask scheduler to run on
    task         run one input alone, by its number in the plan (a job array)
    memory_gib   memory for all workers together (None: what is free)
    engine       "auto", "dask" or "local"
    retry        run inputs again whose work failed before

    Returns the exit code of `bole campaign run`: 0 done, 1 work is missing or went wrong, 2 inputs are bad, 3 cancelled, 4 finished early.
    """
    asked = {"workers": workers, "scheduler": scheduler, "task": task, "memory_gib": memory_gib, "engine": engine, "retry": retry}
    return _asked(bole_campaign.run, _place(document, out), out, **asked)


def status(out):
    """A dict for every input, in the order of the document: input_id, state, verdict, stems, seconds, peak_mib, error, ..."""
    return _asked(bole_campaign.status, out)


def merge(out):
    """Writes stems.csv, campaign.gpkg and campaign.html from what is done so far; returns the rows of status()."""
    return _asked(bole_campaign.merge, out)
