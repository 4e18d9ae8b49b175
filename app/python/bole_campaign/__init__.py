"""Campaigns: one pipeline on many inputs, on one machine, a Dask cluster or a job array.

    import bole.campaign
    code = bole.campaign.run("campaign.json", out="survey", workers=4)
    for row in bole.campaign.status("survey"):
        print(row["input_id"], row["state"], row["error"])

The engine needs Python and the program `bole` (in the PATH, or BOLE_PROGRAM), nothing else; Dask.distributed where it is
to be used. Inputs are checked and attempts recorded as by `bole campaign`.
"""

from .errors import CampaignError


def _request(document, out, **more):
    from . import program

    place = program.find_program()
    given = {name: value for name, value in more.items() if value is not None}
    return {"campaign": str(document), "out": str(out), "program": place, "version": program.version_of(place), **given}


def plan(document, out, retry=False):
    """[{task, id, why, runs, memory_gib, set}]: what a run would do. Throws CampaignError."""
    from . import command

    return command.plan_rows(_request(document, out, retry=retry))


def run(document, out, workers=None, scheduler=None, task=None, memory_gib=None, engine="auto", retry=False):
    """Runs what is missing or changed; returns the exit code of `bole campaign run`. From the main thread. Throws CampaignError."""
    from . import command

    return command.run(_request(document, out, workers=workers, scheduler=scheduler, task=task, memory_gib=memory_gib, engine=engine, retry=retry))


def status(out):
    """The rows of the inputs, in the order of the document. Throws CampaignError."""
    from . import command

    return command.kept_plan(out).rows()


def merge(out):
    """Writes stems.csv, campaign.gpkg and campaign.html from what is done so far; returns the rows of the inputs."""
    from . import client, command

    found = command.kept_plan(out)
    with client.only_client(found.out):
        return found.merge()[0]
